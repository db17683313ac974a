//! What tiles are compared with: one tile that repeats, and a quilt made for its place.
//!
//! A quilt in the manner of Efros and Freeman (2001) is laid block by block, each block one of
//! those that fit best to what lies there, cut along the overlap. It never repeats and knows no
//! tiles, but has to be made and kept at full size.

use super::Shape;
use super::corner::Corners;
use super::quilt::Quilt;
use super::stock::{Stock, Texel};
use super::weave::{Hold, weave};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;

/// Positions compared for a block.
const POSITIONS: usize = 4096;
/// Blocks that fit worse than the best by this factor are out.
const TOLERANCE: f64 = 1.1;

/// The best of some tiles that repeat on their own: a patch cut from itself on the sides.
pub fn periodic(stock: &Stock, shape: Shape, seed: u64, candidates: usize) -> Option<Quilt> {
    let candidate = |at: usize| {
        let mut random = Pcg64::seed_from_u64(seed ^ (at as u64) << 32);
        Corners::new(stock, shape, 1, &mut random)
    };
    let all = (0..candidates).into_par_iter().map(candidate);
    let best = all.enumerate().min_by_key(|(at, corners)| (corners.price, *at));
    best.map(|(_, corners)| corners.tile([0; 4]))
}

/// A quilt of blocks, so many texels wide and high. The examples are larger than a block.
pub fn quilted(stock: &Stock, block: usize, width: usize, height: usize, seed: u64) -> Quilt {
    let overlap = (block / 6).max(1);
    let step = block - overlap;
    let blocks = |length: usize| length.div_ceil(step);
    let (wide, high) = (blocks(width) * step + overlap, blocks(height) * step + overlap);
    // Texel 0 is none of an example: nothing lies there yet.
    let mut quilt = Quilt::new(wide, high, |_, _| 0);
    let mut random = Pcg64::seed_from_u64(seed);
    for top in (0..high - overlap).step_by(step) {
        for left in (0..wide - overlap).step_by(step) {
            let there = Quilt::new(block, block, |x, y| quilt.at(left + x, top + y));
            let at = fitting(stock, &there, &mut random);
            let new = Quilt::new(block, block, |x, y| at + (y * stock.stride() + x) as Texel);
            let texels = there.texels.iter().zip(&new.texels);
            let first = Quilt {
                texels: texels.map(|(&old, &new)| if old == 0 { new } else { old }).collect(),
                ..there
            };
            let hold: Vec<Hold> = (0..block * block)
                .map(|at| {
                    let (x, y) = (at % block, at / block);
                    let (inner_x, inner_y) = (left == 0 || x >= overlap, top == 0 || y >= overlap);
                    match () {
                        () if inner_x && inner_y => Hold::Second,
                        () if (left > 0 && x == 0) || (top > 0 && y == 0) => Hold::First,
                        () => Hold::Free,
                    }
                })
                .collect();
            let woven = weave(stock, &first, &new, &hold).quilt(&first, &new);
            for y in 0..block {
                let row = &woven.texels[y * block..][..block];
                quilt.texels[(top + y) * wide + left..][..block].copy_from_slice(row);
            }
        }
    }
    Quilt::new(width, height, |x, y| quilt.at(x, y))
}

/// A position of a block that fits what lies there.
fn fitting(stock: &Stock, there: &Quilt, random: &mut Pcg64) -> Texel {
    let block = there.width;
    let laid: Vec<(Texel, Texel)> = (0..block * block)
        .filter(|&at| there.texels[at] != 0)
        .map(|at| ((at % block + at / block * stock.stride()) as Texel, there.texels[at]))
        .collect();
    let positions: Vec<Texel> = (0..POSITIONS)
        .map(|_| {
            let place = stock.places()[random.random_range(0..stock.places().len())];
            let x = random.random_range(0..place.width - block + 1);
            stock.texel(x, place.top + random.random_range(0..place.height - block + 1))
        })
        .collect();
    let cost = |&at: &Texel| {
        // Every other place will do.
        let differences = laid.iter().step_by(2);
        differences.map(|&(offset, old)| u64::from(stock.difference(at + offset, old))).sum()
    };
    let costs: Vec<u64> = positions.par_iter().map(cost).collect();
    let least = costs.iter().min().copied().unwrap_or(0) as f64 * TOLERANCE;
    let good: Vec<Texel> =
        (0..POSITIONS).filter(|&at| costs[at] as f64 <= least).map(|at| positions[at]).collect();
    good[random.random_range(0..good.len())]
}

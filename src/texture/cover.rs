//! The middle of a tile covered by one more patch of an example (Ng et al. 2005).
//!
//! The patch may show in a disk about the middle that keeps clear of the strip, and has to show
//! where the seams of the tile cross its inner part. Where it ends is the cheapest cut, which
//! also weighs the seams that it hides.
//!
//! Where the patch is taken from: all positions are compared with the tile in random places of
//! the ring in which the cut will run. The best are tried, by preference those that no other tile
//! took.

use super::Shape;
use super::quilt::Quilt;
use super::stock::{Stock, Texel};
use super::weave::{Hold, weave};
use rand::RngExt;
use rand_pcg::Pcg64;

/// Places of the ring that are compared.
const PLACES: usize = 192;
/// Positions compared at most, so that large examples do not take longer than they are worth.
const POSITIONS: usize = 1 << 16;
/// The best positions that are kept for a tile.
const KEPT: usize = 48;
/// What a position costs more for each tile that took it or one nearby, in parts of its cost.
const USED: f64 = 0.5;

/// A position of a patch, the texel at its north-western corner, and how badly it fits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fit {
    /// The sum of the differences.
    pub cost: u64,
    /// The texel.
    pub texel: Texel,
}

/// What is the same for all tiles.
#[derive(Debug, Clone)]
pub struct Cover {
    shape: Shape,
    /// Places of a tile in the ring.
    ring: Vec<(usize, usize)>,
}

/// Twice the distance from the middle, squared.
fn off(shape: Shape, x: usize, y: usize) -> usize {
    let from = |at: usize| (2 * at + 1).abs_diff(shape.side);
    from(x) * from(x) + from(y) * from(y)
}

impl Cover {
    /// Chooses the places that are compared.
    pub fn new(shape: Shape, random: &mut Pcg64) -> Self {
        let (inner, outer) = (shape.core(), 2 * shape.radius());
        let places = (0..shape.side).flat_map(|y| (0..shape.side).map(move |x| (x, y)));
        let mut ring: Vec<(usize, usize)> = places
            .filter(|&(x, y)| (inner * inner..outer * outer).contains(&off(shape, x, y)))
            .collect();
        let count = ring.len().min(PLACES);
        for at in 0..count {
            let other = random.random_range(at..ring.len());
            ring.swap(at, other);
        }
        ring.truncate(count);
        Self { shape, ring }
    }

    /// The best positions in some examples, the best first.
    pub fn fits(
        &self,
        stock: &Stock,
        tile: &Quilt,
        examples: &[usize],
        random: &mut Pcg64,
    ) -> Vec<Fit> {
        let (side, stride) = (self.shape.side, stock.stride());
        let wanted: Vec<u16> =
            self.ring.iter().flat_map(|&(x, y)| stock.light(tile.at(x, y))).copied().collect();
        let offsets: Vec<usize> = self.ring.iter().map(|&(x, y)| y * stride + x).collect();
        let features = stock.features();
        let mut best: Vec<Fit> = Vec::new();
        let mut limit = u64::MAX;
        let mut compare = |texel: Texel| {
            let mut cost = 0u64;
            for (some, wanted) in offsets.chunks(16).zip(wanted.chunks(16 * features)) {
                for (offset, wanted) in some.iter().zip(wanted.chunks(features)) {
                    let light = stock.light(texel + *offset as Texel);
                    let parts = light.iter().zip(wanted);
                    cost += parts.map(|(a, b)| u64::from(a.abs_diff(*b))).sum::<u64>();
                }
                if cost >= limit {
                    return;
                }
            }
            add(&mut best, Fit { cost, texel }, stride, side / 16);
            if best.len() == KEPT {
                limit = best[KEPT - 1].cost;
            }
        };
        let total: usize = examples.iter().map(|&example| self.positions(stock, example)).sum();
        for &example in examples {
            let place = stock.places()[example];
            let (columns, rows) = (place.width - side + 1, place.height - side + 1);
            if total <= POSITIONS {
                for at in 0..columns * rows {
                    compare(stock.texel(at % columns, place.top + at / columns));
                }
            } else {
                for _ in 0..POSITIONS / examples.len() {
                    let x = random.random_range(0..columns);
                    compare(stock.texel(x, place.top + random.random_range(0..rows)));
                }
            }
        }
        best
    }

    fn positions(&self, stock: &Stock, example: usize) -> usize {
        let place = stock.places()[example];
        (place.width - self.shape.side + 1) * (place.height - self.shape.side + 1)
    }

    /// Puts the patch at a position into a tile; what is paid for all seams then.
    pub fn cut(&self, stock: &Stock, tile: &Quilt, at: Texel) -> (Quilt, u64) {
        let shape = self.shape;
        let patch =
            Quilt::new(shape.side, shape.side, |x, y| at + (y * stock.stride() + x) as Texel);
        let (core, radius) = (shape.core(), 2 * shape.radius());
        let mut hold: Vec<Hold> = (0..shape.side * shape.side)
            .map(|at| match off(shape, at % shape.side, at / shape.side) {
                off if off >= radius * radius => Hold::First,
                off if off < core * core / 4 => Hold::Second,
                _ => Hold::Free,
            })
            .collect();
        for (p, q, _) in tile.seams(stock) {
            for place in [p, q] {
                if off(shape, place % shape.side, place / shape.side) < core * core {
                    hold[place] = Hold::Second;
                }
            }
        }
        let woven = weave(stock, tile, &patch, &hold);
        (woven.quilt(tile, &patch), woven.price)
    }
}

/// Keeps a fit if it is among the best, and better than those close by.
fn add(best: &mut Vec<Fit>, fit: Fit, stride: usize, apart: usize) {
    let close = |other: &Fit| near(other.texel, fit.texel, stride, apart);
    if best.iter().any(|other| other.cost <= fit.cost && close(other)) {
        return;
    }
    best.retain(|other| !close(other));
    let at = best.partition_point(|other| *other < fit);
    best.insert(at, fit);
    best.truncate(KEPT);
}

/// Whether two texels are at most so many columns and rows apart.
fn near(a: Texel, b: Texel, stride: usize, apart: usize) -> bool {
    let (a, b) = (a as usize, b as usize);
    (a % stride).abs_diff(b % stride) <= apart && (a / stride).abs_diff(b / stride) <= apart
}

/// Gives each tile the positions that it shall try, the tiles in turn.
pub fn shared_out(fits: &[Vec<Fit>], tries: usize, stock: &Stock, shape: Shape) -> Vec<Vec<Texel>> {
    let mut taken: Vec<Texel> = Vec::new();
    let mut shares = Vec::new();
    for fits in fits {
        let uses = |texel: Texel| {
            let close = |&&other: &&Texel| near(other, texel, stock.stride(), shape.side / 8);
            taken.iter().filter(close).count()
        };
        let cost = |fit: &Fit| fit.cost as f64 * (1.0 + USED * uses(fit.texel) as f64);
        let mut ranked: Vec<(f64, Texel)> = fits.iter().map(|fit| (cost(fit), fit.texel)).collect();
        ranked.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        ranked.truncate(tries);
        taken.extend(ranked.first().map(|(_, texel)| *texel));
        shares.push(ranked.into_iter().map(|(_, texel)| texel).collect());
    }
    shares
}

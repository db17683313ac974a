//! Whether a tiling looks like the examples: its colors, and its small patches.

use crate::texture::{Quilt, Stock, Texel};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;

/// Texels of a patch's side.
const PATCH: usize = 7;
/// Patches looked up.
const PATCHES: usize = 96;
/// Classes of brightness.
const CLASSES: usize = 256;

/// How one channel is spread, in 1/255 of full light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Channel {
    /// The mean, less that of the examples.
    pub mean: f64,
    /// The variance, by that of the examples.
    pub variance: f64,
    /// How far light has to be moved, on average, to make one distribution of the other.
    pub moved: f64,
}

/// Numbers on likeness.
#[derive(Debug, Clone, PartialEq)]
pub struct Likeness {
    /// The channels of the picture and its maps.
    pub channels: Vec<Channel>,
    /// The distance of small patches from the nearest in the examples: the root of the mean of
    /// the squares, in 1/255 of full light; the mean over patches.
    pub patches: f64,
    /// What 95 % of the patches keep below.
    pub patches_high: f64,
}

impl Likeness {
    /// Looks at a tiling; patches are drawn at random.
    pub fn of(stock: &Stock, tiling: &Quilt, seed: u64) -> Self {
        let all: Vec<Texel> = stock.all().collect();
        let full = full(stock);
        let channels = (0..stock.features())
            .map(|channel| {
                let spread = |texels: &[Texel]| {
                    let mut spread = vec![0.0; CLASSES];
                    let value = |texel: &Texel| {
                        f64::from(stock.light(*texel)[channel]) / full[channel] * 255.0
                    };
                    let count = texels.len() as f64;
                    let mean = texels.iter().map(value).sum::<f64>() / count;
                    let squares = texels.iter().map(|texel| (value(texel) - mean).powi(2));
                    let variance = squares.sum::<f64>() / count;
                    for texel in texels {
                        spread[(value(texel) as usize).min(CLASSES - 1)] += 1.0 / count;
                    }
                    (mean, variance, spread)
                };
                let (is, was) = (spread(&tiling.texels), spread(&all));
                let mut over = 0.0;
                let mut moved = 0.0;
                for (a, b) in is.2.iter().zip(&was.2) {
                    over += a - b;
                    moved += f64::abs(over);
                }
                Channel { mean: is.0 - was.0, variance: is.1 / was.1.max(1e-9), moved }
            })
            .collect();
        let mut random = Pcg64::seed_from_u64(seed);
        let places: Vec<(usize, usize)> = (0..PATCHES)
            .map(|_| {
                let x = random.random_range(0..tiling.width - PATCH + 1);
                (x, random.random_range(0..tiling.height - PATCH + 1))
            })
            .collect();
        let mut distances: Vec<f64> =
            places.par_iter().map(|&(x, y)| nearest(stock, tiling, x, y, &full)).collect();
        distances.sort_by(f64::total_cmp);
        let patches = distances.iter().sum::<f64>() / PATCHES as f64;
        Self { channels, patches, patches_high: distances[PATCHES * 95 / 100] }
    }
}

/// Full light of every feature.
fn full(stock: &Stock) -> Vec<f64> {
    let counts = stock.images(0).iter().map(|image| image.format().channels.count());
    counts.flat_map(|count| vec![65535.0 / count as f64; count]).collect()
}

/// The distance of a patch from the nearest in the examples.
fn nearest(stock: &Stock, tiling: &Quilt, x: usize, y: usize, full: &[f64]) -> f64 {
    let scale: Vec<f32> = full.iter().map(|full| (255.0 / full) as f32).collect();
    let features = stock.features();
    let light =
        |texel: Texel| stock.light(texel).iter().zip(&scale).map(|(&s, by)| f32::from(s) * by);
    let wanted: Vec<f32> = (0..PATCH * PATCH)
        .flat_map(|at| light(tiling.at(x + at % PATCH, y + at / PATCH)))
        .collect();
    let mut least = f32::MAX;
    for place in stock.places() {
        if place.width < PATCH || place.height < PATCH {
            continue;
        }
        for top in place.top..=place.top + place.height - PATCH {
            for left in 0..=place.width - PATCH {
                let mut sum = 0.0;
                for (row, wanted) in wanted.chunks(PATCH * features).enumerate() {
                    for (column, wanted) in wanted.chunks(features).enumerate() {
                        let texel = stock.texel(left + column, top + row);
                        for (a, b) in light(texel).zip(wanted) {
                            sum += (a - b) * (a - b);
                        }
                    }
                    if sum >= least {
                        break;
                    }
                }
                least = least.min(sum);
            }
        }
    }
    f64::from(least / (PATCH * PATCH * features) as f32).sqrt()
}

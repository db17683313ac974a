//! What comes back with the period of the tiles.
//!
//! All tiles are transformed (Fourier), and their sum is compared with what the sum of so many
//! independent pictures would have: a ratio of 1 is no sign of a period, that of the number of
//! tiles means that all show the same. Lines at multiples of 1/side in the spectrum of the tiling
//! are just these ratios.

use super::brightness;
use crate::texture::{Quilt, Stock};
use std::f64::consts::TAU;

/// Frequencies looked at, in either direction, in periods a tile.
const FREQUENCIES: usize = 8;
/// Lags looked at, in tiles.
const LAGS: usize = 4;

/// Numbers on repetition.
#[derive(Debug, Clone, PartialEq)]
pub struct Period {
    /// The mean ratio over low frequencies.
    pub comb: f64,
    /// The largest ratio.
    pub peak: f64,
    /// The number of tiles, which is the ratio of a picture with the period of the tiles.
    pub tiles: usize,
    /// The autocorrelation 1, 2, ... tiles apart; the larger of both directions.
    pub correlation: Vec<f64>,
}

impl Period {
    /// Looks at a tiling.
    pub fn of(stock: &Stock, tiling: &Quilt, side: usize) -> Self {
        let (width, height) = (tiling.width, tiling.height);
        let light: Vec<f64> = tiling.texels.iter().map(|&texel| brightness(stock, texel)).collect();
        let mean = light.iter().sum::<f64>() / light.len().max(1) as f64;
        let light: Vec<f64> = light.into_iter().map(|value| value - mean).collect();
        let (comb, peak) = comb(&light, width, height, side);
        let variance = light.iter().map(|value| value * value).sum::<f64>() / light.len() as f64;
        let correlation = (1..=LAGS)
            .filter(|lag| (lag + 1) * side <= width.min(height))
            .map(|lag| {
                let shift = lag * side;
                let mean = |pairs: &mut dyn Iterator<Item = (usize, usize)>| {
                    let (mut sum, mut count) = (0.0, 0u64);
                    for (a, b) in pairs {
                        sum += light[a] * light[b];
                        count += 1;
                    }
                    sum / count.max(1) as f64 / variance.max(1.0)
                };
                let beside = (0..width * height).filter(|at| at % width + shift < width);
                let below = 0..width * (height - shift);
                let beside = mean(&mut beside.map(|at| (at, at + shift)));
                beside.max(mean(&mut below.map(|at| (at, at + shift * width))))
            })
            .collect();
        Self { comb, peak, tiles: (width / side) * (height / side), correlation }
    }
}

/// The mean and the largest ratio.
fn comb(light: &[f64], width: usize, height: usize, side: usize) -> (f64, f64) {
    let waves: Vec<Vec<(f64, f64)>> = (0..=FREQUENCIES)
        .map(|k| {
            let angle = |at: usize| TAU * (k * at % side) as f64 / side as f64;
            (0..side).map(|at| (angle(at).cos(), angle(at).sin())).collect()
        })
        .collect();
    // East from 0 to F, south from -F to F.
    let rows = 2 * FREQUENCIES + 1;
    let mut sums = vec![(0.0, 0.0); (FREQUENCIES + 1) * rows];
    let mut powers = vec![0.0; sums.len()];
    let tiles = (width / side) * (height / side);
    let mut along = vec![(0.0, 0.0); side * (FREQUENCIES + 1)];
    for tile in 0..tiles {
        let (left, top) = (tile % (width / side) * side, tile / (width / side) * side);
        for y in 0..side {
            let row = &light[(top + y) * width + left..][..side];
            for (k, wave) in waves.iter().enumerate() {
                let mut sum = (0.0, 0.0);
                for (value, (cos, sin)) in row.iter().zip(wave) {
                    sum = (sum.0 + value * cos, sum.1 - value * sin);
                }
                along[k * side + y] = sum;
            }
        }
        for k in 0..=FREQUENCIES {
            for row in 0..rows {
                let (l, down) = (row.abs_diff(FREQUENCIES), row >= FREQUENCIES);
                let mut sum = (0.0, 0.0);
                for (value, &(cos, sin)) in along[k * side..][..side].iter().zip(&waves[l]) {
                    let sin = if down { -sin } else { sin };
                    sum.0 += value.0 * cos - value.1 * sin;
                    sum.1 += value.0 * sin + value.1 * cos;
                }
                let at = k * rows + row;
                sums[at] = (sums[at].0 + sum.0, sums[at].1 + sum.1);
                powers[at] += sum.0 * sum.0 + sum.1 * sum.1;
            }
        }
    }
    // Those east of the vertical axis, and the southern half of it.
    let asked = (0..sums.len()).filter(|at| *at > FREQUENCIES);
    let ratios: Vec<f64> = asked
        .map(|at| (sums[at].0 * sums[at].0 + sums[at].1 * sums[at].1) / powers[at].max(1.0))
        .collect();
    let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
    (mean, ratios.into_iter().fold(0.0, f64::max))
}

//! Seams: the mismatch where texels are cut, and whether lines of the tiling can be seen.

use crate::texture::{Quilt, Stock};

/// Numbers on seams. Ratios near 1 mean that nothing is to be seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seams {
    /// The part of all steps from texel to texel that go over a seam.
    pub share: f64,
    /// The mean mismatch of those, by the mean difference of texels side by side in the examples.
    pub mean: f64,
    /// The mismatch that 95 % of them keep below, likewise.
    pub high: f64,
    /// The largest mismatch, likewise.
    pub largest: f64,
    /// The mean difference of texels side by side at seams, by that elsewhere.
    pub at_cuts: f64,
    /// The same at the borders of tiles.
    pub at_borders: f64,
    /// The same at the lines through the middles of tiles.
    pub at_middles: f64,
}

impl Seams {
    /// Looks at a tiling.
    pub fn of(stock: &Stock, tiling: &Quilt, side: usize) -> Self {
        let gradient = stock.mean_gradient().max(1.0);
        let mut mismatches: Vec<u32> = Vec::new();
        let mut steps = 0u64;
        // Cuts, borders, middles, elsewhere: sums of differences, and how many.
        let mut sums = [(0.0, 0u64); 4];
        for (p, q, step) in tiling.pairs(stock) {
            let (a, b) = (tiling.texels[p], tiling.texels[q]);
            steps += 1;
            let difference = f64::from(stock.difference(a, b));
            let cut = b != a + step as u32;
            if cut {
                mismatches.push(stock.mismatch(a, b, step));
            }
            // The line between them: that before the column or row of the second.
            let line = if step == 1 { q % tiling.width } else { q / tiling.width };
            let (border, middle) = (line % side == 0, line % side == side / 2);
            let places = [cut, border, middle, !(cut || border || middle)];
            for (sum, _) in sums.iter_mut().zip(places).filter(|(_, there)| *there) {
                sum.0 += difference;
                sum.1 += 1;
            }
        }
        mismatches.sort_unstable();
        let count = mismatches.len();
        let total: f64 = mismatches.iter().map(|&mismatch| f64::from(mismatch)).sum();
        let at = |place: usize| f64::from(mismatches.get(place).copied().unwrap_or(0)) / gradient;
        let mean = |(sum, count): (f64, u64)| sum / count.max(1) as f64;
        let elsewhere = mean(sums[3]).max(1.0);
        Self {
            share: count as f64 / steps.max(1) as f64,
            mean: total / count.max(1) as f64 / gradient,
            high: at((count * 95 / 100).min(count.saturating_sub(1))),
            largest: at(count.saturating_sub(1)),
            at_cuts: mean(sums[0]) / elsewhere,
            at_borders: mean(sums[1]) / elsewhere,
            at_middles: mean(sums[2]) / elsewhere,
        }
    }
}

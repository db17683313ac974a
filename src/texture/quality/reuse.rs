//! How much of the examples shows, and how evenly.

use crate::texture::{Quilt, Stock};

/// Numbers on reuse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reuse {
    /// The part of the texels of the examples that show somewhere.
    pub share: f64,
    /// The entropy of where a texel comes from, by that of an even choice.
    pub evenness: f64,
    /// How often the most used texel shows, by the mean.
    pub largest: f64,
}

impl Reuse {
    /// Looks at a tiling.
    pub fn of(stock: &Stock, tiling: &Quilt) -> Self {
        let last = tiling.texels.iter().max().map_or(0, |&texel| texel as usize);
        let mut counts = vec![0u64; last + 1];
        for &texel in &tiling.texels {
            counts[texel as usize] += 1;
        }
        let all = tiling.texels.len().max(1) as f64;
        let used = counts.iter().filter(|&&count| count > 0);
        let entropy: f64 = used
            .clone()
            .map(|&count| {
                let part = count as f64 / all;
                -part * part.log2()
            })
            .sum();
        let texels = stock.texels() as f64;
        let most = counts.iter().max().copied().unwrap_or(0) as f64;
        Self {
            share: used.count() as f64 / texels,
            evenness: entropy / texels.log2().max(1.0),
            largest: most * texels / all,
        }
    }
}

//! How good tiles are, in numbers.
//!
//! They are looked at in a tiling: a quilt as wide as many tiles. The same numbers for other ways
//! to fill the plane ([`super::quilting`], one periodic tile) say what is gained.
//!
//! * [`Seams`]: how badly texels fit where they are cut, against how texels differ anyway;
//! * [`Period`]: how much of the picture comes back with the period of the tiles;
//! * [`Likeness`]: whether colors and small patches are those of the examples;
//! * [`Reuse`]: how much of the examples is used, and how often.

mod likeness;
mod period;
mod reuse;
mod seams;

pub use likeness::{Channel, Likeness};
pub use period::Period;
pub use reuse::Reuse;
pub use seams::Seams;

use super::quilt::Quilt;
use super::stock::Stock;

/// All of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Quality {
    /// Columns and rows of tiles that were looked at.
    pub size: (usize, usize),
    /// Where texels are cut.
    pub seams: Seams,
    /// What comes back.
    pub period: Period,
    /// What colors and patches are like.
    pub likeness: Likeness,
    /// Where texels come from.
    pub reuse: Reuse,
}

impl Quality {
    /// Looks at a tiling by tiles of some size, laid from the north-western corner.
    pub fn of(stock: &Stock, tiling: &Quilt, side: usize, seed: u64) -> Self {
        Self {
            size: (tiling.width / side, tiling.height / side),
            seams: Seams::of(stock, tiling, side),
            period: Period::of(stock, tiling, side),
            likeness: Likeness::of(stock, tiling, seed),
            reuse: Reuse::of(stock, tiling),
        }
    }
}

/// How bright a texel is: the sum of its features.
fn brightness(stock: &Stock, texel: u32) -> f64 {
    stock.light(texel).iter().map(|&sample| f64::from(sample)).sum()
}

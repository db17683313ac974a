//! The direct tiling of the diagonal set: every diagonal a random walk of its own, in closed form.
//!
//! From SW to NE a color doubles and gains a bit. A walk of `n` steps from `a` reaches
//! `2^n a + V` modulo `C`, where the `n` bits of `V` are those gained. So every diagonal `x - y` is cut
//! into pieces of `n` steps, beginning at a random one; the colors at the ends of pieces are random,
//! and of the `V` that lead from one to the next a random one is taken. As `V` and its complement are
//! equally likely, every bit is fair, and NW, SW and SE lie on three diagonals: every tile has the same
//! probability. What lies on one diagonal is not independent, though, and shows as streaks.

use super::TilingError;
use super::hash::{hash3, uni};

/// A tiling of the diagonal set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Diagonal {
    /// Colors.
    pub colors: u32,
    /// Chooses the tiling.
    pub seed: u32,
}

/// Steps of a piece, as a power of two and as they are.
const STEPS: u32 = 16;

impl Diagonal {
    /// The tiling over this many colors.
    ///
    /// # Errors
    /// Fewer than two colors, or more than 128.
    pub fn new(colors: usize, seed: u32) -> Result<Self, TilingError> {
        match (2..=128).contains(&colors) {
            true => Ok(Self { colors: colors as u32, seed }),
            false => Err(TilingError::CompactColors(colors)),
        }
    }

    /// The seeds of its hashes: where pieces begin, the colors there, the steps between.
    pub fn hash_seeds(self) -> [u32; 3] {
        [7, 8, 9].map(|purpose| self.seed.wrapping_add(purpose))
    }

    /// The color of a point.
    pub fn color(self, x: i64, y: i64) -> u8 {
        let c = self.colors;
        let diagonal = x.wrapping_sub(y) as u32;
        let hash =
            |which: usize, piece: i64| hash3(self.hash_seeds()[which], diagonal, piece as u32);
        let along = y.wrapping_add(i64::from(uni(hash(0, 0), STEPS)));
        let (piece, step) = (along >> 4, along as u32 & (STEPS - 1));
        let [from, to] = [piece, piece.wrapping_add(1)].map(|piece| uni(hash(1, piece), c));
        // 2^16 from + V is to modulo C, for V below 2^16 that leave this rest:
        let rest = (to + c * (1 << STEPS) - (from << STEPS)) % c;
        let count = ((1 << STEPS) - 1 - rest) / c + 1;
        let bits = rest + c * uni(hash(2, piece), count);
        (((from << step) + (bits >> (STEPS - step))) % c) as u8
    }
}

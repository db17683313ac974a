//! The direct tiling of the xor set: exactly as random as a tiling of that set can be.
//!
//! Every point has a random bit. Bit `i` of its color is the exclusive or of the bits of those points
//! `(x - j, y - (i - j))` for which `binomial(i, j)` is odd, that is `j & (i - j) = 0`. By Pascal's
//! rule bit `i + 1` of NE is then bit `i` of NW xor bit `i` of SE: the rule of the set; and bit 0 of
//! NE is new. The colors of NW, SW and SE are exactly uniform and independent, and so are any two
//! points; one bit a tile is all that any tiling of a compact set has.

use super::TilingError;
use super::hash::{hash3, key, mix};
use super::rows;

/// A tiling of the xor set over `2^bits` colors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Xor {
    /// Digits of a color.
    pub bits: u32,
    /// Chooses the tiling.
    pub seed: u32,
}

/// Added to the seed: other colorings with the same seed are other hashes.
const PURPOSE: u32 = 5;

impl Xor {
    /// The tiling over this many colors.
    ///
    /// # Errors
    /// A number that is no power of two.
    pub fn new(colors: usize, seed: u32) -> Result<Self, TilingError> {
        match colors.is_power_of_two() && (2..=128).contains(&colors) {
            true => Ok(Self { bits: colors.ilog2(), seed }),
            false => Err(TilingError::NotPowerOfTwo(colors)),
        }
    }

    /// The seed of its hash.
    pub fn hash_seed(self) -> u32 {
        self.seed.wrapping_add(PURPOSE)
    }

    /// The random bit of a point.
    fn bit(self, x: i64, y: i64) -> u8 {
        (hash3(self.hash_seed(), x as u32, y as u32) >> 31) as u8
    }

    /// The color of a point.
    pub fn color(self, x: i64, y: i64) -> u8 {
        let digit = |i: i64| {
            let terms = (0..=i).filter(|j| j & (i - j) == 0);
            terms.fold(0, |sum, j| sum ^ self.bit(x.wrapping_sub(j), y.wrapping_sub(i - j))) << i
        };
        (0..i64::from(self.bits)).map(digit).sum()
    }
}
/// Rows of colors, each the one south of the row before, from the bits of so many rows as a color
/// has digits.
#[derive(Debug)]
pub(super) struct XorRows {
    xor: Xor,
    x: i64,
    /// The random bits of the last rows, that of the row `y` in `y mod bits`; each begins `bits - 1`
    /// points further west.
    bits: Vec<Vec<u8>>,
    /// The southmost row known.
    known: Option<i64>,
}

impl XorRows {
    pub(super) fn new(xor: Xor, x: i64, width: usize) -> Self {
        let rows = xor.bits as usize;
        Self { xor, x, bits: vec![vec![0; width + rows - 1]; rows], known: None }
    }

    /// The colors of the row `y`.
    pub(super) fn row(&mut self, y: i64, colors: &mut [u8]) {
        let count = i64::from(self.xor.bits);
        let place = |y: i64| y.rem_euclid(count) as usize;
        let south = y.wrapping_sub(count - 1);
        let from = match self.known {
            Some(known) if known == south.wrapping_add(1) => known,
            _ => y.wrapping_add(1),
        };
        let mut row = from;
        while row != south {
            row = row.wrapping_sub(1);
            let west = self.x.wrapping_sub(count - 1);
            let first = rows::begun(key(self.xor.hash_seed()), row);
            for (bit, at) in self.bits[place(row)].iter_mut().zip(0..) {
                *bit = (mix((west as u32).wrapping_add(at).wrapping_add(first)) >> 31) as u8;
            }
        }
        self.known = Some(south);
        colors.fill(0);
        for i in 0..count {
            for j in (0..=i).filter(|j| j & (i - j) == 0) {
                let begin = (count - 1 - j) as usize;
                let bits = &self.bits[place(y.wrapping_sub(i - j))][begin..];
                for (color, bit) in colors.iter_mut().zip(bits) {
                    *color ^= bit << i;
                }
            }
        }
    }
}

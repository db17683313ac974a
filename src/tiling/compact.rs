//! Direct tilings of compact sets of corner tiles.
//!
//! Which set, and by which construction, depends on the number of colors; see [`Rule`] for the sets.

use super::{Block4, Diagonal, Rule, TilingError, Xor};

/// A direct tiling of a compact set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Compact {
    /// Of the xor set over a power of two.
    Xor(Xor),
    /// Of the difference set over three colors.
    Block4(Block4),
    /// Of the diagonal set.
    Diagonal(Diagonal),
}

impl Compact {
    /// The tiling that looks best over this many colors.
    ///
    /// # Errors
    /// Numbers of colors without one.
    pub fn of(colors: usize, seed: u32) -> Result<Self, TilingError> {
        match colors {
            3 => Ok(Self::Block4(Block4 { seed })),
            _ if colors.is_power_of_two() => Ok(Self::Xor(Xor::new(colors, seed)?)),
            _ => Err(TilingError::CompactColors(colors)),
        }
    }

    /// Whether it is a tiling over this many colors.
    pub fn has_colors(self, colors: usize) -> bool {
        match self {
            Compact::Xor(xor) => colors == 1 << xor.bits,
            Compact::Block4(_) => colors == 3,
            Compact::Diagonal(diagonal) => colors == diagonal.colors as usize,
        }
    }

    /// The tiles that it shows.
    pub fn rule(self) -> Rule {
        match self {
            Compact::Xor(_) => Rule::Xor,
            Compact::Block4(_) => Rule::Difference,
            Compact::Diagonal(_) => Rule::Diagonal,
        }
    }

    /// The seed.
    pub fn seed(self) -> u32 {
        match self {
            Compact::Xor(xor) => xor.seed,
            Compact::Block4(block) => block.seed,
            Compact::Diagonal(diagonal) => diagonal.seed,
        }
    }

    /// The color of a point.
    pub fn color(self, x: i64, y: i64) -> u8 {
        match self {
            Compact::Xor(xor) => xor.color(x, y),
            Compact::Block4(block) => block.color(x, y),
            Compact::Diagonal(diagonal) => diagonal.color(x, y),
        }
    }
}

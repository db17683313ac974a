//! Direct tilings of compact sets of corner tiles.
//!
//! Which set, and by which construction, depends on the number of colors; see [`Rule`] for the sets.

use super::{Block4, Diagonal, Frames, Rule, TilingError, Xor};

/// A direct tiling of a compact set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Compact {
    /// Of the xor set over a power of two.
    Xor(Xor),
    /// Of the difference set over three colors.
    Block4(Block4),
    /// Of the difference set over any number of colors.
    Frames(Frames),
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
            _ if colors.is_power_of_two() && colors > 1 => Ok(Self::Xor(Xor::new(colors, seed)?)),
            _ => Ok(Self::Frames(Frames::new(colors, seed)?)),
        }
    }

    /// Whether it is a tiling over this many colors.
    pub fn has_colors(self, colors: usize) -> bool {
        match self {
            Compact::Xor(xor) => colors == 1 << xor.bits,
            Compact::Block4(_) => colors == 3,
            Compact::Frames(frames) => colors == frames.colors(),
            Compact::Diagonal(diagonal) => colors == diagonal.colors as usize,
        }
    }

    /// The tiles that it shows.
    pub fn rule(self) -> Rule {
        match self {
            Compact::Xor(_) => Rule::Xor,
            Compact::Block4(_) | Compact::Frames(_) => Rule::Difference,
            Compact::Diagonal(_) => Rule::Diagonal,
        }
    }

    /// The seed.
    pub fn seed(self) -> u32 {
        match self {
            Compact::Xor(xor) => xor.seed,
            Compact::Block4(block) => block.seed,
            Compact::Frames(frames) => frames.seed(),
            Compact::Diagonal(diagonal) => diagonal.seed,
        }
    }

    /// The color of a point.
    pub fn color(self, x: i64, y: i64) -> u8 {
        match self {
            Compact::Xor(xor) => xor.color(x, y),
            Compact::Block4(block) => block.color(x, y),
            Compact::Frames(frames) => frames.color(x, y),
            Compact::Diagonal(diagonal) => diagonal.color(x, y),
        }
    }

    /// Bits of freedom of a tile: of the diagonal set up to a millionth, of frames at least.
    pub fn entropy(self) -> f64 {
        match self {
            Compact::Xor(_) | Compact::Diagonal(_) => 1.0,
            Compact::Block4(_) => 0.996_64,
            Compact::Frames(frames) => frames.entropy(),
        }
    }
}

//! Colors and numbers of colors.
//!
//! Colors are 0, 1, 2, … and mean nothing but "same" or "different". Corner tiles have one
//! palette. The horizontal edges (north, south) and the vertical edges (east, west) of Wang
//! tiles never meet, so they have palettes of their own, of `CH` and `CV` colors.

use super::TileError;
use std::fmt;
use std::str::FromStr;

/// The largest number of colors of a palette: the number of a tile then still fits 32 bits.
pub const MAX_COLORS: u16 = 255;

/// A color, 0-based.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Color(pub u8);

impl fmt::Display for Color {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}

/// How many colors the palettes have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Colors {
    horizontal: u8,
    vertical: u8,
}

impl Colors {
    /// One palette of `count` colors for every corner or edge.
    ///
    /// # Errors
    /// When `count` is 0 or above [`MAX_COLORS`].
    pub fn one(count: u64) -> Result<Self, TileError> {
        Self::pair(count, count)
    }

    /// `horizontal` colors for north and south edges, `vertical` ones for east and west edges.
    ///
    /// # Errors
    /// When either is 0 or above [`MAX_COLORS`].
    pub fn pair(horizontal: u64, vertical: u64) -> Result<Self, TileError> {
        let check = |count: u64| {
            u8::try_from(count)
                .ok()
                .filter(|&c| c > 0 && u16::from(c) <= MAX_COLORS)
                .ok_or(TileError::ColorCount { count, max: u64::from(MAX_COLORS) })
        };
        Ok(Self { horizontal: check(horizontal)?, vertical: check(vertical)? })
    }

    /// Colors of north and south edges (`CH`); the one palette of corner tiles.
    pub fn horizontal(self) -> usize {
        usize::from(self.horizontal)
    }

    /// Colors of east and west edges (`CV`); the one palette of corner tiles.
    pub fn vertical(self) -> usize {
        usize::from(self.vertical)
    }

    /// The larger of the two numbers.
    pub fn largest(self) -> usize {
        self.horizontal().max(self.vertical())
    }

    /// The palette of the vertical edges for both: what a ring of dominoes along a row has.
    pub fn of_row(self) -> Self {
        Self { horizontal: self.vertical, vertical: self.vertical }
    }

    /// The palette of the horizontal edges for both: what a ring of dominoes down a column has.
    pub fn of_column(self) -> Self {
        Self { horizontal: self.horizontal, vertical: self.horizontal }
    }

    /// The number of colors when both palettes have the same size.
    pub fn single(self) -> Option<usize> {
        (self.horizontal == self.vertical).then_some(self.horizontal())
    }
}

impl fmt::Display for Colors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.single() {
            Some(count) => write!(f, "{count}"),
            None => write!(f, "{},{}", self.horizontal, self.vertical),
        }
    }
}

impl FromStr for Colors {
    type Err = TileError;

    fn from_str(text: &str) -> Result<Self, TileError> {
        let number = |part: &str| {
            let digits = part.trim();
            if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
                return Err(TileError::ColorSyntax(text.to_owned()));
            }
            // More digits than a u64 holds are certainly more colors than we handle.
            Ok(digits.parse::<u64>().unwrap_or(u64::MAX))
        };
        match text.split_once(',') {
            None => Self::one(number(text)?),
            Some((h, v)) => Self::pair(number(h)?, number(v)?),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parses_and_prints() {
        for text in ["1", "3", "255", "2,3", "255,1"] {
            assert_eq!(text.parse::<Colors>().unwrap().to_string(), text);
        }
        assert_eq!("4,4".parse::<Colors>().unwrap().to_string(), "4");
    }

    #[test]
    fn refuses_bad_counts() {
        for text in ["0", "256", "2,0", "0,2", "99999999999999999999999"] {
            assert!(matches!(text.parse::<Colors>(), Err(TileError::ColorCount { .. })), "{text}");
        }
        for text in ["", "x", "-1", "2,", "2,3,4", "+2", "1.5"] {
            assert!(matches!(text.parse::<Colors>(), Err(TileError::ColorSyntax(_))), "{text}");
        }
    }
}

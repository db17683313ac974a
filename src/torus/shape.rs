//! The shape of a torus and its wrap-around.
//!
//! Cells are numbered row by row from the north-west: `cell = row * width + column`.

use crate::tiles::{Colors, Kind, Members, TileSet};
use std::fmt;
use std::str::FromStr;

/// A cell of a torus, numbered row by row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Cell(pub u32);

impl Cell {
    /// The number as an array index.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// The width and height of a torus, both at least 1, with fewer than 2^32 cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Shape {
    width: u32,
    height: u32,
}

/// A size that is no shape of a torus.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ShapeError {
    /// A side is 0.
    #[error("size {0}x{1}: both sides must be at least 1")]
    Empty(u64, u64),
    /// More cells than can be numbered.
    #[error("size {0}x{1}: more than 4294967295 cells")]
    TooLarge(u64, u64),
    /// Not of the form `WxH`.
    #[error("size '{0}': expected WxH, as in 9x9")]
    Syntax(String),
}

impl Shape {
    /// A torus of `width` columns and `height` rows.
    ///
    /// # Errors
    /// When a side is 0 or there are more than `2^32 - 1` cells.
    pub fn new(width: u64, height: u64) -> Result<Self, ShapeError> {
        if width == 0 || height == 0 {
            return Err(ShapeError::Empty(width, height));
        }
        match width.checked_mul(height) {
            Some(cells) if cells <= u64::from(u32::MAX) => {
                Ok(Self { width: width as u32, height: height as u32 })
            }
            _ => Err(ShapeError::TooLarge(width, height)),
        }
    }

    /// The near-square shape for `cells` cells (Schlömer 2012): the height is the largest
    /// divisor not above the square root.
    ///
    /// # Errors
    /// When `cells` is 0 or too large.
    pub fn near_square(cells: u64) -> Result<Self, ShapeError> {
        let height = (1..=cells.isqrt()).rev().find(|&h| cells.is_multiple_of(h)).unwrap_or(1);
        Self::new(cells / height, height)
    }

    /// The shape of a packing of `set` when none is given: a ring along a row for dominoes,
    /// `C^2` x `C^2` (`CV^2` x `CH^2`) for complete sets, else the near-square shape.
    ///
    /// # Errors
    /// When the set has too many tiles for a torus.
    pub fn default_for(set: &TileSet) -> Result<Self, ShapeError> {
        let (h, v) = (set.colors().horizontal() as u64, set.colors().vertical() as u64);
        match (set.kind(), set.members()) {
            (Kind::Domino, _) => Self::new(set.size(), 1),
            (_, Members::Complete) => Self::new(v * v, h * h),
            _ => Self::near_square(set.size()),
        }
    }

    /// The palette of a ring of dominoes of this shape: that of the vertical edges along a
    /// row, that of the horizontal edges down a column.
    pub fn ring_colors(self, colors: Colors) -> Colors {
        if self.height > 1 { colors.of_column() } else { colors.of_row() }
    }

    /// The number of columns.
    pub fn width(self) -> usize {
        self.width as usize
    }

    /// The number of rows.
    pub fn height(self) -> usize {
        self.height as usize
    }

    /// The number of cells.
    pub fn cells(self) -> usize {
        self.width() * self.height()
    }

    /// The cell at this row and column, both already within the torus.
    pub fn cell(self, row: usize, column: usize) -> Cell {
        Cell(row as u32 * self.width + column as u32)
    }

    /// The row and column of a cell.
    pub fn position(self, cell: Cell) -> (usize, usize) {
        ((cell.0 / self.width) as usize, (cell.0 % self.width) as usize)
    }

    /// The cell `rows` further south and `columns` further east, around the seams.
    pub fn step(self, cell: Cell, rows: i64, columns: i64) -> Cell {
        let (row, column) = self.position(cell);
        let row = (row as i64 + rows).rem_euclid(i64::from(self.height));
        let column = (column as i64 + columns).rem_euclid(i64::from(self.width));
        self.cell(row as usize, column as usize)
    }
}

impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

impl FromStr for Shape {
    type Err = ShapeError;

    fn from_str(text: &str) -> Result<Self, ShapeError> {
        let wrong = || ShapeError::Syntax(text.to_owned());
        let (w, h) = text.split_once('x').ok_or_else(wrong)?;
        let side = |digits: &str| {
            if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
                return Err(wrong());
            }
            Ok(digits.parse::<u64>().unwrap_or(u64::MAX))
        };
        Self::new(side(w)?, side(h)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parses_sizes() {
        let shape: Shape = "9x6".parse().unwrap();
        assert_eq!((shape.width(), shape.height(), shape.to_string()), (9, 6, "9x6".to_owned()));
        for text in ["", "9", "9x", "x9", "9X9", "-1x2", "9x9x9", " 9x9"] {
            assert_eq!(text.parse::<Shape>(), Err(ShapeError::Syntax(text.to_owned())));
        }
        assert_eq!("0x3".parse::<Shape>(), Err(ShapeError::Empty(0, 3)));
        assert!(matches!("65536x65536".parse::<Shape>(), Err(ShapeError::TooLarge(..))));
        assert!(matches!("99999999999999999999x1".parse::<Shape>(), Err(ShapeError::TooLarge(..))));
    }

    #[test]
    fn near_square_shapes() {
        for (cells, shape) in [(54, "9x6"), (128, "16x8"), (250, "25x10"), (31, "31x1"), (1, "1x1")]
        {
            assert_eq!(Shape::near_square(cells).unwrap().to_string(), shape);
        }
    }

    #[test]
    fn steps_wrap_around() {
        let shape = Shape::new(5, 3).unwrap();
        assert_eq!(shape.step(shape.cell(0, 0), -1, -1), shape.cell(2, 4));
        assert_eq!(shape.step(shape.cell(2, 4), 4, 6), shape.cell(0, 0));
    }
}

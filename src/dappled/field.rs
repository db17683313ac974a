//! A rectangle of tiles, some of which may still be free.
//!
//! Invariant: `cells` holds `width * height` tiles, row by row from the north, each below the
//! number of tiles that its reader was told, or [`FREE`].

/// A cell that has no tile yet.
pub const FREE: u8 = u8::MAX;

/// Cells in a field at most.
pub const MOST_CELLS: usize = 1 << 30;

/// Tiles in a rectangle.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Field {
    width: usize,
    height: usize,
    cells: Vec<u8>,
}

/// What is no field.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum FieldError {
    /// No cells, or too many.
    #[error("{width}x{height} cells: expected at least one, and at most {MOST_CELLS}")]
    Size {
        /// Columns asked for.
        width: usize,
        /// Rows asked for.
        height: usize,
    },
    /// Cells that do not make the rectangle.
    #[error("{found} cells, expected {width}x{height}")]
    Cells {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
        /// How many cells there are.
        found: usize,
    },
}

impl Field {
    /// A rectangle of cells, row by row from the north.
    ///
    /// # Errors
    /// No cells, too many, or a number of cells that is not `width * height`.
    pub fn new(width: usize, height: usize, cells: Vec<u8>) -> Result<Self, FieldError> {
        match width.checked_mul(height) {
            Some(count) if (1..=MOST_CELLS).contains(&count) => {
                if count == cells.len() {
                    return Ok(Self { width, height, cells });
                }
                Err(FieldError::Cells { width, height, found: cells.len() })
            }
            _ => Err(FieldError::Size { width, height }),
        }
    }

    /// A rectangle whose cells all hold this.
    ///
    /// # Errors
    /// No cells, or too many.
    pub fn filled(width: usize, height: usize, tile: u8) -> Result<Self, FieldError> {
        match width.checked_mul(height) {
            Some(count) if (1..=MOST_CELLS).contains(&count) => {
                Self::new(width, height, vec![tile; count])
            }
            _ => Err(FieldError::Size { width, height }),
        }
    }

    /// As [`Field::new`], of cells that are known to make the rectangle.
    pub(super) fn of(width: usize, height: usize, cells: Vec<u8>) -> Self {
        debug_assert_eq!(cells.len(), width * height);
        Self { width, height, cells }
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// What a cell holds.
    pub fn at(&self, column: usize, row: usize) -> u8 {
        self.cells[row * self.width + column]
    }

    /// Puts a tile in a cell.
    pub fn set(&mut self, column: usize, row: usize, tile: u8) {
        self.cells[row * self.width + column] = tile;
    }

    /// All cells, row by row from the north.
    pub fn cells(&self) -> &[u8] {
        &self.cells
    }

    /// All cells, to be changed.
    pub fn cells_mut(&mut self) -> &mut [u8] {
        &mut self.cells
    }

    /// The rows, from the north.
    pub fn rows(&self) -> impl Iterator<Item = &[u8]> {
        self.cells.chunks(self.width)
    }

    /// Whether every cell has a tile.
    pub fn is_complete(&self) -> bool {
        !self.cells.contains(&FREE)
    }

    /// Whether every cell that is filled here holds the same there.
    pub fn agrees_with(&self, other: &Field) -> bool {
        (self.width, self.height) == (other.width, other.height)
            && self.cells.iter().zip(&other.cells).all(|(&a, &b)| a == FREE || a == b)
    }
}

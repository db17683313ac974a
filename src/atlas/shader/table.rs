//! The table of cells as a texture: what a shader reads instead of a closed form.
//!
//! Tile `t` stands in column `t % width` and row `t / width`; its texel is `row * columns + column`
//! of its cell in the packing, for a tile that is not in it 0. The width is the smallest power of
//! two that makes the texture no higher than wide.

use super::AtlasError;
use crate::tiles::TileId;
use crate::tiling::Cells;

/// The most tiles of a table: a texture of 4096 x 4096.
const MOST: u64 = 1 << 24;

/// Cells by tiles.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CellTable {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// The cell of every tile, row by row.
    pub cells: Vec<u32>,
}

impl CellTable {
    /// The width and height for this many tile numbers.
    pub fn size(numbers: u64) -> (usize, usize) {
        let mut width = 1u64;
        while width * width < numbers {
            width *= 2;
        }
        (width as usize, numbers.div_ceil(width) as usize)
    }

    /// Whether a texture holds this many tile numbers.
    ///
    /// # Errors
    /// More than a texture is made for.
    pub(super) fn check(numbers: u64) -> Result<(), AtlasError> {
        if numbers > MOST {
            return Err(AtlasError::Asked(format!(
                "a table of {numbers} tiles: expected at most {MOST}; complete sets can do without, \
                 by --lookup formula"
            )));
        }
        Ok(())
    }

    /// The table of the cells of all tile numbers of a kind and colors.
    ///
    /// # Errors
    /// More numbers than a texture is made for.
    pub fn new(cells: &Cells) -> Result<Self, AtlasError> {
        let numbers = cells.kind().tiles(cells.colors());
        Self::check(numbers)?;
        let (width, height) = Self::size(numbers);
        let mut table = vec![0; width * height];
        for (place, number) in table.iter_mut().zip(0..numbers as u32) {
            if let Some((row, column)) = cells.find(TileId(number)) {
                *place = cells.shape().cell(row, column).0;
            }
        }
        Ok(Self { width, height, cells: table })
    }
}

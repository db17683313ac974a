//! Where the tiles of a packing lie in its atlas.
//!
//! *Packed*: every tile in the cell where the packing has it, side by side. *By number*: in the
//! order of tile numbers, as sheets usually are; neighbors then do not match.
//!
//! Engines that cut tiles out of the atlas want a *gutter* around each. It shows what lies around
//! the tile in the packing, so a filter that strays into it reads a legal neighbor. (Repeating
//! the border texels, as most tools do, gives colors that no neighbor has.)

use super::AtlasError;
use super::sides::is_square;
use crate::tiles::{Colors, Kind, TileId};
use crate::torus::{Packing, Topology};

/// The order of tiles in the atlas.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Arrangement {
    /// As in the packing.
    Packed,
    /// By tile number, row by row.
    ByNumber,
}

/// What gutters show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gutter {
    /// The neighbors in the packing.
    Neighbor,
    /// The border texels again and again.
    Clamp,
}

/// The cells of an atlas.
#[derive(Debug, Clone)]
pub struct Layout {
    /// What carries the colors.
    pub kind: Kind,
    /// The palettes.
    pub colors: Colors,
    /// Cells of a row.
    pub columns: usize,
    /// The tile of every cell, row by row from the top.
    pub tiles: Vec<TileId>,
    /// Texels of a tile's side.
    pub side: usize,
    /// Texels of the gutter on each side of each tile.
    pub gutter: usize,
    /// Tiles in increasing order, each with the first cell that shows it.
    places: Vec<(TileId, u32)>,
}

/// The most texels a PNG has in a row or column.
const PNG_LIMIT: usize = (1 << 31) - 1;

impl Layout {
    /// The atlas of a packing on a torus.
    ///
    /// # Errors
    /// Dominoes, a board that is no torus, turned squares; sides and gutters that make no sense;
    /// more texels than a PNG can have.
    pub fn new(
        packing: &Packing,
        arrangement: Arrangement,
        side: usize,
        gutter: usize,
    ) -> Result<Self, AtlasError> {
        let asked = |message: String| Err(AtlasError::Asked(message));
        let kind = packing.set.kind();
        if !is_square(kind) {
            return asked("an atlas is made of corner or Wang tiles, not of dominoes".into());
        }
        if packing.board.topology != Topology::Torus || packing.board.rotations {
            let message = "an atlas repeats in both directions: expected a packing on a torus, \
                           of tiles that are not turned";
            return asked(message.into());
        }
        let mut tiles = packing.tiles.clone();
        if arrangement == Arrangement::ByNumber {
            tiles.sort_unstable();
        }
        Self::of_cells(kind, packing.set.colors(), tiles, packing.shape.width(), side, gutter)
    }

    /// The layout of a sheet: its tiles row by row, `columns` in a row.
    ///
    /// # Errors
    /// As [`Layout::new`]; and cells that fill no rectangle.
    pub fn of_cells(
        kind: Kind,
        colors: Colors,
        tiles: Vec<TileId>,
        columns: usize,
        side: usize,
        gutter: usize,
    ) -> Result<Self, AtlasError> {
        let asked = |message: String| Err(AtlasError::Asked(message));
        if side == 0 || side > 4096 {
            return asked(format!("tiles of {side} texels: expected 1 to 4096"));
        }
        if gutter > side {
            return asked(format!("a gutter of {gutter} texels: at most the tile's {side}"));
        }
        if columns == 0 || tiles.is_empty() || !tiles.len().is_multiple_of(columns) {
            let cells = tiles.len();
            return asked(format!("{cells} tiles do not fill rows of {columns}"));
        }
        let mut places: Vec<(TileId, u32)> =
            tiles.iter().enumerate().map(|(cell, &tile)| (tile, cell as u32)).collect();
        places.sort_unstable();
        places.dedup_by_key(|(tile, _)| *tile);
        let layout = Self { kind, colors, columns, tiles, side, gutter, places };
        let (width, height) = (layout.width(), layout.height());
        if width.max(height) > PNG_LIMIT {
            return asked(format!(
                "an atlas of {width} x {height} texels: a PNG has at most {PNG_LIMIT} a side"
            ));
        }
        Ok(layout)
    }

    /// Rows of cells.
    pub fn rows(&self) -> usize {
        self.tiles.len() / self.columns
    }

    /// Texels from tile to tile.
    pub fn block(&self) -> usize {
        self.side + 2 * self.gutter
    }

    /// Texels of a row of the atlas.
    pub fn width(&self) -> usize {
        self.columns * self.block()
    }

    /// Rows of texels.
    pub fn height(&self) -> usize {
        self.rows() * self.block()
    }

    /// The number of mip levels, the atlas itself included, in which no texel shows two tiles,
    /// or a tile and its gutter.
    pub fn levels(&self) -> usize {
        let mut halvings = self.side.trailing_zeros();
        if self.gutter > 0 {
            halvings = halvings.min(self.gutter.trailing_zeros());
        }
        halvings as usize + 1
    }

    /// The cell that shows a tile; of several the first.
    pub fn cell(&self, tile: TileId) -> Option<usize> {
        let at = self.places.binary_search_by_key(&tile, |(tile, _)| *tile).ok()?;
        Some(self.places[at].1 as usize)
    }

    /// Column and row of a cell.
    pub fn position(&self, cell: usize) -> (usize, usize) {
        (cell % self.columns, cell / self.columns)
    }

    /// The different tiles in increasing order, each with its first cell.
    pub fn places(&self) -> impl ExactSizeIterator<Item = (TileId, usize)> + '_ {
        self.places.iter().map(|&(tile, cell)| (tile, cell as usize))
    }
}

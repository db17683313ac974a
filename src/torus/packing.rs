//! A packing as files and people have it: a tile in every cell.
//!
//! This type promises nothing about its tiles; whether they fit and whether each occurs as
//! often as the set asks is for [`crate::verify`] to say.

use super::{Cell, Shape};
use crate::tiles::{TileId, TileSet};

/// Tiles on a torus, claimed to be a packing or covering of a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Packing {
    /// The set whose tiles these should be.
    pub set: TileSet,
    /// The torus.
    pub shape: Shape,
    /// Whether every tile occurs at least once (covering) instead of exactly once (packing).
    pub cover: bool,
    /// The tile of every cell, row by row.
    pub tiles: Vec<TileId>,
}

impl Packing {
    /// The tile in a cell.
    pub fn tile(&self, cell: Cell) -> TileId {
        self.tiles[cell.index()]
    }

    /// The tiles row by row.
    pub fn rows(&self) -> impl Iterator<Item = &[TileId]> {
        self.tiles.chunks(self.shape.width())
    }
}

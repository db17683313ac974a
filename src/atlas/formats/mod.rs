//! The formats of other programs, one file each.
//!
//! What they all tell is a [`Sheet`]: a picture with a tile in every cell. The picture itself is
//! not looked at; its cells lie as those of the packing, so that the packing *is* the tile set.
//!
//! * [`tiled`] and [`tsj`]: tile sets and maps of the map editor Tiled;
//! * [`godot`], [`texturepacker`], [`obj`]: engines and 3-D programs;
//! * [`ktx2`] and [`dds`]: pictures with their mip chain as graphics cards take them;
//! * [`puzzle`]: a sheet for a laser cutter;
//! * [`wangsets`]: the way back, from a tile set of Tiled to its colors.

pub mod dds;
pub mod godot;
pub mod ktx2;
pub mod obj;
pub mod puzzle;
mod texels;
pub mod texturepacker;
pub mod tiled;
pub mod tsj;
pub mod wangsets;
mod wangsets_json;
mod wangsets_xml;

use crate::tiles::TileId;
use crate::torus::Packing;
use std::collections::HashMap;

/// A picture of a packing, as far as others have to know it. All lengths are in texels.
#[derive(Debug, Clone, Copy)]
pub struct Sheet<'a> {
    /// The tiles, on a torus; corner or Wang tiles.
    pub packing: &'a Packing,
    /// The name of the picture, as the file is to say it.
    pub image: &'a str,
    /// The side of a tile.
    pub tile: u64,
    /// What lies around all tiles.
    pub margin: u64,
    /// What lies between two tiles.
    pub spacing: u64,
}

impl Sheet<'_> {
    /// Width and height of the picture.
    pub fn size(&self) -> (u64, u64) {
        let shape = self.packing.shape;
        let length = |cells: usize| {
            let cells = cells as u64;
            2 * self.margin + cells * self.tile + (cells - 1) * self.spacing
        };
        (length(shape.width()), length(shape.height()))
    }

    /// Where the tile of a cell begins: column and row of its first texel.
    pub fn corner(&self, cell: usize) -> (u64, u64) {
        let width = self.packing.shape.width();
        let at = |line: usize| self.margin + line as u64 * (self.tile + self.spacing);
        (at(cell % width), at(cell / width))
    }

    /// The first cell of every tile.
    pub fn cells(&self) -> HashMap<TileId, usize> {
        let mut cells = HashMap::with_capacity(self.packing.tiles.len());
        for (cell, &tile) in self.packing.tiles.iter().enumerate() {
            cells.entry(tile).or_insert(cell);
        }
        cells
    }

    /// The colors of the tile in a cell, in the order of [`crate::tiles::Kind::sides`].
    pub fn sides(&self, cell: usize) -> [u8; 4] {
        let set = &self.packing.set;
        set.kind().unpack(self.packing.tiles[cell], set.colors())
    }
}

/// Text within XML.
pub(super) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            c => escaped.push(c),
        }
    }
    escaped
}

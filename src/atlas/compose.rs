//! The atlas itself: drawn a row of tiles at a time, with its mip levels, and given out as rows
//! of texels, so that an atlas may be larger than memory.

use super::light::Decoder;
use super::{AtlasError, Gutter, Image, Layout, TileImages, chain};
use crate::tiles::TileId;
use crate::torus::{Packing, Shape};
use rayon::prelude::*;
use std::io;

/// Bytes of a row of tiles at most.
const BAND_LIMIT: u64 = 3 << 30;

/// What is drawn.
pub struct Scene<'a> {
    /// Where the tiles go.
    pub layout: &'a Layout,
    /// The packing, for the neighbors that gutters show.
    pub packing: &'a Packing,
    /// What gutters show.
    pub gutter: Gutter,
    /// The pictures of the tiles.
    pub images: &'a dyn TileImages,
}

impl Scene<'_> {
    /// Draws the first `levels` mip levels. `take` gets, for each row of tiles from the top, the
    /// texels of that row in every level.
    ///
    /// # Errors
    /// A tile that cannot be drawn, and what `take` reports.
    pub fn draw(
        &self,
        levels: usize,
        mut take: impl FnMut(usize, &Image) -> io::Result<()>,
    ) -> Result<(), AtlasError> {
        let decoder = Decoder::new(self.images.format());
        let (columns, block) = (self.layout.columns, self.layout.block());
        let cells_of = self.cells_of_tiles();
        // Levels take a third more, and the row of texels is there twice.
        let bytes = (columns * block * block * self.images.format().bytes()) as u64 * 8 / 3;
        if bytes > BAND_LIMIT {
            return Err(AtlasError::Asked(format!(
                "a row of {columns} tiles of {block} texels a side takes {} MiB of memory, the \
                 limit is {}",
                bytes >> 20,
                BAND_LIMIT >> 20
            )));
        }
        for row in self.layout.tiles.chunks(columns) {
            let chains: Vec<Vec<Image>> = row
                .par_iter()
                .map(|&tile| Ok(chain(self.block(tile, &cells_of)?, levels, &decoder)))
                .collect::<Result<_, AtlasError>>()?;
            for level in 0..levels {
                let size = block >> level;
                let mut band = Image::new(columns * size, size, self.images.format());
                for (column, chain) in chains.iter().enumerate() {
                    band.blit(&chain[level], column * size, 0);
                }
                take(level, &band)?;
            }
        }
        Ok(())
    }

    /// All levels in memory.
    ///
    /// # Errors
    /// As [`Scene::draw`].
    pub fn levels(&self, levels: usize) -> Result<Vec<Image>, AtlasError> {
        let (width, height) = (self.layout.width(), self.layout.height());
        let format = self.images.format();
        let mut whole: Vec<Image> =
            (0..levels).map(|level| Image::new(width >> level, height >> level, format)).collect();
        let mut next = vec![0; levels];
        self.draw(levels, |level, band| {
            whole[level].blit(band, 0, next[level]);
            next[level] += band.height();
            Ok(())
        })?;
        Ok(whole)
    }

    /// Where the packing has each tile; only gutters ask.
    fn cells_of_tiles(&self) -> Vec<(TileId, usize)> {
        if self.layout.gutter == 0 || self.gutter == Gutter::Clamp {
            return Vec::new();
        }
        let tiles = self.packing.tiles.iter().enumerate();
        let mut cells: Vec<(TileId, usize)> = tiles.map(|(cell, &tile)| (tile, cell)).collect();
        cells.sort_unstable();
        cells.dedup_by_key(|(tile, _)| *tile);
        cells
    }

    /// A tile with its gutter.
    fn block(&self, tile: TileId, cells: &[(TileId, usize)]) -> Result<Image, AtlasError> {
        let image = self.images.draw(tile)?;
        let (side, gutter) = (self.layout.side, self.layout.gutter);
        if gutter == 0 {
            return Ok(image);
        }
        let block = self.layout.block();
        let mut whole = Image::new(block, block, image.format());
        match self.gutter {
            Gutter::Clamp => {
                let bytes = image.format().bytes();
                for y in 0..block {
                    let from = image.row(y.saturating_sub(gutter).min(side - 1));
                    for (x, texel) in whole.row_mut(y).chunks_exact_mut(bytes).enumerate() {
                        let x = x.saturating_sub(gutter).min(side - 1);
                        texel.copy_from_slice(&from[x * bytes..][..bytes]);
                    }
                }
            }
            Gutter::Neighbor => {
                let at = cells.binary_search_by_key(&tile, |(tile, _)| *tile);
                let cell = at.map(|at| cells[at].1).unwrap_or(0);
                for dy in -1..=1 {
                    for dx in -1..=1 {
                        let there = neighbor(self.packing.shape, cell, dx, dy);
                        let picture = match (dx, dy) {
                            (0, 0) => image.clone(),
                            _ => self.images.draw(self.packing.tiles[there])?,
                        };
                        let (x, from_x, width) = part(dx, side, gutter);
                        let (y, from_y, height) = part(dy, side, gutter);
                        whole.blit(&picture.part(from_x, from_y, width, height), x, y);
                    }
                }
            }
        }
        Ok(whole)
    }
}

/// The cell so many columns and rows from another one, around the torus.
fn neighbor(shape: Shape, cell: usize, dx: isize, dy: isize) -> usize {
    let (width, height) = (shape.width() as isize, shape.height() as isize);
    let (column, row) = (cell as isize % width, cell as isize / width);
    let (column, row) = ((column + dx).rem_euclid(width), (row + dy).rem_euclid(height));
    (row * width + column) as usize
}

/// Of a neighbor in one direction: where it shows, from where on, and how much of it.
fn part(step: isize, side: usize, gutter: usize) -> (usize, usize, usize) {
    match step {
        -1 => (0, side - gutter, gutter),
        0 => (gutter, 0, side),
        _ => (gutter + side, 0, gutter),
    }
}

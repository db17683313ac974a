//! A tiling by the tiles of any packing: the packing repeated, then mixed.
//!
//! Not every set tiles at random, and hardly any closes on a torus by chance. But a packing repeated is
//! a tiling, and a block of it may be taken out and filled again by any tiles that fit around and
//! inside. Blocks of 2 to 7 tiles a side are tried at random places, row by row with a limited search;
//! a block that finds no other filling keeps its own, so every step leaves a tiling, and where the set
//! is rigid nothing changes. (Of a compact set two tiles fit in the north and the west: a block of
//! `b` tiles a side has about `2^(b b) / C^(2b)` fillings, one of which is there.)

use super::{ColorMap, TilingError, hash};
use crate::tiles::{Kind, TileId};
use crate::torus::{Cell, Packing, Shape};
use std::collections::HashMap;

/// A tiling of a torus by the tiles of a packing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mixed {
    /// The tiling.
    pub map: ColorMap,
    /// How many of its cells have another tile than the packing repeated.
    pub changed: usize,
}

/// Cells of a mixed tiling, at most; a larger packing is taken once.
const CELLS: usize = 1 << 13;

/// Sides of blocks.
const BLOCKS: std::ops::RangeInclusive<usize> = 2..=7;

/// Tiles laid in a block at most.
const PATIENCE: usize = 3000;

/// The packing repeated up to four times along each side, mixed; if nothing can be changed, the
/// packing as it is.
///
/// # Errors
/// Dominoes, and cells that do not fit.
pub fn mixed(packing: &Packing, seed: u32) -> Result<Mixed, TilingError> {
    let plain = ColorMap::of(packing)?;
    let shape = packing.shape;
    let times = (1..=4).rev().find(|times| shape.cells() * times * times <= CELLS).unwrap_or(1);
    let (width, height) = (shape.width() * times, shape.height() * times);
    let Ok(large) = Shape::new(width as u64, height as u64) else {
        return Ok(Mixed { map: plain, changed: 0 });
    };
    let rows = (0..height).map(|row| &packing.tiles[row % shape.height() * shape.width()..]);
    let tiles: Vec<TileId> = rows.flat_map(|row| row[..shape.width()].repeat(times)).collect();
    let mut blocks = Blocks::new(packing, large, tiles.clone(), seed);
    for side in BLOCKS.filter(|&side| side < width.min(height)) {
        // Enough for every cell to be in one of them some times.
        for _ in 0..3 * large.cells().div_ceil(side * side) {
            blocks.refill(side);
        }
    }
    let changed = blocks.tiles.iter().zip(&tiles).filter(|(now, then)| now != then).count();
    if changed == 0 {
        return Ok(Mixed { map: plain, changed });
    }
    let mixed = Packing::new(packing.set.clone(), large, true, blocks.tiles);
    Ok(Mixed { map: ColorMap::of(&mixed)?, changed })
}

/// What two neighbors must agree on: one color of Wang tiles, two of corner tiles.
type Seam = [u8; 2];

/// Tiles on a torus, and what fits where.
struct Blocks {
    kind: Kind,
    shape: Shape,
    tiles: Vec<TileId>,
    sides: HashMap<TileId, [u8; 4]>,
    /// The tiles with a north and a west side.
    fitting: HashMap<(Seam, Seam), Vec<TileId>>,
    seed: u32,
    draws: u32,
}

impl Blocks {
    fn new(packing: &Packing, shape: Shape, tiles: Vec<TileId>, seed: u32) -> Self {
        let (kind, colors) = (packing.set.kind(), packing.set.colors());
        let sides = packing.tiles.iter().map(|&tile| (tile, kind.unpack(tile, colors))).collect();
        let mut blocks =
            Self { kind, shape, tiles, sides, fitting: HashMap::new(), seed, draws: 0 };
        let mut all = packing.tiles.clone();
        all.sort_unstable();
        all.dedup();
        for tile in all {
            let [north, _, _, west] = blocks.seams(tile);
            blocks.fitting.entry((north, west)).or_default().push(tile);
        }
        blocks
    }

    /// North, east, south and west of a tile, each as its neighbor there has it too.
    fn seams(&self, tile: TileId) -> [Seam; 4] {
        let [a, b, c, d] = self.sides.get(&tile).copied().unwrap_or_default();
        match self.kind {
            // NE, SE, SW, NW.
            Kind::Corner => [[d, a], [a, b], [c, b], [d, c]],
            _ => [[a, 0], [b, 0], [c, 0], [d, 0]],
        }
    }

    /// A number below `below`.
    fn draw(&mut self, below: usize) -> usize {
        self.draws = self.draws.wrapping_add(1);
        hash::uni(hash::hash3(self.seed, self.draws, 0x006d_6978), below as u32) as usize
    }

    /// Fills a block somewhere again, if the search finds a filling soon.
    fn refill(&mut self, side: usize) {
        let corner = Cell(self.draw(self.shape.cells()) as u32);
        let cells: Vec<Cell> = (0..side * side)
            .map(|at| self.shape.step(corner, (at / side) as i64, (at % side) as i64))
            .collect();
        let before: Vec<TileId> = cells.iter().map(|cell| self.tiles[cell.index()]).collect();
        // Of every cell that is filled: the tiles that fit, the first one tried, how many were.
        let mut tried: Vec<(Vec<TileId>, usize, usize)> = Vec::with_capacity(cells.len());
        let mut laid = 0;
        while let Some(&cell) = cells.get(tried.len()) {
            let at = tried.len();
            let candidates = self.candidates(cell, at / side + 1 == side, at % side + 1 == side);
            let first = self.draw(candidates.len().max(1));
            tried.push((candidates, first, 0));
            // The next one that is left, here or, when none is, at a cell before.
            loop {
                laid += 1;
                let Some((candidates, first, count)) = tried.last_mut() else { break };
                if *count < candidates.len() && laid < PATIENCE {
                    let tile = candidates[(*first + *count) % candidates.len()];
                    *count += 1;
                    self.tiles[cells[tried.len() - 1].index()] = tile;
                    break;
                }
                tried.pop();
            }
            if tried.is_empty() {
                for (cell, tile) in cells.iter().zip(before) {
                    self.tiles[cell.index()] = tile;
                }
                return;
            }
        }
    }

    /// The tiles that fit the neighbors in the north and the west; at the end of a column or a row
    /// of the block also those beyond.
    fn candidates(&self, cell: Cell, last_row: bool, last_column: bool) -> Vec<TileId> {
        let neighbor =
            |rows, columns| self.seams(self.tiles[self.shape.step(cell, rows, columns).index()]);
        let (north, west) = (neighbor(-1, 0)[2], neighbor(0, -1)[1]);
        let east = last_column.then(|| neighbor(0, 1)[3]);
        let south = last_row.then(|| neighbor(1, 0)[0]);
        let fits = |tile: &TileId| {
            let seams = self.seams(*tile);
            east.is_none_or(|east| seams[1] == east) && south.is_none_or(|south| seams[2] == south)
        };
        let fitting = self.fitting.get(&(north, west)).map_or(&[][..], Vec::as_slice);
        fitting.iter().copied().filter(fits).collect()
    }
}

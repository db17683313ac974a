//! A tiling by the tiles of any packing: the packing repeated, then changed at random.
//!
//! Not every set tiles at random: of a compact set two tiles fit on three sides, of others perhaps
//! none. But a packing repeated is a tiling, and where a corner or an edge can have another color such
//! that all tiles around it are still tiles of the packing, so is what comes of that (Glauber
//! dynamics). No step can fail, so nothing has to be taken back; where the set is rigid, nothing
//! changes.

use super::{ColorMap, TilingError, hash};
use crate::torus::{Cell, Lattice, Packing, Shape};
use std::collections::HashSet;

/// A tiling of a torus by the tiles of a packing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mixed {
    /// The tiling.
    pub map: ColorMap,
    /// How many of its labels are not those of the packing repeated.
    pub changed: usize,
}

/// Cells of a mixed tiling, about; a larger packing is repeated once.
const CELLS: usize = 1 << 13;

/// How often every label is tried.
const SWEEPS: u32 = 24;

/// The packing repeated up to four times along each side, mixed; if nothing can be changed, the
/// packing as it is.
///
/// # Errors
/// Dominoes, and cells that do not fit.
pub fn mixed(packing: &Packing, seed: u32) -> Result<Mixed, TilingError> {
    let plain = ColorMap::of(packing)?;
    let (kind, shape) = (plain.kind(), packing.shape);
    let times = (1..=4).rev().find(|times| shape.cells() * times * times <= CELLS).unwrap_or(1);
    let (width, height) = (shape.width() * times, shape.height() * times);
    let Ok(large) = Shape::new(width as u64, height as u64) else {
        return Ok(Mixed { map: plain, changed: 0 });
    };
    let rows = (0..height).map(|row| &packing.tiles[row % shape.height() * shape.width()..]);
    let tiles = rows.flat_map(|row| row[..shape.width()].repeat(times)).collect();
    let mut repeated = Packing::new(packing.set.clone(), large, true, tiles);
    let lattice = Lattice { kind, shape: large };
    let allowed: HashSet<_> = packing.tiles.iter().copied().collect();
    let before = ColorMap::of(&repeated)?;
    let mut labels = before.labels().to_vec();
    let per_cell = lattice.per_cell();
    let mut draws = 0;
    let mut draw = |below: usize| {
        draws += 1;
        hash::uni(hash::hash3(seed, draws, 0x006d_6978), below as u32) as usize
    };
    for _ in 0..SWEEPS as usize * labels.len() {
        let place = draw(labels.len());
        let (cell, which) = (Cell((place / per_cell) as u32), place % per_cell);
        let colors = packing.set.colors();
        let palette = if which == 0 { colors.horizontal() } else { colors.vertical() };
        let kept = std::mem::replace(&mut labels[place], draw(palette) as u8);
        // A corner belongs to four tiles, a north edge also to the tile above, a west edge to that
        // on its left.
        let steps: &[(i64, i64)] = match (per_cell, which) {
            (1, _) => &[(0, 0), (-1, 0), (0, -1), (-1, -1)],
            (_, 0) => &[(0, 0), (-1, 0)],
            _ => &[(0, 0), (0, -1)],
        };
        let fits = |&(rows, columns): &(i64, i64)| {
            let cell = large.step(cell, rows, columns);
            allowed.contains(&lattice.tile(&labels, &packing.set, cell))
        };
        if !steps.iter().all(fits) {
            labels[place] = kept;
        }
    }
    let changed = labels.iter().zip(before.labels()).filter(|(now, then)| now != then).count();
    if changed == 0 {
        return Ok(Mixed { map: plain, changed });
    }
    repeated.tiles = lattice.packing(&labels, &packing.set, true).tiles;
    Ok(Mixed { map: ColorMap::of(&repeated)?, changed })
}

//! One pass in which a cell that repeats too often takes a tile that begins anew in every set, if
//! there is one; else one that breaks nothing, if there is one.
//!
//! Cells are never changed again, and a cell looks back only: the result does not depend on the
//! order, as long as a cell comes after those before it in its row and above it. A field that is
//! dappled already does not change.

use super::super::Limit;
use super::lines::{Run, Runs, Shared};
use super::schedule::Step;
use super::scheme::{Greedy, Layer, NO_SET};
use super::start::mixed;

/// The rectangle while the pass is on.
pub struct Pass<'a> {
    tiles: &'a Shared,
    horizontal: Vec<(&'a Layer<'a>, Runs)>,
    vertical: Vec<(&'a Layer<'a>, Runs)>,
    all: u64,
    seed: u64,
}

impl<'a> Pass<'a> {
    /// At the first cell. `all` are the tiles that there are.
    pub fn new(tiles: &'a Shared, greedy: &'a Greedy<'a>, all: u64, seed: u64) -> Self {
        let (width, height) = tiles.size();
        let runs = |layers: &'a [Layer<'a>], lines| {
            layers.iter().map(|layer| (layer, Runs::new(lines))).collect()
        };
        let horizontal = runs(&greedy.horizontal, height);
        Self { tiles, horizontal, vertical: runs(&greedy.vertical, width), all, seed }
    }

    /// The runs that end before a cell.
    fn before(&self, column: usize, row: usize) -> impl Iterator<Item = (&Layer<'a>, Run)> {
        let horizontal = self.horizontal.iter().map(move |(layer, runs)| (*layer, runs.get(row)));
        let vertical = self.vertical.iter().map(move |(layer, runs)| (*layer, runs.get(column)));
        horizontal.chain(vertical)
    }
}

impl Step for Pass<'_> {
    fn step(&self, column: usize, row: usize, _: (bool, bool)) {
        let cell = row * self.tiles.size().0 + column;
        let (mut old, mut forbidden) = (0, 0);
        for (layer, run) in self.before(column, row) {
            if run.length > 0 && run.label != NO_SET {
                let set = layer.sets[usize::from(run.label)];
                old |= set;
                let limit: &Limit = layer.limits[usize::from(run.label)];
                if limit.at(cell).is_some_and(|limit| run.length >= u64::from(limit)) {
                    forbidden |= set;
                }
            }
        }
        let mut tile = self.tiles.get(column, row);
        if forbidden >> tile & 1 == 1 {
            let anew = self.all & !old;
            let choices = if anew == 0 { self.all & !forbidden } else { anew };
            if choices != 0 {
                tile = choose(choices, mixed(self.seed, cell as u64));
                self.tiles.set(column, row, tile);
            }
        }
        for (layer, runs) in &self.horizontal {
            runs.set(row, runs.get(row).then(layer.set_of[usize::from(tile)]));
        }
        for (layer, runs) in &self.vertical {
            runs.set(column, runs.get(column).then(layer.set_of[usize::from(tile)]));
        }
    }
}

/// One of the tiles of a set that is not empty, all of them alike.
pub fn choose(mut set: u64, random: u64) -> u8 {
    for _ in 0..((random >> 32) * u64::from(set.count_ones())) >> 32 {
        set &= set - 1;
    }
    set.trailing_zeros() as u8
}

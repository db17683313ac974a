//! All fillings of a patch, with the tiles that were in it.
//!
//! Free are the labels that only cells of the patch show. They get their colors one after the
//! other, row by row; a cell whose last label gets its color has become a tile, which must be one
//! of those taken out and not yet used again. With few tiles in a patch nearly every cell decides
//! itself, so the tree is small; tables are made once, and only what belongs to the patch is
//! touched.
//!
//! Invariant: between two searches no tile is counted and `last` holds no place.

use super::Refusal;
use crate::tiles::TileSet;
use crate::torus::{Cell, Lattice, Shape};
use std::ops::ControlFlow;

/// The most tiles that there may be over the colors.
pub const MAX_TILES: u64 = 1 << 26;

/// No free label.
const NONE: u32 = u32::MAX;

/// The patches of one size on a torus, and the tables to fill them.
#[derive(Debug, Clone)]
pub struct Patch {
    shape: Shape,
    width: usize,
    height: usize,
    /// The labels of every cell, in the order of its sides, and how many it has.
    sides: Vec<[u32; 4]>,
    per_tile: usize,
    /// Colors of each side, and what one color more adds to the number of a tile.
    radices: Vec<u8>,
    weights: Vec<u32>,
    /// How many sides show a label, in all and in the patch.
    shown: Vec<u8>,
    inside: Vec<u8>,
    /// For every label its place among the free ones.
    places: Vec<u32>,
    /// Tiles taken out and not yet used again, by number.
    left: Vec<u16>,
    free: Vec<u32>,
    colors: Vec<u8>,
    /// The cells that become tiles at a place, one after the other, and where those of each begin.
    cells: Vec<u32>,
    begins: Vec<u32>,
    /// For each of them the number of its tile when the label of its place has color 0, and what
    /// one color more adds.
    bases: Vec<u32>,
    steps: Vec<u32>,
}

impl Patch {
    /// Patches of `width` columns and `height` rows of cells.
    ///
    /// # Errors
    /// When they do not suit the torus, or there are too many tiles.
    pub fn new(
        set: &TileSet,
        lattice: Lattice,
        width: usize,
        height: usize,
    ) -> Result<Self, Refusal> {
        let (kind, shape) = (lattice.kind, lattice.shape);
        let tiles = kind.tiles(set.colors());
        if tiles > MAX_TILES {
            return Err(Refusal::TooManyTiles(tiles));
        }
        if width > shape.width() || height > shape.height() {
            return Err(Refusal::TooLarge { width, height, shape });
        }
        let radices = kind.radices(set.colors());
        let weight = |side: usize| radices[side + 1..].iter().product::<usize>() as u32;
        let mut shown = vec![0; lattice.labels()];
        let cells = (0..shape.cells() as u32).map(|cell| {
            let mut sides = [0; 4];
            for (side, label) in sides.iter_mut().zip(lattice.sides(Cell(cell))) {
                *side = label as u32;
                shown[label] += 1;
            }
            sides
        });
        let mut patch = Self {
            shape,
            width,
            height,
            sides: cells.collect(),
            per_tile: radices.len(),
            weights: (0..radices.len()).map(weight).collect(),
            radices: radices.iter().map(|&radix| radix.min(255) as u8).collect(),
            inside: vec![0; shown.len()],
            places: vec![NONE; shown.len()],
            left: vec![0; tiles as usize],
            shown,
            free: Vec::new(),
            colors: Vec::new(),
            cells: Vec::new(),
            begins: Vec::new(),
            bases: Vec::new(),
            steps: Vec::new(),
        };
        patch.lay(Cell(0));
        let free = patch.free.len();
        patch.lift();
        if free == 0 { Err(Refusal::Nothing(width, height)) } else { Ok(patch) }
    }

    /// Calls `each` with the colors of the free labels of the patch at `corner`, its north-west
    /// cell, in every filling there is, and whether it is the present one; [`Patch::free`] says
    /// which labels these are. Gives the number of nodes, up to `most`, and whether that was
    /// enough. `labels` is as before afterwards.
    pub fn fillings(
        &mut self,
        labels: &mut [u8],
        corner: Cell,
        most: u64,
        mut each: impl FnMut(&[u8], bool) -> ControlFlow<()>,
    ) -> (u64, bool) {
        self.lay(corner);
        let before: Vec<u8> = self.free.iter().map(|&label| labels[label as usize]).collect();
        for &cell in &self.cells {
            let tile = self.tile(labels, cell);
            self.left[tile] += 1;
        }
        let searched = self.search(labels, most, |filling| each(filling, filling == before));
        // All tiles that were counted are those of the present filling.
        for (&label, color) in self.free.iter().zip(before) {
            labels[label as usize] = color;
        }
        for &cell in &self.cells {
            let tile = self.tile(labels, cell);
            self.left[tile] = 0;
        }
        self.lift();
        searched
    }

    /// The free labels of the patch last filled, in the order of their colors.
    pub fn free(&self) -> &[u32] {
        &self.free
    }

    /// The number of the tile in a cell.
    fn tile(&self, labels: &[u8], cell: u32) -> usize {
        let sides = self.sides[cell as usize].iter().zip(&self.weights);
        sides.map(|(&label, &weight)| u32::from(labels[label as usize]) * weight).sum::<u32>()
            as usize
    }

    /// Lists the free labels and the cells that they complete.
    fn lay(&mut self, corner: Cell) {
        let (width, height) = (self.width as i64, self.height as i64);
        let cell = |i: i64| self.shape.step(corner, i / width, i % width).index();
        let cells: Vec<usize> = (0..width * height).map(cell).collect();
        for &cell in &cells {
            for &label in &self.sides[cell][..self.per_tile] {
                self.inside[label as usize] += 1;
            }
        }
        self.free.clear();
        self.colors.clear();
        for &cell in &cells {
            for (&label, &radix) in self.sides[cell].iter().zip(&self.radices) {
                let at = label as usize;
                if self.inside[at] == self.shown[at] && self.places[at] == NONE {
                    self.places[at] = self.free.len() as u32;
                    self.free.push(label);
                    self.colors.push(radix);
                }
            }
        }
        // A cell becomes a tile with the last of its free labels, if it has any.
        let last = |cell: usize| {
            let places = self.sides[cell][..self.per_tile].iter();
            places.map(|&label| self.places[label as usize]).filter(|&place| place != NONE).max()
        };
        let mut completed: Vec<(u32, u32)> =
            cells.iter().filter_map(|&cell| Some((last(cell)?, cell as u32))).collect();
        completed.sort_unstable();
        let begins = (0..=self.free.len() as u32)
            .map(|place| completed.partition_point(|&(last, _)| last < place) as u32);
        self.begins = begins.collect();
        let step = |&(place, cell): &(u32, u32)| {
            let sides = self.sides[cell as usize].iter().zip(&self.weights);
            let own = sides.filter(|&(&label, _)| label == self.free[place as usize]);
            own.map(|(_, weight)| weight).sum()
        };
        self.steps = completed.iter().map(step).collect();
        self.bases = vec![0; completed.len()];
        self.cells = completed.into_iter().map(|(_, cell)| cell).collect();
        for &cell in &cells {
            for &label in &self.sides[cell][..self.per_tile] {
                self.inside[label as usize] = 0;
            }
        }
    }

    /// Forgets which places the labels have.
    fn lift(&mut self) {
        for &label in &self.free {
            self.places[label as usize] = NONE;
        }
    }

    fn search(
        &mut self,
        labels: &mut [u8],
        most: u64,
        mut each: impl FnMut(&[u8]) -> ControlFlow<()>,
    ) -> (u64, bool) {
        let end = self.free.len();
        // The color to try next, place by place.
        let mut next = vec![0; end];
        let mut filling = vec![0; end];
        let (mut at, mut nodes) = (0, 0);
        self.enter(labels, at);
        loop {
            if next[at] == self.colors[at] {
                let Some(before) = at.checked_sub(1) else { return (nodes, true) };
                at = before;
                self.put_back(at, filling[at]);
                continue;
            }
            let color = next[at];
            next[at] += 1;
            if !self.take(at, color) {
                continue;
            }
            if nodes == most {
                return (nodes, false);
            }
            nodes += 1;
            filling[at] = color;
            if at + 1 < end {
                labels[self.free[at] as usize] = color;
                at += 1;
                next[at] = 0;
                self.enter(labels, at);
                continue;
            }
            if each(&filling).is_break() {
                return (nodes, false);
            }
            self.put_back(at, color);
        }
    }

    /// Prepares the tiles that a place completes: all but its own label is known.
    #[inline]
    fn enter(&mut self, labels: &mut [u8], at: usize) {
        labels[self.free[at] as usize] = 0;
        for i in self.begins[at] as usize..self.begins[at + 1] as usize {
            self.bases[i] = self.tile(labels, self.cells[i]) as u32;
        }
    }

    /// Takes the tiles that a color at a place completes, if all of them are there.
    #[inline]
    fn take(&mut self, at: usize, color: u8) -> bool {
        let Self { begins, bases, steps, left, .. } = self;
        let cells = begins[at] as usize..begins[at + 1] as usize;
        let tile = |i: usize| (bases[i] + steps[i] * u32::from(color)) as usize;
        for i in cells.clone() {
            if left[tile(i)] == 0 {
                (cells.start..i).for_each(|i| left[tile(i)] += 1);
                return false;
            }
            left[tile(i)] -= 1;
        }
        true
    }

    /// Takes back what was taken with a color at a place.
    #[inline]
    fn put_back(&mut self, at: usize, color: u8) {
        let Self { begins, bases, steps, left, .. } = self;
        for i in begins[at] as usize..begins[at + 1] as usize {
            left[(bases[i] + steps[i] * u32::from(color)) as usize] += 1;
        }
    }
}

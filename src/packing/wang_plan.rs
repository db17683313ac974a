//! What a Wang tile in a cell decides, prepared before the search.
//!
//! For every orbit of cells in the visiting order: which neighbors are placed before, and the
//! tiles that may ever stand there, by the labels given beforehand, as neighbors of their own
//! images, and without needing a tile twice.

use super::Task;
use super::quotient::Quotient;
use super::reduction::Reduction;
use crate::search::{Alternatives, Words};
use crate::tiles::{Kind, TileId};
use crate::torus::{Cell, Order};
use std::collections::HashMap;

/// The neighbors of a cell, in the order of the sides N, E, S, W: rows and columns to go, and
/// the side by which the neighbor touches.
pub const NEIGHBORS: [(i64, i64, usize); 4] = [(-1, 0, 2), (0, 1, 3), (1, 0, 0), (0, -1, 1)];

/// What is decided by the tile of one orbit of cells.
///
/// Cells have *slots*: first those whose tile is chosen, in the order of the levels, then all
/// others, last a dummy.
#[derive(Debug, Clone)]
pub struct Step<const N: usize> {
    /// The cell whose tile is chosen.
    pub cell: Cell,
    /// The slots of the neighbors placed before, or of the dummy.
    pub neighbors: [u32; 4],
    /// The tiles that may ever stand there.
    pub ever: Words<N>,
    /// The slots of the orbit, one step of the automorphism after the other, its own first.
    pub orbit: Vec<u32>,
}

/// The steps of a search over cells, for at most `64 * N` tiles.
#[derive(Debug, Clone)]
pub struct WangPlan<const N: usize> {
    /// By tile: the colors of its sides N, E, S, W.
    pub tiles: Vec<[u8; 4]>,
    /// By tile: its images under 0, 1, … steps of the automorphism.
    pub images: Vec<Vec<u32>>,
    /// The steps known beforehand.
    pub known: Vec<Step<N>>,
    /// One step a level.
    pub steps: Vec<Step<N>>,
    /// By cell: its slot.
    pub slots: Vec<u32>,
}

impl<const N: usize> WangPlan<N> {
    /// Plans the visits of all orbits; `None` when the reduction and the pins disagree.
    pub fn new(task: &Task, reduction: &Reduction) -> Option<Self> {
        let quotient = Quotient::new(task);
        let mut given = task.pins.labels().to_vec();
        for (place, color) in reduction.fixed_labels(task) {
            if given[place].is_some_and(|known| known != color) {
                return None;
            }
            given[place] = Some(color);
        }
        let colors = task.set.colors();
        let numbers: Vec<TileId> = task.set.allowed().collect();
        let dense: HashMap<TileId, u32> = numbers.iter().copied().zip(0..).collect();
        let images = |&tile: &TileId| -> Vec<u32> {
            let maps = quotient.maps().iter();
            maps.filter_map(|map| dense.get(&map.tile(Kind::Wang, colors, tile)).copied()).collect()
        };
        let mut plan = Self {
            tiles: numbers.iter().map(|&tile| Kind::Wang.unpack(tile, colors)).collect(),
            images: numbers.iter().map(images).collect(),
            known: Vec::new(),
            steps: Vec::new(),
            slots: vec![u32::MAX; task.shape.cells()],
        };
        plan.visit(task, &quotient, &given);
        Some(plan)
    }

    fn visit(&mut self, task: &Task, quotient: &Quotient, given: &[Option<u8>]) {
        let (shape, lattice) = (task.shape, task.lattice());
        let all_given = |cell| lattice.sides(cell).into_iter().all(|place| given[place].is_some());
        let is_known = |&cell: &Cell| quotient.orbit(cell).any(all_given);
        let mut visits = task.visiting_order().cells(shape);
        visits.sort_by_key(|cell| !is_known(cell));
        let first = quotient.first_visits(&visits);
        let representatives = quotient.representatives(&visits);
        let known = representatives.iter().take_while(|cell| is_known(cell)).count();
        let chosen = representatives[known..].iter().copied();
        for (slot, cell) in chosen.chain(Order::Row.cells(shape)).enumerate() {
            let free = &mut self.slots[cell.index()];
            *free = (*free).min(slot as u32);
        }
        self.number_slots();
        let dummy = shape.cells() as u32;
        let once: Vec<bool> =
            (0..self.tiles.len()).map(|tile| self.fits_once(task, quotient, tile)).collect();
        for cell in representatives {
            let own = first[cell.index()];
            let neighbors = NEIGHBORS.map(|(rows, columns, _)| {
                let neighbor = shape.step(cell, rows, columns).index();
                if first[neighbor] < own { self.slots[neighbor] } else { dummy }
            });
            let orbit: Vec<Cell> = quotient.orbit(cell).collect();
            let mut ever = Words::EMPTY;
            for tile in (0..self.tiles.len()).filter(|&tile| once[tile]) {
                if self.fits_given(task, given, &orbit, tile)
                    && self.fits_itself(task, &orbit, tile)
                {
                    ever.insert(tile as u32);
                }
            }
            let orbit = orbit.into_iter().map(|cell| self.slots[cell.index()]).collect();
            let step = Step { cell, neighbors, ever, orbit };
            if self.known.len() < known { self.known.push(step) } else { self.steps.push(step) }
        }
    }

    /// Makes the slots consecutive, in the order of what they were.
    fn number_slots(&mut self) {
        let mut order: Vec<usize> = (0..self.slots.len()).collect();
        order.sort_by_key(|&cell| self.slots[cell]);
        for (slot, cell) in order.into_iter().enumerate() {
            self.slots[cell] = slot as u32;
        }
    }

    /// In a packing a tile and its images must differ, and of a class at most two may occur.
    fn fits_once(&self, task: &Task, quotient: &Quotient, tile: usize) -> bool {
        let mut images = self.images[tile].clone();
        images.sort_unstable();
        images.dedup();
        let class = |tile: u32| [0, 3].map(|side| self.tiles[tile as usize][side]);
        let of_class = images.iter().filter(|&&image| class(image) == class(tile as u32)).count();
        (task.cover || images.len() == quotient.order()) && !(task.set.is_compact() && of_class > 2)
    }

    /// Whether a tile and its images show the labels given on the orbit.
    fn fits_given(&self, task: &Task, given: &[Option<u8>], orbit: &[Cell], tile: usize) -> bool {
        orbit.iter().zip(&self.images[tile]).all(|(&cell, &image)| {
            let places = task.lattice().sides(cell).into_iter();
            places
                .zip(self.tiles[image as usize])
                .all(|(place, color)| given[place].is_none_or(|pin| pin == color))
        })
    }

    /// Whether a tile matches those of its images that are its neighbors.
    fn fits_itself(&self, task: &Task, orbit: &[Cell], tile: usize) -> bool {
        NEIGHBORS.iter().enumerate().all(|(side, &(rows, columns, touching))| {
            let neighbor = task.shape.step(orbit[0], rows, columns);
            let mut images = orbit.iter().zip(&self.images[tile]);
            images.all(|(&cell, &image)| {
                cell != neighbor || self.tiles[tile][side] == self.tiles[image as usize][touching]
            })
        })
    }

    /// For every tile the tiles that may stand to its N, E, S and W.
    pub fn partners(&self) -> Vec<[Words<N>; 4]> {
        let mut showing: HashMap<(usize, u8), Words<N>> = HashMap::new();
        for (tile, sides) in self.tiles.iter().enumerate() {
            for (side, &color) in sides.iter().enumerate() {
                showing.entry((side, color)).or_insert(Words::EMPTY).insert(tile as u32);
            }
        }
        let partners = |sides: &[u8; 4]| {
            std::array::from_fn(|side| {
                let touching = NEIGHBORS[side].2;
                showing.get(&(touching, sides[side])).copied().unwrap_or(Words::EMPTY)
            })
        };
        self.tiles.iter().map(partners).collect()
    }

    /// By the numbers of colors used of the two palettes, the first times `stride`: the tiles
    /// that may follow in a fixed order of colors, one that shows, besides colors used before,
    /// only the next ones, its sides taken in the order N, S and E, W.
    pub fn follow(&self, palettes: (usize, usize), stride: usize) -> Vec<Words<N>> {
        let in_order = |used: usize, a: u8, b: u8| {
            let (a, b) = (usize::from(a), usize::from(b));
            a <= used && b <= used.max(a + 1)
        };
        let mut follow = vec![Words::EMPTY; (palettes.0 + 1) * stride];
        for (numbers, follow) in follow.iter_mut().enumerate() {
            let (used_h, used_v) = (numbers / stride, numbers % stride);
            for (tile, &[n, e, s, w]) in self.tiles.iter().enumerate() {
                if in_order(used_h, n, s) && in_order(used_v, e, w) {
                    follow.insert(tile as u32);
                }
            }
        }
        follow
    }
}

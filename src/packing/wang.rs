//! Wang packings: whole tiles in cells.
//!
//! The candidates of a cell are the tiles the law of the set leaves open ([`WangRule`]), AND
//! those that match each neighbor already placed, AND those that may ever stand in this cell
//! (labels given beforehand, neighbors of its own orbit). Tiles are numbered densely in the
//! order of the set, so that a set of `n` tiles takes `n/64` words, whatever its colors.
//!
//! Invariant: `sides` holds the colors of all cells at levels pushed, on the level of orbits;
//! `rule` holds exactly their tiles.

use super::quotient::Quotient;
use super::reduction::Reduction;
use super::wang_rule::WangRule;
use super::{Labeled, Task, TaskError};
use crate::search::{Alternatives, Problem, Words};
use crate::tiles::{Kind, TileId};
use crate::torus::{Cell, Order};
use std::collections::HashMap;

/// The neighbors of a cell, in the order of the sides N, E, S, W: rows and columns to go, and
/// the side by which the neighbor touches.
const NEIGHBORS: [(i64, i64, usize); 4] = [(-1, 0, 2), (0, 1, 3), (1, 0, 0), (0, -1, 1)];

/// Which labels of a cell to give: dominoes have but one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// North and west.
    Both,
    /// North: a ring of dominoes down a column.
    North,
    /// West: a ring of dominoes along a row.
    West,
}

#[derive(Debug, Clone)]
struct Step {
    cell: u32,
    /// The neighbors placed before, or the dummy cell.
    neighbors: [u32; 4],
    /// The cells of its orbit, one step of the automorphism after the other, itself first.
    orbit: Vec<u32>,
}

/// The search for Wang packings under a rule; `QUOTIENT` with a prescribed automorphism.
#[derive(Debug, Clone)]
pub struct Wang<const N: usize, R, const QUOTIENT: bool> {
    steps: Vec<Step>,
    /// By level: the tiles that may ever stand there.
    ever: Vec<Words<N>>,
    /// By side and color: the tiles that show it; for the dummy color, all.
    showing: [Vec<Words<N>>; 4],
    /// By tile: the colors of its sides N, E, S, W.
    tiles: Vec<[u8; 4]>,
    /// By tile: its images under 0, 1, … steps of the automorphism.
    images: Vec<Vec<u32>>,
    /// By cell: the colors of its sides; the dummy cell shows the dummy color.
    sides: Vec<[u8; 4]>,
    rule: R,
    shown: Shown,
    /// By level: colors of the two palettes used before it, when their order is fixed.
    used: Vec<(u8, u8)>,
    /// By those numbers, the first times `stride`: the tiles that may follow.
    follow: Vec<Words<N>>,
    stride: usize,
}

impl<const N: usize, R: WangRule<N>, const QUOTIENT: bool> Wang<N, R, QUOTIENT> {
    /// The problem of a task that has been checked, for a set of at most `64 * N` tiles.
    ///
    /// `Ok(None)` means that what the reduction fixes already contradicts itself.
    ///
    /// # Errors
    /// When the pins contradict each other.
    pub fn new(
        task: &Task,
        reduction: &Reduction,
        shown: Shown,
        rule: R,
    ) -> Result<Option<Self>, TaskError> {
        let quotient = Quotient::new(task);
        let (set, colors) = (&task.set, task.set.colors());
        let numbers: Vec<TileId> = set.allowed().collect();
        let tiles: Vec<[u8; 4]> = numbers.iter().map(|&t| Kind::Wang.unpack(t, colors)).collect();
        let dummy = colors.largest();
        let mut showing: [Vec<Words<N>>; 4] =
            std::array::from_fn(|_| vec![Words::EMPTY; dummy + 1]);
        for (side, showing) in showing.iter_mut().enumerate() {
            for (tile, sides) in tiles.iter().enumerate() {
                showing[usize::from(sides[side])].insert(tile as u32);
            }
            showing[dummy] = Words::ALL;
        }
        let dense: HashMap<TileId, u32> = numbers.iter().copied().zip(0..).collect();
        let image = |&tile: &TileId| -> Vec<u32> {
            let maps = quotient.maps().iter();
            maps.filter_map(|map| dense.get(&map.tile(Kind::Wang, colors, tile)).copied()).collect()
        };
        let images: Vec<Vec<u32>> = numbers.iter().map(image).collect();
        let mut given = task.pins.labels().to_vec();
        for (place, color) in reduction.fixed_labels(task) {
            if given[place].is_some_and(|known| known != color) {
                return Ok(None);
            }
            given[place] = Some(color);
        }
        let mut problem = Self {
            steps: Vec::new(),
            ever: Vec::new(),
            showing,
            tiles,
            images,
            sides: vec![[dummy as u8; 4]; task.shape.cells() + 1],
            rule,
            shown,
            used: Vec::new(),
            follow: Vec::new(),
            stride: colors.vertical() + 1,
        };
        problem.plan(task, &quotient, &given);
        problem.order_colors(task, reduction);
        match problem.place_fixed(task, &quotient, &given) {
            Ok(()) => Ok(Some(problem)),
            Err(_) if !task.has_pins() => Ok(None),
            Err(cell) => {
                let (row, column) = task.shape.position(Cell(cell));
                let message = format!("no tile is left for row {row}, column {column}");
                Err(TaskError::Pins(message))
            }
        }
    }

    /// One step for every orbit, those known beforehand first.
    fn plan(&mut self, task: &Task, quotient: &Quotient, given: &[Option<u8>]) {
        let shape = task.shape;
        let mut visits = task.order.unwrap_or(Order::Row).cells(shape);
        visits.sort_by_key(|&cell| !is_known(task, quotient, given, cell));
        let first = quotient.first_visits(&visits);
        let nowhere = shape.cells() as u32;
        for cell in quotient.representatives(&visits) {
            let own = first[cell.index()];
            let neighbors = NEIGHBORS.map(|(rows, columns, _)| {
                let neighbor = shape.step(cell, rows, columns);
                if first[neighbor.index()] < own { neighbor.0 } else { nowhere }
            });
            let orbit: Vec<u32> = quotient.orbit(cell).map(|cell| cell.0).collect();
            self.ever.push(self.ever_at(task, quotient, given, cell, &orbit));
            self.steps.push(Step { cell: cell.0, neighbors, orbit });
        }
    }

    /// The tiles that may ever stand in a cell: by the labels given on its orbit, as neighbors
    /// of their own images, and without needing a tile twice.
    fn ever_at(
        &self,
        task: &Task,
        quotient: &Quotient,
        given: &[Option<u8>],
        cell: Cell,
        orbit: &[u32],
    ) -> Words<N> {
        let lattice = task.lattice();
        let mut ever = Words::EMPTY;
        for (tile, images) in self.images.iter().enumerate() {
            let sides_at = |power: usize| self.tiles[images[power] as usize];
            let fits_given = orbit.iter().enumerate().all(|(power, &cell)| {
                let places = lattice.sides(Cell(cell));
                places
                    .iter()
                    .zip(sides_at(power))
                    .all(|(&place, color)| given[place].is_none_or(|pin| pin == color))
            });
            let fits_itself =
                NEIGHBORS.iter().enumerate().all(|(side, &(rows, columns, touching))| {
                    let neighbor = task.shape.step(cell, rows, columns).0;
                    let powers = orbit.iter().enumerate().filter(|&(_, &image)| image == neighbor);
                    powers
                        .into_iter()
                        .all(|(power, _)| self.tiles[tile][side] == sides_at(power)[touching])
                });
            if fits_given && fits_itself && self.fits_once(task, quotient, tile) {
                ever.insert(tile as u32);
            }
        }
        ever
    }

    /// In a packing a tile and its images must differ, and of a class at most two may occur.
    fn fits_once(&self, task: &Task, quotient: &Quotient, tile: usize) -> bool {
        let mut images = self.images[tile].clone();
        images.sort_unstable();
        images.dedup();
        let fixed = |tile: u32| [0, 3].map(|side| self.tiles[tile as usize][side]);
        let of_class = images.iter().filter(|&&image| fixed(image) == fixed(tile as u32)).count();
        (task.cover || images.len() == quotient.order()) && !(task.set.is_compact() && of_class > 2)
    }

    /// Prepares the fixed order of colors: a tile may show, besides colors used before, only
    /// the next ones, its sides taken in the order N, S and E, W.
    fn order_colors(&mut self, task: &Task, reduction: &Reduction) {
        self.used = vec![(0, 0); self.steps.len() + 1];
        let Some(from) = reduction.ordered_from else { return };
        self.used[0] = (from as u8, from as u8);
        let (h, v) = (task.set.colors().horizontal(), task.set.colors().vertical());
        self.follow = vec![Words::EMPTY; (h + 1) * (v + 1)];
        for used_h in 0..=h {
            for used_v in 0..=v {
                let follow = &mut self.follow[used_h * (v + 1) + used_v];
                for (tile, &[n, e, s, w]) in self.tiles.iter().enumerate() {
                    let in_order = |used: usize, a: u8, b: u8| {
                        let (a, b) = (usize::from(a), usize::from(b));
                        a <= used && b <= used.max(a + 1)
                    };
                    if in_order(used_h, n, s) && in_order(used_v, e, w) {
                        follow.insert(tile as u32);
                    }
                }
            }
        }
    }

    /// Places the tiles known beforehand and drops their steps; names the cell that
    /// contradicts.
    fn place_fixed(
        &mut self,
        task: &Task,
        quotient: &Quotient,
        given: &[Option<u8>],
    ) -> Result<(), u32> {
        let known = |step: &Step| is_known(task, quotient, given, Cell(step.cell));
        let fixed = self.steps.iter().take_while(|step| known(step)).count();
        let used = self.used[0];
        for level in 0..fixed {
            let mut candidates = self.candidates(level);
            if QUOTIENT && !R::EXACT {
                candidates = self.tried(candidates);
            }
            if candidates.is_empty() {
                return Err(self.steps[level].cell);
            }
            self.push(level, candidates.take_first());
        }
        if let Some(level) = self.ever.iter().position(Words::is_empty) {
            return Err(self.steps[level].cell);
        }
        self.steps.drain(..fixed);
        self.ever.drain(..fixed);
        self.used.drain(..fixed);
        if self.follow.is_empty() {
            self.used.fill((0, 0));
        } else {
            self.used[0] = used;
        }
        Ok(())
    }

    #[inline(always)]
    fn candidates(&self, level: usize) -> Words<N> {
        let step = &self.steps[level];
        let mut candidates = self.rule.open() & self.ever[level];
        for (side, &(_, _, touching)) in NEIGHBORS.iter().enumerate() {
            let color = self.sides[step.neighbors[side] as usize][touching];
            candidates &= self.showing[side][usize::from(color)];
        }
        candidates
    }

    /// Of some candidates those whose images may be placed along with them.
    #[inline(never)]
    fn tried(&mut self, candidates: Words<N>) -> Words<N> {
        let mut fitting = candidates;
        for tile in candidates.numbers() {
            let mut placed = 0;
            let mut fits = true;
            for &image in &self.images[tile as usize] {
                fits &= self.rule.open().contains(image);
                self.rule.take(image);
                placed += 1;
            }
            fits &= self.rule.holds();
            for &image in self.images[tile as usize][..placed].iter().rev() {
                self.rule.release(image);
            }
            if !fits {
                fitting.remove(tile);
            }
        }
        fitting
    }
}

/// Whether all labels of a cell, or of an image of it, are given beforehand.
fn is_known(task: &Task, quotient: &Quotient, given: &[Option<u8>], cell: Cell) -> bool {
    let lattice = task.lattice();
    let known = |cell: Cell| lattice.sides(cell).into_iter().all(|place| given[place].is_some());
    quotient.orbit(cell).any(known)
}

impl<const N: usize, R: WangRule<N>, const QUOTIENT: bool> Problem for Wang<N, R, QUOTIENT> {
    type Alternatives = Words<N>;

    fn levels(&self) -> usize {
        self.steps.len()
    }

    #[inline(always)]
    fn alternatives(&mut self, level: usize) -> Words<N> {
        let mut candidates = self.candidates(level);
        if !self.follow.is_empty() {
            let (h, v) = self.used[level];
            candidates &= self.follow[usize::from(h) * self.stride + usize::from(v)];
        }
        if QUOTIENT && !R::EXACT { self.tried(candidates) } else { candidates }
    }

    #[inline(always)]
    fn push(&mut self, level: usize, choice: u32) {
        let step = &self.steps[level];
        let sides = self.tiles[choice as usize];
        self.sides[step.cell as usize] = sides;
        self.rule.take(choice);
        if QUOTIENT {
            let images = &self.images[choice as usize];
            for (&cell, &image) in step.orbit.iter().zip(images).skip(1) {
                self.sides[cell as usize] = self.tiles[image as usize];
                self.rule.take(image);
            }
        }
        if !self.follow.is_empty() {
            let (h, v) = self.used[level];
            let [n, e, s, w] = sides;
            self.used[level + 1] = (h.max(n + 1).max(s + 1), v.max(e + 1).max(w + 1));
        }
    }

    #[inline(always)]
    fn pop(&mut self, _: usize, choice: u32) {
        if QUOTIENT {
            for &image in self.images[choice as usize][1..].iter().rev() {
                self.rule.release(image);
            }
        }
        self.rule.release(choice);
    }
}

impl<const N: usize, R: WangRule<N>, const QUOTIENT: bool> Labeled for Wang<N, R, QUOTIENT> {
    fn write_labels(&self, labels: &mut Vec<u8>) {
        labels.clear();
        let cells = self.sides.len() - 1;
        for &[n, _, _, w] in &self.sides[..cells] {
            match self.shown {
                Shown::Both => labels.extend([n, w]),
                Shown::North => labels.push(n),
                Shown::West => labels.push(w),
            }
        }
    }
}

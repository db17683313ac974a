//! Orbits of cells under a prescribed automorphism.
//!
//! With `a[p + t] = map(a[p])` the first cell of an orbit in the visiting order decides all
//! its cells. Without an automorphism every orbit is one cell. The same orbits serve corner
//! windows, dominoes and Wang tiles, which are all named by their north-west cell.

use super::Task;
use crate::symmetry::ColorMap;
use crate::torus::{Cell, Shape};

/// The orbits of the cells of a torus.
#[derive(Debug, Clone)]
pub struct Quotient {
    shape: Shape,
    /// The translation, in rows and columns.
    step: (i64, i64),
    /// The color maps of 0, 1, … steps; as many as an orbit has cells.
    maps: Vec<ColorMap>,
}

impl Quotient {
    /// The orbits for a task whose automorphism has been checked.
    pub fn new(task: &Task) -> Self {
        let shape = task.shape;
        match &task.automorphism {
            None => {
                let maps = vec![ColorMap::identity(task.set.colors())];
                Self { shape, step: (0, 0), maps }
            }
            Some(automorphism) => {
                let maps = automorphism.powers(automorphism.order(shape), task.set.colors());
                Self { shape, step: (automorphism.dy.into(), automorphism.dx.into()), maps }
            }
        }
    }

    /// Cells in an orbit.
    pub fn order(&self) -> usize {
        self.maps.len()
    }

    /// The color maps of 0, 1, … steps of the translation.
    pub fn maps(&self) -> &[ColorMap] {
        &self.maps
    }

    /// The orbit of a cell, beginning with it, one step of the translation after the other.
    pub fn orbit(&self, cell: Cell) -> impl Iterator<Item = Cell> {
        let (rows, columns) = self.step;
        let shape = self.shape;
        (0..self.order() as i64).map(move |k| shape.step(cell, k * rows, k * columns))
    }

    /// For every cell the position, in `visits`, of the first cell of its orbit.
    pub fn first_visits(&self, visits: &[Cell]) -> Vec<usize> {
        let mut first = vec![usize::MAX; self.shape.cells()];
        for (position, &cell) in visits.iter().enumerate() {
            for image in self.orbit(cell) {
                let known = &mut first[image.index()];
                *known = (*known).min(position);
            }
        }
        first
    }

    /// One cell of every orbit, the first of it in `visits`.
    pub fn representatives(&self, visits: &[Cell]) -> Vec<Cell> {
        let first = self.first_visits(visits);
        let is_first = |&(position, cell): &(usize, &Cell)| first[cell.index()] == position;
        visits.iter().enumerate().filter(is_first).map(|(_, &cell)| cell).collect()
    }
}

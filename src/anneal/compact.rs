//! Compact corner sets with the symmetry `a[row][column + X/C] = a[row][column] + 1` modulo `C`.
//!
//! Of `X` columns, `C` of which make a turn, the first `X / C` are unknown: `2 C^2` cells. Their
//! windows are taken relative to their NW color, which is what the symmetry leaves of a tile.
//! There are `C^2` classes (SW - NW, SE - NW), each to be met twice, with different NE - NW. The
//! cost is the sum of `(count - 2)^2` over the classes, and 2 for every tile met again. One cell
//! after the other gets a random color, which is kept by the rule of Metropolis at a constant
//! temperature.
//!
//! Where only the height is a multiple of `C` the torus is reflected through its SW-NE
//! diagonal. Source: this project.

use super::metropolis::{Landscape, walk};
use crate::search::Limits;
use crate::torus::Shape;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// What annealing came to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Annealed {
    /// The colors of the lattice points, row by row from the north; `None` when a limit was met.
    pub labels: Option<Vec<u8>>,
    /// Moves tried.
    pub moves: u64,
}

/// Whether the torus has `2 C^3` cells and a side that the symmetry suits.
pub fn suits(colors: usize, shape: Shape) -> bool {
    (2..=255).contains(&colors)
        && shape.cells() == 2 * colors.pow(3)
        && [shape.width(), shape.height()].iter().any(|&side| turns(colors, side))
}

/// Whether the colors make a turn along a side. One unknown column would make all (SW, SE) alike.
fn turns(colors: usize, side: usize) -> bool {
    side.is_multiple_of(colors) && side > colors
}

/// A packing of the compact set; nodes of the limits are moves. Finds nothing where the torus
/// does not suit ([`suits`]).
pub fn compact_corner(colors: usize, shape: Shape, seed: u64, limits: &Limits<'_>) -> Annealed {
    let (w, h) = (shape.width(), shape.height());
    if !suits(colors, shape) {
        return Annealed { labels: None, moves: 0 };
    }
    if turns(colors, w) {
        return Quotient::new(colors, w / colors, h).anneal(seed, limits);
    }
    let Annealed { labels, moves } = Quotient::new(colors, h / colors, w).anneal(seed, limits);
    let reflected =
        |cells: Vec<u8>| (0..w * h).map(|i| cells[(w - 1 - i % w) * h + (h - 1 - i / w)]).collect();
    Annealed { labels: labels.map(reflected), moves }
}

/// The unknown cells, and what is counted about their windows.
struct Quotient {
    colors: usize,
    columns: usize,
    rows: usize,
    cells: Vec<usize>,
    classes: Vec<u32>,
    tiles: Vec<u32>,
    cost: i64,
}

impl Quotient {
    fn new(colors: usize, columns: usize, rows: usize) -> Self {
        Self {
            colors,
            columns,
            rows,
            cells: vec![0; columns * rows],
            classes: vec![0; colors.pow(2)],
            tiles: vec![0; colors.pow(3)],
            // Every class lacks two.
            cost: 4 * colors.pow(2) as i64,
        }
    }

    fn anneal(mut self, seed: u64, limits: &Limits<'_>) -> Annealed {
        let mut rng = Pcg64::seed_from_u64(seed);
        let temperature = if self.colors < 8 { 0.45 } else { 0.40 };
        self.cells.iter_mut().for_each(|cell| *cell = rng.random_range(0..self.colors));
        (0..self.cells.len()).for_each(|window| self.count(window, true));
        let mut moves = 0;
        if !walk(&mut self, temperature, &mut rng, &mut moves, limits.nodes, limits.stop) {
            return Annealed { labels: None, moves };
        }
        let all = |row| (0..self.columns * self.colors).map(move |column| (row, column));
        let cells = (0..self.rows).flat_map(all);
        let labels = cells.map(|(row, column)| self.at(row, column) as u8).collect();
        Annealed { labels: Some(labels), moves }
    }

    /// The windows that show a cell, each once, and how many they are.
    fn windows_at(&self, cell: usize) -> ([usize; 4], usize) {
        let (row, column) = (cell / self.columns, cell % self.columns);
        let north = (row + self.rows - 1) % self.rows;
        let west = (column + self.columns - 1) % self.columns;
        let (mut windows, mut number) = ([0; 4], 0);
        for (row, column) in [(row, column), (row, west), (north, column), (north, west)] {
            let window = row * self.columns + column;
            if !windows[..number].contains(&window) {
                windows[number] = window;
                number += 1;
            }
        }
        (windows, number)
    }

    /// The color anywhere on the torus.
    fn at(&self, row: usize, column: usize) -> usize {
        let turns = column / self.columns;
        let cell = row % self.rows * self.columns + column % self.columns;
        (self.cells[cell] + turns) % self.colors
    }

    /// Counts a window in, or out again.
    fn count(&mut self, window: usize, more: bool) {
        let (row, column) = (window / self.columns, window % self.columns);
        let nw = self.at(row, column);
        let relative = |color: usize| (color + self.colors - nw) % self.colors;
        let sw = relative(self.at(row + 1, column));
        let se = relative(self.at(row + 1, column + 1));
        let ne = relative(self.at(row, column + 1));
        let class = sw * self.colors + se;
        let tile = class * self.colors + ne;
        self.cost -= self.worth(class, tile);
        for count in [&mut self.classes[class], &mut self.tiles[tile]] {
            *count = if more { *count + 1 } else { *count - 1 };
        }
        self.cost += self.worth(class, tile);
    }

    /// What a class and a tile add to the cost.
    fn worth(&self, class: usize, tile: usize) -> i64 {
        let (off, again) = (i64::from(self.classes[class]) - 2, i64::from(self.tiles[tile]) - 1);
        off * off + 2 * again.max(0)
    }
}

impl Landscape for Quotient {
    fn cells(&self) -> usize {
        self.cells.len()
    }

    fn colors(&self) -> usize {
        self.colors
    }

    fn color(&self, cell: usize) -> usize {
        self.cells[cell]
    }

    fn recolor(&mut self, cell: usize, color: usize) {
        let (windows, number) = self.windows_at(cell);
        windows[..number].iter().for_each(|&window| self.count(window, false));
        self.cells[cell] = color;
        windows[..number].iter().for_each(|&window| self.count(window, true));
    }

    fn cost(&self) -> i64 {
        self.cost
    }
}

//! Brick walls: grids of tiles in which joints meet, but never cross.
//!
//! A joint crosses each edge of a tile at one of a few *positions*. In a tile exactly one pair of
//! opposite edges has the same position: that joint goes straight through, and the two others end at
//! it, beside each other. An *h-tile* (label 0) has a joint from west to east, a *v-tile* (label 1)
//! one from north to south. Around every corner of the grid there is then one brick, a rectangle.
//!
//! * [`Wall`] holds the positions of all edges; [`Wall::fault`] checks them from the definition;
//! * [`labels`] makes walls of given labels: of dappled ones, which have no long joints, and with any
//!   boundary; it also counts them;
//! * [`region`] decides regions of any form, with holes, with any boundary, in linear time.
//!
//! Sources: Derouet-Jourdan, Mizoguchi, Salvati, *Wang tiles modeling of wall patterns*, 2015;
//! Derouet-Jourdan, Kaji, Mizoguchi, *A linear algorithm for brick Wang tiling*, 2019; Kaji and
//! others, *Dappled tiling*, 2016, section 5.

pub mod boundary;
pub mod labels;
pub mod region;
mod walk;

pub use crate::tiles::Side;
pub use walk::weight;

/// An edge whose position is not known, or that is none.
pub const FREE: u8 = u8::MAX;

/// Positions at most: sets of them are words.
pub const MOST_POSITIONS: u8 = 64;

/// Where a position lies on its edge of length 1, from its west or north end: well inside, so that
/// no brick is a sliver.
pub fn place(position: u8, positions: u8) -> f64 {
    0.22 + 0.56 * f64::from(position) / f64::from(positions.max(2) - 1)
}

/// The positions of the edges of a grid, some of them [`FREE`].
///
/// Invariant: every position is below `positions`, or [`FREE`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wall {
    width: usize,
    height: usize,
    positions: u8,
    inside: Vec<bool>,
    /// First the edges between east and west neighbors, row by row, then those between north and
    /// south neighbors, column by column.
    edges: Vec<u8>,
}

/// What is wrong in a wall.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("row {row}, column {column}: {what}")]
pub struct WallFault {
    /// The row.
    pub row: usize,
    /// The column.
    pub column: usize,
    /// What is wrong there.
    pub what: &'static str,
}

impl Wall {
    /// A grid with these cells, row by row, nothing known of its edges.
    pub fn new((width, height): (usize, usize), positions: u8, inside: Vec<bool>) -> Self {
        debug_assert!(inside.len() == width * height);
        debug_assert!((2..=MOST_POSITIONS).contains(&positions));
        let edges = vec![FREE; height * (width + 1) + width * (height + 1)];
        Self { width, height, positions, inside, edges }
    }

    /// A whole rectangle, nothing known of its edges.
    pub fn rectangle(size: (usize, usize), positions: u8) -> Self {
        Self::new(size, positions, vec![true; size.0 * size.1])
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// How many positions there are.
    pub fn positions(&self) -> u8 {
        self.positions
    }

    /// Whether a cell is part of the wall.
    pub fn holds(&self, column: usize, row: usize) -> bool {
        self.inside[row * self.width + column]
    }

    /// The number of the edge on a side of a cell.
    fn edge(&self, column: usize, row: usize, side: Side) -> usize {
        let rows = self.height * (self.width + 1);
        match side {
            Side::North => rows + column * (self.height + 1) + row,
            Side::South => rows + column * (self.height + 1) + row + 1,
            Side::West => row * (self.width + 1) + column,
            Side::East => row * (self.width + 1) + column + 1,
        }
    }

    /// The position of an edge.
    pub fn at(&self, column: usize, row: usize, side: Side) -> u8 {
        self.edges[self.edge(column, row, side)]
    }

    /// Gives an edge a position.
    pub fn set(&mut self, column: usize, row: usize, side: Side, position: u8) {
        let edge = self.edge(column, row, side);
        self.edges[edge] = position;
    }

    /// The cell on the other side of an edge, if it is part of the wall.
    pub fn neighbor(&self, column: usize, row: usize, side: Side) -> Option<(usize, usize)> {
        let (column, row) = match side {
            Side::North => (column, row.checked_sub(1)?),
            Side::South => (column, row + 1),
            Side::West => (column.checked_sub(1)?, row),
            Side::East => (column + 1, row),
        };
        (column < self.width && row < self.height && self.holds(column, row))
            .then_some((column, row))
    }

    /// The positions of a tile: north, east, south, west.
    pub fn tile(&self, column: usize, row: usize) -> [u8; 4] {
        Side::ALL.map(|side| self.at(column, row, side))
    }

    /// 1 for a v-tile, 0 for an h-tile.
    pub fn label(&self, column: usize, row: usize) -> u8 {
        let [north, _, south, _] = self.tile(column, row);
        u8::from(north == south)
    }

    /// The cells of the wall, row by row: column and row.
    pub fn cells(&self) -> impl Iterator<Item = (usize, usize)> {
        let cells = self.inside.iter().enumerate().filter(|(_, inside)| **inside);
        cells.map(|(cell, _)| (cell % self.width, cell / self.width))
    }

    /// The first cell that is no brick tile; with `cyclic` edges, or that does not fit the other end.
    pub fn fault(&self, cyclic: bool) -> Option<WallFault> {
        self.cells().find_map(|(column, row)| {
            let [north, east, south, west] = self.tile(column, row);
            let ends = || {
                let (last_column, last_row) = (self.width - 1, self.height - 1);
                column == 0 && west != self.at(last_column, row, Side::East)
                    || row == 0 && north != self.at(column, last_row, Side::South)
            };
            let what = match (north == south, east == west) {
                _ if [north, east, south, west].contains(&FREE) => "an edge has no position",
                (true, true) => "the joints cross",
                (false, false) => "no joint goes through",
                _ if cyclic && ends() => "the joints do not meet those of the other end",
                _ => return None,
            };
            Some(WallFault { row, column, what })
        })
    }
}

/// All brick tiles over some positions, by north, east, south, west.
pub fn tiles(positions: u8) -> Vec<[u8; 4]> {
    let all = || 0..positions;
    let pairs: Vec<(u8, u8)> = all().flat_map(|a| all().map(move |b| (a, b))).collect();
    let all = pairs.iter().flat_map(|&(n, s)| pairs.iter().map(move |&(e, w)| [n, e, s, w]));
    all.filter(|[n, e, s, w]| (n == s) != (e == w)).collect()
}

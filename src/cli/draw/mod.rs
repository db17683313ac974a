//! Drawing packings with characters.
//!
//! * [`plain`]: lines and labels, readable anywhere: a color stands where tiles share it.
//! * [`colored`]: blocks of color. Corner tiles have four quarters, Wang tiles four triangles
//!   (half blocks give two square pixels a character), dominoes two halves.
//!
//! Drawings are made one row of tiles at a time and never cut off, so that they may be piped.
//! Packings that are none are drawn, too: one sees where neighbors do not fit.

pub mod canvas;
pub mod colored;
pub mod palette;
pub mod plain;

use crate::tiles::{Kind, turn};
use crate::torus::{Cell, Packing};
use std::io::{self, Write};

/// How to draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Style {
    /// With blocks of color, for a terminal.
    pub color: bool,
    /// With the number of every tile.
    pub indices: bool,
}

/// Draws a packing.
///
/// # Errors
/// What `out` reports.
pub fn draw(out: &mut dyn Write, packing: &Packing, style: Style) -> io::Result<()> {
    let view = View::new(packing, style);
    match (view.kind, style.color) {
        (Kind::Corner, false) => plain::corner(out, &view),
        (Kind::Wang, false) => plain::wang(out, &view),
        (Kind::Domino, false) => plain::domino(out, &view),
        (Kind::Corner, true) => colored::corner(out, &view),
        (Kind::Wang, true) => colored::wang(out, &view),
        (Kind::Domino, true) => colored::domino(out, &view),
    }
}

/// A packing as drawings need it: colors by row and column, around the seams.
#[derive(Debug)]
pub struct View<'a> {
    packing: &'a Packing,
    kind: Kind,
    /// Rows and columns.
    pub height: usize,
    /// Columns.
    pub width: usize,
    /// Characters of the longest label of a color.
    pub label: usize,
    /// Digits of the largest tile number, 0 when numbers are not wanted.
    pub digits: usize,
}

impl<'a> View<'a> {
    fn new(packing: &'a Packing, style: Style) -> Self {
        let (set, shape) = (&packing.set, packing.shape);
        let largest = packing.tiles.iter().map(|tile| tile.0).max().unwrap_or(0);
        Self {
            packing,
            kind: set.kind(),
            height: shape.height(),
            width: shape.width(),
            label: palette::label_width(set.colors().largest()),
            digits: if style.indices { largest.to_string().len() } else { 0 },
        }
    }

    fn cell(&self, row: usize, column: usize) -> Cell {
        self.packing.shape.cell(row % self.height, column % self.width)
    }

    /// The colors of the tile in a cell, in the order of [`Kind::sides`].
    pub fn sides(&self, row: usize, column: usize) -> [u8; 4] {
        let cell = self.cell(row, column);
        let sides = self.kind.unpack(self.packing.tile(cell), self.packing.set.colors());
        match self.packing.turns.get(cell.index()) {
            Some(&turns) => turn::turned(sides, turns),
            None => sides,
        }
    }

    /// Whether this side of the drawing, as in [`crate::torus::board::SIDES`], meets another one.
    pub fn meets(&self, side: usize) -> bool {
        !self.packing.board.topology.is_outer(side)
    }

    /// The number of the tile in a cell as text of equal lengths, empty when numbers are not wanted.
    pub fn number(&self, row: usize, column: usize) -> String {
        match self.digits {
            0 => String::new(),
            digits => format!("{:>digits$}", self.packing.tile(self.cell(row, column)).0),
        }
    }

    /// The label of a color.
    pub fn name(&self, color: u8) -> String {
        palette::label(color, self.label)
    }
}

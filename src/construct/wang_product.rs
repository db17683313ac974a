//! All Wang tiles: a ring along the columns times a ring along the rows.
//!
//! The west and east colors of a tile form a domino over the `CV` vertical-edge colors, its
//! north and south colors one over the `CH` horizontal-edge colors. Lay a ring of all the first
//! along every row and a ring of all the second down every column: on a torus `CV^2` wide and
//! `CH^2` high every pair of dominoes, so every tile, meets in exactly one cell, and
//! `column = position of (W, E)`, `row = position of (N, S)`.
//!
//! Wei's ring for `C` colors begins with that for `C - 1`. Laid from west to east and from south
//! to north it makes the packing recursive: the south-west block, `(CV-1)^2` wide and `(CH-1)^2`
//! high, is the product of the two shorter rings. Read from north to south the column is the ring
//! backwards, again a ring of all dominoes. See `verify::recursion`.
//!
//! Source: Wei 2004, section 4; Lagae 2007, section 5.5.2.

use super::{Ring, Seed};
use crate::tiles::Colors;

/// The packing of all Wang tiles as a product of two rings.
#[derive(Debug, Clone)]
pub struct WangProduct {
    /// West colors along a row.
    along: Ring,
    /// North colors down a column.
    down: Ring,
}

impl WangProduct {
    /// The product of the two least rings, or of two rings chosen by a seed.
    pub fn new(colors: Colors, mut seed: Option<Seed>) -> Self {
        let along = Ring::choose(colors.vertical(), seed.as_mut());
        let down = Ring::choose(colors.horizontal(), seed.as_mut());
        Self { along, down }
    }

    /// The product of two of Wei's rings, which is recursive.
    pub fn wei(colors: Colors) -> Self {
        Self { along: Ring::wei(colors.vertical()), down: Ring::wei_backward(colors.horizontal()) }
    }

    /// `CV^2`.
    pub fn width(&self) -> usize {
        self.along.length()
    }

    /// `CH^2`.
    pub fn height(&self) -> usize {
        self.down.length()
    }

    /// The color of the north edges of a row.
    pub fn north(&self, row: usize) -> u8 {
        self.down.colors()[row]
    }

    /// The colors of the west edges, column by column; the same in every row.
    pub fn wests(&self) -> &[u8] {
        self.along.colors()
    }

    /// Row and column of the tile with these colors, each within its palette.
    pub fn find(&self, n: u8, e: u8, s: u8, w: u8) -> (usize, usize) {
        (self.down.place(n, s), self.along.place(w, e))
    }
}

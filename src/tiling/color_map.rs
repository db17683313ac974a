//! A color map: colors on a torus, repeated over the plane.
//!
//! Whatever fits on a torus is a tiling: what an artist laid, a packing repeated, a patch that some
//! search filled. Only its tiles occur, so any set will do. The south-west tile of the map is the
//! tile `(0, 0)`; see the conventions of [`super`].
//!
//! Invariant: `labels` are those of [`Lattice`] for the shape.

use super::TilingError;
use crate::tiles::{Colors, Kind, TileId};
use crate::torus::{Lattice, Packing, Shape};

/// Colors on a torus.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ColorMap {
    kind: Kind,
    colors: Colors,
    shape: Shape,
    labels: Vec<u8>,
}

impl ColorMap {
    /// The colors that tiles on a torus show, which must fit. Nothing else is asked of them: they
    /// need not be a packing.
    ///
    /// # Errors
    /// Dominoes, and the first cell that does not fit.
    pub fn of(tiles: &Packing) -> Result<Self, TilingError> {
        let (kind, shape) = (tiles.set.kind(), tiles.shape);
        if kind == Kind::Domino {
            return Err(TilingError::Dominoes);
        }
        let labels = Lattice::labels_of(tiles).map_err(|cell| {
            let (row, column) = shape.position(cell);
            TilingError::MapDoesNotFit { row, column }
        })?;
        Ok(Self { kind, colors: tiles.set.colors(), shape, labels })
    }

    /// The kind of tiles.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The numbers of colors.
    pub fn colors(&self) -> Colors {
        self.colors
    }

    /// How many tiles it repeats after.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// The labels of [`Lattice`]: row by row from the north, the color of the north-west corner of
    /// every cell, or for Wang tiles those of its north and its west edge.
    pub fn labels(&self) -> &[u8] {
        &self.labels
    }

    /// The colors of the tile at a place, in the order of [`Kind::sides`].
    pub fn sides(&self, x: i64, y: i64) -> [u8; 4] {
        let (width, height) = (self.shape.width(), self.shape.height());
        let around = |at: i64, size: usize| at.rem_euclid(size as i64) as usize;
        let (row, column) = (around(-1 - y, height), around(x, width));
        let (below, east) = ((row + 1) % height, (column + 1) % width);
        let label = |row: usize, column: usize, which: usize| {
            let per_cell = Lattice { kind: self.kind, shape: self.shape }.per_cell();
            self.labels[(row * width + column) * per_cell + which]
        };
        match self.kind {
            Kind::Corner => [
                label(row, east, 0),
                label(below, east, 0),
                label(below, column, 0),
                label(row, column, 0),
            ],
            _ => [
                label(row, column, 0),
                label(row, east, 1),
                label(below, column, 0),
                label(row, column, 1),
            ],
        }
    }

    /// The different tiles that it shows, in order.
    pub fn tiles(&self) -> Vec<TileId> {
        let (h, v) = (self.colors.horizontal() as u32, self.colors.vertical() as u32);
        let (width, height) = (self.shape.width() as i64, self.shape.height() as i64);
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let mut tiles: Vec<TileId> = places
            .map(|(x, y)| {
                let [a, b, c, d] = self.sides(x, y).map(u32::from);
                TileId(((a * v + b) * h + c) * v + d)
            })
            .collect();
        tiles.sort_unstable();
        tiles.dedup();
        tiles
    }
}

//! One symmetry of a set of packings: recolor, rotate or reflect, translate, in this order.
//!
//! The first two are a [`PointSymmetry`]. Recoloring comes first, so the permutation of the
//! horizontal palette meets the labels of horizontal edges even when these become vertical
//! ones; composing two then exchanges the palettes of the later map when the earlier isometry
//! transposes: `(d1, s1)` then `(d2, s2)` is `(d1 then d2, s1 then s2 seen through d1)`.

use super::{ColorMap, Isometry};
use crate::tiles::{Colors, Kind, TileId};
use crate::torus::Lattice;

/// A color permutation followed by a rotation or reflection about the north-west corner of cell
/// (0, 0).
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PointSymmetry {
    /// What it does to places.
    pub isometry: Isometry,
    /// What it does to colors, before they move.
    pub map: ColorMap,
}

impl PointSymmetry {
    /// Changes nothing.
    pub fn identity(colors: Colors) -> Self {
        Self { isometry: Isometry::IDENTITY, map: ColorMap::identity(colors) }
    }

    /// First `self`, then `next`.
    pub fn then(&self, next: &Self) -> Self {
        let map = self.map.then(&seen_through(self.isometry, &next.map));
        Self { isometry: self.isometry.then(next.isometry), map }
    }

    /// The one that undoes this one.
    pub fn inverse(&self) -> Self {
        let map = seen_through(self.isometry, &self.map.inverse());
        Self { isometry: self.isometry.inverse(), map }
    }

    /// The tile that `tile` becomes; `None` as for [`Isometry::tile`].
    pub fn tile(&self, kind: Kind, colors: Colors, tile: TileId) -> Option<TileId> {
        self.isometry.tile(kind, colors, self.map.tile(kind, colors, tile))
    }

    /// The permutation that the label arriving at `place` of the image went through.
    pub fn recoloring(&self, kind: Kind, place: usize) -> &[u8] {
        let horizontal_image = kind == Kind::Wang && place.is_multiple_of(2);
        match kind {
            Kind::Wang if horizontal_image != self.isometry.transposes() => self.map.horizontal(),
            _ => self.map.vertical(),
        }
    }
}

/// The map that does after `isometry`, to the colors there, what `map` does before it.
/// Exchanging the palettes is its own inverse, so this also goes the other way.
fn seen_through(isometry: Isometry, map: &ColorMap) -> ColorMap {
    if isometry.transposes() { map.exchanged() } else { map.clone() }
}

/// A point symmetry followed by a translation.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Symmetry {
    /// What it does before it translates.
    pub point: PointSymmetry,
    /// Rows to the south, below the height.
    pub rows: usize,
    /// Columns to the east, below the width.
    pub columns: usize,
}

impl Symmetry {
    /// For every place of the image, the place its label comes from.
    pub fn sources(&self, lattice: Lattice) -> Vec<usize> {
        translated(&self.point.isometry.sources(lattice), lattice, self.rows, self.columns)
    }

    /// The labels that `labels` become.
    pub fn image(&self, lattice: Lattice, labels: &[u8]) -> Vec<u8> {
        let color = |(place, &source): (usize, &usize)| {
            self.point.recoloring(lattice.kind, place)[usize::from(labels[source])]
        };
        self.sources(lattice).iter().enumerate().map(color).collect()
    }
}

/// What every place holds, moved `rows` to the south and `columns` to the east.
pub(super) fn translated<T: Copy>(
    places: &[T],
    lattice: Lattice,
    rows: usize,
    columns: usize,
) -> Vec<T> {
    let width = lattice.per_cell() * lattice.shape.width();
    let (seam_row, seam_column) = (width * rows, lattice.per_cell() * columns);
    let mut moved = places.to_vec();
    moved.rotate_right(seam_row);
    moved.chunks_mut(width).for_each(|row| row.rotate_right(seam_column));
    moved
}

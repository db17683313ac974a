//! The partition of a torus that codes tilings by the tiles of Jeandel and Rao.
//!
//! The torus is the plane modulo (phi, 0) and (1, phi + 3). A point and the steps (x, y) from it
//! give a pattern of labels, and for almost every point a tiling of the plane.
//!
//! Source: Labbé 2019, arXiv:1903.06137; the tiles are those of Jeandel and Rao 2021, Advances in
//! Combinatorics 2021:1, figure 4 (figure 3 before label 4 was merged with 0).

use super::polygon::{Point, Polygon};
use super::zphi::Zphi;
use crate::torus::toral::{ToralPiece, ToralPoint};

/// The tiles [N, E, S, W] over 4 labels.
pub const JEANDEL_RAO: [[u32; 4]; 11] = [
    [0, 2, 1, 2],
    [2, 2, 0, 2],
    [1, 1, 1, 3],
    [2, 1, 2, 3],
    [1, 3, 3, 3],
    [1, 0, 1, 3],
    [0, 0, 1, 0],
    [1, 3, 2, 0],
    [2, 0, 2, 1],
    [2, 1, 0, 1],
    [3, 3, 2, 1],
];

/// The same with the fifth label that marks some north and south sides.
pub const JEANDEL_RAO_UNMERGED: [[u32; 4]; 11] = {
    let mut tiles = JEANDEL_RAO;
    tiles[0][0] = 4;
    tiles[9][2] = 4;
    tiles
};

/// The vectors of the lattice.
pub const LATTICE: [ToralPoint; 2] = [[0, 1, 0, 0], [1, 0, 3, 1]];

/// Width and height of the rectangle.
pub const DOMAIN: ToralPoint = [0, 1, 3, 1];

/// Labels and vertices.
const PIECES: [(usize, &[ToralPoint]); 24] = [
    (0, &[[0, 0, 0, 0], [-1, 1, 0, 0], [-1, 1, 1, 0]]),
    (0, &[[-1, 1, 0, 0], [1, 0, 0, 0], [1, 0, 1, 0]]),
    (0, &[[1, 0, 0, 0], [0, 1, 0, 0], [0, 1, 1, 0]]),
    (1, &[[0, 0, 0, 0], [-1, 1, 1, 0], [0, 0, 1, 0]]),
    (1, &[[-1, 1, 0, 0], [1, 0, 1, 0], [-1, 1, 1, 0]]),
    (1, &[[1, 0, 0, 0], [0, 1, 1, 0], [1, 0, 1, 0]]),
    (2, &[[0, 0, 1, 1], [0, 0, 2, 0], [-1, 1, 2, 1]]),
    (3, &[[1, 0, 2, 0], [1, 0, 1, 0], [0, 1, 2, 0], [0, 1, 2, 1]]),
    (4, &[[0, 0, 2, 0], [1, 0, 2, 1], [-1, 1, 2, 1]]),
    (4, &[[-1, 1, 2, 1], [1, 0, 2, 1], [1, 0, 3, 1]]),
    (5, &[[0, 0, 1, 1], [-1, 1, 2, 1], [0, 0, 2, 1]]),
    (5, &[[0, 0, 2, 1], [2, -1, 2, 1], [2, -1, 3, 1]]),
    (5, &[[2, -1, 2, 1], [-1, 1, 2, 1], [1, 0, 3, 1]]),
    (6, &[[0, 0, 2, 1], [2, -1, 3, 1], [0, 0, 3, 1]]),
    (6, &[[2, -1, 2, 1], [1, 0, 3, 1], [2, -1, 3, 1]]),
    (6, &[[1, 0, 2, 1], [0, 1, 3, 1], [1, 0, 3, 1]]),
    (7, &[[1, 0, 1, 1], [0, 1, 2, 1], [1, 0, 2, 1]]),
    (7, &[[1, 0, 2, 1], [0, 1, 2, 1], [0, 1, 3, 1]]),
    (7, &[[0, 0, 2, 0], [0, 0, 1, 0], [1, 0, 2, 1]]),
    (8, &[[-1, 1, 2, 0], [-1, 1, 1, 0], [0, 1, 2, 1]]),
    (9, &[[0, 0, 1, 0], [-1, 1, 1, 0], [-1, 1, 2, 0]]),
    (9, &[[-1, 1, 1, 0], [1, 0, 1, 0], [1, 0, 2, 0]]),
    (9, &[[1, 0, 1, 0], [0, 1, 1, 0], [0, 1, 2, 0]]),
    (10, &[[0, 0, 1, 0], [1, 0, 1, 1], [1, 0, 2, 1]]),
];

/// A partition of the torus into labeled convex polygons.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Partition {
    /// Labels and polygons.
    pub pieces: Vec<(usize, Polygon)>,
    /// The vectors of the lattice: (w, 0) and one of height h.
    pub lattice: [Point; 2],
}

impl Partition {
    /// That of Jeandel and Rao's tiles.
    pub fn jeandel_rao() -> Self {
        let polygon = |vertices: &[ToralPoint]| Polygon(vertices.iter().map(point).collect());
        Self {
            pieces: PIECES.iter().map(|&(label, vertices)| (label, polygon(vertices))).collect(),
            lattice: LATTICE.each_ref().map(point),
        }
    }

    /// The vector `m` times the first of the lattice and `n` times the second.
    pub fn shift(&self, m: i64, n: i64) -> Point {
        let [first, second] = self.lattice;
        let times = |k: i64, x: Zphi| Zphi::new(k, 0) * x;
        [0, 1].map(|i| times(m, first[i]) + times(n, second[i]))
    }

    /// The pieces as a certificate lists them.
    pub fn listed(&self) -> Vec<ToralPiece> {
        let piece = |(label, polygon): &(usize, Polygon)| ToralPiece {
            label: *label,
            polygon: listed(polygon),
        };
        self.pieces.iter().map(piece).collect()
    }
}

fn point(&[a, b, c, d]: &ToralPoint) -> Point {
    [Zphi::new(a, b), Zphi::new(c, d)]
}

/// The vertices of a polygon as plain numbers.
pub fn listed(polygon: &Polygon) -> Vec<ToralPoint> {
    polygon.0.iter().map(|[x, y]| [x.a, x.b, y.a, y.b]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pieces_fill_the_rectangle() {
        let partition = Partition::jeandel_rao();
        let areas = partition.pieces.iter().map(|(_, polygon)| polygon.double_area());
        let height = Zphi::new(3, 1);
        let twice = Zphi::new(2, 0) * Zphi::PHI * height;
        assert_eq!(areas.fold(Zphi::ZERO, |sum, area| sum + area), twice);
        for (i, (_, one)) in partition.pieces.iter().enumerate() {
            for (_, other) in &partition.pieces[..i] {
                assert_eq!(one.common(other), Ok(None));
            }
        }
    }
}

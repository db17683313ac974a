//! Labels: the colors that neighboring tiles share, each written once.
//!
//! For corner tiles the label of a cell is the color of its north-west corner; for Wang tiles a
//! cell has two labels, the colors of its north and its west edge; for dominoes the color of its
//! first end. Every array of labels describes tiles that fit, so search and symmetry need not
//! check neighbors. The labels of a cell stand together, cells row by row.

use super::{Cell, Packing, Shape};
use crate::tiles::{Color, Corner, Domino, Kind, TileId, TileSet, Wang};

/// Labels on a torus, for tiles of one kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lattice {
    /// The kind of the tiles.
    pub kind: Kind,
    /// The torus.
    pub shape: Shape,
}

impl Lattice {
    /// Labels of each cell: 2 for Wang tiles, else 1.
    pub fn per_cell(self) -> usize {
        if self.kind == Kind::Wang { 2 } else { 1 }
    }

    /// Labels in all.
    pub fn labels(self) -> usize {
        self.per_cell() * self.shape.cells()
    }

    /// The positions, in the array of labels, of the sides of the tile in `cell`, in the order
    /// of [`Kind::sides`].
    pub fn sides(self, cell: Cell) -> Vec<usize> {
        let at = |rows, columns| self.shape.step(cell, rows, columns).index();
        match self.kind {
            Kind::Corner => vec![at(0, 1), at(1, 1), at(1, 0), at(0, 0)],
            Kind::Wang => {
                vec![2 * at(0, 0), 2 * at(0, 1) + 1, 2 * at(1, 0), 2 * at(0, 0) + 1]
            }
            Kind::Domino if self.shape.height() > 1 => vec![at(0, 0), at(1, 0)],
            Kind::Domino => vec![at(0, 0), at(0, 1)],
        }
    }

    /// The tile that the labels put into `cell`.
    pub fn tile(self, labels: &[u8], set: &TileSet, cell: Cell) -> TileId {
        let side = |i: usize| Color(labels[i]);
        let colors = set.colors();
        match (self.kind, &self.sides(cell)[..]) {
            (Kind::Corner, &[ne, se, sw, nw]) => {
                Corner { ne: side(ne), se: side(se), sw: side(sw), nw: side(nw) }.id(colors)
            }
            (Kind::Wang, &[n, e, s, w]) => {
                Wang { n: side(n), e: side(e), s: side(s), w: side(w) }.id(colors)
            }
            (_, sides) => {
                let (first, second) = (sides[0], sides[sides.len() - 1]);
                Domino { first: side(first), second: side(second) }.id(colors)
            }
        }
    }

    /// The packing that the labels describe.
    pub fn packing(self, labels: &[u8], set: &TileSet, cover: bool) -> Packing {
        let cells = (0..self.shape.cells() as u32).map(Cell);
        let tiles = cells.map(|cell| self.tile(labels, set, cell)).collect();
        Packing::new(set.clone(), self.shape, cover, tiles)
    }

    /// The labels of a packing, or the first cell one of whose neighbors does not fit.
    ///
    /// # Errors
    /// The cell whose tile disagrees with a label that an earlier tile wrote.
    pub fn labels_of(packing: &Packing) -> Result<Vec<u8>, Cell> {
        let lattice = Lattice { kind: packing.set.kind(), shape: packing.shape };
        let mut labels = vec![None; lattice.labels()];
        for cell in (0..packing.shape.cells() as u32).map(Cell) {
            let colors = lattice.kind.unpack(packing.tile(cell), packing.set.colors());
            for (place, color) in lattice.sides(cell).into_iter().zip(colors) {
                if labels[place].is_some_and(|known| known != color) {
                    return Err(cell);
                }
                labels[place] = Some(color);
            }
        }
        Ok(labels.into_iter().flatten().collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tiles::{Colors, Members};

    #[test]
    fn labels_and_tiles_describe_the_same_packing() {
        for (kind, w, h) in [(Kind::Corner, 4, 3), (Kind::Wang, 3, 2), (Kind::Domino, 5, 1)] {
            let set = TileSet::new(kind, Colors::one(3).unwrap(), Members::Complete).unwrap();
            let lattice = Lattice { kind, shape: Shape::new(w, h).unwrap() };
            let labels: Vec<u8> = (0..lattice.labels()).map(|i| (i * i % 7 % 3) as u8).collect();
            let packing = lattice.packing(&labels, &set, false);
            assert_eq!(Lattice::labels_of(&packing), Ok(labels));
        }
    }

    #[test]
    fn a_mismatch_is_found() {
        let set = TileSet::new(Kind::Domino, Colors::one(2).unwrap(), Members::Complete).unwrap();
        let shape = Shape::new(2, 1).unwrap();
        let packing = Packing::new(set, shape, false, vec![TileId(1), TileId(1)]);
        assert_eq!(Lattice::labels_of(&packing), Err(Cell(1)));
    }
}

//! The eight rotations and reflections of the square, acting on tiles and on a torus.
//!
//! Every one is "exchange rows and columns, or not; then reverse the rows, or not; then reverse
//! the columns, or not", about the north-west corner of cell (0, 0). Doubled coordinates give
//! every place whole numbers: lattice points are (even, even), cell centers (odd, odd), north
//! edges (even, odd), west edges (odd, even). One linear map then moves all of them, and the
//! east edge that a reflection turns into a west edge finds its owner, the next cell, by itself.
//! A moved tile is another tile: these are symmetries of the *set of packings*.
//!
//! A ring of dominoes has one reflection, its reversal; here that is the half turn.

use crate::tiles::{Colors, Kind, TileId};
use crate::torus::{Cell, Lattice, Shape};

/// A rotation or reflection of the square; rows run south, columns east.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Isometry {
    transposes: bool,
    reverses_rows: bool,
    reverses_columns: bool,
}

/// A displacement or place in doubled coordinates: rows to the south, columns to the east.
type Doubled = (i64, i64);

impl Isometry {
    /// Changes nothing.
    pub const IDENTITY: Self = Self::new(false, false, false);
    /// By 90 degrees clockwise: north becomes east.
    pub const QUARTER_TURN: Self = Self::new(true, false, true);
    /// By 180 degrees; the reversal of a ring of dominoes.
    pub const HALF_TURN: Self = Self::new(false, true, true);
    /// By 270 degrees clockwise: north becomes west.
    pub const THREE_QUARTER_TURN: Self = Self::new(true, true, false);
    /// Exchanges east and west.
    pub const MIRROR_EAST_WEST: Self = Self::new(false, false, true);
    /// Exchanges north and south.
    pub const MIRROR_NORTH_SOUTH: Self = Self::new(false, true, false);
    /// Through the diagonal from north-west to south-east: exchanges north and west.
    pub const MIRROR_DIAGONAL: Self = Self::new(true, false, false);
    /// Through the diagonal from south-west to north-east: exchanges north and east.
    pub const MIRROR_ANTIDIAGONAL: Self = Self::new(true, true, true);

    /// All eight, the identity first.
    pub const ALL: [Self; 8] = [
        Self::IDENTITY,
        Self::QUARTER_TURN,
        Self::HALF_TURN,
        Self::THREE_QUARTER_TURN,
        Self::MIRROR_EAST_WEST,
        Self::MIRROR_NORTH_SOUTH,
        Self::MIRROR_DIAGONAL,
        Self::MIRROR_ANTIDIAGONAL,
    ];

    const fn new(transposes: bool, reverses_rows: bool, reverses_columns: bool) -> Self {
        Self { transposes, reverses_rows, reverses_columns }
    }

    /// Whether rows become columns: width and height change places, and so do the palettes of
    /// Wang tiles.
    pub fn transposes(self) -> bool {
        self.transposes
    }

    /// First `self`, then `next`.
    pub fn then(self, next: Self) -> Self {
        // Reversing rows before a transposition is reversing columns after it.
        let (rows, columns) = self.reversals_after(next.transposes);
        Self {
            transposes: self.transposes != next.transposes,
            reverses_rows: rows != next.reverses_rows,
            reverses_columns: columns != next.reverses_columns,
        }
    }

    /// The one that undoes this one.
    pub fn inverse(self) -> Self {
        let (reverses_rows, reverses_columns) = self.reversals_after(self.transposes);
        Self { transposes: self.transposes, reverses_rows, reverses_columns }
    }

    fn reversals_after(self, transposition: bool) -> (bool, bool) {
        let (rows, columns) = (self.reverses_rows, self.reverses_columns);
        if transposition { (columns, rows) } else { (rows, columns) }
    }

    /// Whether it maps this torus to itself and, for Wang tiles, each palette to one of equal
    /// size; of dominoes, only the identity and the reversal are asked for.
    pub fn fits(self, lattice: Lattice, colors: Colors) -> bool {
        let shape = lattice.shape;
        match lattice.kind {
            Kind::Domino => self == Self::IDENTITY || self == Self::HALF_TURN,
            _ if !self.transposes => true,
            Kind::Corner => shape.width() == shape.height(),
            Kind::Wang => shape.width() == shape.height() && colors.single().is_some(),
        }
    }

    /// The side of the image that side number `side` of a tile becomes, both in the order of
    /// [`Kind::sides`]; `None` when there is no such side, or when a domino would be turned off
    /// its line.
    pub fn side(self, kind: Kind, side: usize) -> Option<usize> {
        let sides = sides_from_center(kind);
        let image = self.apply(*sides.get(side)?);
        sides.iter().position(|&offset| offset == image)
    }

    /// The tile that `tile` becomes; `None` when a color is too large for the palette it gets
    /// to, or a domino would be turned off its line.
    pub fn tile(self, kind: Kind, colors: Colors, tile: TileId) -> Option<TileId> {
        let sides = kind.unpack(tile, colors);
        let mut image = [0; 4];
        let count = kind.sides().len();
        for (i, &color) in sides.iter().enumerate().take(count) {
            image[self.side(kind, i)?] = color;
        }
        kind.pack(&image[..count], colors).ok()
    }

    /// The cell that `cell` becomes; the isometry must fit the torus.
    pub fn cell(self, lattice: Lattice, cell: Cell) -> Cell {
        let (row, column) = lattice.shape.position(cell);
        owner(lattice, self.apply((2 * row as i64 + 1, 2 * column as i64 + 1))).0
    }

    /// The translation that is to this isometry as the one by `rows` and `columns` is before it:
    /// "translate, then move" equals "move, then translate by the result".
    pub fn translation(self, shape: Shape, rows: usize, columns: usize) -> (usize, usize) {
        let (rows, columns) = self.apply((rows as i64, columns as i64));
        let (height, width) = (shape.height() as i64, shape.width() as i64);
        (rows.rem_euclid(height) as usize, columns.rem_euclid(width) as usize)
    }

    /// The place, in the array of labels, that the label at `place` gets to; the isometry must
    /// fit the torus.
    pub fn place(self, lattice: Lattice, place: usize) -> usize {
        let (cell, lies_in_row) = owner(lattice, self.apply(doubled(lattice, place)));
        match lattice.kind {
            Kind::Wang => 2 * cell.index() + usize::from(lies_in_row),
            Kind::Corner | Kind::Domino => cell.index(),
        }
    }

    /// For every place of the image, the place its label comes from.
    pub fn sources(self, lattice: Lattice) -> Vec<usize> {
        let inverse = self.inverse();
        (0..lattice.labels()).map(|place| inverse.place(lattice, place)).collect()
    }

    fn apply(self, (row, column): Doubled) -> Doubled {
        let (row, column) = if self.transposes { (column, row) } else { (row, column) };
        let reverse = |reverses: bool, steps: i64| if reverses { -steps } else { steps };
        (reverse(self.reverses_rows, row), reverse(self.reverses_columns, column))
    }
}

/// Where the sides of a tile are, seen from its center.
fn sides_from_center(kind: Kind) -> &'static [Doubled] {
    match kind {
        Kind::Corner => &[(-1, 1), (1, 1), (1, -1), (-1, -1)],
        Kind::Wang => &[(-1, 0), (0, 1), (1, 0), (0, -1)],
        // In a row or down a column; only the half turn, which is the same for both, is used.
        Kind::Domino => &[(0, -1), (0, 1)],
    }
}

/// Where the label at `place` lies.
fn doubled(lattice: Lattice, place: usize) -> Doubled {
    let per_cell = lattice.per_cell();
    let (row, column) = lattice.shape.position(Cell((place / per_cell) as u32));
    let (row, column) = (2 * row as i64, 2 * column as i64);
    let west_edge = match lattice.kind {
        Kind::Corner => return (row, column),
        Kind::Wang => place % per_cell == 1,
        Kind::Domino => lattice.shape.height() == 1,
    };
    if west_edge { (row + 1, column) } else { (row, column + 1) }
}

/// The cell whose point, edge or center is at `(row, column)`, and whether that is in the
/// middle of a row (a west edge or a center) rather than between two rows.
fn owner(lattice: Lattice, (row, column): Doubled) -> (Cell, bool) {
    let shape = lattice.shape;
    let row = row.rem_euclid(2 * shape.height() as i64) as usize;
    let column = column.rem_euclid(2 * shape.width() as i64) as usize;
    (shape.cell(row / 2, column / 2), row % 2 == 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_what_they_do() {
        let [n, e, s, w] = [0, 1, 2, 3];
        let side = |isometry: Isometry, side| isometry.side(Kind::Wang, side).unwrap();
        assert_eq!([n, e, s, w].map(|i| side(Isometry::QUARTER_TURN, i)), [e, s, w, n]);
        assert_eq!([n, e, s, w].map(|i| side(Isometry::HALF_TURN, i)), [s, w, n, e]);
        assert_eq!([n, e, s, w].map(|i| side(Isometry::THREE_QUARTER_TURN, i)), [w, n, e, s]);
        assert_eq!([n, e, s, w].map(|i| side(Isometry::MIRROR_EAST_WEST, i)), [n, w, s, e]);
        assert_eq!([n, e, s, w].map(|i| side(Isometry::MIRROR_NORTH_SOUTH, i)), [s, e, n, w]);
        assert_eq!([n, e, s, w].map(|i| side(Isometry::MIRROR_DIAGONAL, i)), [w, s, e, n]);
        assert_eq!([n, e, s, w].map(|i| side(Isometry::MIRROR_ANTIDIAGONAL, i)), [e, n, w, s]);
        let (ne, se, sw, nw) = (0, 1, 2, 3);
        let keeps_ne = |i| Isometry::MIRROR_ANTIDIAGONAL.side(Kind::Corner, i).unwrap();
        assert_eq!([ne, se, sw, nw].map(keeps_ne), [ne, nw, sw, se]);
        assert_eq!(Isometry::HALF_TURN.side(Kind::Domino, 0), Some(1));
        assert_eq!(Isometry::QUARTER_TURN.side(Kind::Domino, 0), None);
        assert_eq!(Isometry::IDENTITY.side(Kind::Domino, 2), None);
    }

    #[test]
    fn they_are_a_group() {
        for a in Isometry::ALL {
            assert_eq!(a.then(a.inverse()), Isometry::IDENTITY);
            for b in Isometry::ALL {
                assert!(Isometry::ALL.contains(&a.then(b)));
                assert_eq!(a.then(b).apply((3, 5)), b.apply(a.apply((3, 5))));
            }
        }
    }
}

//! Boards: which sides of cells meet, and what is asked of those that do not.
//!
//! On a torus every side meets another one. A cylinder wraps from west to east, so that its
//! north and south sides are *outer* sides; all four of a rectangle are. Outer sides are free,
//! or have a color prescribed, which is the *border*. Tiles are fixed, or squares that may be
//! turned ([`crate::tiles::turn`]).
//!
//! [`Edges`] numbers the places where colors are: the north and west edges of all cells, as a
//! [`Lattice`](super::Lattice) has them, then the outer east edges from the north, then the
//! outer south edges from the west. The colors at all places are a picture of the board.

use super::{Cell, Shape};
use std::fmt;
use std::str::FromStr;

/// The sides of a cell or board: north, east, south, west.
pub const SIDES: [&str; 4] = ["north", "east", "south", "west"];

/// Which seams are closed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Topology {
    /// Both.
    #[default]
    Torus,
    /// East and west meet.
    Cylinder,
    /// None.
    Rectangle,
}

impl Topology {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Torus, Self::Cylinder, Self::Rectangle];

    /// The name used in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Torus => "torus",
            Self::Cylinder => "cylinder",
            Self::Rectangle => "rectangle",
        }
    }

    /// Whether this side of the board, numbered as [`SIDES`], is an outer one.
    pub fn is_outer(self, side: usize) -> bool {
        match self {
            Self::Torus => false,
            Self::Cylinder => side.is_multiple_of(2),
            Self::Rectangle => true,
        }
    }
}

impl fmt::Display for Topology {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Topology {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let named = Self::ALL.into_iter().find(|topology| topology.name() == text);
        named.ok_or_else(|| format!("topology '{text}': expected torus, cylinder or rectangle"))
    }
}

/// The colors prescribed at outer sides.
///
/// Invariant: the list of a side is empty, where all of it is free, or as long as the side, and
/// then some color in it is prescribed.
#[derive(Debug, Clone, PartialEq, Eq, Default, Hash)]
pub struct Border {
    sides: [Vec<Option<u8>>; 4],
}

/// A border that does not suit its board.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum BorderError {
    /// There is no such side.
    #[error("a {topology} has no border in the {side}")]
    NotOuter {
        /// The board.
        topology: Topology,
        /// Its side.
        side: &'static str,
    },
    /// A list of another length.
    #[error("the border has {given} colors in the {side}, but the board has {length} cells there")]
    Length {
        /// The side.
        side: &'static str,
        /// The length of the list.
        given: usize,
        /// The length of the side.
        length: usize,
    },
}

impl Border {
    /// These colors, by side in the order of [`SIDES`]: from west to east and from north to
    /// south; an empty list is a free side.
    ///
    /// # Errors
    /// A list for a side that meets another one, or of another length than its side.
    pub fn new(
        topology: Topology,
        shape: Shape,
        mut sides: [Vec<Option<u8>>; 4],
    ) -> Result<Self, BorderError> {
        for (side, colors) in sides.iter_mut().enumerate() {
            let (name, given, length) = (SIDES[side], colors.len(), length(shape, side));
            if given > 0 && !topology.is_outer(side) {
                return Err(BorderError::NotOuter { topology, side: name });
            }
            if given > 0 && given != length {
                return Err(BorderError::Length { side: name, given, length });
            }
            if colors.iter().all(Option::is_none) {
                colors.clear();
            }
        }
        Ok(Self { sides })
    }

    /// One color at all outer sides.
    pub fn of_one(topology: Topology, shape: Shape, color: u8) -> Self {
        let side = |side| match topology.is_outer(side) {
            true => vec![Some(color); length(shape, side)],
            false => Vec::new(),
        };
        Self { sides: std::array::from_fn(side) }
    }

    /// The colors of a side; empty where it is free.
    pub fn side(&self, side: usize) -> &[Option<u8>] {
        &self.sides[side]
    }

    /// The color prescribed at this place of a side.
    pub fn color(&self, side: usize, place: usize) -> Option<u8> {
        self.sides[side].get(place).copied().flatten()
    }

    /// Whether nothing is prescribed.
    pub fn is_free(&self) -> bool {
        self.sides.iter().all(Vec::is_empty)
    }

    /// The one color of all outer sides.
    pub fn single(&self, topology: Topology, shape: Shape) -> Option<u8> {
        let color = self.sides.iter().flatten().copied().flatten().next()?;
        (*self == Self::of_one(topology, shape, color)).then_some(color)
    }
}

/// The length of a side.
fn length(shape: Shape, side: usize) -> usize {
    if side.is_multiple_of(2) { shape.width() } else { shape.height() }
}

/// What a packing lies on, besides its size, and whether its tiles may be turned.
#[derive(Debug, Clone, PartialEq, Eq, Default, Hash)]
pub struct Board {
    /// Which seams are closed.
    pub topology: Topology,
    /// Tiles are squares that may be turned.
    pub rotations: bool,
    /// What is prescribed at outer sides.
    pub border: Border,
}

impl Board {
    /// Whether it is a torus of fixed tiles.
    pub fn is_plain(&self) -> bool {
        *self == Self::default()
    }
}

/// The places of the colors of a board.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Edges {
    /// Width and height.
    pub shape: Shape,
    /// Which seams are closed.
    pub topology: Topology,
}

impl Edges {
    /// How many places there are.
    pub fn labels(self) -> usize {
        let outer = |side| if self.topology.is_outer(side) { length(self.shape, side) } else { 0 };
        2 * self.shape.cells() + outer(1) + outer(2)
    }

    /// The places of the sides N, E, S, W of a cell.
    pub fn sides(self, cell: Cell) -> [usize; 4] {
        let (shape, (row, column)) = (self.shape, self.shape.position(cell));
        let at = |rows, columns| shape.step(cell, rows, columns).index();
        let (outer_east, outer_south) = (self.topology.is_outer(1), self.topology.is_outer(2));
        let east = match outer_east && column + 1 == shape.width() {
            true => 2 * shape.cells() + row,
            false => 2 * at(0, 1) + 1,
        };
        let south = match outer_south && row + 1 == shape.height() {
            true => 2 * shape.cells() + if outer_east { shape.height() } else { 0 } + column,
            false => 2 * at(1, 0),
        };
        [2 * at(0, 0), east, south, 2 * at(0, 0) + 1]
    }

    /// The outer places: side, number from the west or north, place.
    pub fn outer(self) -> impl Iterator<Item = (usize, usize, usize)> {
        let shape = self.shape;
        let outer = (0..4).filter(move |&side| self.topology.is_outer(side));
        outer.flat_map(move |side| {
            (0..length(shape, side)).map(move |at| {
                let (row, column) = match side {
                    0 => (0, at),
                    1 => (at, shape.width() - 1),
                    2 => (shape.height() - 1, at),
                    _ => (at, 0),
                };
                (side, at, self.sides(shape.cell(row, column))[side])
            })
        })
    }

    /// The colors that a border prescribes, by place.
    pub fn given(self, border: &Border) -> Vec<Option<u8>> {
        let mut given = vec![None; self.labels()];
        for (side, at, place) in self.outer() {
            given[place] = border.color(side, at);
        }
        given
    }
}

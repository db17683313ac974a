//! Checking a packing of cubes from the definition.
//!
//! A packing of cubes is right when the torus has as many cells as there are cubes, every number
//! is that of a cube, every two neighbors agree where they meet (corner cubes on all four corners
//! of the face between them, Wang cubes on the color of that face), also around the torus in all
//! three directions, and every cube occurs once. Numbers are read here by themselves.
//!
//! Layers in messages count from 0 from the bottom, rows from the north, columns from the west.

use crate::torus::{CubeKind, Cubes};
use std::fmt;

/// A cell of a torus in space, for messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CubePlace {
    /// 0-based, from the bottom.
    pub layer: usize,
    /// 0-based, from the north.
    pub row: usize,
    /// 0-based, from the west.
    pub column: usize,
}

impl fmt::Display for CubePlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "layer {}, row {}, column {}", self.layer, self.row, self.column)
    }
}

/// What is wrong with a packing of cubes.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum CubesFault {
    /// The torus does not have as many cells as there are cubes.
    #[error("size {0}x{1}x{2} does not suit {3} cubes of which {4} are given", .sides[2], .sides[1],
        .sides[0], .cubes, .given)]
    Size {
        /// Layers, rows, columns.
        sides: [usize; 3],
        /// The cubes over the colors.
        cubes: u64,
        /// The length of the list.
        given: usize,
    },
    /// There is no cube with this number.
    #[error("{at}: cube {cube} is out of range: expected 0 to {max}")]
    Range {
        /// The cell.
        at: CubePlace,
        /// The number.
        cube: u32,
        /// The largest number.
        max: u64,
    },
    /// Two neighbors disagree.
    #[error(
        "{at}: {part} has color {color}, but {other} of the cube {direction} ({neighbor}) has \
             color {meets}"
    )]
    Mismatch {
        /// The cell.
        at: CubePlace,
        /// The corner or face of its cube.
        part: &'static str,
        /// The color there.
        color: u64,
        /// `to the east`, `to the south` or `above`.
        direction: &'static str,
        /// The cell there.
        neighbor: CubePlace,
        /// The corner or face of its cube.
        other: &'static str,
        /// The color there.
        meets: u64,
    },
    /// A cube occurs again.
    #[error("{again}: cube {cube} again; it is at {first}, too")]
    Repeated {
        /// The number.
        cube: u32,
        /// The first place.
        first: CubePlace,
        /// The second.
        again: CubePlace,
    },
}

impl CubesFault {
    /// Whether the size of the torus is wrong, whatever the cubes.
    pub fn is_size(&self) -> bool {
        matches!(self, CubesFault::Size { .. })
    }
}

/// Names of the colors of a cube, in the order of the digits of its number.
const CORNERS: [&str; 8] = [
    "lower NE", "lower SE", "lower SW", "lower NW", "upper NE", "upper SE", "upper SW", "upper NW",
];
const FACES: [&str; 6] = ["north", "east", "south", "west", "bottom", "top"];

/// A direction, the step there (layers, rows, columns), and which color here meets which there.
type Direction = (&'static str, [usize; 3], &'static [(usize, usize)]);

const CORNER_DIRECTIONS: [Direction; 3] = [
    ("to the east", [0, 0, 1], &[(0, 3), (1, 2), (4, 7), (5, 6)]),
    ("to the south", [0, 1, 0], &[(2, 3), (1, 0), (6, 7), (5, 4)]),
    ("above", [1, 0, 0], &[(4, 0), (5, 1), (6, 2), (7, 3)]),
];
const FACE_DIRECTIONS: [Direction; 3] = [
    ("to the east", [0, 0, 1], &[(1, 3)]),
    ("to the south", [0, 1, 0], &[(2, 0)]),
    ("above", [1, 0, 0], &[(5, 4)]),
];

/// Checks that the cubes are a packing. Takes four bytes a cube.
///
/// # Errors
/// The first fault: of the size, then of the numbers, then of neighbors, then a repetition.
pub fn check_cube_packing(packing: &Cubes) -> Result<(), CubesFault> {
    let [h, v, z] = packing.set.colors.map(u64::from);
    let (radices, names, directions): (Vec<u64>, &[&str], _) = match packing.set.kind {
        CubeKind::Corner => (vec![h; 8], &CORNERS, CORNER_DIRECTIONS),
        CubeKind::Wang => (vec![h, v, h, v, z, z], &FACES, FACE_DIRECTIONS),
    };
    let (sides, given) = (packing.sides, packing.cubes.len());
    let cubes = radices.iter().try_fold(1u64, |all, &radix| all.checked_mul(radix));
    let cubes = cubes.unwrap_or(u64::MAX);
    let cells = sides.iter().try_fold(1usize, |all, &side| all.checked_mul(side));
    if cells != Some(given) || cubes != given as u64 {
        return Err(CubesFault::Size { sides, cubes, given });
    }
    let [layers, rows, columns] = sides;
    let index = |at: CubePlace| (at.layer * rows + at.row) * columns + at.column;
    let place = |i: usize| CubePlace {
        layer: i / (rows * columns),
        row: i / columns % rows,
        column: i % columns,
    };
    let colors = |at: CubePlace| {
        let mut rest = u64::from(packing.cubes[index(at)]);
        let mut colors = [0; 8];
        for (color, &radix) in colors.iter_mut().zip(&radices).rev() {
            (*color, rest) = (rest % radix, rest / radix);
        }
        colors
    };
    for (i, &cube) in packing.cubes.iter().enumerate() {
        if u64::from(cube) >= cubes {
            return Err(CubesFault::Range { at: place(i), cube, max: cubes - 1 });
        }
    }
    for at in (0..given).map(place) {
        let ours = colors(at);
        for (direction, [l, r, c], pairs) in directions {
            let neighbor = CubePlace {
                layer: (at.layer + l) % layers,
                row: (at.row + r) % rows,
                column: (at.column + c) % columns,
            };
            let theirs = colors(neighbor);
            if let Some(&(a, b)) = pairs.iter().find(|&&(a, b)| ours[a] != theirs[b]) {
                let (part, other) = (names[a], names[b]);
                let (color, meets) = (ours[a], theirs[b]);
                return Err(CubesFault::Mismatch {
                    at,
                    part,
                    color,
                    direction,
                    neighbor,
                    other,
                    meets,
                });
            }
        }
    }
    let mut first: Vec<Option<u32>> = vec![None; given];
    for (i, &cube) in packing.cubes.iter().enumerate() {
        if let Some(before) = first[cube as usize].replace(i as u32) {
            let (first, again) = (place(before as usize), place(i));
            return Err(CubesFault::Repeated { cube, first, again });
        }
    }
    Ok(())
}

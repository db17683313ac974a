//! Claims about whether a set of tiles fills the plane, checked from the definition.
//!
//! * A torus: every tile number exists, and neighbors match, also across the seams.
//! * A square that cannot be filled: all its partial fillings are gone through cell by cell, of
//!   those that border on the rest alike only one is kept, and none reaches the last cell.
//! * An empty power: strips of k rows are put together row by row as a graph with the labels on
//!   their W and E ends as vertices. A tiling far to the east uses only arcs on cycles, and far
//!   to the south only arcs on cycles from N to S label; when no such arc is left, there is no
//!   tiling.
//! * A set like another one: a symmetry and a renaming of labels take one to the other.
//!
//! Like all of this module it shares nothing with what decides sets.
//!
//! Source: Jeandel and Rao 2021, section 3, for the argument about powers.

mod likeness;
mod square;
mod strip;

use crate::tiles::Kind;
use std::collections::BTreeSet;

/// What is said about a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Claim {
    /// Tiles fit on a torus; their numbers, row after row.
    Torus {
        /// Cells of a row.
        width: usize,
        /// Rows.
        height: usize,
        /// The numbers of the tiles.
        cells: Vec<usize>,
    },
    /// No square of this side can be filled.
    NoSquare {
        /// Cells of a row.
        side: usize,
    },
    /// The power of so many rows (or columns) is empty.
    NoStrip {
        /// Of rows, else of columns.
        rows: bool,
        /// How many.
        power: usize,
    },
    /// The set becomes another one.
    Like {
        /// The tiles of the other set.
        other: Vec<[u32; 4]>,
        /// The side of this set that becomes side 0, 1, 2, 3 of the other one.
        sides: [usize; 4],
        /// The tile of the other set that each tile becomes.
        images: Vec<usize>,
    },
}

/// What is wrong with a claim.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ClaimFault {
    /// Dominoes.
    #[error("expected corner or Wang tiles, not dominoes")]
    Dominoes,
    /// A tile listed twice.
    #[error("tile {0:?} is listed twice")]
    Twice([u32; 4]),
    /// A torus without cells, or with more or fewer than it should have.
    #[error("a torus of {width} x {height} has another number of cells than {given}")]
    Cells {
        /// Cells of a row.
        width: usize,
        /// Rows.
        height: usize,
        /// Cells listed.
        given: usize,
    },
    /// A number that no tile has.
    #[error("row {row}, column {column}: tile {tile}, but the tiles are 0 to {most}")]
    Range {
        /// Where.
        row: usize,
        /// Where.
        column: usize,
        /// What is there.
        tile: usize,
        /// The largest number.
        most: usize,
    },
    /// Neighbors that do not fit.
    #[error(
        "row {row}, column {column}: tile {tile} does not fit to tile {neighbor} to its {side}"
    )]
    Neighbors {
        /// Where.
        row: usize,
        /// Where.
        column: usize,
        /// What is there.
        tile: usize,
        /// What is beside it.
        neighbor: usize,
        /// On which side: east or south.
        side: &'static str,
    },
    /// A square that can be filled.
    #[error("a square of {0} x {0} can be filled")]
    Filled(usize),
    /// A power with arcs.
    #[error("the power of {power} {of} is not empty: {arcs} arcs are left")]
    Left {
        /// Rows or columns.
        power: usize,
        /// Which.
        of: &'static str,
        /// How many are left.
        arcs: usize,
    },
    /// A side or a power of 0, for which the claim says nothing.
    #[error("a square or power of size 0 says nothing")]
    Nothing,
    /// More work than the check takes on.
    #[error("too large to be checked: more than {0} steps")]
    TooLarge(usize),
    /// What takes one set to the other does not.
    #[error("not the same set: {0}")]
    Unlike(String),
}

/// Checks what is said about tiles, which are listed as in tile set files. Takes memory for at
/// most `most` partial fillings, or arcs.
///
/// # Errors
/// What is wrong with it.
pub fn check_claim(
    kind: Kind,
    tiles: &[[u32; 4]],
    claim: &Claim,
    most: usize,
) -> Result<(), ClaimFault> {
    if kind == Kind::Domino {
        return Err(ClaimFault::Dominoes);
    }
    let mut seen = BTreeSet::new();
    if let Some(&twice) = tiles.iter().find(|&&tile| !seen.insert(tile)) {
        return Err(ClaimFault::Twice(twice));
    }
    match claim {
        Claim::Torus { width, height, cells } => torus(kind, tiles, (*width, *height), cells),
        Claim::NoSquare { side: 0 } | Claim::NoStrip { power: 0, .. } => Err(ClaimFault::Nothing),
        Claim::NoSquare { side } => square::check(kind, tiles, *side, most),
        Claim::NoStrip { rows, power } => strip::check(kind, tiles, *rows, *power, most),
        Claim::Like { other, sides, images } => likeness::check(kind, tiles, other, *sides, images),
    }
}

/// What a tile shows to the north, east, south, west: a label, or the colors of two corners in
/// the order west to east or north to south.
fn sides(kind: Kind, tile: [u32; 4]) -> [(u32, u32); 4] {
    match kind {
        Kind::Wang => tile.map(|label| (label, label)),
        _ => {
            let [nw, ne, se, sw] = tile;
            [(nw, ne), (ne, se), (sw, se), (nw, sw)]
        }
    }
}

fn torus(
    kind: Kind,
    tiles: &[[u32; 4]],
    (width, height): (usize, usize),
    cells: &[usize],
) -> Result<(), ClaimFault> {
    if cells.is_empty() || width.checked_mul(height) != Some(cells.len()) {
        return Err(ClaimFault::Cells { width, height, given: cells.len() });
    }
    for (at, &tile) in cells.iter().enumerate() {
        let (row, column) = (at / width, at % width);
        if tile >= tiles.len() {
            // There may be no tile at all; any number is then too large.
            return Err(ClaimFault::Range { row, column, tile, most: tiles.len().max(1) - 1 });
        }
    }
    for (at, &tile) in cells.iter().enumerate() {
        let (row, column) = (at / width, at % width);
        let east = cells[row * width + (column + 1) % width];
        let south = cells[(row + 1) % height * width + column];
        for (neighbor, mine, theirs, side) in [(east, 1, 3, "east"), (south, 2, 0, "south")] {
            if sides(kind, tiles[tile])[mine] != sides(kind, tiles[neighbor])[theirs] {
                return Err(ClaimFault::Neighbors { row, column, tile, neighbor, side });
            }
        }
    }
    Ok(())
}

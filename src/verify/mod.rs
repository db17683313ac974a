//! Re-checking a packing from the definition.
//!
//! A packing is right when every tile number exists, every tile belongs to the set, the torus
//! has as many cells as the set has tiles, every two neighbors agree on the color they share,
//! also across both seams, and every tile occurs exactly once. (A covering may have more cells,
//! and a tile may occur again.) On a board some seams are open and outer sides may have colors
//! prescribed; squares may be turned, and the set may list several that are alike. That is all this module looks at. It shares no code with the
//! search, the constructions, the symmetries or the files, and reads tile numbers by itself, so
//! that a mistake there cannot hide here.
//!
//! Rows and columns in messages count from 0, rows from the north, columns from the west.
//!
//! Source: Lagae 2007, sections 2.2 and 5.5; Schlömer 2012, sections 2.4 and 3.3.

mod board;
mod cubes;
mod decode;
mod fault;
mod members;
mod neighbors;
mod occurrences;
mod recursion;
mod refutation;
mod rows;
mod toral;

pub use cubes::{CubePlace, CubesFault, check_cube_packing};
pub use fault::{Fault, Place, Tile, Touch};
pub use recursion::{Block, NotRecursive, Recursion, check_recursion};
pub use refutation::{Claim, ClaimFault, check_claim};
pub use rows::{RowCheck, RowFault};
pub use toral::{
    CertificateFault, ProvedSet, Step, WayBack, check_certificate, check_corner_tiles,
};

use crate::tiles::Kind;
use crate::torus::Packing;
use decode::Numbering;
use members::Membership;
use std::fmt;

/// At most so many faults of each sort are kept; all are counted.
pub const KEPT: usize = 20;

/// What became of a check: the faults found, the most telling first.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Verdict {
    faults: Vec<Fault>,
    total: u64,
    kept: usize,
}

impl Verdict {
    /// Whether the packing is right.
    pub fn is_valid(&self) -> bool {
        self.total == 0
    }

    /// The faults kept, at most [`KEPT`] of a sort: size, tile numbers out of range, tiles
    /// outside the set, neighbors that do not fit, outer sides that do not fit the border, a third tile of a class of a compact set,
    /// tiles that occur again, tiles missing.
    pub fn faults(&self) -> &[Fault] {
        &self.faults
    }

    /// The number of faults found, also those that were not kept. A size or a tile number that
    /// is wrong leaves nothing to say about the rest, so the rest is then not looked at.
    pub fn total(&self) -> u64 {
        self.total
    }

    /// Whether the torus has the wrong size for the set: a mistake in the question rather than
    /// an answer to it.
    pub fn is_wrong_size(&self) -> bool {
        self.faults.iter().any(Fault::is_size)
    }

    /// Begins another sort of fault.
    fn next_sort(&mut self) {
        self.kept = 0;
    }

    /// Counts `count` faults, whether they are kept or not.
    fn count(&mut self, count: u64) {
        self.total += count;
    }

    /// Keeps an already counted fault unless there are enough of its sort.
    fn keep(&mut self, fault: impl FnOnce() -> Fault) {
        if !self.is_full() {
            self.faults.push(fault());
            self.kept += 1;
        }
    }

    /// Counts one fault, and keeps it unless there are enough of its sort.
    fn add(&mut self, fault: impl FnOnce() -> Fault) {
        self.count(1);
        self.keep(fault);
    }

    fn is_full(&self) -> bool {
        self.kept >= KEPT
    }
}

impl fmt::Display for Verdict {
    /// One line: `valid`, or the first fault and how many more there are.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.faults.first(), self.total) {
            (None, _) => f.write_str("valid"),
            (Some(fault), 1) => write!(f, "{fault}"),
            (Some(fault), 2) => write!(f, "{fault} (and 1 more fault)"),
            (Some(fault), total) => write!(f, "{fault} (and {} more faults)", total - 1),
        }
    }
}

/// Checks that the tiles are a packing (or covering) of their set.
///
/// Takes memory in proportion to the cells, and time in proportion to the cells and, to name
/// missing tiles, to the members of the set up to the last one named.
pub fn check(packing: &Packing) -> Verdict {
    let mut verdict = Verdict::default();
    let numbering = Numbering::new(&packing.set);
    let members = Membership::new(&packing.set, &numbering);
    check_size(packing, &members, &mut verdict);
    board::check_sense(packing, &mut verdict);
    check_range(packing, &numbering, &mut verdict);
    if verdict.is_valid() {
        members::check(packing, &numbering, &members, &mut verdict);
        neighbors::check(packing, &numbering, &mut verdict);
        board::check_border(packing, &numbering, &mut verdict);
        match board::lists_again(packing) {
            true => board::check_copies(packing, &numbering, &mut verdict),
            false => occurrences::check(packing, &numbering, &members, &mut verdict),
        }
    }
    verdict
}

fn check_size(packing: &Packing, members: &Membership<'_>, verdict: &mut Verdict) {
    verdict.next_sort();
    let (shape, given) = (packing.shape, packing.tiles.len());
    if given != shape.cells() {
        verdict.add(|| Fault::Cells { shape, given });
    }
    if packing.set.kind() == Kind::Domino && shape.width() > 1 && shape.height() > 1 {
        verdict.add(|| Fault::NotARing { shape });
    }
    let (cells, tiles, cover) = (shape.cells() as u64, members.size(), packing.cover);
    if cells < tiles || (cells > tiles && !cover) {
        verdict.add(|| Fault::Size { shape, tiles, cover });
    }
}

fn check_range(packing: &Packing, numbering: &Numbering, verdict: &mut Verdict) {
    verdict.next_sort();
    let universe = numbering.universe();
    for (index, &tile) in packing.tiles.iter().enumerate() {
        if u64::from(tile.0) >= universe {
            let at = Place::of(index, packing.shape);
            verdict.add(|| Fault::Range { at, tile: tile.0, max: universe - 1 });
        }
    }
}

//! Do neighbors agree on the color they share, also across the seams that are closed?
//!
//! Every cell is compared with its neighbor to the east and to the south, which covers every
//! pair once. Corner tiles share two corners with each; that the four tiles around a lattice
//! point agree follows from the pairs. A ring of dominoes has one direction only.

use super::board::{closes_eastward, closes_southward, shown};
use super::decode::Numbering;
use super::{Fault, Place, Touch, Verdict};
use crate::tiles::Kind;
use crate::torus::Packing;

/// A digit of the tile that must equal a digit of its neighbor, each with its name.
type Shared = ((usize, &'static str), (usize, &'static str));

const CORNER_EAST: &[Shared] =
    &[((0, "NE corner"), (3, "NW corner")), ((1, "SE corner"), (2, "SW corner"))];
const CORNER_SOUTH: &[Shared] =
    &[((2, "SW corner"), (3, "NW corner")), ((1, "SE corner"), (0, "NE corner"))];
const WANG_EAST: &[Shared] = &[((1, "east side"), (3, "west side"))];
const WANG_SOUTH: &[Shared] = &[((2, "south side"), (0, "north side"))];
const DOMINO: &[Shared] = &[((1, "second end"), (0, "first end"))];

/// Reports every two neighbors that disagree.
pub(super) fn check(packing: &Packing, numbering: &Numbering, verdict: &mut Verdict) {
    verdict.next_sort();
    let (width, height) = (packing.shape.width(), packing.shape.height());
    let (east, south) = match numbering.kind() {
        Kind::Corner => (CORNER_EAST, CORNER_SOUTH),
        Kind::Wang => (WANG_EAST, WANG_SOUTH),
        Kind::Domino if height > 1 => (&[][..], DOMINO),
        Kind::Domino => (DOMINO, &[][..]),
    };
    let (eastward, southward) = (closes_eastward(packing), closes_southward(packing));
    for row in 0..height {
        for column in 0..width {
            let this = Place { row, column };
            let eastern = Place { row, column: (column + 1) % width };
            let southern = Place { row: (row + 1) % height, column };
            if eastward || column + 1 < width {
                compare(packing, numbering, (this, "east", eastern), east, verdict);
            }
            if southward || row + 1 < height {
                compare(packing, numbering, (this, "south", southern), south, verdict);
            }
        }
    }
}

fn compare(
    packing: &Packing,
    numbering: &Numbering,
    (at, direction, neighbor): (Place, &'static str, Place),
    shared: &[Shared],
    verdict: &mut Verdict,
) {
    let digits = |place: Place| shown(packing, numbering, place);
    let (mine, theirs) = (digits(at), digits(neighbor));
    for &((my_digit, my_part), (their_digit, their_part)) in shared {
        let (color, other) = (mine[my_digit], theirs[their_digit]);
        if color != other {
            verdict.add(|| Fault::Mismatch {
                this: Touch { at, part: my_part, color },
                direction,
                neighbor: Touch { at: neighbor, part: their_part, color: other },
            });
        }
    }
}

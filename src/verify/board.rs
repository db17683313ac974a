//! What boards ask besides: squares turned by 0 to 3 quarter turns, prescribed colors at outer
//! sides, and of squares that the set lists several times as many as it lists.

use super::decode::Numbering;
use super::{Fault, Place, Touch, Verdict};
use crate::tiles::{Kind, Members, TileId};
use crate::torus::{Packing, Topology};
use std::collections::BTreeMap;

/// So many places are named in one fault.
const NAMED: usize = 4;

/// The names of the sides of a tile, in the order of its digits.
const PARTS: [&str; 4] = ["north side", "east side", "south side", "west side"];

/// Whether the east sides of the last column meet the west sides of the first.
pub(super) fn closes_eastward(packing: &Packing) -> bool {
    packing.board.topology != Topology::Rectangle
}

/// Whether the south sides of the last row meet the north sides of the first.
pub(super) fn closes_southward(packing: &Packing) -> bool {
    packing.board.topology == Topology::Torus
}

/// The colors that the tile of a cell shows, in the order of its digits: after a quarter turn
/// clockwise the north side shows what the west side did.
pub(super) fn shown(packing: &Packing, numbering: &Numbering, place: Place) -> [u8; 4] {
    let index = place.row * packing.shape.width() + place.column;
    let [n, e, s, w] = numbering.digits(packing.tiles[index]);
    match packing.turns.get(index) {
        None | Some(0) => [n, e, s, w],
        Some(1) => [w, n, e, s],
        Some(2) => [s, w, n, e],
        Some(_) => [e, s, w, n],
    }
}

/// Reports what makes no sense, so that the rest need not be looked at.
pub(super) fn check_sense(packing: &Packing, verdict: &mut Verdict) {
    verdict.next_sort();
    let (board, set, shape) = (&packing.board, &packing.set, packing.shape);
    let fixed_torus = board.topology == Topology::Torus && !board.rotations;
    if set.kind() != Kind::Wang && !fixed_torus {
        verdict.add(|| Fault::Board { what: "only Wang tiles lie on boards and are turned" });
    }
    if board.rotations && set.colors().horizontal() != set.colors().vertical() {
        verdict.add(|| Fault::Board { what: "squares that are turned have one palette" });
    }
    if (set.is_compact() || packing.cover) && !fixed_torus {
        verdict.add(|| Fault::Board { what: "a board holds each square of its set once" });
    }
    let turns = if board.rotations { packing.tiles.len() } else { 0 };
    if packing.turns.len() != turns {
        let given = packing.turns.len();
        verdict.add(|| Fault::Turns { given, expected: turns });
    }
    for (index, &turns) in packing.turns.iter().enumerate().filter(|(_, turns)| **turns > 3) {
        verdict.add(|| Fault::Turn { at: Place::of(index, shape), turns });
    }
    for (side, lengths) in [shape.width(), shape.height()].repeat(2).into_iter().enumerate() {
        let is_outer = match side {
            0 | 2 => !closes_southward(packing),
            _ => !closes_eastward(packing),
        };
        let given = board.border.side(side).len();
        if given > 0 && (!is_outer || given != lengths) {
            verdict.add(|| Fault::Board { what: "the border does not suit the board" });
        }
    }
}

/// Reports outer sides that do not have the color prescribed.
pub(super) fn check_border(packing: &Packing, numbering: &Numbering, verdict: &mut Verdict) {
    verdict.next_sort();
    let (width, height) = (packing.shape.width(), packing.shape.height());
    let mut compare = |side: usize, at: Place, asked: Option<u8>| {
        let color = shown(packing, numbering, at)[side];
        if let Some(asked) = asked.filter(|&asked| asked != color) {
            let this = Touch { at, part: PARTS[side], color };
            verdict.add(|| Fault::Border { this, asked });
        }
    };
    let border = &packing.board.border;
    for (side, row) in [(0, 0), (2, height - 1)] {
        for (column, &asked) in border.side(side).iter().enumerate() {
            compare(side, Place { row, column }, asked);
        }
    }
    for (side, column) in [(1, width - 1), (3, 0)] {
        for (row, &asked) in border.side(side).iter().enumerate() {
            compare(side, Place { row, column }, asked);
        }
    }
}

/// Whether the set lists some tile several times.
pub(super) fn lists_again(packing: &Packing) -> bool {
    match packing.set.members() {
        Members::Explicit(tiles) => tiles.windows(2).any(|pair| pair[0] == pair[1]),
        _ => false,
    }
}

/// Reports tiles that occur more or less often than the set lists them.
pub(super) fn check_copies(packing: &Packing, numbering: &Numbering, verdict: &mut Verdict) {
    let mut cells: BTreeMap<TileId, Vec<usize>> = BTreeMap::new();
    for (index, &tile) in packing.tiles.iter().enumerate() {
        cells.entry(tile).or_default().push(index);
    }
    let Members::Explicit(tiles) = packing.set.members() else { return };
    let mut copies: BTreeMap<TileId, u64> = BTreeMap::new();
    tiles.iter().for_each(|&tile| *copies.entry(tile).or_default() += 1);
    verdict.next_sort();
    for (tile, copies) in copies {
        let cells = cells.get(&tile).map_or(&[][..], Vec::as_slice);
        if cells.len() as u64 != copies {
            let at = cells.iter().take(NAMED).map(|&cell| Place::of(cell, packing.shape));
            let (at, tile) = (at.collect(), numbering.name(tile));
            let times = cells.len() as u64;
            verdict.add(|| Fault::Copies { tile, times, copies, at });
        }
    }
}

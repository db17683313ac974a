//! Every set as Wang tiles with labels 0, 1, 2, ...
//!
//! A corner tile is a Wang tile whose edges carry the ordered pair of their corners' colors: two
//! corner tiles fit where these Wang tiles do, and four around a corner that fit by pairs fit
//! (Lagae 2007, section 8.4). So whatever is decided for one is decided for the other.

use super::cycles::on_cycles;
use crate::aperiodic::Set;
use crate::tiles::Kind;
use std::collections::BTreeMap;

/// Labels N, E, S, W; those of N and S are a space of their own.
pub type Tile = [u32; 4];

/// The tiles of a set in their order, labels numbered by size.
pub fn wang(set: &Set) -> Vec<Tile> {
    let sides = |t: [u32; 4]| match set.kind() {
        Kind::Wang => t.map(|label| (label, 0)),
        _ => [(t[0], t[1]), (t[1], t[2]), (t[3], t[2]), (t[0], t[3])],
    };
    let tiles: Vec<_> = set.tiles().iter().map(|&tile| sides(tile)).collect();
    let numbers = |one: usize, other: usize| {
        let labels = tiles.iter().flat_map(|tile| [(tile[one], 0), (tile[other], 0)]);
        let mut numbers: BTreeMap<(u32, u32), u32> = labels.collect();
        (0..).zip(numbers.values_mut()).for_each(|(number, place)| *place = number);
        numbers
    };
    let (h, v) = (numbers(0, 2), numbers(1, 3));
    tiles.iter().map(|t| [h[&t[0]], v[&t[1]], h[&t[2]], v[&t[3]]]).collect()
}

/// The set reflected in its main diagonal: rows become columns.
pub fn transposed(tiles: &[Tile]) -> Vec<Tile> {
    tiles.iter().map(|&[n, e, s, w]| [w, s, e, n]).collect()
}

/// One more than the largest label of N and S, and of E and W.
pub fn labels(tiles: &[Tile]) -> (usize, usize) {
    let count = |one: usize, other: usize| {
        tiles.iter().map(|tile| tile[one].max(tile[other]) as usize + 1).max().unwrap_or(0)
    };
    (count(0, 2), count(1, 3))
}

/// The numbers of the tiles that remain when those on no cycle of labels are removed again and
/// again, in both directions. If there is a tiling, there is one by these.
pub fn useful(tiles: &[Tile]) -> Vec<usize> {
    let (h, v) = labels(tiles);
    let mut kept: Vec<usize> = (0..tiles.len()).collect();
    loop {
        let arcs = |from: usize, to: usize| -> Vec<(u32, u32)> {
            kept.iter().map(|&tile| (tiles[tile][from], tiles[tile][to])).collect()
        };
        let (down, along) = (on_cycles(h, &arcs(0, 2)), on_cycles(v, &arcs(3, 1)));
        let both = kept.iter().zip(down.iter().zip(&along));
        let left: Vec<usize> =
            both.filter(|(_, (down, along))| **down && **along).map(|(&tile, _)| tile).collect();
        if left.len() == kept.len() {
            return kept;
        }
        kept = left;
    }
}

/// Tiles that lack a neighbor, and on which sides (0 to 3: N, E, S, W).
pub fn lonely(tiles: &[Tile]) -> Vec<(usize, Vec<usize>)> {
    let lacks =
        |tile: &Tile, side: usize| !tiles.iter().any(|other| other[(side + 2) % 4] == tile[side]);
    let sides = |tile: &Tile| (0..4).filter(|&side| lacks(tile, side)).collect::<Vec<_>>();
    let all = tiles.iter().map(sides).enumerate();
    all.filter(|(_, sides)| !sides.is_empty()).collect()
}

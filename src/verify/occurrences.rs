//! Does every tile of the set occur, and none again?
//!
//! Two bits a tile, *seen* and *seen again*, decide it. When there are far more tile numbers
//! than cells, the bits belong to the numbers that occur, in order, instead of to all numbers,
//! so memory stays in proportion to the cells. A compact set names no tiles: there, every class
//! of tiles that share their fixed colors must show exactly two.

use super::decode::Numbering;
use super::members::{Membership, classes};
use super::{Fault, Place, Verdict};
use crate::tiles::{Kind, TileId};
use crate::torus::Packing;
use bitvec::vec::BitVec;
use std::collections::HashMap;

/// So many places and colors are named in one fault.
const NAMED: usize = 4;
/// The bits belong to all tile numbers while there are at most this many for each cell.
const NUMBERS_PER_CELL: u64 = 64;

/// Reports tiles that occur too often or not at all.
pub(super) fn check(
    packing: &Packing,
    numbering: &Numbering,
    members: &Membership<'_>,
    verdict: &mut Verdict,
) {
    let mut seen = Seen::new(packing, numbering.universe());
    for &tile in &packing.tiles {
        if members.holds(tile, numbering) {
            seen.note(tile);
        }
    }
    let compact = matches!(members, Membership::Compact(_));
    // A third tile of a class tells more than the repetitions and gaps that come with it.
    let classes = compact.then(|| Classes::new(numbering, &seen));
    if let Some(classes) = &classes {
        classes.check_overfull(verdict);
    }
    if !packing.cover {
        check_repeated(packing, numbering, &seen, verdict);
    }
    match &classes {
        Some(classes) => classes.check_lacking(verdict),
        None => check_missing(numbering, members, &seen, verdict),
    }
}

/// Which tiles occur, and which occur again.
struct Seen {
    /// The tile numbers that have a bit, in order; `None`: all have one.
    numbers: Option<Vec<u32>>,
    once: BitVec,
    again: BitVec,
}

impl Seen {
    fn new(packing: &Packing, universe: u64) -> Self {
        let dense = universe <= NUMBERS_PER_CELL * packing.tiles.len() as u64;
        let numbers = (!dense).then(|| {
            let mut numbers: Vec<u32> = packing.tiles.iter().map(|tile| tile.0).collect();
            numbers.sort_unstable();
            numbers.dedup();
            numbers
        });
        let bits = numbers.as_ref().map_or(universe as usize, Vec::len);
        Self { numbers, once: BitVec::repeat(false, bits), again: BitVec::repeat(false, bits) }
    }

    fn bit(&self, tile: TileId) -> Option<usize> {
        match &self.numbers {
            None => Some(tile.index()),
            Some(numbers) => numbers.binary_search(&tile.0).ok(),
        }
    }

    fn note(&mut self, tile: TileId) {
        if let Some(bit) = self.bit(tile)
            && self.once.replace(bit, true)
        {
            self.again.set(bit, true);
        }
    }

    fn holds(&self, tile: TileId) -> bool {
        self.bit(tile).is_some_and(|bit| self.once[bit])
    }

    /// The tiles whose bits are set, in increasing order.
    fn tiles<'a>(&'a self, bits: &'a BitVec) -> impl Iterator<Item = TileId> + 'a {
        bits.iter_ones().map(|bit| match &self.numbers {
            None => TileId(bit as u32),
            Some(numbers) => TileId(numbers[bit]),
        })
    }
}

fn check_repeated(packing: &Packing, numbering: &Numbering, seen: &Seen, verdict: &mut Verdict) {
    verdict.next_sort();
    let total = seen.again.count_ones() as u64;
    if total == 0 {
        return;
    }
    verdict.count(total);
    let named: Vec<TileId> = seen.tiles(&seen.again).take(super::KEPT).collect();
    let mut found: HashMap<TileId, (u64, Vec<Place>)> =
        named.iter().map(|&tile| (tile, (0, Vec::new()))).collect();
    for (index, tile) in packing.tiles.iter().enumerate() {
        if let Some((times, places)) = found.get_mut(tile) {
            *times += 1;
            if places.len() < NAMED {
                places.push(Place::of(index, packing.shape));
            }
        }
    }
    for tile in named {
        if let Some((times, at)) = found.remove(&tile) {
            verdict.keep(|| Fault::Repeated { tile: numbering.name(tile), times, at });
        }
    }
}

fn check_missing(
    numbering: &Numbering,
    members: &Membership<'_>,
    seen: &Seen,
    verdict: &mut Verdict,
) {
    verdict.next_sort();
    let missing = members.size() - seen.once.count_ones() as u64;
    verdict.count(missing);
    let absent = members.tiles().filter(|&tile| !seen.holds(tile));
    for tile in absent.take(missing.min(super::KEPT as u64) as usize) {
        verdict.keep(|| Fault::Missing { tile: numbering.name(tile) });
    }
}

/// The tiles that occur in a packing of a compact set, by their fixed colors.
struct Classes<'a> {
    numbering: &'a Numbering,
    /// Ordered by class.
    tiles: Vec<TileId>,
}

impl<'a> Classes<'a> {
    fn new(numbering: &'a Numbering, seen: &Seen) -> Self {
        let mut tiles: Vec<TileId> = seen.tiles(&seen.once).collect();
        tiles.sort_by_key(|&tile| class(numbering, tile));
        Self { numbering, tiles }
    }

    /// The classes that show any tile, with their tiles.
    fn shown(&self) -> impl Iterator<Item = (u64, &[TileId])> {
        let class = |tile: TileId| class(self.numbering, tile);
        let groups = self.tiles.chunk_by(move |&a, &b| class(a) == class(b));
        groups.map(move |group| (class(group[0]), group))
    }

    fn check_overfull(&self, verdict: &mut Verdict) {
        verdict.next_sort();
        for (class, tiles) in self.shown().filter(|(_, tiles)| tiles.len() > 2) {
            verdict.add(|| class_fault(self.numbering, class, tiles));
        }
    }

    fn check_lacking(&self, verdict: &mut Verdict) {
        verdict.next_sort();
        for (class, tiles) in self.shown().filter(|(_, tiles)| tiles.len() < 2) {
            verdict.add(|| class_fault(self.numbering, class, tiles));
        }
        let all = classes(self.numbering);
        let empty = all - self.shown().count() as u64;
        verdict.count(empty);
        let mut shown = self.shown().map(|(class, _)| class).peekable();
        let absent = (0..all).filter(|class| shown.next_if_eq(class).is_none());
        for absent in absent.take(empty.min(super::KEPT as u64) as usize) {
            verdict.keep(|| class_fault(self.numbering, absent, &[]));
        }
    }
}

/// The number of the class of a tile: its fixed colors, the digits SE, SW, NW of a corner tile
/// or N, W of a Wang tile, as a mixed-radix number.
fn class(numbering: &Numbering, tile: TileId) -> u64 {
    let (digits, radices) = (numbering.digits(tile), numbering.radices());
    fixed(numbering).iter().fold(0, |n, &i| n * radices[i] + u64::from(digits[i]))
}

/// The places of the fixed digits.
fn fixed(numbering: &Numbering) -> &'static [usize] {
    match numbering.kind() {
        Kind::Corner => &[1, 2, 3],
        Kind::Wang | Kind::Domino => &[0, 3],
    }
}

fn class_fault(numbering: &Numbering, class: u64, tiles: &[TileId]) -> Fault {
    let (names, radices) = (numbering.names(), numbering.radices());
    let (mut rest, mut words) = (class, Vec::new());
    for &i in fixed(numbering).iter().rev() {
        words.push(format!("{} {}", names[i], rest % radices[i]));
        rest /= radices[i];
    }
    words.reverse();
    let free = |&tile: &TileId| {
        let digits = numbering.digits(tile);
        let free = (0..names.len()).filter(|i| !fixed(numbering).contains(i));
        free.map(|i| format!("{} {}", names[i], digits[i])).collect::<Vec<_>>().join(", ")
    };
    Fault::Class {
        fixed: words.join(", "),
        found: tiles.len() as u64,
        free: tiles.iter().take(NAMED).map(free).collect(),
    }
}

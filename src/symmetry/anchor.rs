//! Where the origin of a packing may lie.
//!
//! A search does not look at all translates of a packing: it puts a window that occurs once (or
//! twice) at the origin, cell (0, 0). A canonical form must then be the least of the images that
//! have such a window there, or the search would never come across it. That also spares trying
//! all translations: for an image to have the anchor at the origin, one of the few cells with
//! the *preimage* of the anchor has to be moved there.

use super::PointSymmetry;
use crate::tiles::{Colors, Kind, TileId};
use crate::torus::{Cell, Lattice};

/// What must be in cell (0, 0) of a representative.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Anchor {
    /// Anything: all translations compete.
    Everywhere,
    /// This tile, which every packing of the set has.
    Tile(TileId),
    /// A tile of the class of all zeros of a compact set: NW = SW = SE = 0 of a corner tile,
    /// N = W = 0 of a Wang tile. Every compact packing has two.
    Class,
}

/// Tiles described by the colors of some of their sides, in the order of [`Kind::sides`].
type Pattern = [Option<u8>; 4];

impl Anchor {
    fn pattern(self, kind: Kind, colors: Colors) -> Pattern {
        match (self, kind) {
            (Anchor::Tile(tile), _) => {
                let mut pattern = kind.unpack(tile, colors).map(Some);
                pattern[kind.sides().len()..].fill(None);
                pattern
            }
            (Anchor::Class, Kind::Corner) => [None, Some(0), Some(0), Some(0)],
            (Anchor::Class, Kind::Wang) => [Some(0), None, None, Some(0)],
            (Anchor::Class, Kind::Domino) | (Anchor::Everywhere, _) => [None; 4],
        }
    }
}

/// The tiles that `point` turns into tiles of the pattern.
fn preimage(pattern: Pattern, point: &PointSymmetry, kind: Kind) -> Pattern {
    let undo = point.map.inverse();
    let mut preimage = [None; 4];
    for (side, before) in preimage.iter_mut().enumerate() {
        let after = point.isometry.side(kind, side).and_then(|image| pattern[image]);
        let horizontal = kind == Kind::Wang && side % 2 == 0;
        let palette = if horizontal { undo.horizontal() } else { undo.vertical() };
        *before = after.map(|color| palette[usize::from(color)]);
    }
    preimage
}

/// Finds, in an array of labels, the cells that hold a preimage of the anchor.
#[derive(Debug, Clone)]
pub(super) struct Locator {
    /// For every cell the places of the labels of its sides; unused ones are 0.
    sides: Vec<[usize; 4]>,
    /// Which sides the preimages fix: one mask, unless the group turns the anchor.
    masks: Vec<[bool; 4]>,
    /// The different preimages, sorted: the number of the mask, and the colors of the sides
    /// that it fixes.
    patterns: Vec<(usize, [u8; 4])>,
}

/// The cells found: for every pattern a list, linked through the cells.
#[derive(Debug, Clone, Default)]
pub(super) struct Found {
    first: Vec<usize>,
    next: Vec<usize>,
}

/// The end of a list.
const NONE: usize = usize::MAX;

/// A preimage of the anchor: the numbers of its pattern and of the mask of that.
#[derive(Debug, Clone, Copy)]
pub(super) struct Preimage {
    pattern: usize,
    mask: usize,
}

impl Locator {
    /// For the preimages of the anchor under the points, which come back in the same order.
    pub(super) fn new(
        anchor: Anchor,
        lattice: Lattice,
        colors: Colors,
        points: impl Iterator<Item = PointSymmetry>,
    ) -> (Self, Vec<Preimage>) {
        let kind = lattice.kind;
        let wanted = anchor.pattern(kind, colors);
        let preimages: Vec<_> = points.map(|point| preimage(wanted, &point, kind)).collect();
        let mut masks: Vec<_> = preimages.iter().map(mask).collect();
        masks.sort_unstable();
        masks.dedup();
        let coded = |preimage: &Pattern| {
            let number = masks.partition_point(|other| *other < mask(preimage));
            (number, preimage.map(Option::unwrap_or_default))
        };
        let mut patterns: Vec<_> = preimages.iter().map(coded).collect();
        patterns.sort_unstable();
        patterns.dedup();
        let numbered = preimages.iter().map(coded).map(|code| Preimage {
            pattern: patterns.partition_point(|pattern| *pattern < code),
            mask: code.0,
        });
        let numbered = numbered.collect();
        let cells = (0..lattice.shape.cells() as u32).map(Cell);
        let sides = cells.map(|cell| {
            let mut places = [0; 4];
            for (place, side) in places.iter_mut().zip(lattice.sides(cell)) {
                *place = side;
            }
            places
        });
        (Self { sides: sides.collect(), patterns, masks }, numbered)
    }

    /// Room for what [`Locator::locate`] finds.
    pub(super) fn room(&self) -> Found {
        let next = vec![NONE; self.masks.len() * self.sides.len()];
        Found { first: vec![NONE; self.patterns.len()], next }
    }

    /// Lists for every pattern the cells whose tile is in it.
    pub(super) fn locate(&self, labels: &[u8], found: &mut Found) {
        found.first.fill(NONE);
        for (number, mask) in self.masks.iter().enumerate() {
            let next = &mut found.next[number * self.sides.len()..];
            for (cell, places) in self.sides.iter().enumerate() {
                let shown = |i: usize| if mask[i] { labels[places[i]] } else { 0 };
                let code = (number, std::array::from_fn(shown));
                if let Ok(pattern) = self.patterns.binary_search(&code) {
                    next[cell] = found.first[pattern];
                    found.first[pattern] = cell;
                }
            }
        }
    }

    /// The cells found for a preimage.
    pub(super) fn cells<'a>(
        &self,
        found: &'a Found,
        preimage: Preimage,
    ) -> impl Iterator<Item = usize> + 'a {
        let next = &found.next[preimage.mask * self.sides.len()..];
        let start = found.first[preimage.pattern];
        let known = |cell: usize| (cell != NONE).then_some(cell);
        std::iter::successors(known(start), move |&cell| known(next[cell]))
    }
}

fn mask(pattern: &Pattern) -> [bool; 4] {
    pattern.map(|side| side.is_some())
}

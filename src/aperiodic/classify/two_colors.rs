//! All 65,536 sets of corner tiles over two colors.
//!
//! A set is a mask of 16 bits; tile NW, NE, SE, SW is bit 8 NW + 4 NE + 2 SE + SW. Nothing is
//! divided out. A set that fills the plane with two periods keeps doing so when tiles are added;
//! the *generators* are those of which no tile can be taken away.

use super::wang::{Tally, slowly};
use super::{NO_STRIPS, Quick};
use crate::aperiodic::decide::{Bounds, Tile, Torus, Verdict, decide};

/// What became of all of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TwoColors {
    /// The sums; the empty set is counted as one without a tiling.
    pub tally: Tally,
    /// The generators.
    pub generators: Vec<Generator>,
}

/// A set that fills the plane with two periods, while no part of it does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Generator {
    /// The tiles.
    pub mask: u16,
    /// The cells of the smallest torus.
    pub torus: usize,
    /// The cells of that tiling that differ by no translation that leaves it as it is: the area
    /// of a torus whose seams may be shifted.
    pub cells: usize,
}

/// The corner tiles of a mask.
pub fn corner_tiles(mask: u16) -> Vec<[u32; 4]> {
    let bit = |tile: u32, bit: u32| tile >> bit & 1;
    let tiles = (0..16).filter(|tile| mask >> tile & 1 == 1);
    tiles.map(|t| [bit(t, 3), bit(t, 2), bit(t, 1), bit(t, 0)]).collect()
}

/// As Wang tiles: the label of an edge is a pair of colors.
fn wang_tiles(mask: u16) -> Vec<Tile> {
    let edges = |[nw, ne, se, sw]: [u32; 4]| [2 * nw + ne, 2 * ne + se, 2 * sw + se, 2 * nw + sw];
    corner_tiles(mask).into_iter().map(edges).collect()
}

/// Decides all sets.
pub fn classify() -> TwoColors {
    let mut quick = Quick::default();
    let bounds = Bounds { strips: NO_STRIPS, ..Bounds::default() };
    let mut decided = |mask: u16| {
        let tiles = wang_tiles(mask);
        quick.decide(&tiles).or_else(|| slowly(&tiles, &bounds, &()))
    };
    let verdicts: Vec<Option<bool>> = (0..=u16::MAX).map(&mut decided).collect();
    let mut tally = Tally::default();
    verdicts.iter().for_each(|&verdict| tally.count(verdict));
    let periodic = |mask: u16| verdicts[usize::from(mask)] == Some(true);
    let minimal = |&mask: &u16| {
        let mut tiles = (0..16).filter(|tile| mask >> tile & 1 == 1);
        periodic(mask) && !tiles.any(|tile| periodic(mask & !(1 << tile)))
    };
    let generator = |mask: u16| {
        let (torus, cells) = match decide(&wang_tiles(mask), &Bounds::default(), &()) {
            Verdict::Periodic(torus) => (torus.area(), torus.area() / periods(&torus)),
            _ => (0, 0),
        };
        Generator { mask, torus, cells }
    };
    let generators = (0..=u16::MAX).filter(minimal).map(generator).collect();
    TwoColors { tally, generators }
}

/// How many translations leave a filled torus as it is.
fn periods(torus: &Torus) -> usize {
    let Torus { width, height, cells, .. } = torus;
    let shifts = (0..*height).flat_map(|dy| (0..*width).map(move |dx| (dx, dy)));
    let same = |&(dx, dy): &(usize, usize)| {
        (0..cells.len()).all(|at| {
            let (row, column) = ((at / width + dy) % height, (at % width + dx) % width);
            cells[at] == cells[row * width + column]
        })
    };
    shifts.filter(same).count()
}

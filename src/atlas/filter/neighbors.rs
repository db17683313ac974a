//! Which cells show what may lie beside a tile, and the smallest and largest value that it adds.
//!
//! What depends only on colors is made once: groups of cells that agree in two sides, and around
//! each corner of a tile the triples of groups (beside, below, between) that fit.

use crate::atlas::Layout;
use crate::atlas::sides::{keys, side_keys};
use crate::tiles::Side;
use std::collections::HashMap;

/// A smallest and a largest value.
type Range = (f64, f64);

/// Of no value at all.
const EMPTY: Range = (f64::INFINITY, f64::NEG_INFINITY);

fn widen(range: &mut Range, (low, high): Range) {
    *range = (range.0.min(low), range.1.max(high));
}

/// The cells of an atlas by the keys of their sides.
#[derive(Debug)]
pub(super) struct Neighbors {
    /// The keys of each cell, in the order of [`Side::ALL`].
    sides: Vec<[u32; 4]>,
    keys: usize,
}

impl Neighbors {
    pub(super) fn new(layout: &Layout) -> Self {
        let (kind, colors) = (layout.kind, layout.colors);
        let sides = layout.tiles.iter().map(|&tile| side_keys(kind, tile, colors)).collect();
        Self { sides, keys: keys(kind, colors) }
    }

    pub(super) fn key(&self, cell: usize, side: Side) -> usize {
        self.sides[cell][side as usize] as usize
    }

    /// For each key of a side, the values of the cells that may lie there; the empty range where
    /// there are none.
    pub(super) fn range_at_side(
        &self,
        side: Side,
        values: impl Iterator<Item = f64>,
    ) -> Vec<Range> {
        let mut ranges = vec![EMPTY; self.keys];
        for (sides, value) in self.sides.iter().zip(values) {
            widen(&mut ranges[sides[side.opposite() as usize] as usize], (value, value));
        }
        ranges
    }
}

/// Cells that agree in two sides.
#[derive(Debug)]
struct Groups {
    /// The group of each cell.
    of: Vec<usize>,
    /// The two keys of each group.
    keys: Vec<(u32, u32)>,
    by_keys: HashMap<(u32, u32), usize>,
}

impl Groups {
    fn new(neighbors: &Neighbors, first: Side, second: Side) -> Self {
        let (mut keys, mut by_keys) = (Vec::new(), HashMap::new());
        let of = neighbors.sides.iter().map(|sides| {
            let both = (sides[first as usize], sides[second as usize]);
            *by_keys.entry(both).or_insert_with(|| {
                keys.push(both);
                keys.len() - 1
            })
        });
        let of = of.collect();
        Self { of, keys, by_keys }
    }

    fn ranges(&self, values: Option<impl Iterator<Item = f64>>) -> Vec<Range> {
        let Some(values) = values else { return vec![(0.0, 0.0); self.keys.len()] };
        let mut ranges = vec![EMPTY; self.keys.len()];
        for (&group, value) in self.of.iter().zip(values) {
            widen(&mut ranges[group], (value, value));
        }
        ranges
    }
}

/// Around a corner of a tile: the tile *beside* it, the one *below* it (above it, in a northern
/// corner), and the one *between*, which must match both.
#[derive(Debug)]
pub(super) struct Corner {
    beside: Groups,
    below: Groups,
    between: Groups,
    /// Tiles that agree in the two sides at the corner see the same.
    tiles: Groups,
    /// For each group of `tiles`, the triples of groups that fit.
    triples: Vec<Vec<[u32; 3]>>,
}

impl Corner {
    /// The corner between two sides, one of them east or west, the other north or south.
    pub(super) fn new(neighbors: &Neighbors, across: Side, down: Side) -> Self {
        let beside = Groups::new(neighbors, across.opposite(), down);
        let below = Groups::new(neighbors, down.opposite(), across);
        let between = Groups::new(neighbors, down.opposite(), across.opposite());
        let tiles = Groups::new(neighbors, across, down);
        let mut fits = |&(east, south): &(u32, u32)| {
            let mut triples = Vec::new();
            for (at, &(west, south_of_it)) in beside.keys.iter().enumerate() {
                if west != east {
                    continue;
                }
                for (under, &(north, east_of_it)) in below.keys.iter().enumerate() {
                    if north != south {
                        continue;
                    }
                    if let Some(&corner) = between.by_keys.get(&(south_of_it, east_of_it)) {
                        triples.push([at as u32, under as u32, corner as u32]);
                    }
                }
            }
            triples
        };
        let triples = tiles.keys.iter().map(&mut fits).collect();
        Self { beside, below, between, tiles, triples }
    }

    /// The sums of the values of the three cells, beside, below and between, for each cell that
    /// they may lie around. Missing values count 0.
    pub(super) fn ranges<I: Iterator<Item = f64>>(&self, values: [Option<I>; 3]) -> Vec<Range> {
        let [beside, below, between] = values;
        let beside = self.beside.ranges(beside);
        let below = self.below.ranges(below);
        let between = self.between.ranges(between);
        let sums: Vec<Range> = self
            .triples
            .iter()
            .map(|triples| {
                let mut sum = EMPTY;
                for &[a, b, c] in triples {
                    let (a, b, c) = (beside[a as usize], below[b as usize], between[c as usize]);
                    widen(&mut sum, ((a.0 + b.0) + c.0, (a.1 + b.1) + c.1));
                }
                sum
            })
            .collect();
        self.tiles.of.iter().map(|&group| sums[group]).collect()
    }
}

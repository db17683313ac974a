//! Which tiles may lie beside a tile, and the smallest and largest value that they can add.

use crate::atlas::sides::{Side, keys, side_keys};
use crate::tiles::{Colors, Kind, TileId};
use std::collections::HashMap;

/// A smallest and a largest value.
type Range = (f64, f64);

fn widen(range: &mut Option<Range>, low: f64, high: f64) {
    let (l, h) = range.get_or_insert((low, high));
    (*l, *h) = (l.min(low), h.max(high));
}

/// The tiles of a set by the keys of their sides.
#[derive(Debug)]
pub(super) struct Neighbors {
    kind: Kind,
    colors: Colors,
    /// The keys of each tile, in the order of [`Side::ALL`].
    sides: Vec<[u32; 4]>,
    keys: usize,
}

impl Neighbors {
    pub(super) fn new(kind: Kind, colors: Colors, tiles: &[TileId]) -> Self {
        let sides = tiles.iter().map(|&tile| side_keys(kind, tile, colors)).collect();
        Self { kind, colors, sides, keys: keys(kind, colors) }
    }

    pub(super) fn key_of(&self, tile: TileId, side: Side) -> usize {
        side_keys(self.kind, tile, self.colors)[side as usize] as usize
    }

    /// For each key of a side, the values of the tiles that may lie there.
    pub(super) fn range_at_side(&self, side: Side, values: &[f64]) -> Vec<Option<Range>> {
        let mut ranges = vec![None; self.keys];
        for (sides, &value) in self.sides.iter().zip(values) {
            widen(&mut ranges[sides[side.opposite() as usize] as usize], value, value);
        }
        ranges
    }
}

/// Around a corner of a tile: the tile *beside* it, the one *below* it (above it, in a northern
/// corner), and the one *between*, which must match both.
pub(super) struct Groups<'a> {
    neighbors: &'a Neighbors,
    across: Side,
    down: Side,
}

/// The range of tiles that agree in two keys.
type Table = HashMap<(u32, u32), Range>;

impl<'a> Groups<'a> {
    pub(super) fn new(neighbors: &'a Neighbors, across: Side, down: Side) -> Self {
        Self { neighbors, across, down }
    }

    /// The ranges of values by two keys.
    fn table(&self, first: Side, second: Side, values: Option<&[f64]>) -> Table {
        let mut table = Table::new();
        for (at, sides) in self.neighbors.sides.iter().enumerate() {
            let value = values.map_or(0.0, |values| values[at]);
            let range = table
                .entry((sides[first as usize], sides[second as usize]))
                .or_insert((value, value));
            *range = (range.0.min(value), range.1.max(value));
        }
        table
    }

    /// The sums of the values of the three tiles, beside, below and between, by the keys of the
    /// tile's two sides. Missing values count 0.
    pub(super) fn ranges(&self, values: [Option<&[f64]>; 3]) -> Around {
        let (across, down) = (self.across, self.down);
        let beside = self.table(across.opposite(), down, values[0]);
        let below = self.table(down.opposite(), across, values[1]);
        let between = self.table(down.opposite(), across.opposite(), values[2]);
        // By the key of the side that the tile itself sees.
        let by_first = |table: &Table| {
            let mut lists: HashMap<u32, Vec<(u32, Range)>> = HashMap::new();
            for (&(first, second), &range) in table {
                lists.entry(first).or_default().push((second, range));
            }
            lists
        };
        let (beside, below) = (by_first(&beside), by_first(&below));
        let mut sums = HashMap::new();
        for sides in &self.neighbors.sides {
            let seen = (sides[across as usize], sides[down as usize]);
            if sums.contains_key(&seen) {
                continue;
            }
            let mut sum: Option<Range> = None;
            let none = Vec::new();
            for &(south, (beside_low, beside_high)) in beside.get(&seen.0).unwrap_or(&none) {
                for &(east, (below_low, below_high)) in below.get(&seen.1).unwrap_or(&none) {
                    let Some(&(low, high)) = between.get(&(south, east)) else { continue };
                    let low = (beside_low + below_low) + low;
                    let high = (beside_high + below_high) + high;
                    widen(&mut sum, low, high);
                }
            }
            sums.insert(seen, sum);
        }
        Around { across, down, sums }
    }
}

/// The sums around a corner.
pub(super) struct Around {
    across: Side,
    down: Side,
    sums: HashMap<(u32, u32), Option<Range>>,
}

impl Around {
    /// The range around a tile; `None` when nothing fits there.
    pub(super) fn around(&self, tile: TileId, neighbors: &Neighbors) -> Option<Range> {
        let keys = side_keys(neighbors.kind, tile, neighbors.colors);
        *self.sums.get(&(keys[self.across as usize], keys[self.down as usize]))?
    }
}

//! Algorithm 1 for two labels: a cell that repeats too often takes the other label; where that
//! repeats too often, too, one neighbor gives way.
//!
//! On its turn a cell follows cells that keep every limit. If both labels are too many, one has
//! repeated to its west and the other to its north, at least twice each, as no limit is below 2.
//! The cell then takes the label of its north-west neighbor, and the two cells between them the
//! other label: that changes one of the two, which stood next to its equals on both sides and now
//! stands alone, but for one cell further on, with which it makes a run of 2.
//!
//! A field that is dappled already does not change. Source: Kaji, Derouet-Jourdan, Ochiai, *Dappled
//! tiling*, 2016, Algorithm 1.

use super::lines::{Run, Runs, Shared};
use super::schedule::Step;

/// How often the labels may repeat, in a row or in a column, up to a cell.
pub trait Bounds: Sync {
    /// The limit of a label in a cell.
    fn at(&self, label: u8, cell: usize) -> u64;
}

/// The same limits everywhere, `u64::MAX` for none.
#[derive(Debug, Clone, Copy)]
pub struct Same(pub [u64; 2]);

impl Bounds for Same {
    fn at(&self, label: u8, _: usize) -> u64 {
        self.0[usize::from(label & 1)]
    }
}

/// The rectangle while Algorithm 1 is at work on it.
pub struct Pair<'a, H, V> {
    /// Labels 0 and 1.
    pub labels: &'a Shared,
    /// The runs of the rows.
    pub rows: Runs,
    /// The runs of the columns.
    pub columns: Runs,
    /// Limits in rows.
    pub horizontal: H,
    /// Limits in columns.
    pub vertical: V,
}

impl<H: Bounds, V: Bounds> Step for Pair<'_, H, V> {
    #[inline]
    fn step(&self, column: usize, row: usize, after: (bool, bool)) {
        let (west, north) = (self.rows.get(row), self.columns.get(column));
        let cell = row * self.labels.size().0 + column;
        let full = |run: Run, limit: u64| u8::from(run.length >= limit) << run.label;
        let forbidden = full(west, self.horizontal.at(west.label, cell))
            | full(north, self.vertical.at(north.label, cell));
        if forbidden == 0b11 {
            return self.give_way(column, row, west.label, after);
        }
        let label = self.labels.get(column, row);
        let label = label ^ (forbidden >> label & 1);
        self.labels.set(column, row, label);
        self.rows.set(row, west.then(label));
        self.columns.set(column, north.then(label));
    }
}

impl<H, V> Pair<'_, H, V> {
    /// A cell between `west` and the other label, both of which have repeated too often.
    #[cold]
    fn give_way(&self, column: usize, row: usize, west: u8, after: (bool, bool)) {
        let (width, height) = self.labels.size();
        let corner = self.labels.get(column - 1, row - 1);
        let other = 1 - corner;
        self.labels.set(column, row, corner);
        // The changed cell stands alone, but for the next one in its line where that had its turn.
        if west == corner {
            self.labels.set(column - 1, row, other);
            let run = match after.0 && row + 1 < height {
                true => Run::one(other).then(self.labels.get(column - 1, row + 1)),
                false => Run::one(other),
            };
            self.columns.set(column - 1, run);
        } else {
            self.labels.set(column, row - 1, other);
            let run = match after.1 && column + 1 < width {
                true => Run::one(other).then(self.labels.get(column + 1, row - 1)),
                false => Run::one(other),
            };
            self.rows.set(row - 1, run);
        }
        self.rows.set(row, Run::one(corner));
        self.columns.set(column, Run::one(corner));
    }
}

//! Rectangles filled with the tiles of any set, a row at a time, looking some rows ahead.
//!
//! A row of tiles below given labels is a walk in the graph whose states are the labels between
//! tiles. Whether *k* rows fit below each other is a walk, too, in the graph of columns of *k*
//! tiles (`columns`). A row is taken from a random walk there, of which only the first tiles
//! are kept: then k - 1 more rows are possible below it, whatever comes. Where none is possible
//! some rows are taken back, the more the oftener it happens, and chosen anew.
//!
//! That fills some hundred tiles a side, or fewer, for rows get harder to go on from the wider they
//! are. The set is transposed when that goes better. Sets that compute ([`Machine`]) need no
//! search, nor do the tiles of Jeandel and Rao.

mod coded;
mod columns;
mod machine;

pub use machine::Machine;

use super::decide::{Tile, transposed};
use crate::search::Stop;
use columns::Columns;

/// How many arcs of a column graph are worth their time.
const ARCS: usize = 60_000;
/// Arcs that are walked along in all, for large rectangles: then fewer rows ahead.
const WORK: f64 = 4e9;
/// Times that rows are taken back before the other direction is tried.
const PATIENCE: usize = 60;

/// A filled rectangle.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Patch {
    /// Tiles in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// The numbers of the tiles, row after row from the north.
    pub cells: Vec<usize>,
    /// Rows (or columns) that were looked ahead.
    pub ahead: usize,
    /// How often rows were taken back.
    pub back: usize,
}

/// Why a rectangle is not filled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unfilled {
    /// No strip of so many rows or columns is filled: the set tiles nothing.
    Impossible {
        /// Rows of the strip.
        rows: usize,
    },
    /// It was told to stop; so many rows (or columns) were filled at best.
    Stopped {
        /// Rows or columns.
        best: usize,
    },
}

/// Fills a rectangle of at least one tile; the same arguments give the same tiles.
///
/// # Errors
/// A set that fills no strip, or a `stop`.
pub fn fill(
    tiles: &[Tile],
    width: usize,
    height: usize,
    seed: u64,
    stop: &dyn Stop,
) -> Result<Patch, Unfilled> {
    let turned = transposed(tiles);
    let arcs = ARCS.min((WORK / (width * height) as f64) as usize).max(200);
    let straight = Columns::new(tiles, arcs).map_err(|rows| Unfilled::Impossible { rows })?;
    let across = Columns::new(&turned, arcs).map_err(|rows| Unfilled::Impossible { rows })?;
    let mut random = Random(seed);
    let mut best = 0;
    // The direction that looks farther ahead first.
    let mut down = straight.ahead() >= across.ahead();
    for patience in (1..).map(|round| PATIENCE << (round / 2).min(20)) {
        let (columns, width, height) =
            if down { (&straight, width, height) } else { (&across, height, width) };
        let mut filling = Filling { columns, width, rows: Vec::new(), back: 0, best: 0 };
        if filling.fill(height, patience, &mut random, stop) {
            let cells: Vec<usize> = filling.rows.concat();
            let (ahead, back) = (columns.ahead(), filling.back);
            let patch = Patch { width, height, cells, ahead, back };
            return Ok(if down { patch } else { patch.transposed() });
        }
        best = best.max(filling.best);
        if stop.should_stop() {
            break;
        }
        down = !down;
    }
    Err(Unfilled::Stopped { best })
}

/// Fills a rectangle with the tiles of Jeandel and Rao, under their own labels; `None` for all
/// others.
pub fn code(tiles: &[Tile], width: usize, height: usize, seed: u64) -> Option<Patch> {
    let cells = coded::fill(tiles, width, height, &mut Random(seed))?;
    Some(Patch { width, height, cells, ahead: 0, back: 0 })
}

/// Fills a rectangle with the tiles of a set that computes; `None` when it does not.
pub fn compute(
    tiles: &[Tile],
    machine: &Machine,
    width: usize,
    height: usize,
    seed: u64,
) -> Option<Patch> {
    let cells = machine::fill(tiles, machine, width, height, &mut Random(seed))?;
    Some(Patch { width, height, cells, ahead: 0, back: 0 })
}

impl Patch {
    /// Rows become columns.
    fn transposed(self) -> Self {
        let (width, height) = (self.height, self.width);
        let cell = |i: usize| self.cells[i % width * height + i / width];
        Self { width, height, cells: (0..width * height).map(cell).collect(), ..self }
    }
}

/// A generator of Vigna (xorshift64*, 2016).
struct Random(u64);

impl Random {
    /// From 0 to 1, without 1.
    fn next(&mut self) -> f64 {
        // 0 would stay 0.
        let mut x = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15).max(1);
        x ^= x >> 12;
        x ^= x << 25;
        x ^= x >> 27;
        self.0 = x;
        (x.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Rows filled so far.
struct Filling<'a> {
    columns: &'a Columns,
    width: usize,
    rows: Vec<Vec<usize>>,
    back: usize,
    /// The most rows there were.
    best: usize,
}

impl Filling<'_> {
    fn fill(
        &mut self,
        height: usize,
        patience: usize,
        random: &mut Random,
        stop: &dyn Stop,
    ) -> bool {
        let mut take = 1;
        while self.rows.len() < height {
            if stop.should_stop() {
                return false;
            }
            match self
                .columns
                .row(self.rows.last().map(Vec::as_slice), self.width, || random.next())
            {
                Some(row) => {
                    self.rows.push(row);
                    if self.rows.len() > self.best {
                        self.best = self.rows.len();
                        take = 1;
                    }
                }
                None => {
                    self.back += 1;
                    if self.back > patience {
                        return false;
                    }
                    self.rows.truncate(self.rows.len().saturating_sub(take));
                    take = take.saturating_mul(2);
                }
            }
        }
        true
    }
}

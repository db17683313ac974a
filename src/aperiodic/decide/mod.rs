//! Whether a set of tiles fills the plane: not at all, with a period, or unknown.
//!
//! [`decide`] goes through the powers of the set, of its rows and of its columns in turn. An
//! empty power says that there is no tiling; the smallest [`square`] that cannot be filled then
//! says it again, in a way that is easy to check. A cycle in a power says that there is a tiling
//! with a period; the smallest [`torus`] shows it. Else the set is undecided, as an aperiodic set
//! must be: [`likeness`] finds out whether it is one that was published.
//!
//! No set of tiles is decided wrongly, but some are not decided: Berger (1966) proved that no
//! program decides all.

mod cycles;
mod form;
mod power;
mod recognize;
pub mod square;
pub mod torus;

pub use cycles::{components, on_cycles};
pub use form::{Tile, labels, lonely, transposed, useful, wang};
pub use power::Power;
pub use recognize::{Likeness, SYMMETRIES, likeness};
pub use torus::Torus;

use crate::search::Stop;

/// How far to go before a set is left undecided.
#[derive(Debug, Clone, Copy)]
pub struct Bounds {
    /// The highest power, and the largest square.
    pub limit: usize,
    /// Arcs of a product of powers, each of 16 bytes; it takes about four times that memory.
    pub arcs: u64,
    /// Tiles placed in one square.
    pub nodes: u64,
    /// Columns and steps of the strips in which a torus is looked for.
    pub strips: torus::Bounds,
}

impl Default for Bounds {
    /// Powers of at most 4 million arcs: about 300 MiB.
    fn default() -> Self {
        let strips = torus::Bounds { columns: 1 << 18, steps: 1 << 26 };
        Self { limit: 40, arcs: 1 << 22, nodes: 1 << 21, strips }
    }
}

/// What is known about a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Verdict {
    /// It fills the plane with two periods; on this torus.
    Periodic(Torus),
    /// It fills the plane with two periods: a power of so many rows (or columns) has a cycle that
    /// writes what it reads. The bounds did not suffice to show the torus.
    Repeats(Strip),
    /// It does not fill the plane: a square of this side cannot be filled, after so many tiles.
    NoSquare {
        /// Tiles in a row of the square.
        side: usize,
        /// Tiles placed in vain.
        nodes: u64,
    },
    /// It does not fill the plane: the power of so many rows (or columns) is empty.
    NoStrip(Strip),
    /// Nothing is known.
    Undecided(Gap),
}

/// A power.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Strip {
    /// Of rows, else of columns.
    pub rows: bool,
    /// How many.
    pub power: usize,
}

/// Why a set was left undecided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Gap {
    /// The highest power of the rows looked at.
    pub rows: usize,
    /// The highest power of the columns looked at.
    pub columns: usize,
    /// Arcs that a higher power would have before it is cut, when that is too many.
    pub arcs: Option<u64>,
    /// Whether it was asked to stop.
    pub stopped: bool,
}

/// The powers of one direction.
struct Direction {
    rows: bool,
    first: Power,
    power: Power,
    height: usize,
}

/// Decides a set of Wang tiles, if the bounds suffice.
pub fn decide(tiles: &[Tile], bounds: &Bounds, stop: &dyn Stop) -> Verdict {
    let turned = transposed(tiles);
    let mut directions = [(true, tiles), (false, &turned)].map(|(rows, tiles)| {
        let first = Power::first(tiles);
        Direction { rows, power: first.clone(), first, height: 1 }
    });
    let mut arcs = None;
    let mut stopped = false;
    for height in 1..=bounds.limit {
        for direction in &mut directions {
            stopped |= stop.should_stop();
            if stopped {
                break;
            }
            if height > 1 {
                let needed = direction.power.product_len(&direction.first);
                if direction.height + 1 < height || needed > bounds.arcs {
                    arcs = arcs.or(Some(needed));
                    continue;
                }
                direction.power = direction.power.above(&direction.first);
                direction.height = height;
            }
            let strip = Strip { rows: direction.rows, power: height };
            if direction.power.is_empty() {
                return refuted(tiles, strip, bounds, stop);
            }
            if direction.power.repeats() {
                return periodic(tiles, strip, bounds, stop);
            }
        }
        if directions.iter().all(|direction| direction.height < height) {
            break;
        }
    }
    let [rows, columns] = directions.map(|direction| direction.height);
    Verdict::Undecided(Gap { rows, columns, arcs, stopped })
}

fn refuted(tiles: &[Tile], strip: Strip, bounds: &Bounds, stop: &dyn Stop) -> Verdict {
    let largest = bounds.limit.max(2 * strip.power);
    match square::smallest(tiles, largest, bounds.nodes, stop) {
        Some((side, nodes)) => Verdict::NoSquare { side, nodes },
        None => Verdict::NoStrip(strip),
    }
}

fn periodic(tiles: &[Tile], strip: Strip, bounds: &Bounds, stop: &dyn Stop) -> Verdict {
    let used = useful(tiles);
    let kept: Vec<Tile> = used.iter().map(|&tile| tiles[tile]).collect();
    match torus::smallest(&kept, strip.power, bounds.strips, stop) {
        Some(torus) => {
            let cells = torus.cells.iter().map(|&tile| used[tile]).collect();
            Verdict::Periodic(Torus { cells, ..torus })
        }
        None => Verdict::Repeats(strip),
    }
}

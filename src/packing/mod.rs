//! The problems: what a search places where.
//!
//! * [`corner`]: colors on lattice points, one word of candidates a cell; a window of four is a
//!   tile. Which tiles a window may still be is a [`rule`]: each once, two for each (NW, SW,
//!   SE), or at least once. [`caps`] counts colors and dominoes and closes those used up, by far
//!   the most valuable pruning.
//! * [`wang`]: whole tiles in cells, the candidates being the AND of a few masks. Rings of
//!   dominoes are Wang tiles with one color across ([`ring`]).
//! * [`board`]: tiles on boards with outer sides, or squares that may be turned.
//! * `corner_batch` and `wang_batch`: partial packings in a few words, completed many at a
//!   time, where the rest is filled line by line (`corner_herd`, `wang_herd`).
//! * [`quotient`]: with a prescribed automorphism one choice decides an orbit of cells.
//! * [`reduction`]: translations and the order of colors are removed before the search starts,
//!   exactly, and multiplied back.
//!
//! [`Task`] says which packings, [`Job`] what is asked about them; [`dispatch`] makes it a
//! problem, [`standing`] runs it, also from where an earlier run stopped, [`solve`] gives the
//! answer ([`restarts`] that of a search begun again and again), and [`estimate`] says how large it is ([`last_lines`] helps it).

pub mod board;
mod board_caps;
mod board_impossible;
mod board_plan;
mod board_sprint;
pub mod caps;
pub mod corner;
mod corner_batch;
mod corner_herd;
pub mod corner_plan;
mod corner_tables;
pub mod dispatch;
pub mod estimate;
pub mod frontier;
pub mod halves;
mod impossible;
pub mod job;
pub mod last_lines;
pub mod prunings;
pub mod quotient;
pub mod reduction;
pub mod restarts;
pub mod ring;
pub mod rows;
pub mod rule;
pub mod sinks;
pub mod solve;
pub mod standing;
pub mod table;
pub mod task;
pub mod wang;
mod wang_batch;
mod wang_herd;
pub mod wang_plan;
pub mod wang_rule;
mod wang_sprint;
mod watched;

pub use frontier::{Cut, frontier};
pub use job::{Job, Question};
pub use prunings::Prunings;
pub use restarts::{Restarted, find_restarting};
pub use solve::{Answer, Counted, Settings, count, find, list};
pub use standing::{Keeper, Standing, run};
pub use task::{MAX_SEARCH_COLORS, Task, TaskError};

use crate::search::Problem;
use last_lines::{Found, LastLines};
use num_bigint::BigUint;

/// A problem whose solutions are labels of a lattice.
pub trait Labeled: Problem {
    /// Writes the labels of the solution at which the problem stands, in the order of
    /// [`crate::torus::Lattice`].
    fn write_labels(&self, labels: &mut Vec<u8>);

    /// For problems whose leaves stand for many packings: the steps that counting them took, and
    /// their number in a unit of the problem's own.
    fn met(&self) -> Option<(u64, BigUint)> {
        None
    }

    /// Whether a look at the last lines shows that no solution lies below this state, with so
    /// many choices made; see [`LastLines::is_hopeless`].
    fn is_hopeless(&self, last: &LastLines, level: usize, found: &mut Found) -> bool {
        let _ = (last, level, found);
        false
    }
}

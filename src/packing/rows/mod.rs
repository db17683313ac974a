//! Counting without listing: two halves of a torus that meet.
//!
//! On a torus with short lines a whole line is one *state*, and two lines that follow each other
//! place as many tiles as a line has cells. A packing is a closed walk of `h` such pairs that
//! uses every tile once (of a compact set: two different tiles of every class). Fix line 0 and
//! line `a`, about half way: the walks from 0 to `a` go into a [table] by what they use, the
//! walks from `a` back to 0 are enumerated, and each looks up what it leaves. None of the
//! packings is ever written down: the halves are some thousand times fewer than they are.
//!
//! * [`law`]: what a walk uses, as a mask of tiles and a number that adds up.
//! * [`line`](mod@line): the states, their classes under the symmetries that keep lines, which
//!   may follow which.
//! * [`walks`]: all walks of a few pairs.
//! * [`join`](mod@join): which of them go together.
//! * [`meet`]: the halves for one choice of line 0 and line `a`.
//! * [`problem`]: all those choices, as a tree that the search walks: so this count is stopped,
//!   saved, taken up again and spread over machines like any other.
//!
//! **Symmetry.** Line 0 runs over one representative of each class only, and stands for the
//! class; all other lines are of the same class or a later one, so that the class of line 0 is
//! the first that occurs. A packing with `m` lines of that class is then met `m` times among its
//! `h` rotations: it counts `h / m` times.

pub mod join;
pub mod law;
pub mod line;
pub mod meet;
pub mod problem;
pub mod table;
pub mod walks;

pub use problem::Rows;

use super::Task;
use crate::tiles::Kind;

/// Tiles of a set at most: a mask of them is one wide word.
pub const MOST_TILES: usize = 128;
/// States of a line at most: there is a table of all pairs of them.
pub const MOST_STATES: usize = 1024;
/// Lines around the torus at least: each quarter of it is a walk.
pub const FEWEST_LINES: usize = 4;
/// Lines around the torus at most.
pub const MOST_LINES: usize = 16;

/// Why the packings of a task cannot be counted this way.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RowsError {
    /// Only corner tiles.
    #[error("counting by lines is for corner tiles, not for {0} tiles")]
    Kind(Kind),
    /// Only packings, with nothing given.
    #[error("counting by lines cannot do with {0}")]
    Asked(&'static str),
    /// The automorphism moves lines.
    #[error(
        "counting by lines needs an automorphism that moves no line to another; here lines are {0}"
    )]
    Automorphism(&'static str),
    /// Too many tiles.
    #[error("{0} tiles: counting by lines handles up to {MOST_TILES}")]
    Tiles(usize),
    /// Too long lines.
    #[error(
        "lines of {length} cells over {colors} colors have too many states: counting by lines \
         handles up to {MOST_STATES}"
    )]
    States {
        /// Cells of a line.
        length: usize,
        /// Colors.
        colors: usize,
    },
    /// Too few or too many lines.
    #[error("{0} lines: counting by lines handles {FEWEST_LINES} to {MOST_LINES}")]
    Lines(usize),
}

/// Checks that the packings of a task can be counted this way.
///
/// # Errors
/// What stands in the way.
pub fn check(task: &Task) -> Result<(), RowsError> {
    if task.set.kind() != Kind::Corner {
        return Err(RowsError::Kind(task.set.kind()));
    }
    if task.cover {
        return Err(RowsError::Asked("coverings"));
    }
    if !task.board.is_plain() {
        return Err(RowsError::Asked("boards"));
    }
    if task.has_pins() {
        return Err(RowsError::Asked("cells given beforehand"));
    }
    let frame = line::Frame::of(task);
    if let Some(automorphism) = &task.automorphism {
        let (across, lines) = match frame.transposed {
            false => (automorphism.dy, "rows"),
            true => (automorphism.dx, "columns"),
        };
        if across != 0 {
            return Err(RowsError::Automorphism(lines));
        }
    }
    let allowed = task.set.allowed().take(MOST_TILES + 1).count();
    if allowed > MOST_TILES {
        let all = task.set.kind().tiles(task.set.colors());
        let tiles = if task.set.is_compact() { all } else { task.set.size() };
        return Err(RowsError::Tiles(tiles as usize));
    }
    let (length, colors) = (frame.length, task.set.colors().horizontal());
    // An automorphism leaves fewer states; those of a part of the line are enumerated.
    let free = task
        .automorphism
        .as_ref()
        .map_or(length, |automorphism| length / automorphism.order(task.shape));
    let states = colors.checked_pow(free as u32).filter(|&states| states <= MOST_STATES);
    if states.is_none() {
        return Err(RowsError::States { length: free, colors });
    }
    if !(FEWEST_LINES..=MOST_LINES).contains(&frame.lines) {
        return Err(RowsError::Lines(frame.lines));
    }
    Ok(())
}

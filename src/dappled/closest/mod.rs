//! The nearest dappled tiling: one that keeps a rule and differs from a field in as few cells as
//! possible, or in cells that weigh as little as possible.
//!
//! *Strips* are a few lines side by side. A strip alone is filled at least cost by a shortest path
//! (`machine`, `strip`). From below, the board is cut into strips that overlap and divide the
//! costs of the cells among them; however they do, no tiling costs less than the strips together,
//! and they are made to agree where they overlap (`dual`, `bounds`). From above, a strip at a
//! time is filled anew while the rest stays (`mend`). When the bounds meet the tiling is proved
//! to be nearest; if they do not, strips grow, and cells are decided both ways (`search`).
//!
//! Strips are far better than lines: with lines alone the bound is that of linear programming,
//! which on random fields of 64 x 64 is some three cells below the nearest tiling; with strips of
//! four or six lines it is less than one cell below.

mod board;
mod bounds;
mod dual;
mod machine;
mod mend;
mod overlap;
mod search;
mod strip;

use super::{FREE, Field, Rule};
use crate::search::Stop;
use board::{Board, NEVER, may_be};
use search::Search;

/// Cells of a field at most.
pub const MOST_CELLS: usize = 1 << 22;

/// The weight of a cell at most.
pub const MOST_WEIGHT: u32 = 1_000_000;

/// What is asked.
#[derive(Debug, Clone, Copy)]
pub struct Task<'a> {
    /// What the tiling keeps.
    pub rule: &'a Rule,
    /// What it is to be near; free cells are near to any tile.
    pub field: &'a Field,
    /// Cells that must hold these tiles, if not free.
    pub fixed: Option<&'a Field>,
    /// What it costs to change a cell, row by row; one for each without.
    pub weights: Option<&'a [u32]>,
}

/// What is no task.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TaskError {
    /// Sizes that differ.
    #[error("{what}: {found} cells, expected {expected}")]
    Size {
        /// What is of another size.
        what: &'static str,
        /// Its cells.
        found: String,
        /// The cells of the rule.
        expected: String,
    },
    /// A tile that there is not.
    #[error("{what}: tile {tile}, expected one below {tiles}")]
    Tile {
        /// What has it.
        what: &'static str,
        /// The tile.
        tile: u8,
        /// How many there are.
        tiles: usize,
    },
    /// A weight that is too large.
    #[error("a weight of {0}: expected {MOST_WEIGHT} or less")]
    Weight(u32),
}

/// What was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Answer {
    /// The nearest tiling found.
    pub tiling: Option<Field>,
    /// How far it is: the weights of cells that differ.
    pub distance: Option<u64>,
    /// No tiling is nearer; none if there is no tiling at all.
    pub bound: Option<u64>,
    /// If there is no tiling at all, fixed cells that are to blame (indices, row by row): these
    /// alone have no completion. Nothing if that was found without them being told apart.
    pub core: Option<Vec<u32>>,
    /// Rounds of bounding and mending.
    pub rounds: u64,
    /// Cells that were decided both ways.
    pub nodes: u64,
    /// Lines of the tallest strips used.
    pub lines: usize,
}

impl Answer {
    /// Whether the tiling is proved to be nearest, or that there is none.
    pub fn is_proved(&self) -> bool {
        self.distance == self.bound
    }
}

/// Finds the nearest tiling, and proves it, unless it is asked to stop before.
///
/// # Errors
/// Sizes or tiles that do not fit the rule.
pub fn closest(task: &Task<'_>, seed: u64, stop: &impl Stop) -> Result<Answer, TaskError> {
    let Task { rule, field, fixed, weights } = *task;
    let (width, height, tiles) = (rule.width(), rule.height(), rule.tiles());
    for (what, field) in [("the field", Some(field)), ("the fixed cells", fixed)] {
        let Some(field) = field else { continue };
        if (field.width(), field.height()) != (width, height) {
            let found = format!("{}x{}", field.width(), field.height());
            return Err(TaskError::Size { what, found, expected: format!("{width}x{height}") });
        }
        let wrong = |&&tile: &&u8| tile != FREE && usize::from(tile) >= tiles;
        if let Some(&tile) = field.cells().iter().find(wrong) {
            return Err(TaskError::Tile { what, tile, tiles });
        }
    }
    if let Some(weights) = weights {
        if weights.len() != width * height {
            let (found, expected) = (weights.len().to_string(), format!("{width}x{height}"));
            return Err(TaskError::Size { what: "the weights", found, expected });
        }
        if let Some(&weight) = weights.iter().find(|&&weight| weight > MOST_WEIGHT) {
            return Err(TaskError::Weight(weight));
        }
    }
    let fixed = |cell: usize| fixed.map_or(FREE, |fixed| fixed.cells()[cell]);
    let costs = (0..width * height).flat_map(|cell| {
        let (wish, fixed) = (field.cells()[cell], fixed(cell));
        let weight = weights.map_or(1, |weights| i64::from(weights[cell]));
        (0..tiles as u8).map(move |tile| match () {
            () if fixed != FREE && fixed != tile => NEVER,
            () if wish == FREE || wish == tile => 0,
            () => weight,
        })
    });
    let board = Board::new(rule, costs.collect());
    let start = (0..width * height).map(|cell| match (fixed(cell), field.cells()[cell]) {
        (FREE, FREE) => 0,
        (FREE, tile) | (tile, _) => tile,
    });
    let free = Field::filled(width, height, FREE).unwrap_or_else(|_| field.clone());
    let partial = task.fixed.unwrap_or(&free);
    let mut search = Search::new(&board, (rule, partial), seed, stop);
    search.run(&start.collect::<Vec<u8>>());
    let (tiling, distance) = match &search.best {
        Some((cells, cost)) => (Field::new(width, height, cells.clone()).ok(), Some(*cost as u64)),
        None => (None, None),
    };
    let bound = may_be(search.bound).then_some(search.bound.max(0) as u64);
    let (rounds, nodes, lines) = (search.rounds, search.nodes, search.lines);
    let core = search.core.clone();
    Ok(Answer { tiling, distance, bound, core, rounds, nodes, lines })
}

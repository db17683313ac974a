//! Exact answers: can these cells be completed to a dappled tiling?
//!
//! A rule is a formula (`encode`), a partial tiling assumes some of its literals, and a solver
//! ([`sat`]) finds a completion or proves that there is none. When there is none, the cells to blame
//! are told: first those that the proof used, then fewer and fewer (`shrink`), until none can be
//! left out.
//!
//! What is found is checked from the definition before it is given out.

mod bound;
mod counts;
mod encode;
mod pack;
mod proof;
pub mod sat;
mod shrink;
mod total;
mod walk;

pub use bound::Reason;
pub use counts::{Counted, Counts, complete_with, counts};
pub use proof::{Proof, proof};

use super::{FREE, Field, Rule};
use crate::search::Stop;
use encode::Formula;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use sat::{Answer, Literal, Solver};
use shrink::smaller;

/// What became of a partial tiling.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Completion {
    /// A dappled tiling that agrees with it.
    Found(Field),
    /// There is none.
    Impossible {
        /// Filled cells that are to blame (indices, row by row, ascending): these alone cannot be
        /// completed. None if there is no dappled tiling at all.
        core: Vec<u32>,
        /// Without any one of them there would be a completion: proved for each.
        minimal: bool,
    },
    /// Stopped before the answer was known.
    Stopped,
}

/// What cannot be asked.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ExactError {
    /// The rule is for another rectangle.
    #[error("{found:?} cells, expected {expected:?}")]
    Size {
        /// Columns and rows of the field.
        found: (usize, usize),
        /// Of the rule.
        expected: (usize, usize),
    },
    /// A tile that there is not.
    #[error("row {row}, column {column}: tile {tile}, expected one below {tiles}")]
    Tile {
        /// The row.
        row: usize,
        /// The column.
        column: usize,
        /// The tile.
        tile: u8,
        /// How many tiles there are.
        tiles: usize,
    },
    /// A tile to count that there is not.
    #[error("tile {tile}: expected one below {tiles}")]
    Counted {
        /// The tile.
        tile: u8,
        /// How many tiles there are.
        tiles: usize,
    },
    /// More clauses than a solver can hold.
    #[error("{0}x{1} cells with these limits make a formula too large for an exact answer")]
    Large(usize, usize),
    /// A completion that was found did not pass the check from the definition: a mistake of this
    /// program.
    #[error("the completion that was found is no dappled tiling: a mistake of this program")]
    Wrong,
}

/// Completes a partial tiling, or names cells that cannot be completed. The seed chooses among
/// completions; it has no influence on whether there is one.
///
/// # Errors
/// A field of another size, with tiles that there are not, or too large.
pub fn complete(
    rule: &Rule,
    partial: &Field,
    seed: u64,
    stop: &dyn Stop,
) -> Result<Completion, ExactError> {
    Question::new(rule, partial, seed)?.answer(stop)
}

/// A partial tiling with the formula of its rule.
#[derive(Debug, Clone)]
struct Question<'a> {
    rule: &'a Rule,
    partial: &'a Field,
    formula: Formula,
    given: Vec<Literal>,
}

impl<'a> Question<'a> {
    fn new(rule: &'a Rule, partial: &'a Field, seed: u64) -> Result<Self, ExactError> {
        let (found, expected) =
            ((partial.width(), partial.height()), (rule.width(), rule.height()));
        if found != expected {
            return Err(ExactError::Size { found, expected });
        }
        let tiles = rule.tiles();
        let strange = |&tile: &u8| tile != FREE && usize::from(tile) >= tiles;
        if let Some(cell) = partial.cells().iter().position(strange) {
            let (row, column) = (cell / found.0, cell % found.0);
            return Err(ExactError::Tile { row, column, tile: partial.cells()[cell], tiles });
        }
        if !Formula::fits(rule) {
            return Err(ExactError::Large(found.0, found.1));
        }
        let formula = Formula::new(rule, Solver::new(0));
        let given = formula.given(partial);
        let mut question = Self { rule, partial, formula, given };
        let mut random = Pcg64::seed_from_u64(seed);
        for cell in 0..partial.cells().len() as u32 {
            question.prefer(cell, random.random_range(0..tiles as u8));
        }
        Ok(question)
    }

    /// Has the solver guess this tile in a cell first.
    fn prefer(&mut self, cell: u32, tile: u8) {
        for other in 0..self.rule.tiles() as u8 {
            let literal = self.formula.holds(cell, other);
            if other != tile {
                self.formula.solver.prefer(!literal);
            }
        }
        let literal = self.formula.holds(cell, tile);
        self.formula.solver.prefer(literal);
    }

    fn answer(&mut self, stop: &dyn Stop) -> Result<Completion, ExactError> {
        Ok(match self.formula.solver.solve(&self.given, stop) {
            Answer::Model => Completion::Found(self.checked(self.formula.tiling(self.partial))?),
            Answer::Failed(failed) => {
                let (core, minimal) = smaller(&mut self.formula.solver, &[], failed, stop);
                Completion::Impossible { core: self.blamed(&core), minimal }
            }
            Answer::Stopped => Completion::Stopped,
        })
    }

    /// What was found, if it is what was asked for: from the definition.
    fn checked(&self, tiling: Field) -> Result<Field, ExactError> {
        match self.rule.accepts(&tiling) && self.partial.agrees_with(&tiling) {
            true => Ok(tiling),
            false => Err(ExactError::Wrong),
        }
    }

    /// The cells of literals, ascending.
    fn blamed(&self, core: &[Literal]) -> Vec<u32> {
        let mut cells: Vec<u32> = core.iter().map(|&l| self.formula.cell(l)).collect();
        cells.sort_unstable();
        cells
    }
}

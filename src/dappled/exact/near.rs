//! A completion that takes after another field: its tiles are guessed first.

use super::sat::Answer;
use super::{Completion, ExactError, Question};
use crate::dappled::{FREE, Field, Rule};
use crate::search::Stop;

/// Completes a partial tiling as [`super::complete`] does, free cells with the tiles of `near` where
/// they fit. If there is none, all cells that the proof used are told, not as few as possible.
///
/// # Errors
/// As [`super::complete`].
pub fn complete_near(
    rule: &Rule,
    partial: &Field,
    near: &Field,
    stop: &dyn Stop,
) -> Result<Completion, ExactError> {
    let mut question = Question::new(rule, partial, 0)?;
    let formula = &mut question.formula;
    for (cell, &tile) in (0..).zip(near.cells()) {
        if usize::from(tile) < rule.tiles() && tile != FREE {
            let literal = formula.holds(cell, tile);
            formula.solver.prefer(literal);
        }
    }
    Ok(match formula.solver.solve(&question.given, stop) {
        Answer::Model => {
            let tiling = formula.tiling(partial);
            if !rule.accepts(&tiling) || !partial.agrees_with(&tiling) {
                return Err(ExactError::Wrong);
            }
            Completion::Found(tiling)
        }
        Answer::Failed(failed) => {
            let mut core: Vec<u32> = failed.iter().map(|&literal| formula.cell(literal)).collect();
            core.sort_unstable();
            Completion::Impossible { core, minimal: false }
        }
        Answer::Stopped => Completion::Stopped,
    })
}

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
    for (cell, &tile) in (0..).zip(near.cells()) {
        if tile != FREE {
            question.prefer(cell, tile);
        }
    }
    Ok(match question.formula.solver.solve(&question.given, stop) {
        Answer::Model => {
            Completion::Found(question.checked(question.formula.tiling(question.partial))?)
        }
        Answer::Failed(failed) => {
            Completion::Impossible { core: question.blamed(&failed), minimal: false }
        }
        Answer::Stopped => Completion::Stopped,
    })
}

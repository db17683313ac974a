//! A problem made to go step by step: the oracle of sprints and batches.

use tilepack::search::Problem;

/// A problem that never sprints.
#[derive(Clone)]
pub(crate) struct StepByStep<P>(pub(crate) P);

impl<P: Problem> Problem for StepByStep<P> {
    type Alternatives = P::Alternatives;

    fn levels(&self) -> usize {
        self.0.levels()
    }

    fn alternatives(&mut self, level: usize) -> P::Alternatives {
        self.0.alternatives(level)
    }

    fn push(&mut self, level: usize, choice: u32) {
        self.0.push(level, choice);
    }

    fn pop(&mut self, level: usize, choice: u32) {
        self.0.pop(level, choice);
    }
}

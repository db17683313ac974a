//! A problem that looks ahead: where the last lines cannot be filled any more, a node has no
//! alternatives.
//!
//! Invariant: `hopeless` holds, for every number of choices made so far, what the look after the
//! last of them said; looks build on each other, so each is made right after its choice.

use super::Labeled;
use super::last_lines::{Found, LastLines};
use crate::search::{Alternatives, Problem};
use num_bigint::BigUint;

/// A problem and its look at the last lines.
#[derive(Debug, Clone)]
pub(super) struct Watched<P> {
    problem: P,
    last: LastLines,
    found: Found,
    hopeless: Vec<bool>,
}

impl<P: Labeled> Watched<P> {
    /// The problem without choices, watched.
    pub(super) fn new(problem: P, last: LastLines) -> Self {
        let (found, hopeless) = (last.begin(), vec![false; problem.levels() + 1]);
        Self { problem, last, found, hopeless }
    }
}

impl<P: Labeled> Problem for Watched<P> {
    type Alternatives = P::Alternatives;

    fn levels(&self) -> usize {
        self.problem.levels()
    }

    fn alternatives(&mut self, level: usize) -> P::Alternatives {
        if self.hopeless[level] {
            return P::Alternatives::EMPTY;
        }
        self.problem.alternatives(level)
    }

    fn push(&mut self, level: usize, choice: u32) {
        self.problem.push(level, choice);
        let made = level + 1;
        self.hopeless[made] = made < self.problem.levels()
            && self.problem.is_hopeless(&self.last, made, &mut self.found);
    }

    fn pop(&mut self, level: usize, choice: u32) {
        self.problem.pop(level, choice);
    }
}

impl<P: Labeled> Labeled for Watched<P> {
    fn write_labels(&self, labels: &mut Vec<u8>) {
        self.problem.write_labels(labels);
    }

    fn met(&self) -> Option<(u64, BigUint)> {
        self.problem.met()
    }
}

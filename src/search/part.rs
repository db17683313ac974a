//! Parts of a search: the nodes at one depth, the *frontier*, dealt into classes.
//!
//! A node of the frontier belongs to part `r` of `m` when a hash of the choices that lead to it
//! is `r` modulo `m`. So whether a branch belongs is known from its path alone, on any machine
//! and with any number of threads, and part `r/m` is the union of the parts `r/km`,
//! `(r+m)/km`, … (the law of `res/mod` in nauty's `geng`; McKay, Piperno 2014). The hash deals
//! out like shuffled cards: with many frontier nodes to a part, parts are even.
//!
//! Every part walks the tree above the frontier again; those nodes are the same for all parts
//! and must be counted once.

use super::values::scramble;
use super::{Alternatives, Count, Problem, Slice, State, Values, Walk};

/// One of several parts of a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Part {
    /// The number of choices that lead to a node of the frontier, at least 1.
    pub depth: usize,
    /// The number of the part, from 0.
    pub number: u64,
    /// How many parts there are, at least 1.
    pub of: u64,
}

impl Part {
    /// Whether a node of the frontier with this hash belongs to the part.
    fn holds(&self, hash: u64) -> bool {
        hash % self.of == self.number
    }
}

/// The hash of the root.
const ROOT: u64 = 0;

/// The hash of a node, from that of its parent and the last choice.
///
/// Part of the format of plans: it may never change.
fn child(parent: u64, choice: u32) -> u64 {
    scramble(parent ^ scramble(u64::from(choice) + 1))
}

/// A problem cut down to one part of its frontier.
#[derive(Debug, Clone)]
pub struct InPart<P> {
    problem: P,
    part: Part,
    /// The hashes of the nodes on the path, as far as the frontier.
    hashes: Vec<u64>,
}

impl<P: Problem> InPart<P> {
    /// The part of a problem without choices; one deeper than the problem is cut at its last level.
    pub fn new(problem: P, part: Part) -> Self {
        let depth = part.depth.clamp(1, problem.levels().max(1));
        Self { problem, part: Part { depth, ..part }, hashes: vec![ROOT; depth + 1] }
    }

    /// What there is to visit. A problem without levels is all in part 0.
    pub fn state<F>(&mut self) -> State<super::Path<P::Alternatives>, F> {
        if self.problem.levels() == 0 && self.part.number > 0 {
            return State::start(Vec::new());
        }
        State::whole(self)
    }

    /// The problem itself.
    pub fn problem(&self) -> &P {
        &self.problem
    }
}

impl<P: Problem> Problem for InPart<P> {
    type Alternatives = P::Alternatives;

    fn levels(&self) -> usize {
        self.problem.levels()
    }

    #[inline(always)]
    fn alternatives(&mut self, level: usize) -> P::Alternatives {
        let mut alternatives = self.problem.alternatives(level);
        if level + 1 == self.part.depth {
            for choice in alternatives.numbers() {
                if !self.part.holds(child(self.hashes[level], choice)) {
                    alternatives.remove(choice);
                }
            }
        }
        alternatives
    }

    #[inline(always)]
    fn push(&mut self, level: usize, choice: u32) {
        if level < self.part.depth {
            self.hashes[level + 1] = child(self.hashes[level], choice);
        }
        self.problem.push(level, choice);
    }

    #[inline(always)]
    fn pop(&mut self, level: usize, choice: u32) {
        self.problem.pop(level, choice);
    }
}

/// Where a tree is cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Frontier {
    /// The number of choices that lead to its nodes.
    pub depth: usize,
    /// Its nodes.
    pub nodes: u64,
    /// The nodes above it, which every part visits.
    pub above: u64,
}

/// The first depth with at least `wanted` nodes, or if there is none, the first with the most.
///
/// It depends on the tree alone. A problem without levels has the frontier of depth 1 without
/// nodes.
pub fn frontier<P: Problem>(problem: &P, wanted: u64) -> Frontier {
    let mut widest = Frontier { depth: 1, nodes: 0, above: 0 };
    for depth in 1..=problem.levels() {
        let found = cut(problem, depth);
        if found.nodes > widest.nodes {
            widest = found;
        }
        if found.nodes == 0 || found.nodes >= wanted {
            break;
        }
    }
    widest
}

/// The frontier at a depth, which is no more than the levels of the problem.
pub fn cut<P: Problem>(problem: &P, depth: usize) -> Frontier {
    let top = Top { problem: problem.clone(), depth };
    let mut walk = Walk::whole(top, Values::Lexicographic);
    while walk.run(u64::MAX, &mut Count) == Slice::Paused {}
    Frontier { depth, nodes: walk.solutions, above: walk.nodes - walk.solutions }
}

/// The first levels of a problem.
#[derive(Debug, Clone)]
struct Top<P> {
    problem: P,
    depth: usize,
}

impl<P: Problem> Problem for Top<P> {
    type Alternatives = P::Alternatives;

    fn levels(&self) -> usize {
        self.depth
    }

    fn alternatives(&mut self, level: usize) -> P::Alternatives {
        self.problem.alternatives(level)
    }

    fn push(&mut self, level: usize, choice: u32) {
        self.problem.push(level, choice);
    }

    fn pop(&mut self, level: usize, choice: u32) {
        self.problem.pop(level, choice);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The classes of nodes are part of the format of plans.
    #[test]
    fn hashes_never_change() {
        let hash = |choices: &[u32]| choices.iter().fold(ROOT, |hash, &c| child(hash, c));
        assert_eq!(hash(&[]), 0);
        assert_eq!(hash(&[0]), 0x5e41ab087439611e);
        assert_eq!(hash(&[1, 2, 3]), 0xef5912808a652961);
    }
}

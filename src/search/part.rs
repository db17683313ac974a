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
use super::{Alternatives, Path, Problem, Sink, Slice, Values, Walk};

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
    /// The level at whose alternatives parts differ.
    pub(super) fn level(self) -> usize {
        self.depth.saturating_sub(1)
    }

    /// Of the alternatives after some choices those that belong to the part: all but at its level.
    pub(super) fn of<A: Alternatives>(self, choices: &[u32], alternatives: A) -> A {
        if choices.len() != self.level() {
            return alternatives;
        }
        let parent = choices.iter().fold(ROOT, |hash, &choice| child(hash, choice));
        let mut ours = alternatives;
        for choice in alternatives.numbers() {
            if child(parent, choice) % self.of != self.number {
                ours.remove(choice);
            }
        }
        ours
    }

    /// The same part of a search of so many levels, of which a frontier is not below the last.
    pub(super) fn within(self, levels: usize) -> Self {
        Self { depth: self.depth.clamp(1, levels.max(1)), ..self }
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
/// nodes. `sink` is told of the nodes of frontiers as if they were solutions, and must never
/// break off.
pub fn frontier<P: Problem>(problem: &P, wanted: u64, sink: &mut impl Sink<P>) -> Frontier {
    let mut widest = Frontier { depth: 1, nodes: 0, above: 0 };
    for depth in 1..=problem.levels() {
        let found = cut(problem, depth, sink);
        if found.nodes > widest.nodes {
            widest = found;
        }
        if found.nodes == 0 || found.nodes >= wanted {
            break;
        }
    }
    widest
}

/// The frontier at a depth, which is at least 1 and no more than the levels of the problem; for
/// the sink see [`frontier`].
pub fn cut<P: Problem>(problem: &P, depth: usize, sink: &mut impl Sink<P>) -> Frontier {
    let mut problem = problem.clone();
    let top = Path::top(&mut problem, depth);
    let mut walk = Walk::new(problem, Values::Lexicographic, top);
    while matches!(walk.run(u64::MAX, sink), Slice::Paused) {}
    Frontier { depth, nodes: walk.solutions, above: walk.nodes - walk.solutions }
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

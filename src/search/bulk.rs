//! When a walk leaves subtrees to a batch, and which.
//!
//! From a certain level on, the walk does not go below a node it reaches: the problem *gathers*
//! the node, and the walk goes on as if nothing were left there. Once enough are gathered, or
//! the walk is to end, the problem visits all below them in one go ([`Problem::expand`]). That
//! adds the same nodes and solutions as the walk would have met; only if they do not fit the
//! budget, or there is a solution that a sink must see, all since the first node gathered is
//! undone, and the walk goes that stretch step by step. So a walk ends where it would have ended
//! by itself, whatever is chosen here.
//!
//! The level is chosen by what is seen: few nodes to be visited step by step, but no subtrees
//! that take much of a budget.

use super::batch::HANDFUL;
use super::{Alternatives, Bounds, Problem};

/// Nodes below one gathered: with more the level is chosen deeper, with fewer less deep.
const MOST: u64 = 512;
const FEWEST: u64 = 128;
/// The share of what is left of the budget that a batch is expected to take, inverted.
const SHARE: u64 = 4;
/// Batches that the budget of a run is thought good for, at least.
const BATCHES: u64 = 64;

/// Where a walk stands, besides its choices and the alternatives left above.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spot<A> {
    pub(super) level: usize,
    /// The alternatives left at this level.
    pub(super) here: A,
    pub(super) nodes: u64,
    pub(super) solutions: u64,
    pub(super) deepest: usize,
}

/// The batch of a walk.
#[derive(Debug, Clone)]
pub(super) struct Bulk<A> {
    /// The level from which on nodes are gathered; at first 0.
    root: usize,
    /// The first level at which they may be, if any.
    lowest: Option<usize>,
    /// Nodes below one gathered, of late.
    mean: u64,
    /// Nodes gathered.
    gathered: usize,
    /// How many to gather.
    group: usize,
    /// The number of nodes up to which none is gathered.
    quiet: u64,
    /// Where the walk stood when it gathered the first.
    first: Option<Spot<A>>,
    choices: Vec<u32>,
    left: Vec<A>,
}

/// What the walk has to look out for.
#[derive(Debug, Clone, Copy)]
pub(super) struct Watch {
    /// From this level on nodes are to be gathered.
    pub(super) root: usize,
    /// With so many nodes visited it must ask again.
    pub(super) pause: u64,
}

impl<A: Alternatives> Bulk<A> {
    pub(super) fn new() -> Self {
        Self {
            root: 0,
            lowest: None,
            mean: 1,
            gathered: 0,
            group: 0,
            quiet: 0,
            first: None,
            choices: Vec::new(),
            left: Vec::new(),
        }
    }

    /// Begins a run of so many nodes in a tree of so many levels; nodes may be gathered from
    /// level `lowest` on.
    pub(super) fn begin(&mut self, lowest: Option<usize>, levels: usize, budget: u64) -> Watch {
        self.lowest = lowest.filter(|&lowest| lowest < levels);
        self.mean = self.mean.min(budget / (SHARE * BATCHES)).max(1);
        self.quiet = 0;
        if let (0, Some(lowest)) = (self.root, self.lowest) {
            self.root = lowest + (levels - lowest) * 3 / 4;
        }
        self.watch(0, budget)
    }

    /// What to look out for, with so many nodes visited.
    pub(super) fn watch(&mut self, nodes: u64, budget: u64) -> Watch {
        let left = budget - nodes;
        self.group = (left / (SHARE * self.mean)).min(HANDFUL as u64) as usize;
        if self.lowest.is_none() || self.group == 0 || self.quiet >= budget {
            return Watch { root: usize::MAX, pause: budget };
        }
        if nodes < self.quiet {
            return Watch { root: usize::MAX, pause: self.quiet };
        }
        Watch { root: self.root, pause: nodes + left.div_ceil(SHARE) }
    }

    /// Whether nodes have been gathered.
    pub(super) fn is_waiting(&self) -> bool {
        self.first.is_some()
    }

    /// Gathers the node where the walk stands, whose alternatives are all left; whether that
    /// could be, and then whether there are enough.
    pub(super) fn gather<P>(
        &mut self,
        problem: &mut P,
        at: Spot<A>,
        choices: &[u32],
        left: &[A],
    ) -> (bool, bool)
    where
        P: Problem<Alternatives = A>,
    {
        if !problem.gather(at.level) {
            return (false, false);
        }
        if self.first.is_none() {
            self.first = Some(at);
            self.choices.clear();
            self.choices.extend_from_slice(&choices[..at.level]);
            self.left.clear();
            self.left.extend_from_slice(&left[..at.level]);
        }
        self.gathered += 1;
        (true, self.gathered >= self.group)
    }

    /// Visits all below the nodes gathered, or takes everything back since the first; where the
    /// walk stands then.
    #[inline(never)]
    pub(super) fn settle<P>(
        &mut self,
        problem: &mut P,
        at: Spot<A>,
        choices: &mut [u32],
        left: &mut [A],
        bounds: Bounds,
    ) -> Spot<A>
    where
        P: Problem<Alternatives = A>,
    {
        let gathered = std::mem::take(&mut self.gathered) as u64;
        let (Some(first), Some(lowest)) = (self.first.take(), self.lowest) else { return at };
        let levels = choices.len();
        match problem.expand(Bounds { budget: bounds.budget - at.nodes, ..bounds }) {
            Ok(visited) => {
                let mean = visited.nodes / gathered.max(1);
                self.mean = (3 * self.mean + mean) / 4 + 1;
                self.root = match mean {
                    MOST.. => (self.root + 1).min(levels - 1),
                    FEWEST.. => self.root,
                    _ => (self.root - 1).max(lowest),
                };
                Spot {
                    nodes: at.nodes + visited.nodes,
                    solutions: at.solutions + visited.solutions,
                    deepest: at.deepest.max(visited.deepest),
                    ..at
                }
            }
            Err(nodes) => {
                if at.nodes + nodes > bounds.budget {
                    self.mean *= SHARE;
                    self.root = (self.root + 1).min(levels - 1);
                } else {
                    self.quiet = first.nodes + nodes;
                }
                let saved = self.choices.iter().zip(&choices[..at.level]);
                let same = saved.take_while(|(saved, now)| saved == now).count();
                for level in (same..at.level).rev() {
                    problem.pop(level, choices[level]);
                }
                for (level, &choice) in self.choices.iter().enumerate().skip(same) {
                    problem.push(level, choice);
                }
                choices[..first.level].copy_from_slice(&self.choices);
                left[..first.level].copy_from_slice(&self.left);
                first
            }
        }
    }
}

//! The walk: depth first along a path, without recursion.
//!
//! The loop runs in slices of a bounded number of nodes, so that it needs no look at a clock or
//! flag inside; between slices the path may be saved, measured or split. It allocates nothing.

use super::bulk::{Bulk, Spot};
use super::{Alternatives, Bounds, Part, Path, Problem, Sink, Stretch, Values};
use std::ops::ControlFlow;

/// How a slice of a walk ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Slice<F> {
    /// The number of nodes was used up; there is more to visit.
    Paused,
    /// Everything on the path has been visited.
    Exhausted,
    /// The sink asked to end at a solution.
    Found(F),
}

/// A problem together with the path that brought it to its state.
#[derive(Debug, Clone)]
pub struct Walk<P: Problem> {
    problem: P,
    values: Values,
    part: Option<Part>,
    path: Path<P::Alternatives>,
    bulk: Bulk<P::Alternatives>,
    /// Nodes visited.
    pub nodes: u64,
    /// Solutions met.
    pub solutions: u64,
    /// The largest number of choices made at once.
    pub deepest: usize,
}

/// Out of the way of the loop: it is called at one level only.
#[inline(never)]
fn in_part<A: Alternatives>(part: Option<Part>, choices: &[u32], alternatives: A) -> A {
    part.map_or(alternatives, |part| part.of(choices, alternatives))
}

/// Nodes left below which no sprint is worth its while.
const SHORTEST_SPRINT: u64 = 512;

impl<P: Problem> Walk<P> {
    /// A walk along `path`, for a problem without choices.
    pub fn new(mut problem: P, values: Values, path: Path<P::Alternatives>) -> Self {
        path.replay(&mut problem);
        let deepest = path.level();
        let bulk = Bulk::new();
        Self { problem, values, part: None, path, bulk, nodes: 0, solutions: 0, deepest }
    }

    /// The same walk within one part of the tree, to which its path belongs.
    pub fn within(self, part: Option<Part>) -> Self {
        Self { part: part.map(|part| part.within(self.problem.levels())), ..self }
    }

    /// A walk over the whole tree.
    pub fn whole(mut problem: P, values: Values) -> Self {
        let path = Path::root(&mut problem);
        Self::new(problem, values, path)
    }

    /// Where it stands.
    pub fn path(&self) -> &Path<P::Alternatives> {
        &self.path
    }

    /// The choices of all levels at the solution last met.
    pub fn solution(&mut self) -> &[u32] {
        self.path.parts().1
    }

    /// Gives away part of the work; see [`Path::split`].
    pub fn split(&mut self) -> Option<Path<P::Alternatives>> {
        self.path.split(self.values)
    }

    /// The part of the whole tree this path has still to visit; see [`Path::remaining`].
    pub fn remaining(&mut self) -> f64 {
        self.path.remaining(&mut self.problem, self.part)
    }

    /// Exchanges the path; gives back the old one.
    pub fn change(&mut self, path: Path<P::Alternatives>) -> Path<P::Alternatives> {
        self.path.rewind(&mut self.problem);
        path.replay(&mut self.problem);
        std::mem::replace(&mut self.path, path)
    }

    /// The problem, without choices.
    pub fn into_problem(mut self) -> P {
        self.path.rewind(&mut self.problem);
        self.problem
    }

    /// Walks on for at most `budget` nodes.
    pub fn run<S: Sink<P>>(&mut self, budget: u64, sink: &mut S) -> Slice<S::Found> {
        let values = self.values;
        let Self { problem, path, part, bulk, .. } = self;
        let (path_level, choices, left) = path.parts();
        let levels = choices.len();
        // The level at which some alternatives belong to other parts, if there are any.
        let cut = part.map_or(usize::MAX, Part::level);
        // Below which level the problem may go on by itself, if at all.
        let counts = sink.counts();
        let below = if counts || sink.breaks() { part.map_or(0, Part::level) } else { levels };
        let lexicographic = values == Values::Lexicographic;
        let start = if P::SPRINTS && lexicographic { below } else { usize::MAX };
        let lowest = problem.gathers_from().map(|lowest| lowest.max(below + 1));
        let mut watch = bulk.begin(lowest, levels, budget);
        let bounds = Bounds { levels, budget, solutions: counts };
        if levels == 0 {
            if left[0].is_empty() {
                return Slice::Exhausted;
            }
            left[0] = P::Alternatives::EMPTY;
            self.solutions += 1;
            return match sink.solution(problem, choices) {
                ControlFlow::Break(found) => Slice::Found(found),
                ControlFlow::Continue(()) => Slice::Exhausted,
            };
        }
        let level = *path_level;
        let deepest = self.deepest;
        let mut at = Spot { level, here: left[level], nodes: 0, solutions: 0, deepest };
        let end = loop {
            if at.here.is_empty() && at.level > 0 {
                at.level -= 1;
                problem.pop(at.level, choices[at.level]);
                at.here = left[at.level];
                continue;
            }
            let is_over = at.here.is_empty();
            if is_over || at.nodes == watch.pause {
                if bulk.is_waiting() {
                    at = bulk.settle(problem, at, choices, left, bounds);
                } else if is_over {
                    break Slice::Exhausted;
                } else if at.nodes == budget {
                    break Slice::Paused;
                }
                watch = bulk.watch(at.nodes, budget);
                continue;
            }
            at.nodes += 1;
            let level = at.level;
            let choice = values.first(level, at.here);
            at.here.remove(choice);
            problem.push(level, choice);
            choices[level] = choice;
            if level + 1 < levels {
                left[level] = at.here;
                let level = level + 1;
                at.level = level;
                at.deepest = at.deepest.max(level);
                at.here = problem.alternatives(level);
                if level == cut {
                    at.here = in_part(*part, &choices[..level], at.here);
                }
                if at.here.is_empty() {
                    continue;
                }
                if level >= watch.root {
                    let (taken, enough) = bulk.gather(problem, at, choices, left);
                    if taken {
                        at.here = P::Alternatives::EMPTY;
                        if enough {
                            at = bulk.settle(problem, at, choices, left, bounds);
                            watch = bulk.watch(at.nodes, budget);
                        }
                        continue;
                    }
                }
                // A sprint would go below what is to be gathered.
                let may_sprint = P::SPRINTS && level >= start && watch.root == usize::MAX;
                if may_sprint && watch.pause - at.nodes >= SHORTEST_SPRINT {
                    left[level] = at.here;
                    let budget = watch.pause - at.nodes;
                    let stretch =
                        Stretch { level, choices: &mut *choices, left: &mut *left, budget, counts };
                    if let Some(sprint) = problem.sprint(stretch) {
                        at.nodes += sprint.nodes;
                        at.solutions += sprint.solutions;
                        at.deepest = at.deepest.max(sprint.deepest);
                        at.level = sprint.level;
                        at.here = left[at.level];
                    }
                }
                continue;
            }
            if !counts && bulk.is_waiting() {
                // What was gathered comes first.
                problem.pop(level, choice);
                at.here.insert(choice);
                at.nodes -= 1;
                at = bulk.settle(problem, at, choices, left, bounds);
                watch = bulk.watch(at.nodes, budget);
                continue;
            }
            at.deepest = levels;
            at.solutions += 1;
            let answer = sink.solution(problem, choices);
            problem.pop(level, choice);
            if let ControlFlow::Break(found) = answer {
                break Slice::Found(found);
            }
        };
        left[at.level] = at.here;
        *path_level = at.level;
        self.deepest = at.deepest;
        self.nodes += at.nodes;
        self.solutions += at.solutions;
        end
    }
}

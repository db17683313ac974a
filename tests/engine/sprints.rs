//! Sprints visit the nodes of the walk, one by one, in its order.
//!
//! The oracle is the same problem made to go step by step. Both are walked in slices of odd
//! lengths; after each they must stand at the same choices with the same alternatives left.

use crate::problems::{SMALL, Visitor, task, with_problem};
use crate::step_by_step::StepByStep;
use std::convert::Infallible;
use std::ops::ControlFlow;
use tilepack::packing::Labeled;
use tilepack::search::{Count, Part, Path, Problem, Sink, Slice, Values, Walk};

/// Breaks off never or at the first solution, and says so.
struct Wants {
    first: bool,
}

impl<P: Problem> Sink<P> for Wants {
    type Found = Vec<u32>;

    fn breaks(&self) -> bool {
        true
    }

    fn solution(&mut self, _: &P, choices: &[u32]) -> ControlFlow<Vec<u32>> {
        match self.first {
            true => ControlFlow::Break(choices.to_vec()),
            false => ControlFlow::Continue(()),
        }
    }

    fn join(&mut self, _: Self) {}
}

/// What can be seen of a walk after a slice.
pub(crate) type Seen<A, F> = (Slice<F>, Vec<u32>, Vec<A>, [u64; 3]);

pub(crate) fn slice<P: Problem, S: Sink<P>>(
    walk: &mut Walk<P>,
    budget: u64,
    sink: &mut S,
) -> Seen<P::Alternatives, S::Found> {
    let end = walk.run(budget, sink);
    let (choices, left) = (walk.path().choices().to_vec(), walk.path().left().to_vec());
    (end, choices, left, [walk.nodes, walk.solutions, walk.deepest as u64])
}

pub(crate) fn walk<P: Problem>(mut problem: P, part: Option<Part>) -> Walk<P> {
    let part =
        part.map(|part| Part { depth: part.depth.clamp(1, problem.levels().max(1)), ..part });
    let path = match part {
        None => Path::root(&mut problem),
        Some(part) => Path::part(&mut problem, part),
    };
    Walk::new(problem, Values::Lexicographic, path).within(part)
}

struct Compare {
    what: String,
    sprints: usize,
    /// By implementation: where the counting walk stands after each slice.
    ways: Vec<Vec<(Vec<u32>, u64)>>,
}

impl Compare {
    fn compare<P: Labeled>(&self, problem: &P, part: Option<Part>, slices: &[u64]) {
        let mut fast = walk(problem.clone(), part);
        let mut slow = walk(StepByStep(problem.clone()), part);
        for &budget in slices {
            let seen: Seen<_, Infallible> = slice(&mut fast, budget, &mut Count);
            assert_eq!(seen, slice(&mut slow, budget, &mut Count), "{} {part:?}", self.what);
        }
        let (mut fast, mut slow) =
            (walk(problem.clone(), None), walk(StepByStep(problem.clone()), None));
        for &budget in slices {
            for first in [true, false] {
                let ours = slice(&mut fast, budget, &mut Wants { first });
                let theirs = slice(&mut slow, budget, &mut Wants { first });
                assert_eq!(ours, theirs, "{} first", self.what);
            }
        }
    }
}

impl Visitor for Compare {
    fn visit<P: Labeled>(&mut self, problem: P) {
        let slices = [1, 511, 512, 513, 600, 7, 1500, 2003, 10_007, 30_011];
        self.sprints += usize::from(P::SPRINTS);
        self.compare(&problem, None, &slices);
        for (depth, number, of) in [(2, 0, 2), (5, 1, 3)] {
            self.compare(&problem, Some(Part { depth, number, of }), &slices);
        }
        let mut walk = Walk::whole(problem, Values::Lexicographic);
        let way = slices.map(|budget| {
            walk.run(budget, &mut Count);
            (walk.path().choices().to_vec(), walk.nodes)
        });
        self.ways.push(way.to_vec());
    }
}

#[test]
fn sprints_visit_the_nodes_of_the_walk() {
    let mut sprints = 0;
    for &words in SMALL {
        for reduce in [true, false] {
            let what = format!("{words:?} {reduce}");
            let mut compare = Compare { what, sprints: 0, ways: Vec::new() };
            with_problem(&task(words), reduce, &mut compare);
            let same = compare.ways.windows(2).all(|pair| pair[0] == pair[1]);
            assert!(same, "implementations part ways: {}", compare.what);
            sprints += compare.sprints;
        }
    }
    assert!(sprints > 0);
}

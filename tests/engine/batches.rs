//! Batches visit what the walk visits.
//!
//! The oracle goes down step by step. From nodes met at random, at every level, a batch must
//! count the same nodes and solutions below, in trees cut off at any level, and must refuse
//! exactly when they are more than it may visit. Then whole walks, in slices, with batches and
//! without.

use crate::problems::{Visitor, mix, task, with_problem};
use crate::sprints::{slice, walk};
use crate::step_by_step::StepByStep;
use tilepack::packing::{Labeled, Task};
use tilepack::search::{Alternatives, Bounds, Count, First, Part, Problem, Values, Visited, Walk};
use tilepack::torus::Order;

/// A task: kind, colors, set, size; the order of cells, or none; a pin, or none.
type Words = ([&'static str; 4], &'static str, Option<(usize, u8)>);

/// Tasks that suit batches.
const TASKS: &[Words] = &[
    (["corner", "2", "complete", "4x4"], "", None),
    (["corner", "2", "complete", "4x4"], "column", None),
    (["corner", "3", "complete", "9x9"], "", None),
    (["corner", "3", "complete", "9x9"], "column", None),
    (["corner", "3", "complete", "9x9"], "", Some((30, 2))),
    (["corner", "3", "complete", "3x27"], "", None),
    (["corner", "3", "complete", "27x3"], "", None),
    (["corner", "4", "complete", "16x16"], "", None),
    (["corner", "4", "complete", "32x8"], "column", None),
    (["corner", "4", "pruned:0-1,2-3", "10x6"], "row", None),
    (["corner", "4", "pruned:0-1,2-3", "6x10"], "column", None),
    (["corner", "3", "compact", "9x6"], "row", None),
    (["corner", "3", "compact", "6x9"], "row", None),
    (["corner", "4", "compact", "16x8"], "row", None),
    (["wang", "2", "complete", "4x4"], "", None),
    (["wang", "2", "complete", "4x4"], "row", None),
    (["wang", "2", "complete", "8x2"], "row", None),
    (["wang", "2", "complete", "8x2"], "column", None),
    (["wang", "2", "complete", "2x8"], "column", None),
];

fn tasks() -> impl Iterator<Item = (String, Task)> {
    TASKS.iter().map(|&([kind, colors, members, size], order, pin)| {
        let mut task = task([kind, colors, members, size, ""]);
        task.order = Order::ALL.into_iter().find(|known| known.name() == order);
        if let Some((place, color)) = pin {
            task.pins.pin(place, color).unwrap();
        }
        (format!("{kind} {colors} {members} {size} {order} {pin:?}"), task)
    })
}

/// Everything below a node, with choices made up to `level`.
fn count<P: Problem>(problem: &mut P, level: usize, levels: usize, visited: &mut Visited) {
    for choice in problem.alternatives(level).numbers().collect::<Vec<_>>() {
        visited.nodes += 1;
        visited.deepest = visited.deepest.max(level + 1);
        if level + 1 == levels {
            visited.solutions += 1;
            continue;
        }
        problem.push(level, choice);
        count(problem, level + 1, levels, visited);
        problem.pop(level, choice);
    }
}

/// Goes down at random, again and again.
struct Descents {
    what: String,
    compared: usize,
}

impl Descents {
    fn compare<P: Labeled>(&mut self, problem: &mut P, level: usize, random: u64) {
        let levels = (level + 1 + random as usize % 5).min(problem.levels());
        let mut below = Visited::default();
        count(problem, level, levels, &mut below);
        for budget in [u64::MAX, below.nodes, below.nodes.saturating_sub(1)] {
            for solutions in [true, false] {
                if !problem.gather(level) {
                    return;
                }
                if self.compared == 0 {
                    // What waits is no part of a copy.
                    let copied = problem.clone().expand(Bounds { levels, budget: 0, solutions });
                    assert_eq!(copied, Ok(Visited::default()), "{}", self.what);
                }
                let allowed = budget >= below.nodes && (solutions || below.solutions == 0);
                match problem.expand(Bounds { levels, budget, solutions }) {
                    Ok(visited) => {
                        assert!(allowed, "{} {level}..{levels}", self.what);
                        assert_eq!(visited, below, "{} {level}..{levels}", self.what);
                        self.compared += 1;
                    }
                    Err(nodes) => {
                        assert!(!allowed && nodes <= below.nodes, "{} {level}", self.what);
                    }
                }
            }
        }
    }
}

impl Visitor for Descents {
    fn visit<P: Labeled>(&mut self, mut problem: P) {
        let Some(from) = problem.gathers_from() else { return };
        let levels = problem.levels();
        for descent in 0..300u64 {
            let mut choices = Vec::new();
            while choices.len() < levels {
                let level = choices.len();
                let random = mix(descent << 20 | level as u64);
                let alternatives: Vec<u32> = problem.alternatives(level).numbers().collect();
                // Mostly the smallest, for that leads deep.
                let at = match random % 8 {
                    0 => random >> 8,
                    _ => 0,
                };
                if level >= from && random >> 4 & 3 == 0 {
                    self.compare(&mut problem, level, random >> 32);
                }
                let Some(&choice) = alternatives.get(at as usize % alternatives.len().max(1))
                else {
                    break;
                };
                problem.push(level, choice);
                choices.push(choice);
            }
            for (level, &choice) in choices.iter().enumerate().rev() {
                problem.pop(level, choice);
            }
        }
    }
}

#[test]
fn batches_count_what_lies_below_a_node() {
    for (what, task) in tasks() {
        for reduce in [true, false] {
            let mut descents = Descents { what: what.clone(), compared: 0 };
            with_problem(&task, reduce && !task.has_pins(), &mut descents);
            assert!(descents.compared > 100, "{what} {}", descents.compared);
        }
    }
}

/// Walks in slices with batches and without.
struct Slices(String);

impl Visitor for Slices {
    fn visit<P: Labeled>(&mut self, problem: P) {
        if problem.gathers_from().is_none() {
            return;
        }
        let what = &self.0;
        let slices = [100, 3_000, 120_000, 700, 40_000, 1 << 16];
        for part in [None, Some(Part { depth: problem.levels() / 2, number: 1, of: 2 })] {
            let mut fast = walk(problem.clone(), part);
            let mut slow = walk(StepByStep(problem.clone()), part);
            for budget in slices {
                let seen = slice(&mut fast, budget, &mut Count);
                assert_eq!(seen, slice(&mut slow, budget, &mut Count), "{what} {part:?}");
            }
        }
        for values in [Values::Lexicographic, Values::Random(3)] {
            let mut fast = Walk::whole(problem.clone(), values);
            let mut slow = Walk::whole(StepByStep(problem.clone()), values);
            for budget in slices {
                let seen = slice(&mut fast, budget, &mut First);
                assert_eq!(seen, slice(&mut slow, budget, &mut First), "{what} {values:?}");
            }
        }
    }
}

#[test]
fn walks_with_batches_end_where_others_do() {
    for (what, task) in tasks() {
        with_problem(&task, !task.has_pins(), &mut Slices(what));
    }
}

//! Sprints visit the nodes of the walk, one by one; caps cut nodes and no solution.

use crate::answers::puzzles;
use crate::step_by_step::StepByStep;
use proptest::prelude::*;
use tilepack::packing::Task;
use tilepack::packing::board::Planned;
use tilepack::search::{Count, Part, Path, Problem, Slice, Values, Walk};
use tilepack::store::{Input, read_squares};
use tilepack::torus::{Board, Border, Order, Shape, Topology};

/// The framed board of a data file.
pub(crate) fn frame(side: u64) -> Task {
    let file = format!("{}/data/frame-{side}x{side}.json", env!("CARGO_MANIFEST_DIR"));
    let set = read_squares(&Input::open(file).unwrap(), None).unwrap().set;
    let shape = Shape::new(side, side).unwrap();
    let border = Border::of_one(Topology::Rectangle, shape, 0);
    Task::on(set, shape, Board { topology: Topology::Rectangle, rotations: true, border })
}

fn walk<P: Problem>(mut problem: P, part: Option<Part>) -> Walk<P> {
    let depth = problem.levels().max(1);
    let part = part.map(|part| Part { depth: part.depth.clamp(1, depth), ..part });
    let path = match part {
        None => Path::root(&mut problem),
        Some(part) => Path::part(&mut problem, part),
    };
    Walk::new(problem, Values::Lexicographic, path).within(part)
}

/// Compares after slices of odd lengths; says whether all was visited, and what it came to.
fn compare(task: &Task, with_caps: bool, part: Option<Part>, slices: &[u64]) -> (bool, [u64; 3]) {
    let problem = Planned::new(task, with_caps).problem::<16>();
    let (mut fast, mut slow) = (walk(problem.clone(), part), walk(StepByStep(problem), part));
    let mut seen = (false, [0; 3]);
    for &slice in slices {
        let end = fast.run(slice, &mut Count);
        assert_eq!(end, slow.run(slice, &mut Count));
        assert_eq!(fast.path().choices(), slow.path().choices());
        assert_eq!(fast.path().left(), slow.path().left());
        let numbers = [fast.nodes, fast.solutions, fast.deepest as u64];
        assert_eq!(numbers, [slow.nodes, slow.solutions, slow.deepest as u64]);
        seen = (end == Slice::Exhausted, numbers);
    }
    seen
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]
    #[test]
    fn on_small_boards(puzzle in puzzles(), order in 0..4usize, part in 0..3u64) {
        if let Some(mut task) = puzzle.task() {
            task.order = Some(Order::ALL[order]);
            let parts = [None, Some(Part { depth: 2, number: part, of: 3 })];
            for (with_caps, part) in [(true, parts[0]), (false, parts[0]), (true, parts[1])] {
                compare(&task, with_caps, part, &[3, 513, 600, 5000, 200_000]);
            }
        }
    }
}

#[test]
fn on_frames() {
    let slices = [1, 511, 512, 513, 700, 7, 1500, 30_011, 100_003];
    for side in [6, 10, 16] {
        for order in Order::ALL {
            let task = Task { order: Some(order), ..frame(side) };
            for with_caps in [true, false] {
                compare(&task, with_caps, None, &slices);
                compare(&task, with_caps, Some(Part { depth: 9, number: 1, of: 2 }), &slices);
            }
        }
    }
}

/// The whole tree of a board of 36 squares: three solutions, each in four positions.
#[test]
fn caps_cut_nodes_and_no_solution() {
    let task = frame(6);
    assert_eq!(compare(&task, true, None, &[10_000_000]), (true, [1_788_857, 12, 36]));
    assert_eq!(compare(&task, false, None, &[10_000_000]), (true, [2_403_361, 12, 36]));
}

//! Stopping and going on: a search may be cut anywhere, and what it leaves completes it.

use crate::paths::All;
use crate::problems::{Tree, Visitor, irregular, mix, task, with_problem};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use tilepack::packing::Labeled;
use tilepack::search::{
    Count, Effort, First, Limits, Path, Plan, Problem, Progress, State, Stop, Trail, TrailError,
    Values, run,
};

fn plan<P: Problem>(problem: &P, values: Values, threads: usize, nodes: u64) -> Plan<'static, P> {
    let limits = Limits { nodes, ..Limits::NONE };
    Plan { threads, limits, ..Plan::simple(problem.clone(), values) }
}

/// What a search stands at, as a file would bring it back: in plain numbers and checked.
fn saved<P: Problem, F>(
    problem: &P,
    state: State<Path<P::Alternatives>, F>,
) -> State<Path<P::Alternatives>, F> {
    let mut problem = problem.clone();
    let again = |path: Path<_>| {
        let again = Trail::of(&path).path(&mut problem)?;
        assert_eq!(again, path);
        Ok::<_, TrailError>(again)
    };
    state.try_map(again).unwrap()
}

/// Runs a search in pieces of so many nodes on so many threads; nodes and sorted solutions.
fn in_pieces<P: Problem>(
    problem: &P,
    values: Values,
    pieces: impl Iterator<Item = (u64, usize)>,
) -> (u64, Vec<Vec<u32>>) {
    let mut solutions = Vec::new();
    let mut state = State::whole(&mut problem.clone());
    for (piece, threads) in pieces {
        let before = state.nodes;
        let all;
        (state, all) = run(&mut plan(problem, values, threads, piece), state, All::default);
        let visited = state.nodes - before;
        assert!(visited <= piece);
        assert!(threads > 1 || state.is_complete() || visited == piece, "exact on one thread");
        solutions.extend(all.0);
        assert_eq!(state.solutions, solutions.len() as u64);
        if state.is_complete() {
            solutions.sort_unstable();
            return (state.effort().nodes, solutions);
        }
        state = saved(problem, state);
    }
    panic!("the pieces end before the search");
}

const ORDERS: [Values; 2] = [Values::Lexicographic, Values::Random(4)];

#[test]
fn cut_after_every_number_of_nodes() {
    let tree = Tree::new(6, irregular);
    for values in ORDERS {
        let whole = in_pieces(&tree, values, std::iter::once((u64::MAX, 1)));
        assert!(whole.0 > 300, "{}", whole.0);
        for first in 0..=whole.0 + 1 {
            for threads in [1, 3] {
                let pieces = [(first, threads), (u64::MAX, 4 - threads)];
                assert_eq!(in_pieces(&tree, values, pieces.into_iter()), whole, "{first}");
            }
        }
        for piece in [1, 2, 3, 7, 50] {
            let pieces = std::iter::repeat((piece, 1));
            assert_eq!(in_pieces(&tree, values, pieces), whole, "{piece}");
        }
    }
}

#[test]
fn cut_at_random() {
    let tree = Tree::new(13, irregular);
    for values in ORDERS {
        let whole = in_pieces(&tree, values, std::iter::once((u64::MAX, 1)));
        for seed in 0..12 {
            let mut random = mix(seed + 7);
            let pieces = std::iter::repeat_with(|| {
                random = mix(random.wrapping_add(0x9e37_79b9_7f4a_7c15));
                let nodes = (random >> 8) % [1, 100, 20_000, 200_000][(random >> 40) as usize % 4];
                (nodes + 1, [1, 2, 3, 8][(random >> 50) as usize % 4])
            });
            assert!(in_pieces(&tree, values, pieces) == whole, "{seed} {values:?}");
        }
    }
}

/// Cuts the searches for all packings of every type of problem.
struct Cuts;

impl Visitor for Cuts {
    fn visit<P: Labeled>(&mut self, problem: P) {
        for values in ORDERS {
            let whole = in_pieces(&problem, values, std::iter::once((u64::MAX, 1)));
            let small = whole.0 / 6 + 1;
            for threads in [1, 2, 8] {
                let pieces = std::iter::repeat((small, threads));
                assert!(in_pieces(&problem, values, pieces) == whole);
            }
        }
    }
}

#[test]
fn cut_packing_problems() {
    for words in [
        ["corner", "2", "complete", "4x4", ""],
        ["corner", "2", "compact", "6x3", ""],
        ["corner", "2", "complete", "6x3", "3,0:0,1"],
        ["wang", "2", "complete", "4x4", "2,0:1,0"],
        ["wang", "2", "compact", "4x2", ""],
        ["wang", "2", "compact", "3x3", ""],
        ["domino", "4", "complete", "16x1", ""],
    ] {
        with_problem(&task(words), true, &mut Cuts);
    }
    with_problem(&task(["wang", "2", "complete", "4x4", ""]), true, &mut Cuts);
}

/// Looks for the first solution in pieces; the work before it, and the solution.
fn first_in_pieces(
    tree: &Tree,
    values: Values,
    pieces: impl Iterator<Item = (u64, usize)>,
) -> (Effort, Option<Vec<u32>>) {
    let mut state = State::whole(&mut tree.clone());
    for (piece, threads) in pieces {
        (state, _) = run(&mut plan(tree, values, threads, piece), state, || First);
        assert!(state.records.len() <= state.left.len() + 1, "{state:?}");
        if state.is_complete() {
            return (state.effort(), state.best.map(|best| best.found));
        }
        state = saved(tree, state);
    }
    panic!("the pieces end before the search");
}

/// A tree whose first solution comes late.
fn late(choices: &[u32]) -> u64 {
    let open = irregular(choices);
    let dead = choices.len() == 11 && choices[..2] != [3, 4] && choices[0] < 4;
    if dead { 0 } else { open }
}

#[test]
fn the_first_solution_in_pieces() {
    let tree = Tree::new(12, late);
    for values in ORDERS {
        let whole = first_in_pieces(&tree, values, std::iter::once((u64::MAX, 1)));
        assert!(whole.1.is_some());
        for threads in [2, 3, 8] {
            let several = first_in_pieces(&tree, values, std::iter::once((u64::MAX, threads)));
            assert_eq!(several, whole, "{threads} threads");
        }
        for seed in 0..20 {
            let draw = |i: u64| mix(mix(seed) + i) >> 8;
            let alone = (0..).map(|i| (draw(i) % 30_000 + 1, 1));
            assert_eq!(first_in_pieces(&tree, values, alone), whole, "nodes and solution");
            // Several threads also visit nodes behind the solution; they do not count.
            let several = (0..).map(|i| (draw(i) % 60_000 + 1, [2, 3, 8][(draw(i) % 3) as usize]));
            assert_eq!(first_in_pieces(&tree, values, several), whole, "{seed}");
        }
    }
}

/// Seen by the search when enough nodes are done.
struct After<'a>(&'a AtomicBool);

impl Stop for After<'_> {
    fn should_stop(&self) -> bool {
        self.0.load(Ordering::SeqCst)
    }
}

/// A tree of 4^15 nodes: far too many to visit here.
fn endless(_: &[u32]) -> u64 {
    0b1111
}

#[test]
fn a_flag_stops_a_long_search_at_once() {
    for threads in [1, 2, 8] {
        let flag = AtomicBool::new(false);
        let set = Instant::now() + Duration::from_millis(150);
        let watch = |_: &Progress| {
            if Instant::now() >= set {
                flag.store(true, Ordering::SeqCst);
            }
        };
        let stop = (After(&flag), ());
        let limits = Limits { stop: &stop, nodes: u64::MAX };
        let tree = Tree::new(30, endless);
        let mut plan =
            Plan { threads, limits, watch: &watch, ..Plan::simple(tree, Values::Lexicographic) };
        let whole = State::whole(&mut plan.problem.clone());
        let (state, _) = run(&mut plan, whole, || Count);
        assert!(set.elapsed() < Duration::from_secs(1), "{:?}", set.elapsed());
        assert!(!state.is_complete() && state.nodes > 0);
    }
}

#[test]
fn a_deadline_stops_too() {
    let deadline = Instant::now() + Duration::from_millis(100);
    let limits = Limits { stop: &deadline, nodes: u64::MAX };
    let mut plan =
        Plan { limits, threads: 2, ..Plan::simple(Tree::new(30, endless), Values::Random(1)) };
    let whole = State::whole(&mut plan.problem.clone());
    let (state, _) = run(&mut plan, whole, || Count);
    assert!(!state.is_complete() && deadline.elapsed() < Duration::from_secs(1));
}

/// A search of a few million nodes, stopped by a flag and completed.
#[test]
fn what_a_stopped_search_leaves_completes_it() {
    struct Stopped;
    impl Visitor for Stopped {
        fn visit<P: Labeled>(&mut self, problem: P) {
            let values = Values::Lexicographic;
            let root = || State::whole(&mut problem.clone());
            let (whole, _) = run(&mut plan(&problem, values, 1, u64::MAX), root(), || Count);
            for threads in [1, 2, 3, 8] {
                let flag = AtomicBool::new(false);
                let watch = |_: &Progress| flag.store(true, Ordering::SeqCst);
                let limits = Limits { stop: &flag, nodes: u64::MAX };
                let all = plan(&problem, values, threads, u64::MAX);
                let (part, _) = run(&mut Plan { limits, watch: &watch, ..all }, root(), || Count);
                let before = part.elapsed;
                let mut rest = plan(&problem, values, 9 - threads, u64::MAX);
                let (rest, _) = run(&mut rest, saved(&problem, part), || Count);
                assert!(rest.is_complete() && rest.elapsed >= before);
                assert_eq!(rest.effort(), whole.effort(), "{threads}");
            }
        }
    }
    with_problem(&task(["wang", "2", "complete", "4x4", ""]), false, &mut Stopped);
}

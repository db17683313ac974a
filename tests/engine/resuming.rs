//! Stopping and going on: a search may be cut anywhere, and what it leaves completes it.

use crate::paths::All;
use crate::problems::{Tree, Visitor, irregular, mix, task, with_problem};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use tilepack::packing::Labeled;
use tilepack::search::{Count, First, Limits, Path, Plan, Problem, Progress, Stop, Values, run};

fn plan<P: Problem>(
    problem: &P,
    values: Values,
    paths: Vec<Path<P::Alternatives>>,
    threads: usize,
    nodes: u64,
) -> Plan<'static, P> {
    let limits = Limits { nodes, ..Limits::NONE };
    Plan { paths, threads, limits, ..Plan::whole(problem.clone(), values) }
}

fn root<P: Problem>(problem: &P) -> Vec<Path<P::Alternatives>> {
    vec![Path::root(&mut problem.clone())]
}

/// Runs a search in pieces of so many nodes on so many threads; nodes and sorted solutions.
fn in_pieces<P: Problem>(
    problem: &P,
    values: Values,
    pieces: impl Iterator<Item = (u64, usize)>,
) -> (u64, Vec<Vec<u32>>) {
    let (mut nodes, mut solutions) = (0, Vec::new());
    let mut paths = root(problem);
    for (piece, threads) in pieces {
        let outcome = run(plan(problem, values, paths, threads, piece), All::default);
        assert!(outcome.nodes <= piece);
        assert!(threads > 1 || outcome.complete || outcome.nodes == piece, "exact on one thread");
        assert_eq!(outcome.solutions, outcome.sink.0.len() as u64);
        assert_eq!(outcome.complete, outcome.left.is_empty());
        nodes += outcome.nodes;
        solutions.extend(outcome.sink.0);
        paths = outcome.left;
        if paths.is_empty() {
            solutions.sort_unstable();
            return (nodes, solutions);
        }
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

/// Looks for the first solution in pieces; the nodes of all, and the solution.
fn first_in_pieces(
    tree: &Tree,
    values: Values,
    pieces: impl Iterator<Item = (u64, usize)>,
) -> (u64, Option<Vec<u32>>) {
    let (mut nodes, mut best) = (0, None);
    let mut paths = root(tree);
    for (piece, threads) in pieces {
        let outcome = run(plan(tree, values, paths, threads, piece), || First);
        nodes += outcome.nodes;
        // What is left lies before what was found, so what is found later is better.
        best = outcome.found.or(best);
        paths = outcome.left;
        if outcome.complete {
            return (nodes, best);
        }
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
            // Several threads also visit nodes behind the solution, which only a search that
            // ends in one piece can leave out.
            let several = (0..).map(|i| (draw(i) % 60_000 + 1, [2, 3, 8][(draw(i) % 3) as usize]));
            assert_eq!(first_in_pieces(&tree, values, several).1, whole.1);
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
        let plan =
            Plan { threads, limits, watch: &watch, ..Plan::whole(tree, Values::Lexicographic) };
        let outcome = run(plan, || Count);
        assert!(set.elapsed() < Duration::from_secs(1), "{:?}", set.elapsed());
        assert!(!outcome.complete && !outcome.left.is_empty() && outcome.nodes > 0);
    }
}

#[test]
fn a_deadline_stops_too() {
    let deadline = Instant::now() + Duration::from_millis(100);
    let limits = Limits { stop: &deadline, nodes: u64::MAX };
    let plan =
        Plan { limits, threads: 2, ..Plan::whole(Tree::new(30, endless), Values::Random(1)) };
    let outcome = run(plan, || Count);
    assert!(!outcome.complete && deadline.elapsed() < Duration::from_secs(1));
}

/// A search of a few million nodes, stopped by a flag and completed.
#[test]
fn what_a_stopped_search_leaves_completes_it() {
    struct Stopped;
    impl Visitor for Stopped {
        fn visit<P: Labeled>(&mut self, problem: P) {
            let values = Values::Lexicographic;
            let whole = run(plan(&problem, values, root(&problem), 1, u64::MAX), || Count);
            for threads in [1, 2, 3, 8] {
                let flag = AtomicBool::new(false);
                let watch = |_: &Progress| flag.store(true, Ordering::SeqCst);
                let limits = Limits { stop: &flag, nodes: u64::MAX };
                let all = plan(&problem, values, root(&problem), threads, u64::MAX);
                let part = run(Plan { limits, watch: &watch, ..all }, || Count);
                let rest = plan(&problem, values, part.left, 9 - threads, u64::MAX);
                let rest = run(rest, || Count);
                assert!(rest.complete);
                assert_eq!(part.nodes + rest.nodes, whole.nodes, "{threads}");
                assert_eq!(part.solutions + rest.solutions, whole.solutions, "{threads}");
                assert_eq!(part.deepest.max(rest.deepest), whole.deepest);
            }
        }
    }
    with_problem(&task(["wang", "2", "complete", "4x4", ""]), false, &mut Stopped);
}

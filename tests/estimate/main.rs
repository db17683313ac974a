//! Estimates: unbiased, honest about their uncertainty, and the same for any number of threads.
//!
//! The oracle is Knuth's estimator in its plainest form, one random path a probe, and exact
//! numbers of nodes level by level from a walk over the whole tree.

#![allow(clippy::unwrap_used)]

use std::sync::atomic::AtomicBool;
use tilepack::packing::estimate::{Estimated, estimate};
use tilepack::packing::last_lines::LastLines;
use tilepack::packing::reduction::Reduction;
use tilepack::packing::solve::SolveError;
use tilepack::packing::{Job, Labeled, Settings as Search, Task, count, dispatch};
use tilepack::search::estimate::{Interval, Settings, estimate as estimate_tree};
use tilepack::search::{Alternatives, Count, Problem, Words};
use tilepack::tiles::{TileSet, notation};

fn task(kind: &str, colors: &str, members: &str, size: &str) -> Task {
    let members = notation::parse_members(members).unwrap().unwrap();
    let set = TileSet::new(kind.parse().unwrap(), colors.parse().unwrap(), members).unwrap();
    let shape = size.parse().unwrap();
    Task::new(set, shape)
}

const SILENT: Settings<'static> =
    Settings { threads: 2, effort: 0, seed: 0, stop: &(), watch: &|_| {} };

fn probed(task: &Task, effort: u64, seed: u64, reduce: bool) -> Estimated {
    estimate(task, &Settings { effort, seed, ..SILENT }, reduce).unwrap()
}

fn holds(interval: Option<Interval>, truth: f64) -> bool {
    // An interval without width, of probes that all agree, is subject to rounding.
    interval.is_some_and(|i| i.low <= truth * (1.0 + 1e-9) && truth <= i.high * (1.0 + 1e-9))
}

/// Of 100 seeds, how many intervals hold the truth, and the mean of the estimates relative to it.
#[track_caller]
fn check_coverage(task: &Task, effort: u64, reduce: bool, packings: f64, nodes: f64) {
    let (mut packings_held, mut nodes_held) = (0, 0);
    let (mut packings_mean, mut nodes_mean) = (0.0, 0.0);
    for seed in 0..100 {
        let tree = probed(task, effort, seed, reduce).tree;
        assert!(!tree.exact && tree.complete && tree.replicates == 64);
        packings_held += u32::from(holds(tree.solutions, packings));
        nodes_held += u32::from(holds(tree.nodes, nodes));
        packings_mean += tree.solutions.map_or(0.0, |i| i.mean) / packings / 100.0;
        nodes_mean += tree.nodes.unwrap().mean / nodes / 100.0;
        let effort = effort as f64;
        assert!(tree.probed as f64 > 0.4 * effort && (tree.probed as f64) < 1.8 * effort);
    }
    assert!(packings_held >= 93, "packings held by {packings_held} of 100 intervals");
    assert!(nodes_held >= 93, "nodes held by {nodes_held} of 100 intervals");
    assert!((packings_mean - 1.0).abs() < 0.04, "packings on average {packings_mean}");
    assert!((nodes_mean - 1.0).abs() < 0.03, "nodes on average {nodes_mean}");
}

#[test]
fn intervals_hold_the_number_of_wang_packings() {
    let task = task("wang", "2", "complete", "4x4");
    let counted = count(&task, &Search::PLAIN, false).unwrap();
    assert_eq!((counted.work.nodes, counted.value.packings), (537_503, 203_520u32.into()));
    check_coverage(&task, 100_000, true, 203_520.0, 537_503.0);
}

#[test]
fn intervals_hold_the_number_of_corner_packings() {
    let task = task("corner", "2", "complete", "4x4");
    // Not reduced: the reduced tree is too small to leave anything out.
    let job = Job { reduce: false, ..Job::from(&task) };
    let counted = count(job, &Search::PLAIN, false).unwrap();
    assert_eq!(counted.value.packings, 32u32.into());
    check_coverage(&task, 16_000, false, 32.0, counted.work.nodes as f64);
}

#[test]
fn small_trees_are_exact() {
    for (words, packings) in [
        (["corner", "2", "complete", "4x4"], 32.0),
        (["wang", "2", "complete", "4x4"], 203_520.0),
        (["domino", "3", "complete", "9x1"], 216.0),
        (["corner", "2", "complete", "2x8"], 0.0),
    ] {
        let [kind, colors, members, size] = words;
        let task = task(kind, colors, members, size);
        let nodes = count(&task, &Search::PLAIN, false).unwrap().work.nodes;
        let tree = probed(&task, 4_000_000, 5, true).tree;
        assert!(tree.exact && tree.complete, "{words:?}");
        assert_eq!(tree.nodes, Some(Interval::exact(nodes as f64)), "{words:?}");
        assert_eq!(tree.solutions, Some(Interval::exact(packings)), "{words:?}");
    }
}

#[test]
fn all_kinds_of_problems() {
    let mut cover = task("corner", "2", "complete", "6x3");
    cover.cover = true;
    let mut ring = task("domino", "4", "complete", "17x1");
    ring.cover = true;
    for (task, effort) in
        [(cover, 4_000), (ring, 40_000), (task("wang", "2,3", "compact", "6x2"), 2_000)]
    {
        let counted = count(&task, &Search::PLAIN, false).unwrap();
        let packings: f64 = counted.value.packings.to_string().parse().unwrap();
        let nodes = counted.work.nodes as f64;
        let held = (0..20).filter(|&seed| {
            let tree = probed(&task, effort, seed, true).tree;
            holds(tree.nodes, nodes) && holds(tree.solutions, packings)
        });
        let held = held.count();
        assert!(held >= 15, "{:?}: {held} of 20", task.shape);
    }
}

#[test]
fn threads_make_no_difference() {
    for (task, effort) in [
        (task("corner", "3", "complete", "9x9"), 600_000),
        (task("wang", "2", "complete", "4x4"), 100_000),
    ] {
        let with = |threads, seed| {
            let settings = Settings { threads, effort, seed, ..SILENT };
            estimate(&task, &settings, true).unwrap().tree
        };
        let one = with(1, 7);
        assert_eq!(one, with(2, 7));
        assert_eq!(one, with(3, 7));
        assert_ne!(one, with(2, 8));
    }
}

#[test]
fn no_estimate_where_no_probe_reached_a_packing() {
    let tree = probed(&task("corner", "4", "complete", "16x16"), 200_000, 1, true).tree;
    assert!(tree.complete && !tree.exact && tree.nodes.is_some());
    assert_eq!(tree.solutions, None);
}

#[test]
fn stopped_at_once() {
    let stop = AtomicBool::new(true);
    let settings = Settings { effort: 1_000_000, stop: &stop, ..SILENT };
    let task = task("corner", "3", "complete", "9x9");
    let tree = estimate(&task, &settings, true).unwrap().tree;
    assert!(!tree.complete && tree.nodes.is_none() && tree.solutions.is_none());
}

/// A tree given by a hash: no, one or several of five alternatives.
#[derive(Clone)]
struct Tree(Vec<u32>);

const LEVELS: usize = 9;

impl Problem for Tree {
    type Alternatives = Words<1>;

    fn levels(&self) -> usize {
        LEVELS
    }

    fn alternatives(&mut self, _: usize) -> Words<1> {
        let mix = |hash: u64, &choice: &u32| {
            (hash ^ u64::from(choice + 1)).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(23)
        };
        let hash = self.0.iter().fold(11, mix) >> 7;
        Words([if self.0.is_empty() || hash % 5 == 0 { 0b1_1111 } else { hash >> 9 & 0b1_1011 }])
    }

    fn push(&mut self, _: usize, choice: u32) {
        self.0.push(choice);
    }

    fn pop(&mut self, _: usize, _: u32) {
        self.0.pop();
    }
}

/// Exact numbers of nodes by level.
fn count_levels(tree: &mut Tree, level: usize, widths: &mut [f64; LEVELS]) {
    for choice in tree.alternatives(level).numbers() {
        widths[level] += 1.0;
        if level + 1 < LEVELS {
            tree.push(level, choice);
            count_levels(tree, level + 1, widths);
            tree.pop(level, choice);
        }
    }
}

/// One random path (Knuth 1975): the number of nodes of each level is the product of the
/// numbers of alternatives on the way.
fn knuth(tree: &mut Tree, random: &mut u64, sums: &mut [f64; LEVELS]) {
    let mut product = 1.0;
    for (level, sum) in sums.iter_mut().enumerate() {
        let choices: Vec<u32> = tree.alternatives(level).numbers().collect();
        product *= choices.len() as f64;
        *sum += product;
        if choices.is_empty() {
            break;
        }
        *random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        tree.push(level, choices[(*random >> 33) as usize % choices.len()]);
    }
    tree.0.clear();
}

#[test]
fn agrees_with_the_whole_tree_and_with_knuth() {
    let mut tree = Tree(Vec::new());
    let (mut exact, mut single) = ([0.0; LEVELS], [0.0; LEVELS]);
    count_levels(&mut tree, 0, &mut exact);
    let (mut random, paths) = (3, 300_000);
    (0..paths).for_each(|_| knuth(&mut tree, &mut random, &mut single));
    for (exact, sum) in exact.iter().zip(single) {
        assert!((sum / f64::from(paths) / exact - 1.0).abs() < 0.05, "Knuth: {exact}");
    }
    let (nodes, leaves) = (exact.iter().sum::<f64>(), exact[LEVELS - 1]);
    let (mut mean_nodes, mut mean_leaves, mut held) = (0.0, 0.0, 0);
    for seed in 0..100 {
        let settings = Settings { effort: (nodes / 8.0) as u64, seed, ..SILENT };
        let look = None::<fn() -> fn(&Tree, usize) -> bool>;
        let estimate = estimate_tree(&tree, look, || Count, &settings);
        assert!(!estimate.exact);
        mean_nodes += estimate.nodes.unwrap().mean / 100.0;
        mean_leaves += estimate.solutions.unwrap().mean / 100.0;
        held += u32::from(holds(estimate.solutions, leaves) && holds(estimate.nodes, nodes));
    }
    assert!((mean_nodes / nodes - 1.0).abs() < 0.02, "{mean_nodes} {nodes}");
    assert!((mean_leaves / leaves - 1.0).abs() < 0.02, "{mean_leaves} {leaves}");
    assert!(held >= 88, "{held}");
}

/// Counts the packings of a problem with and without a look at the last lines.
struct Looking<'a>(&'a LastLines);

impl dispatch::Visitor for Looking<'_> {
    type Output = [[u64; 2]; 2];

    fn visit<P: Labeled>(self, problem: Option<P>) -> Result<Self::Output, SolveError> {
        fn walk<P: Labeled>(
            problem: &mut P,
            level: usize,
            met: &mut [u64; 2],
            look: &mut impl FnMut(&P, usize) -> bool,
        ) {
            let last = level + 1 == problem.levels();
            for choice in problem.alternatives(level).numbers() {
                met[0] += 1;
                met[1] += u64::from(last);
                problem.push(level, choice);
                if !last && !look(problem, level + 1) {
                    walk(problem, level + 1, met, look);
                }
                problem.pop(level, choice);
            }
        }
        let (mut plain, mut looking) = ([0; 2], [0; 2]);
        let mut problem = problem.unwrap();
        walk(&mut problem, 0, &mut plain, &mut |_, _| false);
        let mut found = self.0.begin();
        let mut look = |problem: &P, level: usize| problem.is_hopeless(self.0, level, &mut found);
        walk(&mut problem, 0, &mut looking, &mut look);
        Ok([plain, looking])
    }
}

#[test]
fn the_look_at_the_last_lines_misses_no_packing() {
    for (words, cover) in [
        (["corner", "2", "complete", "4x4"], false),
        (["corner", "2", "compact", "4x4"], false),
        (["corner", "2", "compact", "8x2"], false),
        (["corner", "2", "complete", "6x3"], true),
        (["corner", "2", "complete", "3x6"], true),
        (["corner", "2", "compact", "3x6"], true),
    ] {
        let [kind, colors, members, size] = words;
        let mut task = task(kind, colors, members, size);
        task.cover = cover;
        for reduction in [Reduction::full(&task), Reduction::none()] {
            let last = LastLines::new(&task, &reduction).unwrap();
            let [plain, looking] =
                dispatch::with_problem(&task, &reduction, Looking(&last)).unwrap();
            assert_eq!(plain[1], looking[1], "{words:?}");
            assert!(looking[0] <= plain[0], "{words:?}");
        }
    }
}

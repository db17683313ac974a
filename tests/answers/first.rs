//! First packings. A node is one choice committed by the search (one `push`); what is pinned
//! beforehand, such as the window at the origin, is not counted. The numbers are properties of
//! the problem, the order and the pruning: they guard against unnoticed changes of these.

use crate::engines::verify;
use crate::table::Words;
use tilepack::packing::{Job, Settings, Task, find};
use tilepack::search::{Limits, Values};
use tilepack::torus::Order;

fn settings(threads: usize) -> Settings<'static> {
    Settings { threads, ..Settings::PLAIN }
}

fn job(task: &Task, values: Values) -> Job {
    Job { values, ..Job::from(task) }
}

fn first(task: &Task, values: Values, what: &str) -> u64 {
    let one = find(job(task, values), &settings(1)).unwrap();
    let labels = one.value.as_ref().unwrap();
    verify(task, labels, what);
    for threads in [2, 3, 8] {
        let several = find(job(task, values), &settings(threads)).unwrap();
        assert_eq!(several, one, "{what}, {threads} threads");
    }
    one.work.nodes
}

/// Task, values, and the node at which the first packing is found.
type Row = (Words<'static>, Values, u64);

const FIRSTS: &[Row] = &[
    (Words("corner", "3", "complete", "", ""), Values::Lexicographic, 260_513),
    (Words("corner", "3", "complete", "", ""), Values::Random(2), 1_047_415),
    (Words("corner", "3", "compact", "", ""), Values::Lexicographic, 891),
    (Words("corner", "3", "compact", "", ""), Values::Random(0), 146_038),
    (Words("wang", "3", "complete", "", ""), Values::Random(0), 775_730),
    (Words("wang", "3", "compact", "", ""), Values::Lexicographic, 1427),
    (Words("wang", "2,3", "complete", "", ""), Values::Lexicographic, 455_393),
    (Words("wang", "3,2", "complete", "", ""), Values::Lexicographic, 208),
    (Words("domino", "8", "complete", "", ""), Values::Lexicographic, 70),
    (Words("corner", "3", "complete", "", "3,0:+1"), Values::Lexicographic, 2835),
    (Words("corner", "4", "compact", "16x8", "4,0:1,2,3,0"), Values::Lexicographic, 434),
    (Words("corner", "4", "complete", "", "4,0:1,2,3,0"), Values::Lexicographic, 201_135),
    (Words("corner", "4", "complete", "", "4,0:1,2,3,0"), Values::Random(0), 87_134),
];

#[test]
fn first_packings() {
    for &(words, values, nodes) in FIRSTS {
        let what = format!("{words:?} {values:?}");
        // Written out, so that another choice of the usual order changes nothing here.
        let task = Task { order: Some(Order::Row), ..words.task() };
        assert_eq!(first(&task, values, &what), nodes, "{what}");
    }
}

/// Sixteen by sixteen over four colors with an automorphism: quick whatever the seed.
#[test]
fn four_colors_with_an_automorphism() {
    let task = Words("corner", "4", "complete", "", "4,0:1,2,3,0").task();
    for seed in 0..20 {
        let nodes = first(&task, Values::Random(seed), &format!("seed {seed}"));
        assert!(nodes < 2_000_000, "seed {seed}: {nodes} nodes");
    }
}

/// Larger ones: what is found is right.
#[test]
fn larger_sets() {
    for (words, values) in [
        (Words("domino", "32", "complete", "", ""), Values::Lexicographic),
        (Words("domino", "20", "complete", "1x400", ""), Values::Random(3)),
        (Words("corner", "5", "compact", "25x10", "5,0:+1"), Values::Random(0)),
        (Words("corner", "6", "compact", "24x18", "4,0:+1"), Values::Random(0)),
        (Words("wang", "4", "compact", "8x4", ""), Values::Random(0)),
    ] {
        let task = words.task();
        let limits = Limits { nodes: 1_000_000, ..Limits::NONE };
        let found = find(job(&task, values), &Settings { limits, ..settings(1) }).unwrap();
        verify(&task, &found.value.unwrap(), &format!("{words:?}"));
    }
}

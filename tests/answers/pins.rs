//! Labels given beforehand: some labels of a known packing, or any, even contradictory ones.

use crate::engines::{Effort, agreed_count, agreed_list, check_first};
use crate::oracle;
use crate::table::Words;
use proptest::prelude::*;
use proptest::sample::select;
use tilepack::packing::Task;
use tilepack::torus::Pins;

/// Problems whose packings the oracle lists at once; with spare cells they are coverings.
const PROBLEMS: &[Words<'static>] = &[
    Words("corner", "2", "complete", "4x4", ""),
    Words("corner", "2", "complete", "4x4", "2,2:1,0"),
    Words("corner", "2", "complete", "6x3", ""),
    Words("corner", "2", "complete", "6x3", "3,0:0,1"),
    Words("corner", "2", "compact", "4x4", ""),
    Words("corner", "2", "compact", "9x2", ""),
    Words("corner", "2", "compact", "6x3", "3,0:1,0"),
    Words("corner", "1", "complete", "2x1", "1,0:0"),
    Words("corner", "2", "pruned:0-1", "2x2", "1,0:0,1"),
    Words("wang", "2", "compact", "4x2", ""),
    Words("wang", "2", "compact", "2x4", "0,2:1,0"),
    Words("wang", "2", "compact", "3x3", ""),
    Words("wang", "2", "compact", "5x2", "0,1:1,0/0,1"),
    Words("wang", "1,3", "complete", "9x1", ""),
    Words("wang", "1", "complete", "2x1", "1,0:0"),
    Words("wang", "1", "complete", "3x1", "1,0:0"),
    Words("wang", "1,2", "complete", "3x2", "0,1:0/0,1"),
    Words("wang", "2,1", "complete", "2x3", "1,0:0,1/0"),
    Words("wang", "2", "complete", "4x4", "2,0:1,0"),
    Words("wang", "2", "pruned:0-1", "2x2", "1,0:0,1"),
    Words("domino", "3", "complete", "9x1", ""),
    Words("domino", "3", "complete", "1x9", ""),
    Words("domino", "2", "complete", "6x1", "3,0:0,1"),
    Words("domino", "2", "complete", "1x8", "0,4:1,0"),
    Words("domino", "3", "pruned:0-1", "1x8", ""),
];

fn problem(words: Words<'_>) -> Task {
    let task = words.task();
    let cover = task.shape.cells() as u64 > task.set.size();
    Task { cover, ..task }
}

/// Pins `pinned` and compares with the list of all packings.
fn check(task: &Task, all: &[Vec<u8>], pinned: &[(usize, u8)], what: &str) {
    let mut pins = Pins::free(task.lattice());
    for &(place, color) in pinned {
        let _ = pins.pin(place, color);
    }
    let task = Task { pins: pins.clone(), ..task.clone() };
    let what = format!("{what} {:?}", pins.labels());
    let fits = |labels: &&Vec<u8>| {
        pins.labels().iter().zip(*labels).all(|(pin, label)| pin.is_none_or(|pin| pin == *label))
    };
    let expected: Vec<_> = all.iter().filter(fits).cloned().collect();
    assert_eq!(agreed_count(&task, Effort::Each, &what), expected.len() as u64, "{what}");
    check_first(&task, !expected.is_empty(), Effort::Reduced, &what);
    assert!(agreed_list(&task, Effort::Reduced, &what) == expected, "{what}");
    if let Some(argument) = task.impossible() {
        assert!(expected.is_empty(), "{what}: {argument}");
    }
}

/// All labels of a packing but none, one or two.
#[test]
fn nearly_all_labels() {
    for &words in PROBLEMS {
        let (task, what) = (problem(words), format!("{words:?}"));
        let all = oracle::all(&task);
        for labels in all.iter().take(3) {
            let pinned: Vec<_> = labels.iter().copied().enumerate().collect();
            check(&task, &all, &pinned, &what);
            for hole in 0..labels.len() {
                let but_one: Vec<_> =
                    pinned.iter().copied().filter(|&(at, _)| at != hole).collect();
                check(&task, &all, &but_one, &what);
                check(&task, &all, &but_one[..but_one.len() / 2], &what);
            }
        }
    }
}

/// Every label the same: each tile at most once, but all of one color.
#[test]
fn all_labels_of_one_color() {
    for &words in PROBLEMS {
        let (task, what) = (problem(words), format!("{words:?}"));
        let all = oracle::all(&task);
        let (h, v) = (task.set.colors().horizontal(), task.set.colors().vertical());
        for color in 0..h.min(v) as u8 {
            let pinned: Vec<_> = (0..task.lattice().labels()).map(|at| (at, color)).collect();
            check(&task, &all, &pinned, &what);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn labels_of_a_packing(
        words in select(PROBLEMS),
        chosen in 0usize..1000,
        places in prop::collection::vec(0usize..100, 1..10),
        wrong in 0u8..4,
    ) {
        let task = problem(words);
        let all = oracle::all(&task);
        if !all.is_empty() {
            let labels = &all[chosen % all.len()];
            let places = places.into_iter().map(|at| at % labels.len());
            let mut pinned: Vec<_> = places.map(|at| (at, labels[at])).collect();
            if wrong == 0 {
                pinned[0].1 ^= 1;
            }
            check(&task, &all, &pinned, &format!("{words:?}"));
        }
    }

    #[test]
    fn any_labels(
        words in select(PROBLEMS),
        pins in prop::collection::vec((0usize..100, 0u8..3), 1..8),
    ) {
        let task = problem(words);
        let labels = task.lattice().labels();
        let pinned: Vec<_> = pins.into_iter().map(|(at, color)| (at % labels, color)).collect();
        check(&task, &oracle::all(&task), &pinned, &format!("{words:?}"));
    }
}

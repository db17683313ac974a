//! Large packings with holes: a packing is found, many of its labels are freed again, and the
//! fillings are counted by the engines and by the oracle. This reaches the sizes, the word
//! counts and the seams that small problems do not.

use crate::engines::{Effort, agreed_count, agreed_list, check_first};
use crate::oracle;
use crate::table::Words;
use proptest::prelude::*;
use proptest::sample::select;
use std::sync::OnceLock;
use tilepack::packing::{Job, Settings, Task, find};
use tilepack::search::{Limits, Values};
use tilepack::torus::Pins;

const PROBLEMS: &[Words<'static>] = &[
    Words("corner", "3", "complete", "9x9", ""),
    Words("corner", "3", "complete", "9x9", "3,0:+1"),
    Words("corner", "3", "compact", "9x6", ""),
    Words("corner", "3", "compact", "6x9", "2,0:+1"),
    Words("corner", "3", "compact", "7x8", ""),
    Words("corner", "4", "complete", "16x16", "4,0:1,2,3,0"),
    Words("corner", "4", "compact", "16x8", "4,0:1,2,3,0"),
    Words("corner", "3", "pruned:0-1", "11x3", ""),
    Words("wang", "2", "complete", "4x4", ""),
    Words("wang", "2", "complete", "8x2", ""),
    Words("wang", "2", "complete", "6x3", ""),
    Words("wang", "2,3", "complete", "9x4", ""),
    Words("wang", "3", "complete", "9x9", ""),
    Words("wang", "3", "complete", "12x7", ""),
    Words("wang", "3", "compact", "6x3", ""),
    Words("wang", "4", "compact", "8x4", ""),
    Words("wang", "4", "compact", "11x3", ""),
    Words("wang", "3", "pruned:0-1", "8x4", ""),
    Words("domino", "9", "complete", "81x1", ""),
    Words("domino", "12", "complete", "1x150", ""),
];

/// A packing or covering of every problem.
fn packings() -> &'static [(Words<'static>, Task, Vec<u8>)] {
    static PACKINGS: OnceLock<Vec<(Words<'static>, Task, Vec<u8>)>> = OnceLock::new();
    PACKINGS.get_or_init(|| {
        let found = PROBLEMS.iter().map(|&words| {
            let task = words.task();
            let cover = task.shape.cells() as u64 > task.set.size();
            let task = Task { cover, ..task };
            let limits = Limits { nodes: 300_000, ..Limits::NONE };
            let labels = (0..200).find_map(|seed| {
                let values = Values::Random(seed);
                let job = Job { values, ..Job::from(&task) };
                find(job, &Settings { limits, ..Settings::PLAIN }).unwrap().value
            });
            (words, task, labels.unwrap_or_else(|| panic!("{words:?}: none found")))
        });
        found.collect()
    })
}

/// Frees the labels at these places, as many as the oracle can handle, and compares.
fn check(task: &Task, labels: &[u8], places: &[usize], what: &str) {
    let mut free = vec![false; labels.len()];
    let bits = (task.set.colors().largest() as f64).log2();
    let loose = task.cover || task.set.is_compact();
    for &place in places.iter().take((if loose { 15.0 } else { 22.0 } / bits) as usize) {
        free[place] = true;
    }
    let mut pins = Pins::free(task.lattice());
    for (at, &color) in labels.iter().enumerate().filter(|&(at, _)| !free[at]) {
        pins.pin(at, color).unwrap();
    }
    let task = Task { pins, ..task.clone() };
    let all = oracle::all(&task);
    assert!(all.iter().any(|filled| filled == labels), "{what}");
    assert_eq!(agreed_count(&task, Effort::Each, what), all.len() as u64, "{what}");
    assert!(agreed_list(&task, Effort::Reduced, what) == all, "{what}");
    check_first(&task, true, Effort::Reduced, what);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, failure_persistence: None, ..ProptestConfig::default() })]

    /// A rectangle, anywhere across the seams.
    #[test]
    fn rectangles(
        (words, task, labels) in select(packings()),
        corner in (0usize..1000, 0usize..1000),
        size in (1usize..6, 1usize..6),
    ) {
        let (w, h) = (task.shape.width(), task.shape.height());
        let per_cell = labels.len() / (w * h);
        let cells = (0..size.0).flat_map(|r| (0..size.1).map(move |c| (r, c)));
        let cells = cells.map(|(r, c)| (corner.0 + r) % h * w + (corner.1 + c) % w);
        let places = cells.flat_map(|cell| per_cell * cell..per_cell * (cell + 1));
        let places: Vec<_> = places.collect();
        check(&task, &labels, &places, &format!("{words:?} {corner:?} {size:?} {labels:?}"));
    }

    /// Any labels.
    #[test]
    fn scattered(
        (words, task, labels) in select(packings()),
        places in prop::collection::vec(0usize..1000, 1..20),
    ) {
        let places: Vec<_> = places.into_iter().map(|place| place % labels.len()).collect();
        check(&task, &labels, &places, &format!("{words:?} {places:?} {labels:?}"));
    }
}

//! Prunings change the nodes, never the packings: every combination of them counts the same, and
//! the nodes are those of the table in `docs/search.md`.

use crate::table::Words;
use tilepack::packing::{Prunings, Settings, Task, count, find};

/// The prunings, in the order of the columns.
const COLUMNS: [&str; 4] = ["none", "caps", "last-rows", "caps,last-rows"];

/// Task, packings, nodes of the whole tree with each of the prunings.
const COUNTS: &[(Words<'static>, u64, [u64; 4])] = &[
    (Words("corner", "2", "complete", "4x4", ""), 32, [219, 176, 108, 99]),
    (
        Words("corner", "3", "complete", "9x9", "3,0:+1"),
        303_264,
        [1_857_861, 1_594_475, 762_182, 740_135],
    ),
    (
        Words("corner", "3", "complete", "9x9", "0,3:+1"),
        303_264,
        [1_857_861, 1_594_475, 762_182, 740_135],
    ),
    (Words("corner", "3", "compact", "9x6", "3,0:+1"), 27_702, [131_135, 87_599, 64_033, 53_888]),
    (
        Words("corner", "3", "compact", "9x6", "0,2:+1"),
        311_040,
        [184_108, 151_948, 139_516, 124_780],
    ),
    (Words("corner", "4", "pruned:0-1,2-3", "10x6", ""), 0, [37_510, 29_106, 37_510, 29_106]),
];

/// Task, nodes to the first packing with each of the prunings.
const FIRST: &[(Words<'static>, [u64; 4])] = &[
    (Words("corner", "3", "complete", "9x9", ""), [1_678_105, 260_513, 73_226, 45_597]),
    (Words("corner", "3", "compact", "9x6", ""), [263_007, 891, 171_446, 413]),
    (
        Words("corner", "4", "complete", "16x16", "4,0:1,2,3,0"),
        [263_959, 201_135, 137_995, 120_126],
    ),
    (Words("corner", "4", "compact", "16x8", "4,0:1,2,3,0"), [1045, 434, 279, 171]),
];

#[test]
fn counts() {
    for &(words, packings, nodes) in COUNTS {
        for (column, expected) in COLUMNS.iter().zip(nodes) {
            let prunings: Prunings = column.parse().unwrap();
            assert_eq!(prunings.to_string(), *column);
            let task = Task { prunings, ..words.task() };
            let settings = Settings { threads: 2, ..Settings::PLAIN };
            let answer = count(&task, &settings, false).unwrap();
            let found = (answer.value.packings, answer.work.nodes);
            assert_eq!(found, (packings.into(), expected), "{words:?} {column}");
        }
    }
}

#[test]
fn first_packings() {
    for &(words, nodes) in FIRST {
        for (column, expected) in COLUMNS.iter().zip(nodes) {
            let prunings: Prunings = column.parse().unwrap();
            let task = Task { prunings, ..words.task() };
            let answer = find(&task, &Settings::PLAIN).unwrap();
            assert!(answer.value.is_some());
            assert_eq!(answer.work.nodes, expected, "{words:?} {column}");
        }
    }
}

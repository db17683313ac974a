//! Coverings: every tile at least once, on a torus with a few cells to spare.

use crate::engines::{Effort, check_against_oracle, verify};
use crate::table::Words;
use tilepack::packing::{Settings, Task, count, find};
use tilepack::torus::Order;

fn covering(kind: &str, colors: &str, members: &str, size: &str) -> Task {
    Task { cover: true, ..Words(kind, colors, members, size, "").task() }
}

/// Kind, colors, set and sizes.
type Sizes = (&'static str, &'static str, &'static str, &'static [&'static str]);

const SMALL: &[Sizes] = &[
    ("corner", "1", "complete", &["1x1", "2x1", "2x2", "3x1"]),
    ("corner", "2", "complete", &["4x4", "17x1", "1x17", "6x3", "3x6", "9x2", "2x9", "19x1"]),
    ("corner", "2", "compact", &["4x4", "17x1", "1x17", "6x3", "3x6", "9x2", "2x9", "18x1"]),
    ("corner", "2", "pruned:0-1", &["2x1", "3x1", "2x2", "5x1", "1x5", "2x3"]),
    ("corner", "1", "compact", &["2x1", "3x1", "2x2"]),
    ("wang", "1", "complete", &["1x1", "2x1", "2x2", "1x3"]),
    ("wang", "1", "compact", &["2x1", "3x1", "2x2"]),
    ("wang", "2", "compact", &["4x2", "9x1", "1x9", "3x3", "5x2", "2x5"]),
    ("wang", "1,2", "complete", &["4x1", "5x1", "3x2", "2x3", "7x1", "1x6"]),
    ("wang", "2,1", "complete", &["1x4", "1x5", "3x2", "2x3", "1x7", "6x1"]),
    ("wang", "1,3", "complete", &["10x1", "5x2", "2x5", "11x1"]),
    ("wang", "1,2", "compact", &["2x2", "5x1", "1x5", "3x2", "2x3", "7x1"]),
    ("wang", "2,1", "compact", &["2x2", "5x1", "1x5", "3x2", "2x3", "1x7"]),
    ("wang", "2", "pruned:0-1", &["2x1", "3x1", "2x2", "5x1"]),
    ("domino", "1", "complete", &["1x1", "2x1", "1x3"]),
    ("domino", "2", "complete", &["4x1", "5x1", "1x6", "7x1"]),
    ("domino", "3", "complete", &["10x1", "1x11", "12x1"]),
    ("domino", "3", "pruned:0-1", &["8x1", "1x9", "10x1"]),
];

#[test]
fn small_coverings() {
    let mut some = 0;
    for &(kind, colors, members, sizes) in SMALL {
        for size in sizes {
            let task = covering(kind, colors, members, size);
            let what = format!("covering {kind} {colors} {members} {size}");
            some += u64::from(check_against_oracle(&task, Effort::Each, &what) > 0);
        }
    }
    assert!(some > 40, "only {some} problems have coverings: these tests say little");
}

/// The 31 corner tiles over three colors without 0 next to 1 have no covering with 32 cells,
/// and one with 33.
#[test]
fn smallest_covering_of_31_tiles() {
    for size in ["32x1", "1x32", "16x2", "2x16", "8x4", "4x8"] {
        let mut task = covering("corner", "3", "pruned:0-1", size);
        // Along the short side.
        let wide = task.shape.width() > task.shape.height();
        task.order = Some(if wide { Order::Column } else { Order::Row });
        let counted = count(&task, &Settings::PLAIN, false).unwrap();
        assert!(counted.work.complete && counted.value.packings == 0u32.into(), "{size}");
    }
    for size in ["11x3", "3x11"] {
        let task = covering("corner", "3", "pruned:0-1", size);
        let labels = find(&task, &Settings::PLAIN).unwrap().value.unwrap();
        verify(&task, &labels, size);
    }
}

//! Patches: every side of every tile matches.

use super::{NAMES, published};
use std::sync::atomic::AtomicBool;
use tilepack::aperiodic::Set;
use tilepack::aperiodic::convert::{Method, convert};
use tilepack::aperiodic::decide::wang;
use tilepack::aperiodic::patch::{Patch, Unfilled, fill};
use tilepack::tiles::Kind;

fn legal(set: &Set, patch: &Patch) {
    let tile = |row: usize, column: usize| set.tiles()[patch.cells[row * patch.width + column]];
    for row in 0..patch.height {
        for column in 0..patch.width {
            if column > 0 {
                assert!(set.fits_east(tile(row, column - 1), tile(row, column)));
            }
            if row > 0 {
                assert!(set.fits_south(tile(row - 1, column), tile(row, column)));
            }
        }
    }
}

#[test]
fn of_every_published_set() {
    let never = AtomicBool::new(false);
    for name in NAMES {
        let set = published(name);
        let (width, height) = if name == "knuth92" { (10, 9) } else { (25, 18) };
        let patch = fill(&wang(&set), width, height, 1, &never).unwrap();
        assert_eq!((patch.width, patch.height), (width, height));
        assert_eq!(patch.cells.len(), width * height);
        legal(&set, &patch);
        assert_eq!(fill(&wang(&set), width, height, 1, &never).unwrap(), patch);
    }
}

#[test]
fn of_corner_tiles() {
    let set = convert(&published("ammann16"), Method::Rotation).unwrap().set;
    let patch = fill(&wang(&set), 20, 20, 3, &AtomicBool::new(false)).unwrap();
    legal(&set, &patch);
}

#[test]
fn of_sets_that_fill_nothing() {
    // A single tile that has no neighbor; a strip of one row, but not of two.
    let never = AtomicBool::new(false);
    let lonely = Set::new(Kind::Wang, vec![[0, 0, 0, 1]]).unwrap();
    assert_eq!(fill(&wang(&lonely), 3, 3, 0, &never), Err(Unfilled::Impossible { rows: 1 }));
    let rows = Set::new(Kind::Wang, vec![[0, 0, 1, 0]]).unwrap();
    assert!(matches!(fill(&wang(&rows), 3, 3, 0, &never), Err(Unfilled::Impossible { .. })));
}

#[test]
fn it_stops() {
    let stop = AtomicBool::new(true);
    let set = published("jeandel_rao11_4colors");
    let unfilled = fill(&wang(&set), 30, 30, 0, &stop);
    assert_eq!(unfilled, Err(Unfilled::Stopped { best: 0 }));
}

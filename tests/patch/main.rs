//! Patches filled again: against trying all colors, against the search with everything else given,
//! and the law of the walk.

#![allow(clippy::unwrap_used)]

#[path = "../common/task.rs"]
mod task;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;
use task::task;
use tilepack::packing::{self, Settings, Task};
use tilepack::patch::{Patch, Refusal, Walk};
use tilepack::search::Stop;
use tilepack::tiles::TileId;
use tilepack::torus::{Cell, Shape};
use tilepack::verify;

/// The cells of a patch.
fn cells(shape: Shape, corner: Cell, (width, height): (usize, usize)) -> BTreeSet<Cell> {
    let cell = |i: usize| shape.step(corner, (i / width) as i64, (i % width) as i64);
    (0..width * height).map(cell).collect()
}

/// The labels that no cell outside shows.
fn inner(task: &Task, inside: &BTreeSet<Cell>) -> Vec<usize> {
    let lattice = task.lattice();
    let outside = (0..task.shape.cells() as u32).map(Cell).filter(|cell| !inside.contains(cell));
    let shown: BTreeSet<usize> = outside.flat_map(|cell| lattice.sides(cell)).collect();
    (0..lattice.labels()).filter(|label| !shown.contains(label)).collect()
}

fn tiles(task: &Task, labels: &[u8], cells: &BTreeSet<Cell>) -> Vec<TileId> {
    let lattice = task.lattice();
    let mut tiles: Vec<_> =
        cells.iter().map(|&cell| lattice.tile(labels, &task.set, cell)).collect();
    tiles.sort_unstable();
    tiles
}

/// All labels with the patch filled in every way, sorted.
fn fillings(patch: &mut Patch, labels: &[u8], corner: Cell) -> Vec<Vec<u8>> {
    let mut found = Vec::new();
    let mut changed = labels.to_vec();
    let (mut present, mut nodes) = (0, 0);
    let (all, complete) = patch.fillings(&mut changed, corner, u64::MAX, |filling, is_present| {
        found.push(filling.to_vec());
        present += usize::from(is_present);
        ControlFlow::Continue(())
    });
    nodes += all;
    assert!(complete && nodes >= found.len() as u64);
    assert_eq!((present, &changed[..]), (1, labels));
    let free = patch.free();
    let filled = |filling: Vec<u8>| {
        let mut labels = labels.to_vec();
        for (&label, color) in free.iter().zip(filling) {
            labels[label as usize] = color;
        }
        labels
    };
    let mut found: Vec<_> = found.into_iter().map(filled).collect();
    found.sort_unstable();
    found
}

/// The same by trying all colors on the inner labels.
fn by_trying(task: &Task, labels: &[u8], corner: Cell, size: (usize, usize)) -> Vec<Vec<u8>> {
    let inside = cells(task.shape, corner, size);
    let (free, wanted) = (inner(task, &inside), tiles(task, labels, &inside));
    let lattice = task.lattice();
    let radix: Vec<u8> = {
        // The colors of a label: those of a side that shows it.
        let mut radix = vec![0; lattice.labels()];
        for cell in (0..task.shape.cells() as u32).map(Cell) {
            let radices = task.set.kind().radices(task.set.colors());
            for (label, colors) in lattice.sides(cell).into_iter().zip(radices) {
                radix[label] = colors as u8;
            }
        }
        radix
    };
    let mut all = vec![labels.to_vec()];
    for &label in &free {
        let each = |labels: Vec<u8>| {
            (0..radix[label]).map(move |color| {
                let mut labels = labels.clone();
                labels[label] = color;
                labels
            })
        };
        all = all.into_iter().flat_map(each).collect();
    }
    all.retain(|labels| tiles(task, labels, &inside) == wanted);
    all.sort_unstable();
    all
}

/// Colors that look random; they need not be a packing of anything.
fn strewn(task: &Task, seed: u64) -> Vec<u8> {
    let mut state = seed;
    let mut next = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        state >> 33
    };
    let mut labels = vec![0; task.lattice().labels()];
    for cell in (0..task.shape.cells() as u32).map(Cell) {
        let radices = task.set.kind().radices(task.set.colors());
        for (label, colors) in task.lattice().sides(cell).into_iter().zip(radices) {
            labels[label] = (next() % colors as u64) as u8;
        }
    }
    labels
}

#[test]
fn fillings_are_those_found_by_trying() {
    let mut several = 0;
    for (kind, colors, shape, sizes) in [
        ("corner", "2", "6x5", &[(4, 4), (2, 2), (6, 3), (3, 5), (5, 3)][..]),
        ("corner", "3", "5x4", &[(3, 3), (4, 3), (5, 2), (2, 4)]),
        ("wang", "2", "4x4", &[(3, 3), (2, 2), (4, 2), (1, 4), (2, 1)]),
        ("wang", "3,2", "5x4", &[(2, 2), (3, 2), (2, 3), (5, 1)]),
        ("domino", "3", "9x1", &[(5, 1), (9, 1), (2, 1)]),
        ("domino", "2", "1x7", &[(1, 4), (1, 7)]),
        // A side of 1: a tile meets itself.
        ("wang", "2", "1x5", &[(1, 3), (1, 5)]),
        ("corner", "2", "2x5", &[(2, 4), (2, 5)]),
    ] {
        let mut task = task(kind, colors, "complete", "");
        task.shape = shape.parse().unwrap();
        for &size in sizes {
            let mut patch = Patch::new(&task.set, task.lattice(), size.0, size.1).unwrap();
            for seed in 0..6 {
                let labels = strewn(&task, seed);
                let corner = Cell((7 * seed % task.shape.cells() as u64) as u32);
                let found = fillings(&mut patch, &labels, corner);
                assert_eq!(found, by_trying(&task, &labels, corner, size), "{kind} {size:?}");
                several += usize::from(found.len() > 1);
            }
        }
    }
    assert!(several > 50, "{several}");
}

#[test]
fn fillings_are_those_found_by_search() {
    let mut several = 0;
    for (kind, colors, members, size, patch_size) in [
        ("corner", "3", "complete", "", (6, 6)),
        ("corner", "3", "complete", "", (7, 5)),
        ("corner", "3", "compact", "9x6", (5, 5)),
        ("wang", "3", "complete", "", (4, 4)),
        ("wang", "2,3", "complete", "", (5, 4)),
    ] {
        let task = task(kind, colors, members, size);
        let labels = packing::find(&task, &Settings::PLAIN).unwrap().value.unwrap();
        let (width, height) = patch_size;
        let mut patch = Patch::new(&task.set, task.lattice(), width, height).unwrap();
        for corner in (0..task.shape.cells() as u32).step_by(11).map(Cell) {
            let inside = cells(task.shape, corner, patch_size);
            let free = inner(&task, &inside);
            let mut pinned = task.clone();
            for (label, &color) in labels.iter().enumerate() {
                if !free.contains(&label) {
                    pinned.pins.pin(label, color).unwrap();
                }
            }
            let wanted = tiles(&task, &labels, &inside);
            let mut others = packing::list(&pinned, &Settings::PLAIN, false).unwrap().value;
            // Of a compact set the search may choose other tiles.
            others.retain(|labels| tiles(&task, labels, &inside) == wanted);
            let found = fillings(&mut patch, &labels, corner);
            assert_eq!(found, others, "{kind} {colors} {members} {corner:?}");
            several += usize::from(found.len() > 1);
        }
    }
    assert!(several > 5, "{several}");
}

/// From a ring of all dominoes over three colors the walk reaches all 216, and each as often.
#[test]
fn the_walk_favors_nobody() {
    let task = task("domino", "3", "complete", "");
    let start = packing::find(&task, &Settings::PLAIN).unwrap().value.unwrap();
    let mut walk = Walk::new(&task.set, task.lattice(), start, (7, 1), 1).unwrap();
    let mut visits = BTreeMap::new();
    let steps = 216_000;
    for _ in 0..steps {
        walk.run(1, &());
        *visits.entry(walk.labels().to_vec()).or_insert(0u64) += 1;
    }
    let all = packing::list(&task, &Settings::PLAIN, false).unwrap().value;
    assert!(visits.keys().all(|labels| all.contains(labels)));
    // All that hang together by patches of seven, found by going to every filling.
    let mut patch = Patch::new(&task.set, task.lattice(), 7, 1).unwrap();
    let (mut class, mut open) = (BTreeSet::new(), vec![walk.labels().to_vec()]);
    while let Some(labels) = open.pop() {
        if class.insert(labels.clone()) {
            for corner in (0..9).map(Cell) {
                open.extend(fillings(&mut patch, &labels, corner));
            }
        }
    }
    assert!(visits.keys().eq(&class), "{} of {}", visits.len(), class.len());
    assert!(class.len() > 20, "{}", class.len());
    let expected = steps as f64 / class.len() as f64;
    // Steps depend on each other, so this is wide; a bias by a factor would show.
    for (labels, &count) in &visits {
        let ratio = count as f64 / expected;
        assert!((0.8..1.25).contains(&ratio), "{labels:?}: {ratio}");
    }
}

#[test]
fn a_walk_stays_among_the_packings() {
    for (kind, colors, members, size, patch) in [
        ("corner", "3", "complete", "", (6, 6)),
        ("corner", "3", "compact", "9x6", (5, 5)),
        ("wang", "3", "complete", "", (4, 4)),
    ] {
        let task = task(kind, colors, members, size);
        let start = packing::find(&task, &Settings::PLAIN).unwrap().value.unwrap();
        let mut walk = Walk::new(&task.set, task.lattice(), start.clone(), patch, 3).unwrap();
        for _ in 0..300 {
            let (before, moves) = (walk.labels().to_vec(), walk.walked().moves);
            walk.run(1, &());
            // A move is a change; two of them may lead back.
            assert_eq!(walk.walked().moves - moves, u64::from(walk.labels() != before));
        }
        let walked = walk.walked();
        assert_eq!((walked.steps, walked.skipped), (300, 0));
        // Compact sets leave small patches no choice.
        assert!(walked.moves > 0 || members == "compact", "{kind} {members}: {walked:?}");
        let packing = task.lattice().packing(walk.labels(), &task.set, false);
        assert!(verify::check(&packing).is_valid());
        let mut again = Walk::new(&task.set, task.lattice(), start, patch, 3).unwrap();
        again.run(300, &());
        assert_eq!((again.labels(), again.walked()), (walk.labels(), walked));
    }
}

#[test]
fn what_is_refused_and_what_stops() {
    let task = task("corner", "3", "complete", "");
    let patch = |w, h| Patch::new(&task.set, task.lattice(), w, h).map(|_| ());
    assert_eq!(patch(10, 9), Err(Refusal::TooLarge { width: 10, height: 9, shape: task.shape }));
    assert_eq!(patch(5, 1), Err(Refusal::Nothing(5, 1)));
    assert_eq!(patch(9, 9), Ok(()));
    let large = crate::task("corner", "255", "complete", "9x9");
    let refused = Patch::new(&large.set, large.lattice(), 2, 2);
    assert!(matches!(refused, Err(Refusal::TooManyTiles(_))));
    struct Now;
    impl Stop for Now {
        fn should_stop(&self) -> bool {
            true
        }
    }
    let start = packing::find(&task, &Settings::PLAIN).unwrap().value.unwrap();
    let mut walk = Walk::new(&task.set, task.lattice(), start, (8, 8), 0).unwrap();
    walk.run(1000, &Now);
    assert_eq!(walk.walked().steps, 0);
}

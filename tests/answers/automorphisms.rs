//! Prescribed automorphisms: the search goes over orbits of cells, the oracle filters all
//! packings by `a[row + dy][column + dx] = map(a[row][column])`.

use crate::engines::{Effort, check_against_oracle};
use crate::explicit::{labels, shapes, shown};
use crate::oracle;
use crate::table::Words;
use proptest::prelude::*;
use proptest::sample::select;
use tilepack::packing::solve::SolveError;
use tilepack::packing::{Settings, Task, TaskError, count, find};
use tilepack::search::Limits;
use tilepack::symmetry::{Automorphism, AutomorphismError, ColorMap};
use tilepack::tiles::{Colors, Kind, Members, TileSet};
use tilepack::torus::{Pins, Shape};

/// Checks a task with an automorphism; refused ones must have no packing at all.
fn check(task: &Task, what: &str) -> Option<u64> {
    match task.automorphism.as_ref().unwrap().check(&task.set, task.shape, task.cover) {
        Ok(_) => Some(check_against_oracle(task, Effort::Each, what)),
        Err(AutomorphismError::Collision { .. } | AutomorphismError::Order { .. }) => {
            assert_eq!(oracle::count(task), 0, "{what}");
            None
        }
        Err(error) => panic!("{what}: {error}"),
    }
}

/// Kind, colors, set, size, color permutations.
type Family = (&'static str, &'static str, &'static str, &'static str, &'static [&'static str]);

const FAMILIES: &[Family] = &[
    ("corner", "2", "complete", "4x4", &["+1", "+0"]),
    ("corner", "2", "complete", "6x3", &["+1", "+0"]),
    ("corner", "2", "complete", "9x2", &["+0"]),
    ("corner", "2", "compact", "4x4", &["+1", "+0"]),
    ("corner", "2", "compact", "8x2", &["+1", "+0"]),
    ("corner", "2", "compact", "6x3", &["+1", "+0"]),
    ("corner", "1", "complete", "2x2", &["+0"]),
    ("corner", "2", "pruned:0-1", "2x2", &["+1", "+0"]),
    ("wang", "2", "complete", "4x4", &["+1", "1,0/0,1", "0,1/1,0"]),
    ("wang", "2", "compact", "4x2", &["+1", "+0", "1,0/0,1", "0,1/1,0"]),
    ("wang", "2", "compact", "1x8", &["+1", "+0", "1,0/0,1", "0,1/1,0"]),
    ("wang", "2", "compact", "5x2", &["+1", "+0", "1,0/0,1", "0,1/1,0"]),
    ("wang", "2", "compact", "3x3", &["+0"]),
    ("wang", "1,2", "complete", "4x1", &["+1", "+0"]),
    ("wang", "1,2", "complete", "3x2", &["+1", "+0"]),
    ("wang", "1,3", "complete", "9x1", &["+1", "0/1,0,2"]),
    ("wang", "1,3", "complete", "6x2", &["+1", "+0", "0/1,0,2"]),
    ("wang", "2,1", "complete", "2x3", &["+1", "+0"]),
    ("wang", "1,2", "compact", "2x2", &["+1", "+0"]),
    // Three images of a tile in one class.
    ("wang", "1,4", "compact", "9x1", &["0/0,2,3,1"]),
    ("wang", "4,1", "compact", "1x9", &["0,2,3,1/0"]),
    ("wang", "1,6", "compact", "12x1", &["0/0,1,2,4,5,3"]),
    ("domino", "2", "complete", "4x1", &["+1", "+0"]),
    ("domino", "2", "complete", "1x6", &["+1", "+0"]),
    ("domino", "3", "complete", "9x1", &["+1", "+0"]),
    ("domino", "3", "complete", "1x10", &["+0", "1,0,2"]),
    ("domino", "3", "complete", "12x1", &["+1", "1,0,2"]),
    ("domino", "3", "pruned:0-1", "1x8", &["+0", "1,0,2"]),
];

#[test]
fn every_translation() {
    let (mut asked, mut exist) = (0, 0);
    for &(kind, colors, members, size, maps) in FAMILIES {
        let shape: Shape = size.parse().unwrap();
        for (dx, dy) in (0..shape.width()).flat_map(|x| (0..shape.height()).map(move |y| (x, y))) {
            for map in maps {
                let text = format!("{dx},{dy}:{map}");
                let words = Words(kind, colors, members, size, &text);
                let task = words.task();
                let cover = task.shape.cells() as u64 > task.set.size();
                let found = check(&Task { cover, ..task }, &format!("{words:?}"));
                asked += u64::from(found.is_some());
                exist += u64::from(found.is_some_and(|found| found > 0));
            }
        }
    }
    assert!(asked > 100 && exist > 50, "{exist} of {asked}: these tests say little");
}

/// No ring of sixteen dominoes over four colors has such a symmetry: the 432 fundamental ones
/// are 20736 / 48, so none is its own image. The oracle filters all 331,776.
#[test]
fn dominoes_of_four_colors() {
    for automorphism in ["4,0:1,2,3,0", "12,0:+1", "8,0:1,0,3,2", "8,0:2,3,0,1"] {
        let task = Words("domino", "4", "complete", "16x1", automorphism).task();
        assert_eq!(check(&task, automorphism), Some(0), "{automorphism}");
    }
}

/// The 303,264 corner packings over three colors with a[r][c + 3] = a[r][c] + 1, counted again
/// without the reduction: each shows every tile once, so those that show some tile at some cell
/// are one in 81.
#[test]
fn the_quotient_of_three_colors() {
    let plain = Words("corner", "3", "complete", "9x9", "3,0:+1").task();
    for (row, column, tile) in [(0, 0, [0, 0, 0, 1]), (4, 5, [2, 0, 1, 1]), (8, 8, [1, 2, 0, 2])] {
        let mut task = plain.clone();
        let [ne, se, sw, nw] = tile;
        let (south, east) = ((row + 1) % 9, (column + 1) % 9);
        for (r, c, color) in
            [(row, column, nw), (row, east, ne), (south, column, sw), (south, east, se)]
        {
            task.pins.pin(9 * r + c, color).unwrap();
        }
        let settings = Settings { threads: row / 3 + 1, ..Settings::PLAIN };
        let found = count(&task, &settings, false).unwrap().value.packings;
        assert_eq!(found * 81u32, 303_264u32.into(), "{row} {column} {tile:?}");
    }
    let down = Words("corner", "3", "complete", "9x9", "0,3:+1").task();
    let down = count(&down, &Settings::PLAIN, false).unwrap();
    assert_eq!(down.value.packings, 303_264u32.into(), "reflected");
}

/// The tile with NE 1 and else 0 would bring along those with NE 2 and 3, of the same class.
#[test]
fn three_images_in_one_class_of_corner_tiles() {
    let words = Words("corner", "4", "compact", "12x11", "4,0:0,2,3,1");
    let mut task = Task { cover: true, ..words.task() };
    for (row, column, color) in [(5, 5, 0), (5, 6, 1), (6, 5, 0), (6, 6, 0)] {
        task.pins.pin(12 * row + column, color).unwrap();
    }
    let limits = Limits { nodes: 100_000, ..Limits::NONE };
    match find(&task, &Settings { limits, ..Settings::PLAIN }) {
        Err(SolveError::Task(TaskError::Pins(_))) => {}
        other => panic!("{other:?}"),
    }
    // The same without NE 1 is no contradiction.
    task.pins = Pins::free(task.lattice());
    for (row, column) in [(5, 5), (5, 6), (6, 5), (6, 6)] {
        task.pins.pin(12 * row + column, 0).unwrap();
    }
    assert!(find(&task, &Settings { limits, ..Settings::PLAIN }).is_ok());
}

/// Kinds, palettes, cells, and color permutations.
type Symmetric = (Kind, (u64, u64), &'static [usize], &'static [&'static [u8]]);

const SYMMETRIC: &[Symmetric] = &[
    (Kind::Corner, (2, 2), &[4, 6, 8, 10, 12], &[&[1, 0], &[0, 1]]),
    (Kind::Corner, (3, 3), &[3, 6, 8, 9], &[&[1, 0, 2], &[1, 2, 0], &[0, 1, 2]]),
    (Kind::Wang, (2, 2), &[2, 4, 6, 8], &[&[1, 0], &[0, 1]]),
    (Kind::Wang, (3, 3), &[3, 4, 6], &[&[1, 2, 0], &[0, 2, 1]]),
    (Kind::Domino, (3, 3), &[3, 4, 6, 8, 9], &[&[1, 0, 2], &[1, 2, 0]]),
    (Kind::Domino, (4, 4), &[4, 6, 8], &[&[1, 2, 3, 0], &[1, 0, 3, 2], &[1, 0, 2, 3]]),
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, failure_persistence: None, ..ProptestConfig::default() })]

    /// The tiles of a torus that has a random automorphism.
    #[test]
    fn tiles_of_a_symmetric_torus(
        (kind, (h, v), cells, maps) in select(SYMMETRIC),
        choice in prop::array::uniform5(0usize..1000),
        numbers in prop::collection::vec(0u8..12, 24),
    ) {
        let colors = Colors::pair(h, v).unwrap();
        let [cells, map] = [cells[choice[0] % cells.len()], choice[1] % maps.len()];
        let shapes: Vec<_> = shapes(kind, cells).collect();
        let shape = shapes[choice[2] % shapes.len()];
        let map = ColorMap::new(colors, maps[map].to_vec(), maps[map].to_vec()).unwrap();
        let (dx, dy) = (choice[3] % shape.width(), choice[4] % shape.height());
        let automorphism = Automorphism { dx: dx as u32, dy: dy as u32, map };
        let order = automorphism.order(shape);
        let powers = automorphism.powers(order + 1, colors);
        prop_assume!(order > 1 && powers[order].is_identity());
        let mut symmetric = labels(kind, colors, shape, &numbers);
        let per_cell = symmetric.len() / cells;
        let mut done = vec![false; cells];
        for cell in 0..cells {
            for (k, power) in powers.iter().enumerate().take(order) {
                let (row, column) = (cell / shape.width() + k * dy, cell % shape.width() + k * dx);
                let image = row % shape.height() * shape.width() + column % shape.width();
                if !done[image] {
                    for side in 0..per_cell {
                        let color = symmetric[cell * per_cell + side];
                        symmetric[image * per_cell + side] = power.horizontal()[usize::from(color)];
                    }
                }
                done[image] = true;
            }
        }
        let tiles = shown(kind, colors, shape, &symmetric);
        let cover = tiles.len() < cells;
        let set = TileSet::new(kind, colors, Members::Explicit(tiles)).unwrap();
        let automorphism = Some(automorphism);
        let task = Task { cover, automorphism, ..Task::new(set, shape) };
        let found = check(&task, &format!("{task:?}"));
        prop_assert!(found.is_some_and(|found| found > 0));
    }
}

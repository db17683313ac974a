//! Counting by lines against the search, which counts one by one.

#![allow(clippy::unwrap_used)]

mod halves;

use num_bigint::BigUint;
use tilepack::packing::{Job, Question, Settings, Task, count, rows};
use tilepack::symmetry::Automorphism;
use tilepack::tiles::{Colors, Kind, Members, TileId, TileSet};
use tilepack::torus::{Order, Shape};

fn task(colors: usize, members: Members, shape: &str) -> Task {
    let colors: Colors = colors.to_string().parse().unwrap();
    let set = TileSet::new(Kind::Corner, colors, members).unwrap();
    Task::new(set, shape.parse::<Shape>().unwrap())
}

fn by(task: &Task, by_lines: bool) -> BigUint {
    let question = Question::Count { up_to_symmetry: false };
    let job = Job { by_lines, ..Job::new(task.clone(), question) };
    count(job, &Settings { threads: 2, ..Settings::PLAIN }, false).unwrap().value.packings
}

/// Both ways of laying lines, against the search.
fn check(task: &Task) -> BigUint {
    let expected = by(task, false);
    for order in [None, Some(Order::Row), Some(Order::Column)] {
        let task = Task { order, ..task.clone() };
        if rows::check(&task).is_ok() {
            assert_eq!(by(&task, true), expected, "{task:?}");
        }
    }
    assert!(rows::check(task).is_ok(), "{:?}", rows::check(task));
    expected
}

#[test]
fn complete_sets() {
    assert_eq!(check(&task(2, Members::Complete, "4x4")), BigUint::from(32u32));
    assert_eq!(check(&task(2, Members::Complete, "2x8")), BigUint::ZERO);
    assert_eq!(check(&task(2, Members::Complete, "8x2")), BigUint::ZERO);
    assert_eq!(check(&task(2, Members::Complete, "1x16")), BigUint::ZERO);
}

#[test]
fn compact_sets() {
    for shape in ["4x4", "2x8", "8x2"] {
        check(&task(2, Members::Compact, shape));
    }
}

#[test]
fn compact_sets_that_keep_a_symmetry() {
    for (shape, text) in
        [("9x6", "3,0:+1"), ("6x9", "2,0:+1"), ("6x9", "0,3:+1"), ("9x6", "0,2:+1")]
    {
        let mut task = task(3, Members::Compact, shape);
        let automorphism = Automorphism::parse(text, task.set.colors(), task.shape).unwrap();
        task.automorphism = Some(automorphism);
        let found = check(&task);
        assert!(found > BigUint::ZERO, "{shape} {text}: {found}");
    }
}

#[test]
fn the_quotient_of_three_colors() {
    let mut task = task(3, Members::Complete, "9x9");
    task.automorphism = Some(Automorphism::parse("3,0:+1", task.set.colors(), task.shape).unwrap());
    assert_eq!(by(&task, true), BigUint::from(303_264u32));
}

#[test]
fn sets_of_any_tiles() {
    let mut seed = 0x9e37_79b9u64;
    let mut random = move |below: u64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) % below
    };
    let mut packings = BigUint::ZERO;
    for (shape, colors) in [("3x4", 2), ("4x4", 3), ("3x5", 3), ("3x4", 3), ("5x4", 3), ("2x7", 3)]
    {
        for _ in 0..30 {
            // The windows of a random picture, so that there may be something to find.
            let shape: Shape = shape.parse().unwrap();
            let picture: Vec<u8> = (0..shape.cells()).map(|_| random(colors) as u8).collect();
            let mut tiles: Vec<TileId> = (0..shape.cells())
                .map(|cell| {
                    let (row, column) = (cell / shape.width(), cell % shape.width());
                    let at = |r: usize, c: usize| {
                        picture[(r % shape.height()) * shape.width() + c % shape.width()]
                    };
                    let sides = [
                        at(row, column + 1),
                        at(row + 1, column + 1),
                        at(row + 1, column),
                        at(row, column),
                    ];
                    Kind::Corner.pack(&sides, Colors::one(3).unwrap()).unwrap()
                })
                .collect();
            // A picture that shows a tile twice has another tile in its place.
            tiles.sort_unstable();
            tiles.dedup();
            while tiles.len() < shape.cells() {
                let tile = TileId(random(81) as u32);
                if !tiles.contains(&tile) {
                    tiles.push(tile);
                }
            }
            packings += check(&task(3, Members::Explicit(tiles), &shape.to_string()));
        }
    }
    assert!(packings > BigUint::ZERO);
}

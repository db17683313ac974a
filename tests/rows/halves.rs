//! Counting by halves against the search: Wang tiles and squares, on all boards.

use crate::by;
use num_bigint::BigUint;
use tilepack::packing::{Task, halves};
use tilepack::tiles::{Colors, Kind, Members, TileId, TileSet};
use tilepack::torus::{Board, Topology, board::Border};

fn check(task: &Task) -> BigUint {
    halves::check(task).unwrap();
    let expected = by(task, false);
    assert_eq!(by(task, true), expected, "{task:?}");
    expected
}

fn random(seed: u64) -> impl FnMut(u64) -> u64 {
    let mut state = seed;
    move |below| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % below
    }
}

#[test]
fn complete_sets() {
    let set = |colors: &str| {
        TileSet::new(Kind::Wang, colors.parse().unwrap(), Members::Complete).unwrap()
    };
    let torus = Task::new(set("2"), "4x4".parse().unwrap());
    assert_eq!(check(&torus), BigUint::from(203_520u32));
    check(&Task::new(set("2"), "2x8".parse().unwrap()));
    check(&Task::new(set("2,1"), "2x2".parse().unwrap()));
    check(&Task::new(set("1,3"), "3x3".parse().unwrap()));
}

#[test]
fn boards_of_random_squares() {
    let mut random = random(7);
    let mut packings = BigUint::ZERO;
    for (size, colors) in [("2x2", 2), ("2x3", 2), ("3x2", 3), ("3x3", 2), ("4x3", 2), ("2x5", 2)] {
        for topology in Topology::ALL {
            for rotations in [false, true] {
                for bordered in [false, true] {
                    if bordered && topology == Topology::Torus {
                        continue;
                    }
                    let shape: tilepack::torus::Shape = size.parse().unwrap();
                    let palette = Colors::one(colors).unwrap();
                    let mut tiles = Vec::new();
                    while tiles.len() < shape.cells() {
                        let tile = TileId(random(colors.pow(4)) as u32);
                        // Without rotations no tile is listed twice.
                        if rotations || !tiles.contains(&tile) {
                            tiles.push(tile);
                        }
                    }
                    let set = match rotations {
                        true => TileSet::squares(palette, tiles).unwrap(),
                        false => {
                            TileSet::new(Kind::Wang, palette, Members::Explicit(tiles)).unwrap()
                        }
                    };
                    let border = match bordered {
                        true => Border::of_one(topology, shape, 0),
                        false => Border::default(),
                    };
                    packings += check(&Task::on(set, shape, Board { topology, rotations, border }));
                }
            }
        }
    }
    assert!(packings > BigUint::from(1000u32), "{packings}");
}

/// The square of one color alone is given: 1,908 packings, which five programs count.
#[test]
fn squares_of_macmahon() {
    let colors = Colors::one(3).unwrap();
    let mut classes: Vec<TileId> = (0..81)
        .map(TileId)
        .map(|tile| tilepack::tiles::turn::turns(tile, colors).unwrap().into_iter().min().unwrap())
        .collect();
    classes.sort_unstable();
    classes.dedup();
    assert_eq!(classes.len(), 24);
    let set = TileSet::squares(colors, classes).unwrap();
    let shape = "6x4".parse().unwrap();
    let border = Border::of_one(Topology::Rectangle, shape, 0);
    let board = Board { topology: Topology::Rectangle, rotations: true, border };
    let mut task = Task::on(set, shape, board);
    for place in task.edges().sides(shape.cell(0, 2)) {
        let _ = task.pins.pin(place, 0);
    }
    assert_eq!(by(&task, true), BigUint::from(1908u32));
}

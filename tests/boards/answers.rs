//! The search finds the pictures that trying everything finds, each once.

use crate::naive::{Picture, picture, pictures};
use proptest::prelude::*;
use std::collections::BTreeSet;
use tilepack::packing::{self, Settings, Task};
use tilepack::tiles::{Colors, Kind, Members, TileId, TileSet};
use tilepack::torus::{Board, Border, Order, Shape, Topology};
use tilepack::verify;

/// A board of random squares, many of which there are two of; often cut from a picture, so that
/// there is a solution.
#[derive(Debug, Clone)]
pub(crate) struct Puzzle {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) colors: u8,
    pub(crate) seed: u64,
    pub(crate) topology: Topology,
    pub(crate) rotations: bool,
    /// 0 none, 1 one color, 2 some places of the sides.
    pub(crate) border: u8,
    pub(crate) cut: bool,
}

fn random(state: &mut u64, below: u64) -> u64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 33) % below
}

impl Puzzle {
    pub(crate) fn task(&self) -> Option<Task> {
        let mut state = self.seed;
        let shape = Shape::new(self.width as u64, self.height as u64).unwrap();
        let colors = Colors::one(u64::from(self.colors)).unwrap();
        let edges = tilepack::torus::Edges { shape, topology: self.topology };
        let mut color = || random(&mut state, u64::from(self.colors)) as u8;
        let mut labels: Vec<u8> = (0..edges.labels()).map(|_| color()).collect();
        if self.border == 1 {
            edges.outer().for_each(|(_, _, place)| labels[place] = 0);
        }
        let mut sides = |side: usize| -> Vec<Option<u8>> {
            let mut outer =
                vec![None; if side.is_multiple_of(2) { self.width } else { self.height }];
            for (_, at, place) in edges.outer().filter(|&(s, ..)| s == side) {
                outer[at] = Some(labels[place]).filter(|_| random(&mut state, 3) > 0);
            }
            if self.topology.is_outer(side) { outer } else { Vec::new() }
        };
        let border = match self.border {
            0 => Border::default(),
            1 => Border::of_one(self.topology, shape, 0),
            _ => Border::new(self.topology, shape, std::array::from_fn(&mut sides)).unwrap(),
        };
        let mut tiles: Vec<TileId> = (0..shape.cells() as u32)
            .map(|cell| {
                let mut sides = edges.sides(tilepack::torus::Cell(cell)).map(|place| labels[place]);
                if !self.cut {
                    sides = sides.map(|_| random(&mut state, u64::from(self.colors)) as u8);
                }
                let turns = if self.rotations { random(&mut state, 4) as usize } else { 0 };
                sides.rotate_right(turns);
                Kind::Wang.pack(&sides, colors).unwrap()
            })
            .collect();
        tiles.sort_unstable();
        let set = match self.rotations {
            true => TileSet::squares(colors, tiles),
            false => TileSet::new(Kind::Wang, colors, Members::Explicit(tiles)),
        };
        let board = Board { topology: self.topology, rotations: self.rotations, border };
        Some(Task::on(set.ok()?, shape, board)).filter(|task| !task.board.is_plain())
    }
}

pub(crate) fn puzzles() -> impl Strategy<Value = Puzzle> {
    let shapes = prop_oneof![
        Just((1, 1)),
        Just((2, 1)),
        Just((1, 3)),
        Just((2, 2)),
        Just((3, 2)),
        Just((2, 3)),
        Just((4, 1)),
        Just((3, 3)),
    ];
    let topologies =
        prop_oneof![Just(Topology::Torus), Just(Topology::Cylinder), Just(Topology::Rectangle)];
    (shapes, 1..5u8, any::<u64>(), topologies, any::<bool>(), 0..3u8, prop::bool::weighted(0.8))
        .prop_map(|((width, height), colors, seed, topology, rotations, border, cut)| {
            // Fewer colors on nine cells take an oracle too long.
            let colors = if width * height > 6 { colors.max(3) } else { colors };
            Puzzle { width, height, colors, seed, topology, rotations, border, cut }
        })
}

fn found(task: &Task) -> Vec<Picture> {
    let listed = packing::list(task, &Settings::PLAIN, false).unwrap().value;
    let packings = listed.iter().map(|labels| task.packing(labels));
    packings
        .map(|packing| {
            let verdict = verify::check(&packing);
            assert!(verdict.is_valid(), "{verdict}");
            picture(&packing)
        })
        .collect()
}

fn check(task: &Task) -> usize {
    let expected = pictures(task);
    let found = found(task);
    assert_eq!(found.len(), expected.len(), "each once");
    assert_eq!(found.into_iter().collect::<BTreeSet<_>>(), expected);
    if task.impossible().is_some() {
        assert!(expected.is_empty(), "{:?}", task.impossible());
    }
    for threads in 1..=3 {
        let settings = Settings { threads, ..Settings::PLAIN };
        let counted = packing::count(task, &settings, false).unwrap();
        assert_eq!(counted.value.packings, expected.len().into());
        let first = packing::find(task, &settings).unwrap().value;
        assert_eq!(first.is_some(), !expected.is_empty());
    }
    expected.len()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]
    #[test]
    fn the_pictures_are_those_of_the_oracle(puzzle in puzzles(), order in 0..4usize) {
        if let Some(mut task) = puzzle.task() {
            task.order = Some(Order::ALL[order]);
            check(&task);
        }
    }
}

proptest! {
    #[test]
    fn pins_leave_the_pictures_that_show_them(puzzle in puzzles(), cell in 0..9usize) {
        let Some(mut task) = puzzle.task() else { return Ok(()) };
        let all = pictures(&task);
        let (Some(first), cell) = (all.first(), cell % task.shape.cells()) else { return Ok(()) };
        let shown = first[cell];
        let places = task.edges().sides(tilepack::torus::Cell(cell as u32));
        for (place, color) in places.into_iter().zip(shown) {
            task.pins.pin(place, color).unwrap();
        }
        let expected = all.iter().filter(|picture| picture[cell] == shown).count();
        let counted = packing::count(&task, &Settings::PLAIN, false).unwrap();
        prop_assert_eq!(counted.value.packings, expected.into());
    }
}

/// So that the random boards are not all without solutions.
#[test]
fn boards_cut_from_a_picture_have_one() {
    let mut with_many = 0;
    for seed in 0..40 {
        let puzzle = Puzzle {
            width: 3,
            height: 2,
            colors: 3,
            seed,
            topology: Topology::ALL[seed as usize % 3],
            rotations: true,
            border: (seed / 3 % 3) as u8,
            cut: true,
        };
        let pictures = check(&puzzle.task().unwrap());
        assert!(pictures > 0);
        with_many += usize::from(pictures > 4);
    }
    assert!(with_many > 10);
}

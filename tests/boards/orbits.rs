//! Orbits of pictures, by trying all symmetries on all pictures.

use crate::answers::puzzles;
use crate::naive::{Picture, pictures};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use tilepack::packing::{self, Settings, Task};
use tilepack::tiles::Kind;
use tilepack::torus::{Border, Topology};

fn permutations(of: u8) -> Vec<Vec<u8>> {
    let mut all = vec![Vec::new()];
    for _ in 0..of {
        let longer = |list: &Vec<u8>| -> Vec<Vec<u8>> {
            let free = (0..of).filter(|color| !list.contains(color));
            free.map(|color| [&list[..], &[color]].concat()).collect()
        };
        all = all.iter().flat_map(longer).collect();
    }
    all
}

/// A symmetry by what it does: colors of horizontal and vertical edges, then transposition and
/// reversals, then a translation.
struct Symmetry {
    colors: [Vec<u8>; 2],
    flips: [bool; 3],
    shift: (usize, usize),
}

impl Symmetry {
    fn tile(&self, [n, e, s, w]: [u8; 4]) -> [u8; 4] {
        let [h, v] = &self.colors;
        let color = |list: &[u8], color: u8| list[usize::from(color)];
        let (mut n, mut s) = (color(h, n), color(h, s));
        let (mut e, mut w) = (color(v, e), color(v, w));
        if self.flips[0] {
            (n, e, s, w) = (w, s, e, n);
        }
        if self.flips[1] {
            (n, s) = (s, n);
        }
        if self.flips[2] {
            (e, w) = (w, e);
        }
        [n, e, s, w]
    }

    fn picture(&self, picture: &Picture, (width, height): (usize, usize)) -> Picture {
        let mut image = picture.clone();
        for (cell, &tile) in picture.iter().enumerate() {
            let (mut row, mut column) = (cell / width, cell % width);
            if self.flips[0] {
                (row, column) = (column, row);
            }
            if self.flips[1] {
                row = height - 1 - row;
            }
            if self.flips[2] {
                column = width - 1 - column;
            }
            let (row, column) = ((row + self.shift.0) % height, (column + self.shift.1) % width);
            image[row * width + column] = self.tile(tile);
        }
        image
    }
}

fn class(tile: [u8; 4], rotations: bool) -> [u8; 4] {
    let [n, e, s, w] = tile;
    let turns = [tile, [w, n, e, s], [s, w, n, e], [e, s, w, n]];
    if rotations { turns.into_iter().min().unwrap() } else { tile }
}

/// All symmetries of the packings of a task.
fn symmetries(task: &Task) -> Vec<Symmetry> {
    let (width, height) = (task.shape.width(), task.shape.height());
    let colors = task.set.colors().largest() as u8;
    let tiles: Vec<[u8; 4]> =
        task.set.allowed().map(|tile| Kind::Wang.unpack(tile, task.set.colors())).collect();
    let rotations = task.board.rotations;
    let count = |tiles: &mut dyn Iterator<Item = [u8; 4]>| {
        let mut counts = BTreeMap::new();
        tiles.for_each(|tile| *counts.entry(class(tile, rotations)).or_insert(0) += 1);
        counts
    };
    let squares = count(&mut tiles.iter().copied());
    let mut all = Vec::new();
    let permutations = permutations(colors);
    for horizontal in &permutations {
        for vertical in &permutations {
            if rotations && horizontal != vertical {
                continue;
            }
            for flips in (0..8).map(|bits| [bits & 1 > 0, bits & 2 > 0, bits & 4 > 0]) {
                let turned = flips[0];
                if turned && (width != height || task.board.topology == Topology::Cylinder) {
                    continue;
                }
                let colors = [horizontal.clone(), vertical.clone()];
                let symmetry = Symmetry { colors, flips, shift: (0, 0) };
                if count(&mut tiles.iter().map(|&tile| symmetry.tile(tile))) == squares {
                    all.push(symmetry);
                }
            }
        }
    }
    let (down, across) = match task.board.topology {
        Topology::Torus => (height, width),
        Topology::Cylinder => (1, width),
        Topology::Rectangle => (1, 1),
    };
    let shifts = (0..down * across).map(|shift| (shift / across, shift % across));
    let shifted = shifts.flat_map(|shift| {
        let all = all.iter();
        all.map(move |Symmetry { colors, flips, .. }| Symmetry {
            colors: colors.clone(),
            flips: *flips,
            shift,
        })
    });
    shifted.collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, ..ProptestConfig::default() })]
    #[test]
    fn orbits_are_those_of_the_oracle(puzzle in puzzles()) {
        let puzzle = crate::answers::Puzzle { border: puzzle.border.min(1), ..puzzle };
        let Some(task) = puzzle.task() else { return Ok(()) };
        let shape = (task.shape.width(), task.shape.height());
        let all = pictures(&task);
        let bare = Border::default() == task.board.border;
        let mut symmetries = symmetries(&task);
        // The border is of color 0, which must stay where it shows.
        let outer = |side: usize| task.board.topology.is_outer(side) && !bare;
        symmetries.retain(|symmetry| {
            (!outer(0) || symmetry.colors[0][0] == 0) && (!outer(1) || symmetry.colors[1][0] == 0)
        });
        let mut left = all.clone();
        let mut orbits = 0;
        while let Some(picture) = left.pop_first() {
            orbits += 1;
            let images: BTreeSet<Picture> =
                symmetries.iter().map(|symmetry| symmetry.picture(&picture, shape)).collect();
            prop_assert!(images.is_subset(&all), "a symmetry that is none");
            for image in &images {
                left.remove(image);
            }
        }
        let counted = packing::count(&task, &Settings::PLAIN, true).unwrap().value;
        prop_assert_eq!(counted.packings, all.len().into());
        prop_assert_eq!(counted.fundamental, Some(orbits));
        let listed = packing::list(&task, &Settings::PLAIN, true).unwrap().value;
        prop_assert_eq!(listed.len() as u64, orbits);
    }
}

//! Packings of compact sets, constructed and annealed: every one read cell by cell from the definition.

#![allow(clippy::unwrap_used, clippy::panic)]

use tilepack::anneal;
use tilepack::compact::{self, wang};
use tilepack::search::Limits;
use tilepack::tiles::{Colors, Kind, Members, TileSet};
use tilepack::torus::{Lattice, Shape};
use tilepack::verify;

fn set(kind: Kind, colors: Colors) -> TileSet {
    TileSet::new(kind, colors, Members::Compact).unwrap()
}

fn corner(colors: u64) -> TileSet {
    set(Kind::Corner, Colors::one(colors).unwrap())
}

/// Panics unless every (NW, SW, SE) occurs twice, with different NE.
fn assert_compact_corner(colors: usize, shape: Shape, labels: &[u8]) {
    let (w, h) = (shape.width(), shape.height());
    let at = |r: usize, c: usize| usize::from(labels[r % h * w + c % w]);
    let mut ne_of = vec![Vec::new(); colors.pow(3)];
    for (r, c) in (0..h).flat_map(|r| (0..w).map(move |c| (r, c))) {
        let triple = (at(r, c) * colors + at(r + 1, c)) * colors + at(r + 1, c + 1);
        ne_of[triple].push(at(r, c + 1));
    }
    assert!(ne_of.iter().all(|ne| ne.len() == 2 && ne[0] != ne[1]), "{colors} colors, {shape}");
}

fn assert_valid(set: &TileSet, shape: Shape, labels: &[u8]) {
    let packing = Lattice { kind: set.kind(), shape }.packing(labels, set, false);
    let verdict = verify::check(&packing);
    assert!(verdict.is_valid(), "{shape}: {verdict}");
}

#[test]
fn corner_sets_near_a_square() {
    for colors in 2..=32 {
        let set = corner(colors);
        let shape = Shape::near_square(set.size()).unwrap();
        for seed in 0..3 {
            let labels = compact::construct(&set, shape, seed)
                .unwrap_or_else(|| panic!("{colors} colors, {shape}, seed {seed}"))
                .labels;
            assert_compact_corner(colors as usize, shape, &labels);
            assert_valid(&set, shape, &labels);
        }
    }
}

#[test]
fn corner_sets_in_every_shape_that_is_covered() {
    for colors in 2..=12 {
        let set = corner(colors);
        let shapes = compact::shapes(colors as usize);
        assert!(shapes.is_sorted_by_key(|shape| std::cmp::Reverse(shape.width())));
        for shape in shapes {
            assert_eq!(shape.cells() as u64, set.size());
            let found = compact::construct(&set, shape, 5).unwrap_or_else(|| panic!("{shape}"));
            assert_compact_corner(colors as usize, shape, &found.labels);
            let turned = Shape::new(shape.height() as u64, shape.width() as u64).unwrap();
            assert!(compact::construct(&set, turned, 5).is_some(), "{turned}");
        }
    }
}

/// Copies of every known torus of few colors, on top of each other and side by side, for factors
/// without and with common divisors; also copies of copies.
#[test]
fn copies_of_a_packing() {
    for (fewer, base) in [(2, "4x4"), (3, "9x6"), (3, "2x27"), (4, "64x2"), (3, "18x3")] {
        let base: Shape = base.parse().unwrap();
        let cells = compact::construct(&corner(fewer), base, 1).unwrap().labels;
        for k in 2..=6 {
            let (colors, copies) = (fewer as usize * k, k.pow(3));
            let labels = compact::copies::stacked(&cells, base.width(), fewer as usize, k);
            let shape = Shape::new(base.width() as u64, (base.height() * copies) as u64).unwrap();
            assert_compact_corner(colors, shape, &labels);
        }
    }
    let labels = compact::construct(&corner(16), "64x128".parse().unwrap(), 0).unwrap().labels;
    assert_compact_corner(16, "64x128".parse().unwrap(), &labels);
    let cells =
        compact::copies::stacked(&[0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 1, 1, 0, 1, 1, 1], 4, 2, 2);
    let labels = compact::copies::stacked(&cells, 4, 4, 4);
    assert_compact_corner(16, Shape::new(4, 2048).unwrap(), &labels);
}

#[test]
fn what_has_no_construction() {
    let shape = |size: &str| size.parse::<Shape>().unwrap();
    for (colors, size) in [(2, "8x2"), (3, "54x1"), (4, "128x1"), (7, "343x2")] {
        assert_eq!(compact::construct(&corner(colors), shape(size), 0), None, "{colors} {size}");
    }
    // Not as many cells as tiles.
    assert_eq!(compact::construct(&corner(4), shape("16x16"), 0), None);
    let complete = TileSet::new(Kind::Corner, Colors::one(4).unwrap(), Members::Complete).unwrap();
    assert_eq!(compact::construct(&complete, shape("16x16"), 0), None);
    // All of N, of S, of E and of W alike: nothing in which two tiles could differ.
    let lone = set(Kind::Wang, Colors::pair(1, 2).unwrap());
    assert_eq!(compact::construct(&lone, shape("1x4"), 0), None);
}

#[test]
fn seeds_give_different_packings() {
    for colors in [6, 16] {
        let set = corner(colors);
        let shape = Shape::near_square(set.size()).unwrap();
        let [a, again, b] = [3, 3, 4].map(|seed| compact::construct(&set, shape, seed).unwrap());
        assert_eq!(a, again);
        assert_ne!(a, b);
    }
}

/// For each (N, W) its tiles' (S, E).
fn south_and_east(colors: Colors, shape: Shape, labels: &[u8]) -> Vec<Vec<[u8; 2]>> {
    let (w, h) = (shape.width(), shape.height());
    let at = |r: usize, c: usize, side: usize| labels[2 * (r % h * w + c % w) + side];
    let mut tiles = vec![Vec::new(); colors.horizontal() * colors.vertical()];
    for (r, c) in (0..h).flat_map(|r| (0..w).map(move |c| (r, c))) {
        let pair = usize::from(at(r, c, 0)) * colors.vertical() + usize::from(at(r, c, 1));
        tiles[pair].push([at(r + 1, c, 0), at(r, c + 1, 1)]);
    }
    tiles
}

#[test]
fn wang_sets_in_every_shape() {
    for (horizontal, vertical) in
        [(2, 2), (3, 3), (4, 4), (5, 5), (8, 8), (16, 16), (2, 3), (5, 2), (7, 4)]
    {
        let colors = Colors::pair(horizontal, vertical).unwrap();
        let set = set(Kind::Wang, colors);
        let cells = set.size();
        for width in (1..=cells).filter(|&width| cells.is_multiple_of(width)) {
            let shape = Shape::new(width, cells / width).unwrap();
            for seed in 0..2 {
                let labels = compact::construct(&set, shape, seed).unwrap().labels;
                assert_valid(&set, shape, &labels);
                let labels = wang::weak(colors, shape, seed).unwrap();
                let tiles = south_and_east(colors, shape, &labels);
                assert!(tiles.iter().all(|two| two.len() == 2 && two[0] != two[1]));
                let Some(labels) = wang::strict(colors, shape, seed) else {
                    // On a ring of one row every tile is below itself; two rows may be too few.
                    assert!(shape.width().min(shape.height()) <= 2, "{colors} {shape}");
                    continue;
                };
                let tiles = south_and_east(colors, shape, &labels);
                let differ = |two: &Vec<[u8; 2]>| (0..2).all(|side| two[0][side] != two[1][side]);
                assert!(tiles.iter().all(|two| two.len() == 2 && differ(two)), "{colors} {shape}");
            }
        }
    }
}

#[test]
fn annealing_where_nothing_is_constructed() {
    let shape = |size: &str| size.parse::<Shape>().unwrap();
    for (colors, size) in [(3, "9x6"), (3, "6x9"), (3, "3x18"), (4, "16x8"), (5, "10x25")] {
        let (set, shape) = (corner(colors), shape(size));
        let count = colors as usize;
        let labels = anneal::compact_corner(count, shape, 0, &Limits::NONE).labels.unwrap();
        assert_compact_corner(count, shape, &labels);
        assert_valid(&set, shape, &labels);
        let again = |seed| anneal::compact_corner(count, shape, seed, &Limits::NONE).labels;
        assert_eq!(again(0), Some(labels.clone()));
        assert_ne!(again(1), Some(labels));
    }
    let few = Limits { stop: &(), nodes: 10 };
    assert_eq!(anneal::compact_corner(5, shape("25x10"), 0, &few).labels, None);
    for (colors, size) in [(3, "27x2"), (3, "9x9"), (4, "128x1"), (1, "2x1"), (3, "54x1")] {
        let most = Limits { stop: &(), nodes: 1000 };
        assert_eq!(anneal::compact_corner(colors, shape(size), 0, &most).labels, None, "{size}");
    }
}

//! Packings of compact sets, constructed and annealed: every one read cell by cell from the definition.

#![allow(clippy::unwrap_used, clippy::panic)]

use tilepack::anneal;
use tilepack::compact::{self, wang};
use tilepack::search::Limits;
use tilepack::tiles::{Colors, Kind, Members, TileSet};
use tilepack::torus::{Lattice, Shape};
use tilepack::verify;

/// Colors whose near-square shape has no side `C m` with `m` a divisor of `C`, and the shape
/// nearest to a square that has.
const OTHER_SHAPES: [(u64, &str); 5] =
    [(12, "72x48"), (20, "160x100"), (22, "242x88"), (26, "338x104"), (30, "300x180")];

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
    for colors in 4..=32 {
        let set = corner(colors);
        let near = Shape::near_square(set.size()).unwrap();
        let other = OTHER_SHAPES.iter().find(|(of, _)| *of == colors);
        let shape = match other {
            Some((_, size)) => {
                assert_eq!(compact::construct(&set, near, 0), None, "{colors} colors");
                size.parse().unwrap()
            }
            None => near,
        };
        for seed in 0..3 {
            let labels = compact::construct(&set, shape, seed)
                .unwrap_or_else(|| panic!("{colors} colors, {shape}, seed {seed}"));
            assert_compact_corner(colors as usize, shape, &labels);
            assert_valid(&set, shape, &labels);
        }
    }
}

#[test]
fn corner_sets_in_every_shape_that_is_covered() {
    for colors in 4..=12 {
        let set = corner(colors);
        let shapes = compact::shapes(colors as usize);
        assert!(shapes.is_sorted_by_key(|shape| std::cmp::Reverse(shape.width())));
        for shape in shapes {
            assert_eq!(shape.cells() as u64, set.size());
            let labels = compact::construct(&set, shape, 5).unwrap_or_else(|| panic!("{shape}"));
            assert_compact_corner(colors as usize, shape, &labels);
        }
    }
}

#[test]
fn what_has_no_construction() {
    let shape = |size: &str| size.parse::<Shape>().unwrap();
    for (colors, size) in [(2, "4x4"), (3, "9x6"), (3, "6x9"), (3, "18x3"), (4, "128x1")] {
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
                let labels = compact::construct(&set, shape, seed).unwrap();
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
        let labels = anneal::compact_corner(count, shape, 0, &Limits::NONE).unwrap();
        assert_compact_corner(count, shape, &labels);
        assert_valid(&set, shape, &labels);
        assert_eq!(anneal::compact_corner(count, shape, 0, &Limits::NONE), Some(labels.clone()));
        assert_ne!(anneal::compact_corner(count, shape, 1, &Limits::NONE), Some(labels));
    }
    let few = Limits { stop: &(), nodes: 10 };
    assert_eq!(anneal::compact_corner(5, shape("25x10"), 0, &few), None);
    for (colors, size) in [(3, "27x2"), (3, "9x9"), (4, "128x1"), (1, "2x1"), (3, "54x1")] {
        let most = Limits { stop: &(), nodes: 1000 };
        assert_eq!(anneal::compact_corner(colors, shape(size), 0, &most), None, "{size}");
    }
}

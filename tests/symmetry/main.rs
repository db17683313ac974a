//! Symmetries against brute force, on problems small enough for it.

#![allow(clippy::unwrap_used)]

mod laws;
mod oracle;

use laws::*;
use num_bigint::BigUint;
use oracle::{pairs, problem};
use proptest::prelude::*;
use std::collections::BTreeSet;
use tilepack::symmetry::{
    Anchor, ColorMap, Group, GroupError, Isometry, Symmetry, burnside, by_canonical_form, expand,
};
use tilepack::tiles::{Kind, Members, TileId};

#[test]
fn corner_complete_two_colors_is_one_packing() {
    let problem = problem(Kind::Corner, (2, 2), Members::Complete, (4, 4));
    assert_eq!(check(&problem), (32, 1));
    assert_eq!(problem.group().order(), BigUint::from(16u32 * 2 * 8));
    let packings = problem.packings();
    for (text, found) in [("2,0:1,0", (0, 0)), ("0,2:1,0", (0, 0)), ("2,2:1,0", (32, 1))] {
        assert_eq!(check_automorphism(&problem, &packings, text), found, "{text}");
    }
}

#[test]
fn corner_compact_two_colors() {
    let problem = problem(Kind::Corner, (2, 2), Members::Compact, (4, 4));
    let group = problem.group();
    assert_eq!(group.order(), BigUint::from(16u32 * 2 * 2));
    // Two tiles for each of eight (NW, SW, SE) are all sixteen: the complete set.
    assert_eq!(check(&problem), (32, 1));
    assert_eq!(check_automorphism(&problem, &problem.packings(), "2,2:1,0"), (32, 1));
}

#[test]
fn corner_compact_on_a_torus_that_is_not_square() {
    let problem = problem(Kind::Corner, (2, 2), Members::Compact, (8, 2));
    assert_eq!(problem.group().order(), BigUint::from(16u32 * 2));
    check(&problem);
}

#[test]
fn wang_compact() {
    let sizes = [((4, 2), (1408, 60)), ((2, 4), (1408, 60)), ((8, 1), (576, 20))];
    for (size, found) in sizes {
        let problem = problem(Kind::Wang, (2, 2), Members::Compact, size);
        assert_eq!(problem.group().order(), BigUint::from(8u32 * 4));
        assert_eq!(check(&problem), found);
    }
    let problem_4x2 = problem(Kind::Wang, (2, 2), Members::Compact, (4, 2));
    let packings = problem_4x2.packings();
    let automorphisms = [
        ("2,0:1,0", (80, 7)),
        ("2,0:1,0/0,1", (32, 2)),
        ("2,0:0,1/1,0", (64, 6)),
        ("0,1:1,0", (48, 4)),
        ("2,1:0,1/1,0", (48, 4)),
    ];
    for (text, found) in automorphisms {
        assert_eq!(check_automorphism(&problem_4x2, &packings, text), found, "{text}");
    }
    for (colors, size) in [((1, 2), (2, 2)), ((2, 1), (2, 2)), ((1, 3), (3, 2)), ((3, 1), (2, 3))] {
        check(&problem(Kind::Wang, colors, Members::Compact, size));
    }
}

#[test]
fn wang_complete_small() {
    // One color on the horizontal edges: dominoes side by side, C!^C / C^2 rings.
    let rings = |c: u64, size| problem(Kind::Wang, (1, c), Members::Complete, size);
    assert_eq!(check(&rings(2, (4, 1))).0, 4);
    assert_eq!(check(&rings(3, (9, 1))).0, 24 * 9);
    assert_eq!(check(&problem(Kind::Wang, (2, 1), Members::Complete, (1, 4))).0, 4);
    assert_eq!(check(&problem(Kind::Wang, (2, 1), Members::Complete, (4, 1))).0, 0);
    check(&problem(Kind::Wang, (2, 1), Members::Complete, (2, 2)));
    check(&problem(Kind::Wang, (1, 3), Members::Complete, (3, 3)));
    assert_eq!(check(&problem(Kind::Wang, (1, 1), Members::Complete, (1, 1))), (1, 1));
    let problem = rings(2, (4, 1));
    assert_eq!(check_automorphism(&problem, &problem.packings(), "2,0:0/1,0"), (4, 1));
}

#[test]
fn domino_rings() {
    let ring = |c: u64, size| problem(Kind::Domino, (c, c), Members::Complete, size);
    assert_eq!(check(&ring(1, (1, 1))), (1, 1));
    assert_eq!(check(&ring(2, (4, 1))), (4, 1));
    assert_eq!(check(&ring(2, (1, 4))), (4, 1));
    assert_eq!(check(&ring(3, (9, 1))), (216, 2));
    let three = ring(3, (9, 1));
    assert_eq!(three.group().order(), BigUint::from(9u32 * 6 * 2));
    let packings = three.packings();
    // The differences 0, 1, 2 of the three orbits of dominoes add up to 0, never to 1.
    assert_eq!(check_automorphism(&three, &packings, "3,0:+1"), (0, 0));
    for (size, text) in [((4, 1), "2,0:+1"), ((1, 4), "0,2:+1")] {
        let two = ring(2, size);
        assert_eq!(check_automorphism(&two, &two.packings(), text), (4, 1));
    }
    let no_loops = problem(Kind::Domino, (3, 3), tiles(&[1, 2, 3, 5, 6, 7]), (6, 1));
    assert!(check(&no_loops).0 > 0);
    assert!(check_automorphism(&no_loops, &no_loops.packings(), "3,0:1,0,2").0 > 0);
}

#[test]
fn pruned_sets() {
    // 00 11 22 02 20 12 21: 2 joined with 0 and with 1, all with loops.
    let dominoes = problem(Kind::Domino, (3, 3), pairs(&[(0, 1)]), (7, 1));
    assert_eq!(check(&dominoes), (14, 1));
    assert_eq!(dominoes.group().order(), BigUint::from(7u32 * 2 * 2));
    check(&problem(Kind::Domino, (4, 4), pairs(&[(0, 1), (2, 3), (0, 2)]), (10, 1)));
    check(&problem(Kind::Corner, (2, 2), pairs(&[(0, 1)]), (2, 1)));
    // A color value in both palettes is meant by the pair, though only one has all three.
    for (colors, size) in [((1, 2), (2, 1)), ((2, 2), (2, 1)), ((1, 3), (4, 1)), ((3, 1), (1, 4))] {
        for pair in [(0, 1), (1, 2)] {
            if u64::from(pair.1) < colors.0.max(colors.1) {
                check(&problem(Kind::Wang, colors, pairs(&[pair]), size));
            }
        }
    }
    for (colors, excluded) in [((2, 3), (0, 2)), ((3, 3), (0, 1)), ((4, 2), (1, 3))] {
        check_complete(&problem(Kind::Wang, colors, pairs(&[excluded]), (3, 3)));
    }
    for graph in [&[(0, 1)][..], &[(0, 1), (2, 3)], &[(0, 1), (1, 2), (2, 3)], &[(0, 1), (0, 2)]] {
        check_complete(&problem(Kind::Corner, (4, 4), pairs(graph), (5, 5)));
        check_complete(&problem(Kind::Corner, (5, 5), pairs(graph), (5, 4)));
    }
}

fn tiles(list: &[u32]) -> Members {
    Members::Explicit(list.iter().map(|&t| TileId(t)).collect())
}

#[test]
fn explicit_set_that_only_a_joint_symmetry_keeps() {
    // A quarter turn joined with the exchange of the colors keeps these four; neither does alone.
    let joint = tiles(&[0b0001, 0b0111, 0b0100, 0b1101]);
    let joint = problem(Kind::Corner, (2, 2), joint, (2, 2));
    check(&joint);
    let colors = joint.set.colors();
    let maps = [ColorMap::identity(colors), ColorMap::shift(colors, 1)];
    let has = |isometry, map: &ColorMap| {
        joint.group().points().any(|p| p.isometry == isometry && p.map == *map)
    };
    assert!(has(Isometry::QUARTER_TURN, &maps[1]));
    assert!(!has(Isometry::QUARTER_TURN, &maps[0]) && !has(Isometry::IDENTITY, &maps[1]));

    let wang = problem(Kind::Wang, (2, 2), tiles(&[0b0000, 0b0101, 0b1010, 0b1111]), (2, 2));
    assert!(check(&wang).0 > 0);
    let half = problem(Kind::Wang, (2, 2), tiles(&[0b0000, 0b1111]), (2, 1));
    check(&half);
    // One tile on one cell: every symmetry is in the stabilizer.
    let one = problem(Kind::Wang, (1, 1), Members::Complete, (1, 1));
    assert_eq!(one.group().order(), BigUint::from(8u32));
    let unused = problem(Kind::Corner, (5, 5), tiles(&[0]), (1, 1));
    assert_eq!(check(&unused), (1, 1));
    assert_eq!(unused.group().order(), BigUint::from(8u32), "unused colors stay in order");
}

/// All 203,520 packings, by depth-first search over cells.
fn wang_two_colors() -> Vec<Vec<u8>> {
    fn extend(cell: usize, used: u16, tiles: &mut [u8; 16], found: &mut Vec<Vec<u8>>) {
        if cell == 16 {
            found.push(tiles.iter().flat_map(|t| [t >> 3 & 1, t & 1]).collect());
            return;
        }
        let (row, column) = (cell / 4, cell % 4);
        for tile in 0..16u8 {
            let [n, e, s, w] = [3, 2, 1, 0].map(|bit| tile >> bit & 1);
            let fits = used >> tile & 1 == 0
                && (row == 0 || tiles[cell - 4] >> 1 & 1 == n)
                && (column == 0 || tiles[cell - 1] >> 2 & 1 == w)
                && (row < 3 || tiles[column] >> 3 & 1 == s)
                && (column < 3 || tiles[cell - 3] & 1 == e);
            if fits {
                tiles[cell] = tile;
                extend(cell + 1, used | 1 << tile, tiles, found);
            }
        }
    }
    let mut found = Vec::new();
    extend(0, 0, &mut [0; 16], &mut found);
    found.sort_unstable();
    found
}

#[test]
fn wang_complete_two_colors() {
    let problem = problem(Kind::Wang, (2, 2), Members::Complete, (4, 4));
    let packings = wang_two_colors();
    assert_eq!(packings.len(), 203_520);
    assert!(packings.iter().all(|labels| problem.is_packing(labels)));
    let group = problem.group();
    assert_eq!(group.order(), BigUint::from(16u32 * 4 * 8));
    let pinned: Vec<_> =
        packings.iter().filter(|labels| problem.tiles(labels)[0] == TileId(0)).collect();
    assert_eq!(pinned.len(), 12_720);
    let anchor = Anchor::Tile(TileId(0));
    let orbits = by_canonical_form(&group, anchor, pinned.iter().map(|labels| labels.as_slice()));
    assert_eq!(orbits.values().sum::<u64>(), 203_520);
    assert_eq!(orbits.len(), 538);
    assert_eq!(burnside(&group, &packings), Some(BigUint::from(538u32)));
    let union: BTreeSet<_> = orbits.keys().flat_map(|form| expand(&group, form)).collect();
    assert!(union.iter().eq(&packings), "the representatives give back every packing");

    // The palettes exchanged by a transposition, with an automorphism that tells them apart.
    let automorphisms = [
        ("2,0:1,0", (1536, 18)),
        ("2,0:1,0/0,1", (1536, 17)),
        ("0,2:0,1/1,0", (1536, 17)),
        ("2,2:1,0/0,1", (1792, 25)),
        ("2,2:1,0", (1024, 11)),
    ];
    for (text, found) in automorphisms {
        assert_eq!(check_automorphism(&problem, &packings, text), found, "{text}");
    }
}

#[test]
fn coverings_have_several_tiles_that_may_lie_at_the_origin() {
    let problems = [
        problem(Kind::Domino, (2, 2), Members::Complete, (7, 1)),
        problem(Kind::Wang, (1, 2), Members::Complete, (3, 2)),
        problem(Kind::Wang, (2, 2), tiles(&[0, 5, 10, 15]), (3, 3)),
        problem(Kind::Corner, (2, 2), tiles(&[0b0000, 0b0011, 0b1100, 0b1111]), (5, 3)),
        problem(Kind::Corner, (2, 2), tiles(&[0b0000, 0b0001, 0b0010, 0b0100, 0b1000]), (4, 4)),
    ];
    for problem in problems {
        let coverings = problem.arrays(|labels| problem.is_covering(labels));
        assert!(check_laws(&problem, &problem.group(), &coverings) > 0, "{problem:?}");
    }
}

/// Compact packings on a square torus are complete (C = 2) or out of reach (C = 8), but any
/// array of labels shows how often each class occurs, and with how many free sides.
#[test]
fn compact_groups_keep_the_classes_and_nothing_else_does() {
    for (kind, colors) in [(Kind::Corner, (3, 3)), (Kind::Wang, (3, 3)), (Kind::Wang, (2, 3))] {
        let problem = problem(kind, colors, Members::Compact, (5, 5));
        let radices = problem.radices();
        let random = |k: u32| {
            let label =
                |(i, &r): (u32, &u8)| ((i + 7 * k).wrapping_mul(2_654_435_761) >> 13) as u8 % r;
            (0..).zip(&radices).map(label).collect::<Vec<u8>>()
        };
        let arrays: Vec<_> = (0..10).map(random).collect();
        let points: BTreeSet<_> = problem.group().points().collect();
        for point in all_points(&problem) {
            let kept = arrays.iter().all(|labels| {
                let image = Symmetry { point: point.clone(), rows: 2, columns: 1 }
                    .image(problem.lattice(), labels);
                problem.class_counts(&image) == problem.class_counts(labels)
            });
            assert_eq!(kept, points.contains(&point), "{point:?}");
        }
    }
}

#[test]
fn too_many_color_maps() {
    let group = |kind, colors, members, size| {
        let problem = problem(kind, colors, members, size);
        Group::of(&problem.set, problem.shape, None)
    };
    let eight = group(Kind::Corner, (8, 8), Members::Complete, (64, 64)).unwrap();
    assert_eq!(eight.order(), BigUint::from(40_320u64 * 8 * 4096));
    let ten = group(Kind::Corner, (10, 10), Members::Complete, (100, 100));
    assert!(matches!(ten, Err(GroupError::TooManyColorMaps { .. })));
    let message = ten.unwrap_err().to_string();
    assert!(message.starts_with("up to symmetry needs every color permutation"), "{message}");
    let wang = group(Kind::Wang, (6, 6), Members::Complete, (36, 36));
    assert!(matches!(wang, Err(GroupError::TooManyColorMaps { .. })));
    // Four disjoint pairs over nine colors: the pairs in any order, each either way round.
    let disjoint = pairs(&[(0, 1), (2, 3), (4, 5), (6, 7)]);
    let pruned = group(Kind::Corner, (9, 9), disjoint, (3625, 1)).unwrap();
    assert_eq!(pruned.point_count(), 384 * 4);
    let large = group(Kind::Corner, (255, 255), pairs(&[(0, 1)]), (9, 9));
    assert!(matches!(large, Err(GroupError::TooMuchWork { .. })));
}

/// A kind of tile, palettes and a size.
type Small = (Kind, (u64, u64), (u64, u64));

/// Small enough to try every array of labels.
const SMALL: &[Small] = &[
    (Kind::Corner, (2, 2), (2, 2)),
    (Kind::Corner, (3, 3), (2, 2)),
    (Kind::Corner, (3, 3), (3, 3)),
    (Kind::Corner, (2, 2), (4, 3)),
    (Kind::Corner, (2, 2), (3, 3)),
    (Kind::Corner, (4, 4), (3, 2)),
    (Kind::Corner, (3, 3), (5, 1)),
    (Kind::Wang, (2, 2), (2, 2)),
    (Kind::Wang, (3, 3), (2, 2)),
    (Kind::Wang, (2, 3), (2, 2)),
    (Kind::Wang, (3, 1), (2, 2)),
    (Kind::Wang, (2, 2), (3, 2)),
    (Kind::Wang, (2, 2), (1, 3)),
    (Kind::Wang, (3, 3), (1, 1)),
    (Kind::Wang, (1, 2), (3, 3)),
    (Kind::Domino, (3, 3), (5, 1)),
    (Kind::Domino, (3, 3), (1, 6)),
    (Kind::Domino, (4, 4), (6, 1)),
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// The set of the tiles of a random array of labels has at least this packing.
    #[test]
    fn explicit_sets_with_packings(
        which in 0..SMALL.len(),
        random in proptest::collection::vec(any::<u8>(), 18),
    ) {
        let (kind, colors, size) = SMALL[which];
        let complete = problem(kind, colors, Members::Complete, size);
        let radices = complete.radices();
        let labels: Vec<u8> = random.iter().zip(&radices).map(|(x, r)| x % r).collect();
        let mut tiles = complete.tiles(&labels);
        tiles.sort_unstable();
        tiles.dedup();
        prop_assume!(tiles.len() == complete.shape.cells());
        prop_assert!(check(&problem(kind, colors, Members::Explicit(tiles), size)).0 > 0);
    }

    /// The least set that contains a few random tiles and is kept by a random symmetry.
    #[test]
    fn groups_of_sets_made_symmetric(
        which in 0..SMALL.len(),
        generator in any::<proptest::sample::Index>(),
        seeds in proptest::collection::vec(any::<proptest::sample::Index>(), 1..6),
    ) {
        let (kind, colors, size) = SMALL[which];
        let complete = problem(kind, colors, Members::Complete, size);
        let points = all_points(&complete);
        let point = &points[generator.index(points.len())];
        let colors_of = complete.set.colors();
        let mut tiles = BTreeSet::new();
        for seed in seeds {
            let mut tile = TileId(seed.index(kind.tiles(colors_of) as usize) as u32);
            while tiles.insert(tile) {
                tile = point.tile(kind, colors_of, tile).unwrap();
            }
        }
        let list = Members::Explicit(tiles.into_iter().collect());
        let closed = problem(kind, colors, list, size);
        prop_assert!(keeps_set(&closed, point));
        check_complete(&closed);
        let radices = closed.radices();
        let labels: Vec<u8> = (1..).zip(&radices).map(|(i, &r)| (i * i / 3) as u8 % r).collect();
        check_axioms(&closed, &complete.group(), &labels);
    }
}

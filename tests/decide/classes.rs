//! Tables of classes, against a naive program: all ways to give labels to ordered tiles, those
//! that are useless left out, the rest counted up to everything that does not matter.

use crate::naive::{smallest_square, smallest_torus};
use std::collections::{BTreeMap, BTreeSet};
use tilepack::aperiodic::classify::exhaust::{Question, exhaust};
use tilepack::aperiodic::classify::{Sets, Tally, UpTo, classify, two_colors};
use tilepack::aperiodic::decide::{Bounds, SYMMETRIES};

/// Sets, periodic, without a tiling; for 1 to 5 tiles.
const GRAPHS: [[u64; 3]; 5] =
    [[1, 1, 0], [5, 5, 0], [41, 36, 5], [998, 713, 285], [49_899, 27_952, 21_947]];
const TRANSPOSITION: [[u64; 3]; 5] =
    [[1, 1, 0], [5, 5, 0], [40, 35, 5], [970, 696, 274], [49_104, 27_586, 21_518]];
const SQUARE: [[u64; 3]; 5] =
    [[1, 1, 0], [5, 5, 0], [32, 28, 4], [514, 395, 119], [16_302, 9_916, 6_386]];

fn tally(tiles: usize, up_to: UpTo) -> Tally {
    let sets = Sets::new(tiles, up_to);
    let parts =
        [(0, 2), (1, 2)].map(|part| classify(&sets, part, &Bounds::default(), &(), &|_, _| ()));
    let mut all = Tally::default();
    for part in parts {
        assert!(part.complete && part.undecided.is_empty());
        all += part.tally;
    }
    all
}

fn expected([sets, periodic, no_tiling]: [u64; 3]) -> Tally {
    Tally { sets, periodic, no_tiling, undecided: 0 }
}

#[test]
fn all_sets_of_up_to_five_wang_tiles() {
    for tiles in 1..=5 {
        assert_eq!(tally(tiles, UpTo::Graphs), expected(GRAPHS[tiles - 1]));
        assert_eq!(tally(tiles, UpTo::Transposition), expected(TRANSPOSITION[tiles - 1]));
        assert_eq!(tally(tiles, UpTo::Square), expected(SQUARE[tiles - 1]));
    }
}

/// All sequences of labels in which a new label is the next number.
fn sequences(length: usize) -> Vec<Vec<u32>> {
    (0..length).fold(vec![Vec::new()], |all, _| {
        let longer = all.iter().flat_map(|begun: &Vec<u32>| {
            let new = begun.iter().max().map_or(0, |largest| largest + 1);
            (0..=new).map(move |label| [&begun[..], &[label]].concat())
        });
        longer.collect()
    })
}

/// Whether every arc (two labels of the sequence) can be followed back to its beginning.
fn is_cyclic(arcs: &[u32]) -> bool {
    arcs.chunks(2).all(|arc| {
        let mut reached = BTreeSet::from([arc[1]]);
        for _ in 0..arcs.len() {
            let next = arcs.chunks(2).filter(|arc| reached.contains(&arc[0])).map(|arc| arc[1]);
            let next: Vec<u32> = next.collect();
            reached.extend(next);
        }
        reached.contains(&arc[0])
    })
}

fn orders(n: usize) -> Vec<Vec<usize>> {
    (0..n).fold(vec![Vec::new()], |all, _| {
        let longer = all.iter().flat_map(|begun: &Vec<usize>| {
            let left = (0..n).filter(|i| !begun.contains(i));
            left.map(|i| [&begun[..], &[i]].concat()).collect::<Vec<_>>()
        });
        longer.collect()
    })
}

/// The tiles in the order and with the names of labels that come first.
fn canonical(tiles: &[[u32; 4]], orders: &[Vec<usize>]) -> Vec<[u32; 4]> {
    let named = |order: &Vec<usize>| {
        let mut names: [BTreeMap<u32, u32>; 2] = Default::default();
        let tile = |&tile: &usize| -> [u32; 4] {
            std::array::from_fn(|side| {
                let names = &mut names[side % 2];
                let new = names.len() as u32;
                *names.entry(tiles[tile][side]).or_insert(new)
            })
        };
        order.iter().map(tile).collect::<Vec<_>>()
    };
    orders.iter().map(named).min().unwrap()
}

#[test]
fn the_naive_program_counts_the_same() {
    for tiles in 1..=4 {
        let orders = orders(tiles);
        let sequences: Vec<_> =
            sequences(2 * tiles).into_iter().filter(|labels| is_cyclic(labels)).collect();
        let mut all = BTreeSet::new();
        for rows in &sequences {
            for columns in &sequences {
                let set: Vec<[u32; 4]> = (0..tiles)
                    .map(|t| [columns[2 * t], rows[2 * t + 1], columns[2 * t + 1], rows[2 * t]])
                    .collect();
                if set.iter().collect::<BTreeSet<_>>().len() == tiles
                    && (tiles < 4 || is_least(rows))
                {
                    all.insert(canonical(&set, &orders));
                }
            }
        }
        let image = |set: &Vec<[u32; 4]>, sides: [usize; 4]| {
            let moved: Vec<_> = set.iter().map(|tile| sides.map(|side| tile[side])).collect();
            canonical(&moved, &orders)
        };
        let transpose = [3, 2, 1, 0];
        let least = |sides: &[[usize; 4]]| -> Vec<&Vec<[u32; 4]>> {
            all.iter().filter(|set| sides.iter().all(|&s| **set <= image(set, s))).collect()
        };
        for (classes, table) in [(least(&[transpose]), TRANSPOSITION), (least(&SYMMETRIES), SQUARE)]
        {
            let periodic = classes.iter().filter(|set| {
                let square = smallest_square(set, false, 5).is_some();
                assert!(square || smallest_torus(set, false, 25).is_some(), "{set:?}");
                !square
            });
            let periodic = periodic.count() as u64;
            let sets = classes.len() as u64;
            assert_eq!([sets, periodic, sets - periodic], table[tiles - 1]);
        }
    }
}

/// Whether the tiles are in the order that makes this sequence of labels least: one of each class
/// of rows is enough.
fn is_least(rows: &[u32]) -> bool {
    orders(rows.len() / 2).iter().all(|order| {
        let mut names = BTreeMap::new();
        let labels = order.iter().flat_map(|&tile| [rows[2 * tile], rows[2 * tile + 1]]);
        let named: Vec<u32> = labels
            .map(|label| {
                let new = names.len() as u32;
                *names.entry(label).or_insert(new)
            })
            .collect();
        rows <= &named[..]
    })
}

#[test]
fn all_corner_sets_over_two_colors() {
    let two = two_colors::classify();
    assert_eq!(two.tally, expected([65_536, 61_261, 4_275]));
    assert_eq!(two.generators.len(), 17);
    assert!(two.generators.iter().all(|generator| (1..=6).contains(&generator.cells)));
}

/// The search meets all smallest periodic sets, as it would meet aperiodic ones.
#[test]
fn the_search_for_aperiodic_sets_misses_none() {
    let question = Question { area: 1, periodic: true, ..Question::new(2, 16) };
    let found = exhaust(question, &Bounds::default(), &(), &|_, _| ());
    assert!(found.complete && found.undecided.is_empty());
    let mask = |tiles: &[[u32; 4]]| -> u16 {
        tiles.iter().map(|t| 1 << (8 * t[0] + 4 * t[1] + 2 * t[2] + t[3])).sum()
    };
    let images = |tiles: &[[u32; 4]]| -> BTreeSet<u16> {
        let all = SYMMETRIES.into_iter().flat_map(|sides| [(sides, 0), (sides, 1)]);
        let image = |(sides, flip): ([usize; 4], u32)| -> Vec<[u32; 4]> {
            tiles.iter().map(|tile| sides.map(|side| tile[side] ^ flip)).collect()
        };
        all.map(|symmetry| mask(&image(symmetry))).collect()
    };
    let met: BTreeSet<u16> = found.periodic.iter().flat_map(|tiles| images(tiles)).collect();
    for generator in two_colors::classify().generators {
        assert_eq!(met.contains(&generator.mask), generator.torus > 1, "{generator:?}");
    }
    assert!(met.iter().all(|&mask| {
        let tiles = two_colors::corner_tiles(mask);
        smallest_torus(&tiles, true, 16).is_some()
    }));
}

/// Over three colors, against all sets of at most three tiles.
#[test]
fn small_corner_sets_over_three_colors() {
    let found = exhaust(Question::new(3, 6), &Bounds::default(), &(), &|_, _| ());
    assert!(found.complete && found.undecided.is_empty());
    assert_eq!((found.tally.sets, found.tally.periodic), (222, 116));
    let tile = |t: u32| [t / 27, t / 9 % 3, t / 3 % 3, t % 3];
    for a in 0..81 {
        for b in (a + 1..81).step_by(2) {
            let tiles = [tile(a), tile(b)];
            let torus = smallest_torus(&tiles, true, 4).is_some();
            assert!(torus || smallest_square(&tiles, true, 3).is_some(), "{tiles:?}");
        }
    }
}

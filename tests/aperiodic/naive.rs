//! The constructions again, by their definitions, on small random sets; and laws.

use proptest::prelude::*;
use std::collections::BTreeSet;
use tilepack::aperiodic::Set;
use tilepack::aperiodic::convert::{Method, convert};
use tilepack::tiles::Kind;

type Tile = [u32; 4];

/// All pairs of tiles for which this holds.
fn pairs(tiles: &[Tile], fit: impl Fn(Tile, Tile) -> bool) -> Vec<(Tile, Tile)> {
    let all = tiles.iter().flat_map(|&a| tiles.iter().map(move |&b| (a, b)));
    all.filter(|&(a, b)| fit(a, b)).collect()
}

fn beside(a: Tile, b: Tile) -> bool {
    a[1] == b[3]
}

fn above(a: Tile, b: Tile) -> bool {
    a[2] == b[0]
}

/// The number of different corner tiles, and of pairs.
fn naive(tiles: &[Tile], method: Method) -> (usize, Option<usize>) {
    match method {
        Method::Diagonal => {
            let mut blocks = 0;
            for (a, b) in pairs(tiles, beside) {
                for (c, d) in pairs(tiles, beside) {
                    blocks += usize::from(above(a, c) && above(b, d));
                }
            }
            (blocks, None)
        }
        Method::Horizontal => {
            let all = pairs(tiles, beside);
            let different: BTreeSet<Tile> =
                all.iter().map(|(a, b)| [a[0], b[0], b[2], a[2]]).collect();
            (different.len(), Some(all.len()))
        }
        Method::Vertical => {
            let all = pairs(tiles, above);
            let different: BTreeSet<Tile> =
                all.iter().map(|(a, b)| [a[3], a[1], b[1], b[3]]).collect();
            (different.len(), Some(all.len()))
        }
        Method::Rotation => {
            let mut corners = BTreeSet::new();
            for (a, b) in pairs(tiles, beside) {
                for (c, d) in pairs(tiles, beside) {
                    if above(a, c) && above(b, d) {
                        corners.insert([a[2], a[1], b[2], c[1]]);
                    }
                }
            }
            (tiles.len() + corners.len(), None)
        }
        _ => (4 * tiles.len(), None),
    }
}

fn sets() -> impl Strategy<Value = Vec<Tile>> {
    let tile = [0..3u32, 0..3u32, 0..3u32, 0..3u32];
    prop::collection::btree_set(tile, 1..9).prop_map(|tiles| tiles.into_iter().collect())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn as_defined(tiles in sets()) {
        let set = Set::new(Kind::Wang, tiles.clone()).unwrap();
        for method in Method::TO_CORNER {
            let converted = convert(&set, method).unwrap();
            let (count, pairs) = naive(&tiles, method);
            prop_assert_eq!(converted.set.tiles().len(), count);
            prop_assert_eq!(converted.pairs, pairs);
        }
    }

    /// Other names of labels change nothing; transposition exchanges horizontal and vertical.
    #[test]
    fn names_and_sides_do_not_matter(tiles in sets(), shift in 1..50u32) {
        let renamed = tiles.iter().map(|&[n, e, s, w]| {
            [2 * n + shift, 100 - 3 * e, 2 * s + shift, 100 - 3 * w]
        });
        let transposed = tiles.iter().map(|&[n, e, s, w]| [w, s, e, n]);
        let sizes = |tiles: Vec<Tile>, method: Method| {
            let mut set = Set::new(Kind::Wang, tiles).unwrap();
            let mut sizes = Vec::new();
            for step in [method, Method::ToWang, method] {
                let converted = convert(&set, step).unwrap();
                sizes.push((converted.set.tiles().len(), converted.colors, converted.pairs));
                set = converted.set;
            }
            sizes
        };
        for method in Method::TO_CORNER {
            let turned = match method {
                Method::Horizontal => Method::Vertical,
                Method::Vertical => Method::Horizontal,
                other => other,
            };
            let here = sizes(tiles.clone(), method);
            prop_assert_eq!(&here, &sizes(renamed.clone().collect(), method));
            prop_assert_eq!(&here, &sizes(transposed.clone().collect(), turned));
        }
    }
}

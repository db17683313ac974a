//! Rings of dominoes, complete and not, and how many there are.

use crate::{check, complete};
use num_bigint::BigUint;
use proptest::prelude::*;
use tilepack::construct::ring::{least_color, least_position, wei_color, wei_position};
use tilepack::construct::{Digraph, NotConstructed, Ring, Seed, construct};
use tilepack::count::best;
use tilepack::packing::{self, Settings, Task};
use tilepack::tiles::{Color, Colors, Kind, Members, TileId, TileSet};
use tilepack::torus::Shape;

#[test]
fn closed_forms_both_ways() {
    for colors in (1..=40).chain([254, 255]) {
        let length = colors * colors;
        let least: Vec<u8> = (0..length).map(|p| least_color(colors, p)).collect();
        let wei: Vec<u8> = (0..length).map(wei_color).collect();
        for p in 0..length {
            let next = (p + 1) % length;
            assert_eq!(least_position(colors, least[p], least[next]), p, "{colors}");
            assert_eq!(wei_position(wei[p], wei[next]), p, "{colors}");
        }
    }
    let text = |colors, ring: fn(usize, usize) -> u8| -> String {
        (0..colors * colors).map(|p| ring(colors, p).to_string()).collect()
    };
    assert_eq!(text(3, least_color), "001021122");
    assert_eq!(text(3, |_, p| wei_color(p)), "001102122");
}

/// Taken in order, arcs give the greedy ring; the least of all starts with the least colors.
#[test]
fn the_least_ring_is_the_least() {
    let set = complete(Kind::Domino, "3");
    let task = Task::new(set, Shape::new(9, 1).unwrap());
    let first = packing::find(&task, &Settings::PLAIN).unwrap().value.unwrap();
    assert_eq!(Ring::least(3).colors(), first);
}

#[test]
fn rows_and_columns() {
    for (colors, w, h) in
        [("1", 1, 1), ("2", 4, 1), ("5", 1, 25), ("20", 400, 1), ("255", 65025, 1)]
    {
        let shape = Shape::new(w, h).unwrap();
        for seed in [None, Some(0), Some(1)] {
            check(&construct(&complete(Kind::Domino, colors), shape, seed).unwrap());
        }
    }
}

#[test]
fn pruned_and_explicit_sets() {
    let colors = Colors::one(6).unwrap();
    let pairs = vec![(Color(0), Color(1)), (Color(2), Color(3))];
    let pruned = TileSet::new(Kind::Domino, colors, Members::Pruned(pairs)).unwrap();
    let shape = Shape::default_for(&pruned).unwrap();
    check(&construct(&pruned, shape, None).unwrap());

    let explicit = |arcs: &[(u32, u32)]| {
        let tiles = arcs.iter().map(|&(x, y)| TileId(x * 6 + y)).collect();
        let set = TileSet::new(Kind::Domino, colors, Members::Explicit(tiles)).unwrap();
        let shape = Shape::default_for(&set).unwrap();
        construct(&set, shape, None)
    };
    check(&explicit(&[(1, 3), (3, 4), (4, 1), (3, 3)]).unwrap());
    for (arcs, reason) in [
        (&[(1, 3), (3, 3)][..], "vertex 1 has in-degree 0, out-degree 1"),
        (&[(1, 1), (4, 4)][..], "not connected, no way leads from vertex 1 to vertex 4"),
    ] {
        let Err(NotConstructed::Impossible(why)) = explicit(arcs) else { unreachable!() };
        assert!(why.contains(reason), "{why}");
    }
}

/// `(C!)^C / C^2` rings; each begins anywhere.
#[test]
fn numbers_of_rings() {
    for (colors, rings) in [(1, 1u64), (2, 1), (3, 24), (4, 20736), (5, 995_328_000)] {
        assert_eq!(best::rings(&Digraph::complete(colors)), BigUint::from(rings));
    }
    for colors in 1..=40u32 {
        let factorial: BigUint = (1..=colors).map(BigUint::from).product();
        let rings = factorial.pow(colors) / (colors * colors);
        assert_eq!(best::rings(&Digraph::complete(colors as usize)), rings, "{colors}");
    }
    let none = Digraph::new(3, vec![(0, 1)]);
    assert_eq!(best::packings(&none), BigUint::ZERO);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Random sets of dominoes: a search counts what the theorem says, and a ring is found just
    /// when there is one.
    #[test]
    fn counted_by_search_and_by_theorem(
        walks in prop::collection::vec(prop::collection::vec(0u32..5, 1..6), 1..4),
        seed in 0u64..1000,
    ) {
        // Closed walks, so that degrees mostly match; an arc that comes again is left out.
        let mut tiles: Vec<TileId> = walks
            .iter()
            .flat_map(|walk| (0..walk.len()).map(|i| (walk[i], walk[(i + 1) % walk.len()])))
            .map(|(x, y)| TileId(x * 5 + y))
            .collect();
        tiles.sort_unstable();
        tiles.dedup();
        let arcs: Vec<_> = tiles.iter().map(|t| ((t.0 / 5) as u8, (t.0 % 5) as u8)).collect();
        let colors = Colors::one(5).unwrap();
        let set = TileSet::new(Kind::Domino, colors, Members::Explicit(tiles)).unwrap();
        let shape = Shape::default_for(&set).unwrap();
        let task = Task::new(set.clone(), shape);
        let counted = match task.impossible() {
            Some(_) => BigUint::ZERO,
            None => packing::count(&task, &Settings::PLAIN, false).unwrap().value.packings,
        };
        prop_assert_eq!(&best::packings(&Digraph::new(5, arcs)), &counted);
        match construct(&set, shape, Some(seed)) {
            Ok(ring) => check(&ring),
            Err(_) => prop_assert_eq!(counted, BigUint::ZERO),
        }
    }

    #[test]
    fn random_rings_have_every_domino(colors in 1usize..12, seed in any::<u64>()) {
        let ring = Ring::random(colors, &mut Seed::new(seed));
        let mut seen = vec![false; colors * colors];
        for p in 0..ring.length() {
            let (x, y) = (ring.colors()[p], ring.colors()[(p + 1) % ring.length()]);
            prop_assert_eq!(ring.position(x, y), Some(p));
            prop_assert!(!std::mem::replace(&mut seen[usize::from(x) * colors + usize::from(y)], true));
        }
    }
}

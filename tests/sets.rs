//! Sizes of tile sets, by formula and by enumeration, against the published table.

#![allow(clippy::unwrap_used)]

use tilepack::tiles::{Color, Colors, Kind, Members, TileSet, formula};

/// Schlömer 2012, table 2.1: corner tiles over C colors with k disjoint excluded pairs.
const TABLE_2_1: &[(u64, u64, u64)] = &[
    (2, 0, 16),
    (2, 1, 2),
    (3, 0, 81),
    (3, 1, 31),
    (4, 0, 256),
    (4, 1, 146),
    (4, 2, 60),
    (5, 0, 625),
    (5, 1, 431),
    (5, 2, 261),
    (6, 0, 1296),
    (6, 1, 994),
    (6, 2, 716),
    (6, 3, 462),
    (9, 4, 3625),
];

fn set(kind: Kind, colors: Colors, members: Members) -> TileSet {
    TileSet::new(kind, colors, members).unwrap()
}

fn pairs(count: u64) -> Vec<(Color, Color)> {
    (0..count as u8).map(|i| (Color(2 * i), Color(2 * i + 1))).collect()
}

#[test]
fn schloemer_table_2_1() {
    for &(c, k, size) in TABLE_2_1 {
        let set = set(Kind::Corner, Colors::one(c).unwrap(), Members::Pruned(pairs(k)));
        assert_eq!(formula::disjoint_pairs(c, k), size, "closed form, C={c} k={k}");
        assert_eq!(set.size(), size, "sum over independent sets, C={c} k={k}");
        assert_eq!(set.allowed().count() as u64, size, "enumeration, C={c} k={k}");
    }
}

#[test]
fn formula_equals_enumeration_for_any_graph() {
    let palettes = [(1, 1), (2, 2), (3, 3), (4, 4), (5, 5), (2, 3), (4, 2), (1, 5)];
    for (h, v) in palettes {
        let colors = Colors::pair(h, v).unwrap();
        let largest = colors.largest() as u8;
        let edges: Vec<_> = (0..largest)
            .flat_map(|a| (a + 1..largest).map(move |b| (Color(a), Color(b))))
            .collect();
        for kind in [Kind::Corner, Kind::Wang, Kind::Domino] {
            if kind == Kind::Corner && h != v {
                continue;
            }
            let colors = if kind == Kind::Domino { colors.of_row() } else { colors };
            for graph in 0..1u32 << edges.len() {
                let chosen = edges.iter().enumerate();
                let chosen: Vec<_> =
                    chosen.filter(|(i, _)| graph >> i & 1 == 1).map(|(_, &e)| e).collect();
                let Ok(set) = TileSet::new(kind, colors, Members::Pruned(chosen)) else { continue };
                assert_eq!(set.size(), set.allowed().count() as u64, "{set:?}");
            }
        }
    }
}

#[test]
fn compact_and_complete_sizes() {
    for c in 1..=8 {
        let colors = Colors::one(c).unwrap();
        assert_eq!(set(Kind::Corner, colors, Members::Complete).size(), c.pow(4));
        assert_eq!(set(Kind::Wang, colors, Members::Complete).size(), c.pow(4));
        assert_eq!(set(Kind::Domino, colors, Members::Complete).size(), c.pow(2));
        assert_eq!(set(Kind::Corner, colors, Members::Compact).size(), 2 * c.pow(3));
        assert_eq!(set(Kind::Wang, colors, Members::Compact).size(), 2 * c.pow(2));
    }
}

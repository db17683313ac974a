//! Rings of dominoes against the BEST theorem (van Aardenne-Ehrenfest, de Bruijn 1951): the
//! Eulerian circuits of a digraph number `t * product of (degree - 1)!`, `t` the number of
//! spanning trees toward a root. It counts sets with hundreds of tiles, far beyond the oracle.

use proptest::prelude::*;
use tilepack::packing::{Job, Settings, Task, count};
use tilepack::search::Limits;
use tilepack::tiles::{Color, Colors, Domino, Kind, Members, TileSet, Wang};
use tilepack::torus::Shape;

/// The number of Eulerian circuits; `None` when it does not fit.
fn circuits(arcs: &[(u8, u8)], root: u8) -> Option<i128> {
    let mut vertices: Vec<u8> = arcs.iter().map(|arc| arc.0).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let degree = |v: u8| arcs.iter().filter(|arc| arc.0 == v).count() as i128;
    let others: Vec<u8> = vertices.iter().copied().filter(|&v| v != root).collect();
    let entry = |a: u8, b: u8| {
        let joined = arcs.iter().filter(|arc| **arc == (a, b)).count() as i128;
        if a == b { degree(a) - joined } else { -joined }
    };
    let rows: Vec<Vec<i128>> =
        others.iter().map(|&a| others.iter().map(|&b| entry(a, b)).collect()).collect();
    let mut product = determinant(rows)?;
    for v in vertices {
        for factor in 2..degree(v) {
            product = product.checked_mul(factor)?;
        }
    }
    Some(product)
}

/// By elimination without fractions (Bareiss).
fn determinant(mut m: Vec<Vec<i128>>) -> Option<i128> {
    let (n, mut last, mut sign) = (m.len(), 1, 1);
    for k in 0..n {
        let pivot = (k..n).find(|&row| m[row][k] != 0);
        let Some(pivot) = pivot else { return Some(0) };
        if pivot != k {
            m.swap(pivot, k);
            sign = -sign;
        }
        for i in k + 1..n {
            for j in k + 1..n {
                let (a, b) = (m[i][j].checked_mul(m[k][k])?, m[i][k].checked_mul(m[k][j])?);
                m[i][j] = a.checked_sub(b)? / last;
            }
        }
        last = m[k][k];
    }
    Some(sign * last)
}

#[test]
fn the_theorem_itself() {
    let complete =
        |c: u8| -> Vec<(u8, u8)> { (0..c).flat_map(|a| (0..c).map(move |b| (a, b))).collect() };
    for (colors, rings) in [(1, 1), (2, 1), (3, 24), (4, 20_736), (5, 995_328_000)] {
        assert_eq!(circuits(&complete(colors), 0), Some(rings));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 120, failure_persistence: None, ..ProptestConfig::default() })]

    /// Closed walks through color 0 laid over each other, and loops: up to some 150 tiles.
    #[test]
    fn eulerian_digraphs(
        walks in prop::collection::vec(prop::collection::vec(0u8..40, 1..40), 1..5),
        loops in prop::collection::btree_set(0u8..40, 0..40),
        down in any::<bool>(),
        wang in any::<bool>(),
    ) {
        let mut arcs = Vec::new();
        for walk in walks {
            // All arcs must be new, or the walk is left out.
            let mut around: Vec<(u8, u8)> = Vec::new();
            let mut at = 0;
            for to in walk.into_iter().chain([0]) {
                around.push((at, to));
                at = to;
            }
            let mut all = [&arcs[..], &around[..]].concat();
            all.sort_unstable();
            all.dedup();
            if all.len() == arcs.len() + around.len() {
                arcs = all;
            }
        }
        prop_assume!(!arcs.is_empty());
        for color in loops {
            if arcs.iter().any(|arc| arc.0 == color) && !arcs.contains(&(color, color)) {
                arcs.push((color, color));
            }
        }
        let circuits = circuits(&arcs, 0);
        prop_assume!(circuits.is_some_and(|circuits| circuits <= 50_000));
        let circuits = circuits.unwrap();
        let tiles = arcs.len() as u64;
        let (width, height) = if down { (1, tiles) } else { (tiles, 1) };
        let (kind, colors) = match (wang, down) {
            (false, _) => (Kind::Domino, Colors::one(40)),
            (true, true) => (Kind::Wang, Colors::pair(40, 1)),
            (true, false) => (Kind::Wang, Colors::pair(1, 40)),
        };
        let colors = colors.unwrap();
        let tile = |&(first, second): &(u8, u8)| {
            let (first, second, blank) = (Color(first), Color(second), Color(0));
            match (wang, down) {
                (false, _) => Domino { first, second }.id(colors),
                (true, true) => Wang { n: first, e: blank, s: second, w: blank }.id(colors),
                (true, false) => Wang { n: blank, e: second, s: blank, w: first }.id(colors),
            }
        };
        let tiles = Members::Explicit(arcs.iter().map(tile).collect());
        let set = TileSet::new(kind, colors, tiles).unwrap();
        let task = Task::new(set, Shape::new(width, height).unwrap());
        let what = format!("{arcs:?} {width}x{height} {kind}");
        let limits = Limits { nodes: 500_000, ..Limits::NONE };
        for (reduce, threads) in [(true, 1), (true, 3), (false, 2)] {
            let settings = Settings { limits, threads, ..Settings::PLAIN };
            let job = Job { reduce, ..Job::from(&task) };
            let counted = count(job, &settings, false).unwrap();
            // Some have too many dead ends.
            if counted.work.complete {
                let rings = counted.value.up_to_translation.unwrap();
                prop_assert_eq!(rings, u64::try_from(circuits).unwrap().into(), "{} {}", what, reduce);
            }
        }
    }
}

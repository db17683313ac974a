//! An empty power, checked by putting rows together one by one.

use super::{ClaimFault, sides};
use crate::tiles::Kind;
use std::collections::{BTreeMap, BTreeSet};

/// W end, E end, N label, S label of a column of tiles.
type Arc = [u32; 4];

pub(super) fn check(
    kind: Kind,
    tiles: &[[u32; 4]],
    rows: bool,
    power: usize,
    most: usize,
) -> Result<(), ClaimFault> {
    let mut labels = BTreeMap::new();
    let mut name = |label: (u32, u32)| {
        let new = labels.len() as u32;
        *labels.entry(label).or_insert(new)
    };
    let arc = |tile: &[u32; 4]| {
        let [n, e, s, w] = sides(kind, *tile).map(&mut name);
        if rows { [w, e, n, s] } else { [n, s, w, e] }
    };
    let row: BTreeSet<Arc> = tiles.iter().map(arc).collect();
    let row = cut(row);
    let mut arcs = row.clone();
    for _ in 1..power {
        let mut readers: BTreeMap<u32, Vec<Arc>> = BTreeMap::new();
        row.iter().for_each(|&arc| readers.entry(arc[2]).or_default().push(arc));
        let mut ends: BTreeMap<(u32, u32), u32> = BTreeMap::new();
        let mut next = BTreeSet::new();
        for upper in &arcs {
            for lower in readers.get(&upper[3]).into_iter().flatten() {
                let mut end = |place: usize| {
                    let new = ends.len() as u32;
                    *ends.entry((upper[place], lower[place])).or_insert(new)
                };
                next.insert([end(0), end(1), upper[2], lower[3]]);
            }
            if next.len() > most {
                return Err(ClaimFault::TooLarge(most));
            }
        }
        arcs = cut(next);
    }
    let of = if rows { "rows" } else { "columns" };
    match arcs.len() {
        0 => Ok(()),
        arcs => Err(ClaimFault::Left { power, of, arcs }),
    }
}

/// Only the arcs that are on a cycle of ends and on a cycle of labels, again and again.
fn cut(mut arcs: BTreeSet<Arc>) -> BTreeSet<Arc> {
    loop {
        let before = arcs.len();
        for (from, to) in [(0, 1), (2, 3)] {
            let part = parts(&arcs, from, to);
            arcs.retain(|arc| part[&arc[from]] == part[&arc[to]]);
        }
        if arcs.len() == before {
            return arcs;
        }
    }
}

/// For every vertex its strongly connected part: first all vertices in the order in which a walk
/// leaves them, then, from the last one left on, what leads to each (Kosaraju 1978).
fn parts(arcs: &BTreeSet<Arc>, from: usize, to: usize) -> BTreeMap<u32, u32> {
    let mut there: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    let mut back: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for arc in arcs {
        there.entry(arc[from]).or_default().push(arc[to]);
        there.entry(arc[to]).or_default();
        back.entry(arc[to]).or_default().push(arc[from]);
    }
    let mut left = Vec::new();
    let mut met = BTreeSet::new();
    for &root in there.keys() {
        // A vertex is put down twice: to be entered, then to be left.
        let mut stack = vec![(root, false)];
        while let Some((vertex, leave)) = stack.pop() {
            if leave {
                left.push(vertex);
            } else if met.insert(vertex) {
                stack.push((vertex, true));
                stack.extend(there[&vertex].iter().map(|&next| (next, false)));
            }
        }
    }
    let mut part = BTreeMap::new();
    for &root in left.iter().rev() {
        let mut stack = vec![root];
        while let Some(vertex) = stack.pop() {
            if part.contains_key(&vertex) {
                continue;
            }
            part.insert(vertex, root);
            stack.extend(back.get(&vertex).into_iter().flatten());
        }
    }
    part
}

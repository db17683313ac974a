//! Whether two sets are the same up to the symmetries of the square and the names of labels.
//!
//! Tiles are matched one by one; a match must extend the names given so far, each space of labels
//! one-to-one. The next tile to match is always one that shares a label with an earlier one, so
//! mistakes show early.

use crate::aperiodic::Set;
use crate::tiles::Kind;
use std::collections::{HashMap, HashSet};

/// How a set becomes another one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Likeness {
    /// The side of the first set that becomes side 0, 1, 2, 3 of the second one.
    pub sides: [usize; 4],
    /// For each tile of the first set the number of the one it becomes.
    pub tiles: Vec<usize>,
}

/// The eight symmetries of the square, on four sides (or corners) listed clockwise.
pub const SYMMETRIES: [[usize; 4]; 8] = [
    [0, 1, 2, 3],
    [1, 2, 3, 0],
    [2, 3, 0, 1],
    [3, 0, 1, 2],
    [3, 2, 1, 0],
    [2, 1, 0, 3],
    [1, 0, 3, 2],
    [0, 3, 2, 1],
];

/// How the first set becomes the second one, if it can.
pub fn likeness(first: &Set, second: &Set) -> Option<Likeness> {
    if first.kind() != second.kind() || first.tiles().len() != second.tiles().len() {
        return None;
    }
    SYMMETRIES.into_iter().find_map(|sides| {
        let moved = first.tiles().iter().map(|tile| sides.map(|side| tile[side]));
        let tiles = renaming(first.kind(), &moved.collect::<Vec<_>>(), second.tiles())?;
        Some(Likeness { sides, tiles })
    })
}

/// The space of labels that each side takes from.
fn spaces(kind: Kind) -> [u32; 4] {
    if kind == Kind::Wang { [0, 1, 0, 1] } else { [0; 4] }
}

/// Names of labels, in both directions.
#[derive(Default)]
struct Names {
    there: HashMap<(u32, u32), u32>,
    back: HashMap<(u32, u32), u32>,
}

impl Names {
    /// Names the labels of a tile as those of another one; gives those that are new, or `None`
    /// when that contradicts the names so far.
    fn take(&mut self, spaces: [u32; 4], from: [u32; 4], to: [u32; 4]) -> Option<Vec<usize>> {
        let mut new = Vec::new();
        for side in 0..4 {
            let (there, back) = ((spaces[side], from[side]), (spaces[side], to[side]));
            match (self.there.get(&there), self.back.get(&back)) {
                (Some(&a), Some(&b)) if a == to[side] && b == from[side] => {}
                (None, None) => {
                    self.there.insert(there, to[side]);
                    self.back.insert(back, from[side]);
                    new.push(side);
                }
                _ => {
                    self.forget(spaces, from, to, &new);
                    return None;
                }
            }
        }
        Some(new)
    }

    fn forget(&mut self, spaces: [u32; 4], from: [u32; 4], to: [u32; 4], new: &[usize]) {
        for &side in new {
            self.there.remove(&(spaces[side], from[side]));
            self.back.remove(&(spaces[side], to[side]));
        }
    }
}

/// For each of the first tiles the one it becomes when labels are renamed.
fn renaming(kind: Kind, first: &[[u32; 4]], second: &[[u32; 4]]) -> Option<Vec<usize>> {
    let spaces = spaces(kind);
    let (one, other) = (signatures(spaces, first), signatures(spaces, second));
    let (mut a, mut b) = (one.clone(), other.clone());
    a.sort_unstable();
    b.sort_unstable();
    if a != b {
        return None;
    }
    let order = order(spaces, first);
    let mut names = Names::default();
    let mut used = vec![false; second.len()];
    // For each tile matched: the one it becomes, and the sides with new names.
    let mut path: Vec<(usize, Vec<usize>)> = Vec::new();
    let mut next = 0;
    while let Some(&tile) = order.get(path.len()) {
        let choice = (next..second.len()).find_map(|to| {
            let may = !used[to] && one[tile] == other[to];
            let new = if may { names.take(spaces, first[tile], second[to]) } else { None };
            Some((to, new?))
        });
        if let Some((to, new)) = choice {
            used[to] = true;
            path.push((to, new));
            next = 0;
            continue;
        }
        let (to, new) = path.pop()?;
        names.forget(spaces, first[order[path.len()]], second[to], &new);
        used[to] = false;
        next = to + 1;
    }
    let mut tiles = vec![0; first.len()];
    order.iter().zip(&path).for_each(|(&tile, (to, _))| tiles[tile] = *to);
    Some(tiles)
}

/// What a renaming leaves as it is: how often the labels of a tile are on each side of a tile.
fn signatures(spaces: [u32; 4], tiles: &[[u32; 4]]) -> Vec<Vec<u32>> {
    let mut often: HashMap<(u32, u32), [u32; 4]> = HashMap::new();
    for tile in tiles {
        for side in 0..4 {
            often.entry((spaces[side], tile[side])).or_default()[side] += 1;
        }
    }
    let of = |tile: &[u32; 4]| (0..4).flat_map(|side| often[&(spaces[side], tile[side])]).collect();
    tiles.iter().map(of).collect()
}

/// The tiles in an order in which each shares as many labels as can be with those before.
fn order(spaces: [u32; 4], tiles: &[[u32; 4]]) -> Vec<usize> {
    let mut known: HashSet<(u32, u32)> = HashSet::new();
    let mut order: Vec<usize> = Vec::new();
    let mut left: Vec<usize> = (0..tiles.len()).collect();
    while !left.is_empty() {
        let shared = |&tile: &usize| {
            (0..4).filter(|&s| known.contains(&(spaces[s], tiles[tile][s]))).count()
        };
        let best = (0..left.len()).max_by_key(|&i| (shared(&left[i]), left.len() - i)).unwrap_or(0);
        let tile = left.remove(best);
        known.extend((0..4).map(|s| (spaces[s], tiles[tile][s])));
        order.push(tile);
    }
    order
}

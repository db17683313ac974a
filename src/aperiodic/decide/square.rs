//! The smallest square that cannot be filled, by backtracking that remembers.
//!
//! Cells are filled row by row from the north-west. What is left to fill depends only on the cell
//! and on the labels that border on what is filled (one for each column, and the E label of the
//! last tile), so borders that led nowhere are kept, and given up at once when met again.

use super::form::{Tile, labels};
use crate::search::Stop;
use std::collections::HashSet;

/// What became of a square.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Square {
    /// It can be filled.
    Filled,
    /// It cannot; after so many tiles placed.
    Impossible(u64),
    /// Not known: more tiles would have to be placed than were allowed.
    Stopped,
}

/// The side of the smallest square that cannot be filled, and the tiles placed in vain in it;
/// `None` when all up to `most` can be, or the limits are reached.
pub fn smallest(tiles: &[Tile], most: usize, nodes: u64, stop: &dyn Stop) -> Option<(usize, u64)> {
    for side in 1..=most {
        match fill(tiles, side, nodes, stop) {
            Square::Filled => {}
            Square::Impossible(nodes) => return Some((side, nodes)),
            Square::Stopped => return None,
        }
    }
    None
}

/// No label yet.
const FREE: u32 = u32::MAX;

/// Fills a square, or finds out that it cannot be done.
pub fn fill(tiles: &[Tile], side: usize, nodes: u64, stop: &dyn Stop) -> Square {
    let (h, v) = labels(tiles);
    // Tiles for each N and W label, or for any.
    let at = |n: u32, w: u32| (n.min(h as u32) as usize) * (v + 1) + w.min(v as u32) as usize;
    let mut fitting: Vec<Vec<u32>> = vec![Vec::new(); (h + 1) * (v + 1)];
    for (number, tile) in (0..).zip(tiles) {
        for (n, w) in [(tile[0], tile[3]), (tile[0], FREE), (FREE, tile[3]), (FREE, FREE)] {
            fitting[at(n, w)].push(number);
        }
    }
    let mut border = vec![FREE; side];
    let mut west = FREE;
    let mut hopeless: HashSet<Vec<u32>> = HashSet::new();
    // For each filled cell: the choice, and the labels that it covered.
    let mut path: Vec<(usize, u32, u32)> = Vec::with_capacity(side * side);
    let mut next = 0;
    let mut placed = 0u64;
    loop {
        let cell = path.len();
        let column = cell % side;
        if cell == side * side {
            return Square::Filled;
        }
        let west_here = if column == 0 { FREE } else { west };
        let key = |border: &[u32]| {
            let mut key = Vec::with_capacity(side + 2);
            key.extend([cell as u32, west_here]);
            key.extend(border);
            key
        };
        let choices = &fitting[at(border[column], west_here)];
        let known = next == 0 && choices.len() > 1 && hopeless.contains(&key(&border));
        match choices.get(next) {
            Some(&tile) if !known => {
                placed += 1;
                if placed > nodes || placed.is_multiple_of(4096) && stop.should_stop() {
                    return Square::Stopped;
                }
                path.push((next, border[column], west));
                border[column] = tiles[tile as usize][2];
                west = tiles[tile as usize][1];
                next = 0;
            }
            _ => {
                if choices.len() > 1 && !known {
                    hopeless.insert(key(&border));
                }
                let Some((choice, north, before)) = path.pop() else {
                    return Square::Impossible(placed);
                };
                (border[path.len() % side], west) = (north, before);
                next = choice + 1;
            }
        }
    }
}

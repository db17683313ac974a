//! When horizontal and vertical translation are sound.
//!
//! Two corner tiles of *horizontal* lie side by side when they agree in the N and S of the Wang
//! tile between them. But a set may have two tiles with equal N and S: the one then comes from a
//! pair that ends with the first, the other from a pair that begins with the second, and what lies
//! between is a *mixed* tile, with the W of the one and the E of the other. So corner tilings are
//! tilings by the Wang set **with all mixed tiles**, and that set may well be periodic.
//!
//! Lagae (2007, 8.3.2) asks only that different pairs give different corner tiles. That is not
//! enough: his set of 44 tiles over 6 colors is periodic. What is enough is that there are no
//! mixed tiles, or that the set with them is known to be aperiodic.

use super::Set;
use super::convert::Method;
use std::collections::{BTreeSet, HashMap};

/// The mixed tiles of a Wang set, sorted: tiles that it does not have. Empty for all methods but
/// *horizontal* and *vertical*.
pub fn mixed(set: &Set, method: Method) -> Vec<[u32; 4]> {
    let known: BTreeSet<[u32; 4]> = set.tiles().iter().copied().collect();
    // What must be equal, and the two labels that get mixed: the first side and the opposite one.
    let (equal, sides) = match method {
        Method::Horizontal => ([0, 2], [1, 3]),
        Method::Vertical => ([1, 3], [0, 2]),
        _ => return Vec::new(),
    };
    let mut alike: HashMap<[u32; 2], Vec<[u32; 4]>> = HashMap::new();
    for &tile in set.tiles() {
        alike.entry(equal.map(|side| tile[side])).or_default().push(tile);
    }
    let mut mixed = BTreeSet::new();
    for tiles in alike.values() {
        for &one in tiles {
            for other in tiles {
                let mut tile = one;
                tile[sides[0]] = other[sides[0]];
                if !known.contains(&tile) {
                    mixed.insert(tile);
                }
            }
        }
    }
    mixed.into_iter().collect()
}

/// The set with its mixed tiles: the one whose tilings the corner tilings are.
pub fn enlarged(set: &Set, method: Method) -> Set {
    let tiles = [set.tiles(), &mixed(set, method)].concat();
    Set::of_different(set.kind(), tiles)
}

//! A set like another one: the symmetry, the tiles one to one, the labels one to one.

use super::ClaimFault;
use crate::tiles::Kind;
use std::collections::{BTreeMap, BTreeSet};

pub(super) fn check(
    kind: Kind,
    tiles: &[[u32; 4]],
    other: &[[u32; 4]],
    sides: [usize; 4],
    images: &[usize],
) -> Result<(), ClaimFault> {
    let unlike = |why: String| Err(ClaimFault::Unlike(why));
    // A turn goes on by one side from each to the next, a reflection back by one.
    let turns = [1, 3]
        .into_iter()
        .any(|by| sides[0] < 4 && (1..4).all(|side| sides[side] == (sides[side - 1] + by) % 4));
    if !turns {
        return unlike(format!("{sides:?} is no symmetry of the square"));
    }
    if images.len() != tiles.len() || tiles.len() != other.len() {
        let counts = (tiles.len(), images.len(), other.len());
        return unlike(format!(
            "{} tiles, {} images, {} tiles there",
            counts.0, counts.1, counts.2
        ));
    }
    let mut taken = BTreeSet::new();
    // Labels of N and S are one space, those of E and W another one; corners have but one.
    let space = |side: usize| if kind == Kind::Wang { side % 2 } else { 0 };
    let (mut there, mut back) = (BTreeMap::new(), BTreeMap::new());
    for (number, (tile, &image)) in tiles.iter().zip(images).enumerate() {
        let Some(target) = other.get(image).filter(|_| taken.insert(image)) else {
            return unlike(format!("tile {number} becomes {image}: no such tile, or taken"));
        };
        for side in 0..4 {
            let (mine, theirs) = ((space(side), tile[sides[side]]), (space(side), target[side]));
            let same = *there.entry(mine).or_insert(theirs) == theirs
                && *back.entry(theirs).or_insert(mine) == mine;
            if !same {
                return unlike(format!("tile {number} becomes {image}, but not by new names"));
            }
        }
    }
    Ok(())
}

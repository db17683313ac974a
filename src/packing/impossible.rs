//! Short arguments that no packing exists, without a search.
//!
//! * On a torus of height 1 a tile meets itself: north and south side agree. A set with a tile
//!   whose sides differ has no packing. Likewise for width 1.
//! * On a torus with a side of 2 a window of one color shows twice, in neighboring cells. A
//!   set that needs such a tile exactly once has no packing. (Lagae 2007, 5.5; for complete
//!   corner sets it means that both sides must be at least 3.)
//! * Every side of a tile is shared by a neighbor's opposite side, so in a packing of a fixed
//!   set the tops show the same colors, equally often, as the bottoms; likewise left and right.
//!   For dominoes this is the degree condition of Euler.
//! * A compact set needs two different tiles where only the free sides may differ.

use super::Task;
use crate::tiles::{Kind, TileId, TileSet};
use std::collections::BTreeMap;

/// The first argument that applies.
pub(super) fn reason(task: &Task) -> Option<String> {
    compact_needs_a_choice(&task.set)
        .or_else(|| meets_itself(task))
        .or_else(|| shows_twice(task))
        .or_else(|| unbalanced(task))
}

fn compact_needs_a_choice(set: &TileSet) -> Option<String> {
    if !set.is_compact() {
        return None;
    }
    let (h, v) = (set.colors().horizontal(), set.colors().vertical());
    match set.kind() {
        Kind::Corner if h < 2 => Some(
            "a compact corner set has two tiles with different NE, but there is one color".into(),
        ),
        Kind::Wang if h * v < 2 => {
            Some("a compact Wang set has two tiles for each (N, W), but there is one tile".into())
        }
        _ => None,
    }
}

/// The colors a tile shows on its (top, bottom, left, right).
fn borders(set: &TileSet, tile: TileId) -> [(u8, u8); 4] {
    let s = set.kind().unpack(tile, set.colors());
    match set.kind() {
        // NE, SE, SW, NW
        Kind::Corner => [(s[3], s[0]), (s[2], s[1]), (s[3], s[2]), (s[0], s[1])],
        // N, E, S, W
        Kind::Wang => [(s[0], 0), (s[2], 0), (s[3], 0), (s[1], 0)],
        // The ends of a domino are its left and right, whichever way the ring lies.
        Kind::Domino => [(0, 0), (0, 0), (s[0], 0), (s[1], 0)],
    }
}

fn meets_itself(task: &Task) -> Option<String> {
    let (w, h) = (task.shape.width(), task.shape.height());
    let set = &task.set;
    let (across, down) = match set.kind() {
        Kind::Domino => (w * h == 1, false),
        _ => (w == 1, h == 1),
    };
    if set.is_compact() {
        // Every choice of the fixed sides occurs: for corners also one where they disagree; for
        // edges the two tiles of a choice must then differ on the other axis.
        let colors = set.colors();
        let lone = |count: usize| count < 2;
        let fails = match set.kind() {
            Kind::Wang => {
                (across && lone(colors.horizontal())) || (down && lone(colors.vertical()))
            }
            _ => across || down,
        };
        return fails.then(|| {
            format!("size {}: with a side of 1 a tile is its own neighbor, and too few match themselves", task.shape)
        });
    }
    if !across && !down {
        return None;
    }
    let differs = |&tile: &TileId| {
        let [top, bottom, left, right] = borders(set, tile);
        (down && top != bottom) || (across && left != right)
    };
    set.allowed().find(differs).map(|tile| {
        let sides = set.kind().describe(tile, set.colors());
        format!(
            "size {}: with a side of 1 a tile is its own neighbor, but tile {tile} ({sides}) does not \
             match itself",
            task.shape
        )
    })
}

fn shows_twice(task: &Task) -> Option<String> {
    let set = &task.set;
    let narrow = task.shape.width() == 2 || task.shape.height() == 2;
    if task.cover || set.kind() != Kind::Corner || set.is_compact() || !narrow {
        return None;
    }
    let constant = set.allowed().find(|&tile| {
        let sides = set.kind().unpack(tile, set.colors());
        sides.iter().all(|&c| c == sides[0])
    })?;
    let color = set.kind().unpack(constant, set.colors())[0];
    Some(format!(
        "size {}: both sides must be at least 3, for with a side of 2 the tile with {color} on all corners \
         would show twice, in neighboring cells",
        task.shape
    ))
}

fn unbalanced(task: &Task) -> Option<String> {
    let set = &task.set;
    if task.cover || set.is_compact() {
        return None;
    }
    let mut surplus: [BTreeMap<(u8, u8), i64>; 2] = Default::default();
    for tile in set.allowed() {
        let [top, bottom, left, right] = borders(set, tile);
        for (axis, from, to) in [(0, top, bottom), (1, left, right)] {
            *surplus[axis].entry(from).or_default() += 1;
            *surplus[axis].entry(to).or_default() -= 1;
        }
    }
    let names = match set.kind() {
        Kind::Domino => [("top", "bottom"), ("first end", "second end")],
        _ => [("top", "bottom"), ("left", "right")],
    };
    for (axis, (more, less)) in names.into_iter().enumerate() {
        let Some((&(a, b), &count)) = surplus[axis].iter().find(|(_, count)| **count != 0) else {
            continue;
        };
        let colors = if set.kind() == Kind::Corner {
            format!("colors {a},{b}")
        } else {
            format!("color {a}")
        };
        let (more, less) = if count > 0 { (more, less) } else { (less, more) };
        let count = count.abs();
        return Some(format!(
            "unbalanced set: {count} more tiles have {colors} on the {more} than on the {less}"
        ));
    }
    None
}

//! Short arguments that no packing of a board exists.
//!
//! Every side of a square meets another side of its color, or the border. Where the whole border
//! is prescribed (or there is none), the sides of a color less those at the border pair up:
//! their number is even, and never negative. Tiles that are not turned pair tops with bottoms
//! and right sides with left ones, so that these are equally many.

use super::Task;
use super::board_caps::sides_left;
use crate::tiles::Kind;

/// The first argument that applies.
pub(super) fn reason(task: &Task) -> Option<String> {
    if task.board.rotations { unpaired(task) } else { unbalanced(task) }
}

/// Whether every outer place of these sides has a color prescribed.
fn is_closed(task: &Task, sides: [usize; 2]) -> bool {
    let mut outer = task.edges().outer();
    let free = |side, at| task.board.border.color(side, at).is_none();
    !outer.any(|(side, at, _)| sides.contains(&side) && free(side, at))
}

fn unpaired(task: &Task) -> Option<String> {
    let closed = is_closed(task, [0, 2]) && is_closed(task, [1, 3]);
    let given = task.edges().given(&task.board.border);
    let at_border = |color: usize| {
        given.iter().filter(|given| given.is_some_and(|given| usize::from(given) == color)).count()
    };
    for (color, left) in sides_left(task, &given).into_iter().enumerate() {
        let border = at_border(color);
        let sides = left + border as i64;
        if left < 0 {
            return Some(format!(
                "color {color} is on {sides} sides of the squares, fewer than the {border} places \
                 of the border that show it"
            ));
        }
        if closed && left % 2 != 0 {
            return Some(format!(
                "color {color} is on {sides} sides of the squares, {border} of them at the \
                 border: {left} others cannot pair up, for that is odd"
            ));
        }
    }
    None
}

fn unbalanced(task: &Task) -> Option<String> {
    let colors = task.set.colors();
    let axes = [([0, 2], colors.horizontal()), ([3, 1], colors.vertical())];
    for ([from, to], palette) in axes {
        if !is_closed(task, [from, to]) {
            continue;
        }
        for color in 0..palette as u8 {
            let inner = |side: usize| {
                let tiles = task.set.allowed().map(|tile| Kind::Wang.unpack(tile, colors));
                let all = tiles.filter(|sides| sides[side] == color).count() as i64;
                let border = task.board.border.side(side).iter();
                all - border.filter(|given| **given == Some(color)).count() as i64
            };
            let (a, b) = (inner(from), inner(to));
            let [from, to] = [from, to].map(|side| crate::torus::board::SIDES[side]);
            if a != b {
                return Some(format!(
                    "unbalanced set: off the border, color {color} is on {a} {from} sides, but on \
                     {b} {to} sides"
                ));
            }
        }
    }
    None
}

//! All places where a field breaks a rule, in a few steps a cell: runs are counted along lines.
//!
//! [`Rule::first_fault`] asks the same of every window, and is what tests compare this with.

use super::{Condition, Direction, FREE, Field, Limit, Rule};
use std::ops::ControlFlow;

/// Counts on the runs of a direction in a row of cells, from those before it.
fn count(tiles: &[u8], set: u64, runs: &mut [u32], horizontal: bool) {
    let holds = |tile: u8| tile != FREE && set >> (tile & 63) & 1 == 1;
    let mut last = runs.last().copied().unwrap_or_default();
    for (run, &tile) in runs.iter_mut().zip(tiles) {
        let before = if horizontal { last } else { *run };
        last = if holds(tile) { before + 1 } else { 0 };
        *run = last;
    }
}

/// Tells `found` of every window that is broken: its direction, its last cell and its length. A
/// line that meets its end and is all alike is told of as a whole, by each cell that has a limit.
fn visit(
    rule: &Rule,
    field: &Field,
    mut found: impl FnMut(Direction, usize, usize) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let (width, height) = (rule.width(), rule.height());
    for Condition { set, direction, limit } in rule.conditions() {
        let horizontal = *direction == Direction::Horizontal;
        let meets = rule.edges().meet(*direction);
        let length = if horizontal { width } else { height };
        // For every column the run that ends in the row that was counted last.
        let mut runs = vec![0; width];
        if meets && !horizontal {
            field.rows().for_each(|tiles| count(tiles, *set, &mut runs, false));
        }
        for (row, tiles) in field.rows().enumerate() {
            if horizontal {
                runs.fill(0);
            }
            if horizontal && meets {
                count(tiles, *set, &mut runs, true);
            }
            count(tiles, *set, &mut runs, horizontal);
            let first = row * width;
            let least = match limit {
                Limit::None => continue,
                Limit::Same(limit) => *limit,
                Limit::Map(map) => map[first..first + width].iter().copied().min().unwrap_or(0),
            };
            let maybe = runs.iter().any(|&run| run > least) || meets && length <= least as usize;
            if !maybe {
                continue;
            }
            for (column, &run) in runs.iter().enumerate() {
                let Some(limit) = limit.at(first + column) else { continue };
                // A run longer than the line is all of it, however long it may be.
                let all = meets && run as usize > length;
                if all || run > limit {
                    let window = if all { length } else { limit as usize + 1 };
                    found(*direction, first + column, window)?;
                }
            }
        }
    }
    ControlFlow::Continue(())
}

/// Whether a field breaks nothing; free cells hold nothing.
pub fn is_faultless(rule: &Rule, field: &Field) -> bool {
    visit(rule, field, |_, _, _| ControlFlow::Break(())).is_continue()
}

/// For every cell whether it lies in a window that is broken.
pub fn broken(rule: &Rule, field: &Field) -> Vec<bool> {
    let (width, height) = (rule.width(), rule.height());
    let mut broken = vec![false; width * height];
    let _ = visit(rule, field, |direction, last, length| {
        let (column, row) = (last % width, last / width);
        for back in 0..length {
            let cell = match direction {
                Direction::Horizontal => row * width + (column + width - back) % width,
                Direction::Vertical => (row + height - back) % height * width + column,
            };
            broken[cell] = true;
        }
        ControlFlow::Continue(())
    });
    broken
}

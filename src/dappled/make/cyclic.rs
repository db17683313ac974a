//! Algorithm 2: two labels, lines that meet their end, limits of 3 and more.
//!
//! As Algorithm 1, but near the ends of a line limits are tighter: the first cells of a line may
//! not be all alike up to the last but two that a limit allows, and the last cell counts the run
//! that it closes around the seam. A line that is no longer than its limit must not be all alike.
//!
//! Source: Kaji, Derouet-Jourdan, Ochiai, *Dappled tiling*, 2016, Algorithm 2. Its further rules
//! for limits of 2 fail for some fields and are not used. Nor is what comes out taken on trust here:
//! [`super::make()`] checks it.

use super::super::{Direction, Edges, Field, Limit};
use super::scheme::Classes;

/// A line and what it may not do.
struct Line<'a> {
    cells: &'a [u8],
    /// Its first cell.
    first: usize,
    /// From a cell to the next one.
    step: usize,
    length: usize,
    /// Whether it meets its end.
    meets: bool,
}

impl Line<'_> {
    fn at(&self, at: usize) -> u8 {
        self.cells[self.first + at * self.step]
    }

    /// Whether the cell at a place repeats too often, given the limit of its label.
    fn is_broken(&self, at: usize, limit: u32) -> bool {
        let (label, limit) = (self.at(at), limit as usize);
        let all = |from: usize, to: usize| (from..to).all(|other| self.at(other) == label);
        if !self.meets {
            return at >= limit && all(at - limit, at);
        }
        if limit >= self.length {
            return at + 1 == self.length && all(0, at);
        }
        if at + 1 == self.length {
            let before = (0..=at).rev().take_while(|&other| self.at(other) == label).count();
            let after = (0..at).take_while(|&other| self.at(other) == label).count();
            return before + after > limit;
        }
        if at + 2 == limit {
            return all(0, at);
        }
        at >= limit && all(at - limit, at)
    }
}

/// Changes labels 0 and 1. The limits are the same in all cells, and no less than 3.
pub fn rectify(field: &mut Field, classes: &Classes, edges: Edges) {
    let (width, height) = (field.width(), field.height());
    let limit = |limit: &Limit| match limit {
        Limit::Same(limit) => Some(*limit),
        _ => None,
    };
    let (horizontal, vertical) = (classes.horizontal.map(limit), classes.vertical.map(limit));
    let is_broken = |cells: &[u8], column: usize, row: usize| {
        let label = usize::from(cells[row * width + column] & 1);
        let in_row = horizontal[label].is_some_and(|limit| {
            let meets = edges.meet(Direction::Horizontal);
            let line = Line { cells, first: row * width, step: 1, length: width, meets };
            line.is_broken(column, limit)
        });
        in_row
            || vertical[label].is_some_and(|limit| {
                let meets = edges.meet(Direction::Vertical);
                let line = Line { cells, first: column, step: width, length: height, meets };
                line.is_broken(row, limit)
            })
    };
    let cells = field.cells_mut();
    for weight in 0..width + height - 1 {
        for column in (weight + 1).saturating_sub(height)..width.min(weight + 1) {
            let row = weight - column;
            let cell = row * width + column;
            if !is_broken(cells, column, row) {
                continue;
            }
            cells[cell] ^= 1;
            if column > 0 && row > 0 && is_broken(cells, column, row) {
                let corner = cells[cell - width - 1];
                cells[cell] = corner;
                cells[cell - 1] = corner ^ 1;
                cells[cell - width] = corner ^ 1;
            }
        }
    }
}

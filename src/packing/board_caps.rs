//! How many sides of every color are left, on boards of squares that may be turned.
//!
//! Every color laid at a place where no neighbor lies yet asks for a side of that color among
//! the squares still to be laid. So for each color the sides not yet used, less those already
//! asked for, is never negative: a place between two cells takes 2 of it, when the first of the
//! two is laid, a free outer place 1, and a prescribed color has taken its own beforehand. On a
//! torus, or where the whole border is prescribed, this says how many inner edges of the color
//! are still to come: exactly half of it.
//!
//! A color without any left is *closed*: no square may show it to a cell that is still empty.
//! With a border of a color of its own that keeps the squares of the border out of the middle
//! from the start.

use super::Task;
use super::table::Table;
use crate::tiles::Kind;

/// A color that is never used up, for what asks for nothing.
pub(super) const ENDLESS: u8 = u8::MAX;

/// What is left of every color.
#[derive(Debug, Clone)]
pub(super) struct Caps {
    left: Table<i32, 256>,
    counts: bool,
}

impl Caps {
    /// No color is counted.
    pub(super) fn none() -> Self {
        Self { left: Table::new(Vec::new(), 1), counts: false }
    }

    /// For a task with these colors prescribed.
    pub(super) fn new(task: &Task, given: &[Option<u8>]) -> Self {
        let left = sides_left(task, given).into_iter().map(|left| left as i32);
        Self { left: Table::new(left.collect(), 1), counts: true }
    }

    /// Whether any color is counted.
    pub(super) fn counts(&self) -> bool {
        self.counts
    }

    /// The first two of the colors asked for, where colors are counted. More are asked for only
    /// at free outer sides, and by the first cells of all.
    pub(super) fn asked(&self, mut colors: impl Iterator<Item = u8>) -> [u8; 2] {
        let mut next = || colors.next().filter(|_| self.counts).unwrap_or(ENDLESS);
        [next(), next()]
    }

    /// Whether a color asked for is closed.
    #[inline(always)]
    pub(super) fn are_closed(&self, [a, b]: [u8; 2]) -> bool {
        self.left[usize::from(a)].min(self.left[usize::from(b)]) <= 0
    }

    /// Uses up sides of a color.
    #[inline(always)]
    pub(super) fn take(&mut self, color: u8, cost: u8) {
        if self.counts {
            self.left[usize::from(color)] -= i32::from(cost);
        }
    }

    /// Gives them back.
    #[inline(always)]
    pub(super) fn give(&mut self, color: u8, cost: u8) {
        if self.counts {
            self.left[usize::from(color)] += i32::from(cost);
        }
    }

    /// Uses up sides of the colors asked for, however often they are.
    #[inline(always)]
    pub(super) fn take_both(&mut self, [a, b]: [u8; 2], [cost_a, cost_b]: [u8; 2]) {
        self.left[usize::from(a)] -= i32::from(cost_a);
        self.left[usize::from(b)] -= i32::from(cost_b);
    }

    /// Gives them back.
    #[inline(always)]
    pub(super) fn give_both(&mut self, [a, b]: [u8; 2], [cost_a, cost_b]: [u8; 2]) {
        self.left[usize::from(a)] += i32::from(cost_a);
        self.left[usize::from(b)] += i32::from(cost_b);
    }
}

/// By color: the sides of all squares, less those at the prescribed places of the border (and
/// two for a color given between two cells).
pub(super) fn sides_left(task: &Task, given: &[Option<u8>]) -> Vec<i64> {
    let colors = task.set.colors();
    let mut left = vec![0; colors.largest()];
    for tile in task.set.allowed() {
        for color in Kind::Wang.unpack(tile, colors) {
            left[usize::from(color)] += 1;
        }
    }
    let edges = task.edges();
    let mut outer = vec![false; edges.labels()];
    edges.outer().for_each(|(_, _, place)| outer[place] = true);
    for (place, color) in given.iter().enumerate() {
        if let Some(color) = color {
            left[usize::from(*color)] -= if outer[place] { 1 } else { 2 };
        }
    }
    left
}

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
use crate::tiles::Kind;

/// The number of colors that are counted.
const COLORS: usize = 64;

/// What is left of every color.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Caps {
    left: [i32; COLORS],
    /// The colors with none left, one bit each.
    closed: u64,
    counts: bool,
}

impl Caps {
    /// No color is counted.
    pub(super) fn none() -> Self {
        Self { left: [0; COLORS], closed: 0, counts: false }
    }

    /// For a task with at most 64 colors and these prescribed.
    pub(super) fn new(task: &Task, given: &[Option<u8>]) -> Self {
        let left = sides_left(task, given);
        let mut caps = Self { left: [0; COLORS], closed: 0, counts: true };
        for (color, left) in left.into_iter().enumerate().take(COLORS) {
            caps.left[color] = left as i32;
            caps.close(color);
        }
        caps
    }

    /// Whether any color is counted.
    pub(super) fn counts(&self) -> bool {
        self.counts
    }

    /// The bits of some colors, none where none are counted.
    pub(super) fn bits(&self, colors: impl Iterator<Item = u8>) -> u64 {
        let bits = colors.fold(0, |bits, color| bits | 1 << (color % 64));
        if self.counts { bits } else { 0 }
    }

    /// Whether one of the colors is closed.
    #[inline(always)]
    pub(super) fn are_closed(&self, bits: u64) -> bool {
        self.closed & bits != 0
    }

    /// Uses up sides of a color.
    #[inline(always)]
    pub(super) fn take(&mut self, color: u8, cost: u8) {
        let color = usize::from(color) % COLORS;
        self.left[color] -= i32::from(cost);
        self.close(color);
    }

    /// Gives them back.
    #[inline(always)]
    pub(super) fn give(&mut self, color: u8, cost: u8) {
        let color = usize::from(color) % COLORS;
        self.left[color] += i32::from(cost);
        self.close(color);
    }

    #[inline(always)]
    fn close(&mut self, color: usize) {
        let closed = u64::from(self.left[color] <= 0);
        self.closed = self.closed & !(1 << color) | closed << color;
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

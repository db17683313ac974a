//! The field while it is made dappled, shared by all threads: the tiles, and for every line how its
//! last cells repeat.
//!
//! A [`Run`] tells of the label of the last cell of a line that has been looked at, and how many
//! equal ones there are up to it: that is all a limit asks for, so a cell costs the same whatever
//! the limits are. Cells and runs are atomic, and are read and written without any order: it is the
//! [`super::schedule`] that keeps threads from cells whose turn it is not.

use super::Field;
use std::sync::atomic::{AtomicU8, AtomicU64, Ordering};

/// A label that repeats: of the last cell of a line, and how often up to there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Run {
    /// What repeats.
    pub label: u8,
    /// How often; 0 before the first cell.
    pub length: u64,
}

impl Run {
    /// Before the first cell.
    pub const NONE: Run = Run { label: 0, length: 0 };

    /// The first of its label.
    pub fn one(label: u8) -> Self {
        Run { label, length: 1 }
    }

    /// This run and the next cell.
    pub fn then(self, label: u8) -> Self {
        let before = if self.label == label { self.length } else { 0 };
        Run { label, length: before + 1 }
    }
}

/// The last run of every line of one direction.
#[derive(Debug)]
pub struct Runs(Vec<AtomicU64>);

impl Runs {
    /// Lines of which no cell has been looked at.
    pub fn new(lines: usize) -> Self {
        Self((0..lines).map(|_| AtomicU64::new(0)).collect())
    }

    /// The run at the end of a line.
    pub fn get(&self, line: usize) -> Run {
        let word = self.0[line].load(Ordering::Relaxed);
        Run { label: word as u8, length: word >> 8 }
    }

    /// Tells of a run.
    pub fn set(&self, line: usize, run: Run) {
        self.0[line].store(run.length << 8 | u64::from(run.label), Ordering::Relaxed);
    }
}

/// A field that threads share.
///
/// Rows lie some cells apart from each other, so that cells of an anti-diagonal, however wide the
/// field is, fall into all parts of a cache.
#[derive(Debug)]
pub struct Shared {
    width: usize,
    height: usize,
    stride: usize,
    cells: Vec<AtomicU8>,
}

/// Bytes that a cache holds together.
const LINE: usize = 64;

impl Shared {
    /// Shares a field.
    pub fn new(field: &Field) -> Self {
        let (width, height) = (field.width(), field.height());
        // An odd number of lines.
        let stride = ((width / LINE + 1) | 1) * LINE;
        let mut cells = Vec::with_capacity(stride * height);
        for row in field.rows() {
            cells.extend(row.iter().map(|&tile| AtomicU8::new(tile)));
            cells.extend((width..stride).map(|_| AtomicU8::new(0)));
        }
        Self { width, height, stride, cells }
    }

    /// Columns and rows.
    pub fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    /// What a cell holds.
    pub fn get(&self, column: usize, row: usize) -> u8 {
        self.cells[row * self.stride + column].load(Ordering::Relaxed)
    }

    /// Puts a tile in a cell.
    pub fn set(&self, column: usize, row: usize, tile: u8) {
        self.cells[row * self.stride + column].store(tile, Ordering::Relaxed);
    }

    /// Copies all cells to where they came from.
    pub fn copy_to(&self, field: &mut Field) {
        let rows = field.cells_mut().chunks_mut(self.width);
        for (to, from) in rows.zip(self.cells.chunks(self.stride)) {
            for (to, from) in to.iter_mut().zip(from) {
                *to = from.load(Ordering::Relaxed);
            }
        }
    }
}

//! Where partial corner packings may go in batches, and how they are written down for it.
//!
//! From some level on the cells must be filled line by line, with nothing given in between, and
//! all cells of the first line chosen; then every window is the one that
//! [`corner_batch`](super::corner_batch) expects. Column order is row order with rows and
//! columns exchanged, rows upward are rows.

use super::Task;
use super::caps::Caps;
use super::corner_batch::{COLORS, Kernel, LONGEST_LINE, MOST_DOMINOES, Node};
use super::corner_plan::CornerPlan;
use super::corner_tables::row;
use crate::search::batch::Batch;
use crate::search::{Bounds, Visited};
use crate::torus::{Cell, Order};

/// Partial packings that wait for being completed.
#[derive(Debug, Clone)]
pub(super) struct Herd {
    batch: Batch<Kernel>,
    /// The cells in the order of lines, and at the first level so many of them are known.
    line_order: Vec<u32>,
    known: usize,
    length: usize,
    transposed: bool,
    from: usize,
    colors: usize,
}

impl Herd {
    /// For a task without automorphism, its plan, and the tiles `allowed`, row by row; `None`
    /// when it does not suit.
    pub(super) fn new(task: &Task, plan: &CornerPlan, allowed: &[u64], shift: u32) -> Option<Self> {
        let shape = task.shape;
        let colors = task.set.colors().horizontal();
        let (transposed, lines, length) = match task.visiting_order() {
            Order::Row => (false, shape.height(), shape.width()),
            Order::Column if !task.set.is_compact() => (true, shape.width(), shape.height()),
            _ => return None,
        };
        let (cells, levels) = (shape.cells(), plan.steps.len());
        let fits = colors <= COLORS && (3..=LONGEST_LINE).contains(&length) && lines >= 3;
        let dominoes = task.set.size() <= 256 && colors.pow(2) as u64 <= MOST_DOMINOES;
        if !fits || !dominoes || task.cover || !task.prunings.caps {
            return None;
        }
        let cell = |at: usize| {
            let (line, position) = ((at / length) as i64, (at % length) as i64);
            let upward = if task.set.is_compact() { 1 - line } else { line };
            let (row, column) = if transposed { (position, line) } else { (upward, position) };
            shape.step(Cell(0), row, column).0
        };
        let line_order: Vec<u32> = (0..cells).map(cell).collect();
        let pairs = plan.steps.iter().rev().zip(line_order.iter().rev());
        let suits = pairs.take_while(|(step, cell)| step.cell == **cell).count();
        let known = cells - levels;
        let from = (levels - suits).max(length.saturating_sub(known));
        let allowed = free(colors, transposed, |known| allowed[row(shift, known)]);
        let kernel = Kernel::new(length, cells, levels, allowed, task.set.is_compact());
        let batch = Batch::new(kernel, levels);
        Some(Self { batch, line_order, known, length, transposed, from, colors })
    }

    /// The first level at which nodes may be gathered.
    pub(super) fn from(&self) -> usize {
        self.from
    }

    /// Adds the partial packing at a level, given by the tiles open, row by row, the dominoes
    /// left, and the colors of cells known.
    pub(super) fn gather<const W: usize, const C: usize>(
        &mut self,
        level: usize,
        open: impl Fn([u8; 3]) -> u64,
        caps: &Caps<W, C>,
        color: impl Fn(u32) -> u8,
    ) {
        let chosen = self.known + level;
        let bits = |at: usize| u64::from(color(self.line_order[at]));
        let last = chosen.saturating_sub(32)..chosen;
        let past = last.fold(0, |past, at| past >> 2 | bits(at) << 62);
        let first = (0..self.length).fold(0, |first, at| first | (bits(at) as u32) << (2 * at));
        let mut node =
            Node { free: free(self.colors, self.transposed, open), past, first, ..Node::default() };
        for (row, (beside, behind)) in node.beside.iter_mut().zip(&mut node.behind).enumerate() {
            for color in 0..self.colors {
                let across = Node::lane(color, caps.left_across(row as u8, color as u8));
                let along = Node::lane(color, caps.left_along(row as u8, color as u8));
                let (a, b) = if self.transposed { (along, across) } else { (across, along) };
                (*beside, *behind) = (*beside | a, *behind | b);
            }
        }
        self.batch.add(level, node);
    }

    /// Visits all below what was added.
    pub(super) fn expand(&mut self, bounds: Bounds) -> Result<Visited, u64> {
        self.batch.expand(bounds)
    }
}

/// The tiles open, by `d`, bit by bit of `bac`.
fn free(colors: usize, transposed: bool, open: impl Fn([u8; 3]) -> u64) -> [u64; COLORS] {
    let mut free = [0; COLORS];
    for (d, free) in free.iter_mut().enumerate().take(colors) {
        for b in 0..colors {
            for a in 0..colors {
                let [d, b, a] = [d, b, a].map(|color| color as u8);
                let known = if transposed { [d, a, b] } else { [d, b, a] };
                *free |= open(known) << (b << 4 | a << 2);
            }
        }
    }
    free
}

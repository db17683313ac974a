//! Where partial Wang packings may go in batches, and how they are written down for it.
//!
//! From some level on the cells must be filled line by line, with no labels given, and all cells
//! of the first line chosen; then a tile is asked for what
//! [`wang_batch`](super::wang_batch) expects. Row order is column order with the sides
//! exchanged.

use super::Task;
use super::wang_batch::{Kernel, LONGEST_LINE, Node};
use super::wang_plan::WangPlan;
use crate::search::batch::Batch;
use crate::search::{Alternatives, Bounds, Visited, Words};
use crate::torus::{Cell, Order};

/// Partial packings that wait for being completed.
#[derive(Debug, Clone)]
pub(super) struct Herd {
    batch: Batch<Kernel>,
    /// By tile: its sides `p`, `q`, `r`, `s`.
    tiles: Vec<[u8; 4]>,
    /// The slots in the order of lines, and how many of them are known at level 0.
    line_order: Vec<u32>,
    known: usize,
    length: usize,
    from: usize,
}

impl Herd {
    /// For a task without automorphism, and its plan; `None` when it does not suit.
    pub(super) fn new<const N: usize>(task: &Task, plan: &WangPlan<N>) -> Option<Self> {
        let shape = task.shape;
        let (rows, lines, length) = match task.visiting_order() {
            Order::Row => (true, shape.height(), shape.width()),
            Order::Column => (false, shape.width(), shape.height()),
            _ => return None,
        };
        let suits = (2..=LONGEST_LINE).contains(&length) && lines >= 2;
        let plain = !task.has_pins() && !task.cover && !task.set.is_compact();
        if !suits || !plain || task.set.colors().largest() > 2 {
            return None;
        }
        let (cells, levels) = (shape.cells(), plan.steps.len());
        let cell = |at: usize| {
            let (line, position) = ((at / length) as i64, (at % length) as i64);
            let (row, column) = if rows { (line, position) } else { (position, line) };
            shape.step(Cell(0), row, column)
        };
        let known = cells - levels;
        let own = |(level, at): (usize, usize)| plan.steps[level].cell == cell(at);
        let suits = (0..levels).zip(known..cells).rev().take_while(|&pair| own(pair)).count();
        let sides = |&[n, e, s, w]: &[u8; 4]| if rows { [w, n, e, s] } else { [n, w, s, e] };
        Some(Self {
            batch: Batch::new(Kernel::new(length, cells, levels), levels),
            tiles: plan.tiles.iter().map(sides).collect(),
            line_order: (0..cells).map(|at| plan.slots[cell(at).index()]).collect(),
            known,
            length,
            from: (levels - suits).max(length.saturating_sub(known)),
        })
    }

    /// The first level at which nodes may be gathered.
    pub(super) fn from(&self) -> usize {
        self.from
    }

    /// Adds the partial packing at a level, given by the tiles open and the tiles of slots.
    pub(super) fn gather<const N: usize>(
        &mut self,
        level: usize,
        open: Words<N>,
        tile: impl Fn(u32) -> u32,
    ) {
        let chosen = self.known + level;
        let sides = |at: usize| self.tiles[tile(self.line_order[at]) as usize];
        let open = open.numbers().map(|tile| self.tiles[tile as usize]);
        let past = (chosen.saturating_sub(LONGEST_LINE)..chosen).map(sides);
        let begin = sides((chosen - 1) / self.length * self.length);
        let node = Node::new(open, past, (0..self.length).map(sides), begin);
        self.batch.add(level, node);
    }

    /// Visits all below what was added.
    pub(super) fn expand(&mut self, bounds: Bounds) -> Result<Visited, u64> {
        self.batch.expand(bounds)
    }
}

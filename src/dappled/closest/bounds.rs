//! The systems of strips that bound the cost from below together.
//!
//! One system of strips along one direction is enough if each window across it fits in a strip, two
//! neighbors overlapping by all of it but one line. Otherwise there is a system along either
//! direction, which has all windows of its own, and costs go from one to the other and back.

use super::board::{Board, Cost, NEVER, may_be};
use super::dual::{Pool, System};
use super::machine::Machine;
use crate::search::Stop;
use std::sync::Arc;

/// Costs are multiplied by a power of two up to this.
const FINEST: u32 = 16;

/// Costs of all cells, multiplied, stay below this power of two.
const ROOM: u32 = 56;

/// Systems, and what is on its way between them.
#[derive(Debug, Clone)]
pub(super) struct Bounds {
    pub systems: Vec<System>,
    pool: Pool,
    /// What a cost of one is multiplied by.
    pub unit: Cost,
}

/// How many lines after another the next strip begins, so that every window across is in one.
fn stride(board: &Board, along: usize, lines: usize) -> Option<usize> {
    let longest = board.longest(1 - along);
    match lines == board.lines(along) {
        true => Some(lines),
        false => (lines > longest).then(|| (lines / 2).min(lines - longest).max(1)),
    }
}

impl Bounds {
    /// With machines along rows and along columns; `prefer` is the direction to use if either will
    /// do.
    pub(super) fn new(board: &Board, machines: &[Arc<Machine>; 2], prefer: usize) -> Self {
        let worst = board.costs.iter().filter(|&&cost| may_be(cost)).sum::<Cost>().unsigned_abs();
        let room = ROOM.saturating_sub(worst.checked_ilog2().unwrap_or(0));
        let unit = 1 << FINEST.min(room);
        let strides = [0, 1].map(|along| stride(board, along, machines[along].lines));
        let alone = [prefer, 1 - prefer].into_iter().find(|&along| strides[along].is_some());
        let used: Vec<usize> = alone.map_or(vec![0, 1], |along| vec![along]);
        let share = used.len() as Cost;
        let systems = used.iter().enumerate().map(|(rank, &along)| {
            let machine = Arc::clone(&machines[along]);
            let stride = strides[along].unwrap_or((machine.lines / 2).max(1));
            System::new(board, along, machine, stride, |cell, tile| {
                let whole = board.cost(cell, tile).saturating_mul(unit);
                let part = |rank: usize| (whole / share) * rank as Cost;
                if rank + 1 == used.len() {
                    whole - part(rank)
                } else {
                    part(rank + 1) - part(rank)
                }
            })
        });
        let systems: Vec<System> = systems.collect();
        let pool = if systems.len() > 1 { vec![0; board.costs.len()] } else { Pool::new() };
        Self { systems, pool, unit }
    }

    /// The memory that they would take, in bytes.
    pub(super) fn memory(board: &Board, machines: &[Arc<Machine>; 2], prefer: usize) -> usize {
        let strides = [0, 1].map(|along| stride(board, along, machines[along].lines));
        let alone = [prefer, 1 - prefer].into_iter().find(|&along| strides[along].is_some());
        let of = |along: usize| {
            let machine = &machines[along];
            let stride = strides[along].unwrap_or((machine.lines / 2).max(1));
            let parts = board.lines(along).div_ceil(stride);
            let place = machine.states() + machine.slices.len();
            parts.saturating_mul(board.length(along)).saturating_mul(8 * place)
        };
        alone.map_or_else(|| of(0).saturating_add(of(1)), of)
    }

    /// One round; gives the bound, multiplied, or nothing if it was stopped: then they are of no
    /// more use.
    pub(super) fn round(&mut self, board: &Board, stop: &dyn Stop) -> Option<Cost> {
        let exchange = self.systems.len() > 1;
        let mut sum: Cost = 0;
        for system in &mut self.systems {
            let bound = system.forward(board, exchange.then_some(&mut self.pool), stop)?;
            sum = (sum + bound).min(NEVER);
            system.backward(true);
        }
        Some(sum)
    }

    /// The least cost that a bound leaves open.
    pub(super) fn rounded(&self, bound: Cost) -> Cost {
        if may_be(bound) { (bound + self.unit - 1).div_euclid(self.unit) } else { NEVER }
    }

    /// Keeps tiles that are told out of a cell.
    pub(super) fn bar(&mut self, board: &Board, cell: usize, out: impl Fn(usize) -> bool + Copy) {
        for system in &mut self.systems {
            system.bar(board, cell, out);
        }
    }
}

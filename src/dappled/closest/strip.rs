//! A strip on a board: which lines it has, what its slices cost, and which states may not be
//! where.

use super::board::{Board, Cost, ENDLESS, NEVER};
use super::machine::Machine;

/// Lines of a board side by side, to be read along them.
#[derive(Debug, Clone)]
pub(super) struct Strip {
    /// 0 along rows, 1 along columns.
    pub along: usize,
    /// Its lines, in order.
    pub lines: Vec<usize>,
}

impl Strip {
    /// So many lines from this one on, in a circle.
    pub(super) fn new(board: &Board, along: usize, first: usize, lines: usize) -> Self {
        let all = board.lines(along);
        Self { along, lines: (0..lines).map(|line| (first + line) % all).collect() }
    }

    /// The cell of a line of the strip.
    pub(super) fn cell(&self, board: &Board, line: usize, at: usize) -> usize {
        board.cell(self.along, self.lines[line], at)
    }

    /// What each slice costs at each place, by place, then by slice: the sum of `cost` by cell and
    /// tile, or [`NEVER`] if it breaks a limit across the strip.
    pub(super) fn table(
        &self,
        board: &Board,
        machine: &Machine,
        mut cost: impl FnMut(usize, usize) -> Cost,
    ) -> Vec<Cost> {
        let across = 1 - self.along;
        let wraps = board.meet[across] && self.lines.len() == board.lines(self.along);
        let differ = wraps || board.runs[across].iter().any(|set| set.uniform().is_none());
        let mut table = Vec::with_capacity(board.length(self.along) * machine.slices.len());
        let mut costs = vec![0; self.lines.len() * board.tiles];
        for at in 0..board.length(self.along) {
            for line in 0..self.lines.len() {
                let cell = self.cell(board, line, at);
                for tile in 0..board.tiles {
                    costs[line * board.tiles + tile] = cost(cell, tile);
                }
            }
            for slice in &machine.slices {
                if differ && self.breaks(board, slice, at, wraps) {
                    table.push(NEVER);
                    continue;
                }
                let tiles = slice.iter().enumerate();
                let sum: Cost =
                    tiles.map(|(line, &t)| costs[line * board.tiles + usize::from(t)]).sum();
                table.push(sum.min(NEVER));
            }
        }
        table
    }

    /// Whether a slice breaks a limit across the strip.
    fn breaks(&self, board: &Board, slice: &[u8], at: usize, wraps: bool) -> bool {
        let lines = slice.len();
        board.runs[1 - self.along].iter().any(|set| {
            (0..lines).any(|line| {
                let limit = set.limit(self.cell(board, line, at));
                if limit == ENDLESS || (line < limit as usize && !wraps) {
                    return false;
                }
                (0..=limit as usize)
                    .all(|back| set.set >> slice[(line + lines - back % lines) % lines] & 1 == 1)
            })
        })
    }

    /// The states that may not be, by place, then by state; nothing if limits do not differ.
    pub(super) fn barred(&self, board: &Board, machine: &Machine) -> Vec<bool> {
        let sets = &board.runs[self.along];
        if sets.iter().all(|set| set.uniform().is_some()) {
            return Vec::new();
        }
        let mut barred = Vec::with_capacity(board.length(self.along) * machine.states());
        for at in 0..board.length(self.along) {
            let limits: Vec<u32> = (0..self.lines.len())
                .flat_map(|line| {
                    let cell = self.cell(board, line, at);
                    sets.iter().map(move |set| set.limit(cell))
                })
                .collect();
            barred.extend(
                machine.runs.iter().map(|runs| runs.iter().zip(&limits).any(|(run, l)| run > l)),
            );
        }
        barred
    }
}

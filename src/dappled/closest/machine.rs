//! A strip of a few lines as a machine that reads it slice by slice.
//!
//! A *slice* is a tile for each line of the strip at one place. A *state* is the last slice with
//! the length of the run that it ends, for each line and each set that is limited along the lines.
//! All states that can be reached are kept with their predecessors and successors, so that a
//! shortest path through the places is the best filling of the strip.
//!
//! The same machine serves all strips of its height. Limits that differ by cell are not in it: it
//! counts runs up to the longest limit, and [`Strip`](super::strip::Strip) says which states may
//! not be at which place.

use super::board::{Board, Cost, ENDLESS, NEVER};
use std::collections::HashMap;

/// States and the steps between them.
#[derive(Debug, Default)]
pub(super) struct Machine {
    /// Lines of a strip.
    pub lines: usize,
    /// Tiles of each slice, the first line's first.
    pub slices: Vec<Vec<u8>>,
    /// The last slice of each state.
    pub slice: Vec<u32>,
    /// The runs of each state: by line, then by set.
    pub runs: Vec<Vec<u32>>,
    /// The states that begin a strip.
    pub first: Vec<u32>,
    /// Where the predecessors of each state begin.
    before_from: Vec<u32>,
    before: Vec<u32>,
    /// Where the successors of each state begin.
    after_from: Vec<u32>,
    after: Vec<u32>,
}

impl Machine {
    /// The machine of strips of so many lines along a direction; none if it has more than this
    /// many steps.
    pub(super) fn new(board: &Board, along: usize, lines: usize, most: usize) -> Option<Self> {
        let slices = slices(board, 1 - along, lines, most)?;
        let sets = &board.runs[along];
        let longest: Vec<u32> = sets.iter().map(|set| set.longest()).collect();
        let all: Vec<u32> = sets.iter().map(|set| set.uniform().unwrap_or(ENDLESS)).collect();
        let mut found: HashMap<(u32, Vec<u32>), u32> = HashMap::new();
        let mut states: Vec<(u32, Vec<u32>)> = Vec::new();
        let mut steps: Vec<(u32, u32)> = Vec::new();
        let mut first = Vec::new();
        let none = vec![0; lines * sets.len()];
        let mut next = 0;
        // The state before the first counts no run.
        let mut from = None;
        loop {
            let before = match from {
                None => none.clone(),
                Some(state) => states[state as usize].1.clone(),
            };
            for (number, slice) in slices.iter().enumerate() {
                let Some(runs) = step(&before, slice, sets, &longest, &all) else { continue };
                let key = (number as u32, runs);
                let to = *found.entry(key.clone()).or_insert_with(|| {
                    states.push(key);
                    states.len() as u32 - 1
                });
                match from {
                    None => first.push(to),
                    Some(from) => steps.push((from, to)),
                }
                if steps.len() > most {
                    return None;
                }
            }
            if next == states.len() {
                break;
            }
            from = Some(next as u32);
            next += 1;
        }
        let count = states.len();
        let (after_from, after) = grouped(count, &steps);
        let reverse: Vec<(u32, u32)> = steps.iter().map(|&(from, to)| (to, from)).collect();
        let (before_from, before) = grouped(count, &reverse);
        let (slice, runs) = states.into_iter().unzip();
        Some(Self { lines, slices, slice, runs, first, before_from, before, after_from, after })
    }

    /// How many states there are.
    pub(super) fn states(&self) -> usize {
        self.slice.len()
    }

    /// The states that may come before this one.
    pub(super) fn before(&self, state: usize) -> &[u32] {
        &self.before[self.before_from[state] as usize..self.before_from[state + 1] as usize]
    }

    /// The least cost of the predecessors of each state.
    pub(super) fn least_before(&self, costs: &[Cost], least: &mut [Cost]) {
        for (least, group) in least.iter_mut().zip(self.before_from.windows(2)) {
            let group = &self.before[group[0] as usize..group[1] as usize];
            *least = group.iter().map(|&from| costs[from as usize]).min().unwrap_or(NEVER);
        }
    }

    /// The least cost of the successors of each state.
    pub(super) fn least_after(&self, costs: &[Cost], least: &mut [Cost]) {
        for (least, group) in least.iter_mut().zip(self.after_from.windows(2)) {
            let group = &self.after[group[0] as usize..group[1] as usize];
            *least = group.iter().map(|&to| costs[to as usize]).min().unwrap_or(NEVER);
        }
    }
}

/// Pairs grouped by their first, in order: where each group begins, and the seconds.
fn grouped(count: usize, pairs: &[(u32, u32)]) -> (Vec<u32>, Vec<u32>) {
    let mut from = vec![0; count + 1];
    for &(a, _) in pairs {
        from[a as usize + 1] += 1;
    }
    for at in 0..count {
        from[at + 1] += from[at];
    }
    let mut place = from.clone();
    let mut seconds = vec![0; pairs.len()];
    for &(a, b) in pairs {
        seconds[place[a as usize] as usize] = b;
        place[a as usize] += 1;
    }
    (from, seconds)
}

/// The runs after a slice, if no limit of all cells forbids it.
fn step(
    before: &[u32],
    slice: &[u8],
    sets: &[super::board::Runs],
    longest: &[u32],
    all: &[u32],
) -> Option<Vec<u32>> {
    let mut runs = Vec::with_capacity(before.len());
    for (line, &tile) in slice.iter().enumerate() {
        for (number, set) in sets.iter().enumerate() {
            let run = match set.set >> tile & 1 {
                0 => 0,
                _ => before[line * sets.len() + number] + 1,
            };
            if run > all[number] {
                return None;
            }
            runs.push(run.min(longest[number] + 1));
        }
    }
    Some(runs)
}

/// All slices that no limit of all cells across the strip forbids; none if there are too many.
fn slices(board: &Board, across: usize, lines: usize, most: usize) -> Option<Vec<Vec<u8>>> {
    let sets = &board.runs[across];
    let mut slices: Vec<Vec<u8>> = vec![Vec::new()];
    for _ in 0..lines {
        let mut longer = Vec::new();
        for slice in &slices {
            for tile in 0..board.tiles as u8 {
                let mut slice = slice.clone();
                slice.push(tile);
                let allowed = sets.iter().all(|set| {
                    let Some(limit) = set.uniform() else { return true };
                    let run = slice.iter().rev().take_while(|&&t| set.set >> t & 1 == 1).count();
                    run <= limit as usize
                });
                if allowed {
                    longer.push(slice);
                }
            }
        }
        slices = longer;
        if slices.len() > most {
            return None;
        }
    }
    Some(slices)
}

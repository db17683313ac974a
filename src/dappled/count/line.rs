//! A line of cells as an automaton: what of the cells so far matters for those to come.
//!
//! Going along a line, all that its conditions ask is how long the run of each of their sets is
//! that ends here, up to the longest limit; on a line that meets its own end also whether its first
//! run still goes on, and how long the last one may be. These are states, a layer of them for each
//! number of cells passed. Then, from the end backwards, states with the same future are made one,
//! and those without a future are dropped. So a layer has as few states as it can.
//!
//! Invariant: every state is reached by some cells, and some further ones bring it to the end.

use crate::dappled::FREE;
use std::collections::HashMap;

/// No state: these tiles break a limit.
pub(super) const DEAD: u32 = u32::MAX;

/// States of a layer at most.
const MOST_STATES: usize = 1 << 16;

/// What one condition asks of a line.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) struct Demand {
    /// Its tiles, a bit each.
    pub(super) set: u64,
    /// The limit of runs that end in each cell; no longer than the line.
    pub(super) limits: Vec<Option<u32>>,
    /// Runs are told apart up to this length.
    pub(super) longest: u32,
}

/// What happens at the two ends of a line.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) enum Ends {
    /// Nothing.
    Free,
    /// They meet.
    Meet,
    /// The runs, one for each demand, with which the line begins and must end.
    Turn(Vec<u32>),
    /// Nothing, and states are told apart by their runs, whatever their future.
    Runs,
}

/// What is asked of a line.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) struct Task {
    /// How many tiles there are.
    pub(super) tiles: usize,
    /// Its conditions.
    pub(super) demands: Vec<Demand>,
    /// Its cells, as far as they are given.
    pub(super) given: Vec<u8>,
    /// Its ends.
    pub(super) ends: Ends,
}

/// One demand on the way.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
struct Run {
    /// Tiles of the set up to here, up to the longest limit.
    length: u32,
    /// How long the last run may be, for the first one goes on after it.
    bound: u32,
    /// Whether all cells so far belong to the first run, on a line that meets its end.
    first: bool,
}

/// The states after some cells.
#[derive(Debug, Clone, Default)]
pub(super) struct Layer {
    /// By state and tile the state in the next layer.
    next: Vec<u32>,
    /// The state before each of them, and the tile that leads from it; of several the first.
    from: Vec<(u32, u8)>,
    /// The runs of each, one for each demand; of several that are one, the first.
    pub(super) runs: Vec<Vec<u32>>,
}

/// A line.
#[derive(Debug, Clone)]
pub(super) struct Line {
    tiles: usize,
    layers: Vec<Layer>,
}

impl Line {
    /// The automaton of a line; `None` if it has too many states.
    pub(super) fn new(task: &Task) -> Option<Self> {
        let length = task.given.len();
        let mut states = vec![start(task)];
        let mut layers: Vec<Layer> = vec![Layer { from: vec![(DEAD, 0)], ..Layer::default() }];
        for cell in 0..length {
            let mut numbers: HashMap<Vec<Run>, u32> = HashMap::new();
            let (mut after, mut from, mut next) = (Vec::new(), Vec::new(), Vec::new());
            for (number, state) in states.iter().enumerate() {
                for tile in 0..task.tiles as u8 {
                    next.push(match passed(task, cell, tile, state) {
                        None => DEAD,
                        Some(state) => *numbers.entry(state.clone()).or_insert_with(|| {
                            after.push(state);
                            from.push((number as u32, tile));
                            after.len() as u32 - 1
                        }),
                    });
                }
            }
            if after.len() > MOST_STATES {
                return None;
            }
            let lengths = |state: &Vec<Run>| state.iter().map(|run| run.length).collect();
            layers[cell].runs = states.iter().map(lengths).collect();
            layers[cell].next = next;
            layers.push(Layer { from, ..Layer::default() });
            states = after;
        }
        let last = states.iter().map(|state| u32::from(!ends(task, state)) * DEAD).collect();
        let lengths = |state: &Vec<Run>| state.iter().map(|run| run.length).collect();
        layers[length].runs = states.iter().map(lengths).collect();
        let mut line = Self { tiles: task.tiles, layers };
        if task.ends != Ends::Runs {
            line.merge(last);
        }
        Some(line)
    }

    /// Makes states with the same future one. `class` has those of the last layer.
    fn merge(&mut self, mut class: Vec<u32>) {
        for at in (0..self.layers.len()).rev() {
            let layer = &mut self.layers[at];
            if !layer.next.is_empty() {
                let to = |&next: &u32| if next == DEAD { DEAD } else { class[next as usize] };
                let mut numbers: HashMap<Vec<u32>, u32> = HashMap::new();
                let future = layer.next.chunks(self.tiles).map(|next| {
                    let next: Vec<u32> = next.iter().map(to).collect();
                    let count = numbers.len() as u32;
                    match next.iter().all(|&next| next == DEAD) {
                        true => DEAD,
                        false => *numbers.entry(next).or_insert(count),
                    }
                });
                let new: Vec<u32> = future.collect();
                let next = layer.next.iter().map(to).collect();
                (layer.next, class) = (next, new);
            }
            // The first of each class stays.
            let mut count = 0;
            let stays = class.iter().map(|&number| {
                let first = number == count;
                count += u32::from(first);
                first
            });
            let stays: Vec<bool> = stays.collect();
            let mut keep = stays.iter().flat_map(|&stays| std::iter::repeat_n(stays, self.tiles));
            layer.next.retain(|_| keep.next().unwrap_or(false));
            let mut keep = stays.iter();
            layer.from.retain(|_| keep.next().copied().unwrap_or(false));
            let mut keep = stays.iter();
            layer.runs.retain(|_| keep.next().copied().unwrap_or(false));
        }
        self.renumber();
    }

    /// States before those that stayed have new numbers, and may have been merged into another; any
    /// state with the same next one will do.
    fn renumber(&mut self) {
        for at in 1..self.layers.len() {
            let (before, here) = self.layers.split_at_mut(at);
            let next = &before[at - 1].next;
            for (place, &state) in next.iter().enumerate().filter(|&(_, &state)| state != DEAD) {
                let from = ((place / self.tiles) as u32, (place % self.tiles) as u8);
                here[0].from[state as usize] = from;
            }
        }
    }

    /// How many tiles there are.
    pub(super) fn tiles(&self) -> u8 {
        self.tiles as u8
    }

    /// States after so many cells.
    pub(super) fn states(&self, cells: usize) -> usize {
        self.layers[cells].from.len()
    }

    /// The state after one more cell.
    pub(super) fn next(&self, cells: usize, state: u32, tile: u8) -> u32 {
        self.layers[cells].next[state as usize * self.tiles + usize::from(tile)]
    }

    /// The runs of a state, where states are told apart by them.
    pub(super) fn runs(&self, cells: usize, state: u32) -> &[u32] {
        &self.layers[cells].runs[state as usize]
    }

    /// Some cells that lead to a state.
    pub(super) fn word(&self, cells: usize, mut state: u32) -> Vec<u8> {
        let mut word = Vec::new();
        for layer in self.layers[1..=cells].iter().rev() {
            let (before, tile) = layer.from[state as usize];
            word.push(tile);
            state = before;
        }
        word.reverse();
        word
    }
}

fn start(task: &Task) -> Vec<Run> {
    let first = task.ends == Ends::Meet;
    let length = |demand: usize| match &task.ends {
        Ends::Turn(runs) => runs[demand],
        _ => 0,
    };
    (0..task.demands.len())
        .map(|demand| Run { length: length(demand), bound: u32::MAX, first })
        .collect()
}

/// The state after a cell, unless that breaks a limit.
fn passed(task: &Task, cell: usize, tile: u8, state: &[Run]) -> Option<Vec<Run>> {
    if task.given[cell] != FREE && task.given[cell] != tile {
        return None;
    }
    let mut after = state.to_vec();
    for (run, demand) in after.iter_mut().zip(&task.demands) {
        if demand.set >> tile & 1 == 0 {
            (run.length, run.first) = (0, false);
            continue;
        }
        if let Some(limit) = demand.limits[cell] {
            if run.length >= limit {
                return None;
            }
            if run.first {
                // A window that ends here and begins before the seam.
                run.bound = run.bound.min(limit - cell as u32 - 1);
            }
        }
        run.length = (run.length + 1).min(demand.longest);
    }
    Some(after)
}

/// Whether a line may end so.
fn ends(task: &Task, state: &[Run]) -> bool {
    let limited = |demand: &Demand| demand.limits.iter().any(Option::is_some);
    match &task.ends {
        Ends::Free | Ends::Runs => true,
        Ends::Meet => state.iter().zip(&task.demands).all(|(run, demand)| match run.first {
            true => !limited(demand),
            false => run.length <= run.bound,
        }),
        Ends::Turn(runs) => state.iter().zip(runs).all(|(run, &length)| run.length == length),
    }
}

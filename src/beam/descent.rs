//! One descent of the beam: from a random first row down to the last cell, or to its end.
//!
//! At every cell all states are continued by all colors, and the best of these children are
//! kept, by score and noise. A state knows only its last row; what came before is read off the
//! parents and colors that are noted for every cell. Children are numbered in the order of their
//! parents and colors and no two compare equal, so the outcome depends on the seed alone.

use super::excess::Excess;
use super::model::{At, Model};
use super::random::{Gumbel, Random};
use super::rule::Rule;
use crate::search::Attempt;

/// Tries to draw a first row before another palette is tried.
const ROWS: usize = 200;

/// What is the same in all descents.
pub(super) struct Beam<'a, R> {
    pub(super) model: &'a Model<R>,
    pub(super) gumbel: &'a Gumbel,
    pub(super) excess: &'a Excess,
    /// States kept.
    pub(super) width: usize,
    /// Colors of the first row.
    pub(super) palette: usize,
    pub(super) seed: u64,
}

/// The states of one cell and their scores.
struct Level {
    states: Vec<u16>,
    scores: Vec<i64>,
}

impl<R: Rule> Beam<'_, R> {
    /// Descends for the time number `number`; `stop` is told the nodes so far after every row.
    /// The colors are found row by row; nodes are children looked at that broke no rule.
    pub(super) fn descend(
        &self,
        number: u64,
        mut stop: impl FnMut(u64) -> bool,
    ) -> Attempt<Vec<u8>> {
        let (model, words) = (self.model, self.model.words());
        let mut random = Random::new(self.seed, number);
        let mut descent = Attempt { found: None, nodes: 0, depth: 0, cut: false };
        let mut start = model.start().to_vec();
        for tile in self.excess.choose(&mut random) {
            model.give(&mut start, tile);
        }
        let Some((top, first)) = self.first_row(&start, &mut random) else { return descent };
        let under = model.under(&top);
        descent.depth = top.len();
        let mut level = Level { states: first, scores: vec![0] };
        let mut next = Level { states: Vec::new(), scores: Vec::new() };
        let mut trace: Vec<Vec<(u32, u8)>> = Vec::new();
        let (mut children, mut keys) = (Vec::new(), Vec::new());
        let (mut ranked, mut scratch) = (Vec::new(), Vec::new());
        for row in 1..model.height {
            for column in 0..model.width {
                let at = At { row, column };
                children.clear();
                keys.clear();
                for (parent, state) in level.states.chunks_exact(words).enumerate() {
                    let before = level.scores[parent];
                    model.choices(state, &under, at, &mut scratch, |color, change| {
                        let score = before + change;
                        keys.push(key(score + self.gumbel.next(&mut random), children.len()));
                        children.push((parent as u32, color as u8, score));
                    });
                }
                if children.is_empty() {
                    return descent;
                }
                descent.nodes += children.len() as u64;
                descent.depth += 1;
                keep_best(&mut keys, self.width, &mut ranked);
                next.states.clear();
                next.scores.clear();
                let mut kept = Vec::with_capacity(keys.len());
                for &key in &keys {
                    let (parent, color, score) = children[number_of(key)];
                    let (from, to) = (parent as usize * words, next.states.len());
                    next.states.extend_from_slice(&level.states[from..from + words]);
                    model.fill(&mut next.states[to..], &under, at, color.into());
                    next.scores.push(score);
                    kept.push((parent, color));
                }
                trace.push(kept);
                std::mem::swap(&mut level, &mut next);
            }
            if stop(descent.nodes) {
                descent.cut = true;
                return descent;
            }
        }
        descent.found = Some(read(top, &trace));
        descent
    }

    /// A random first row over a few colors, or over all where a few do not suffice, and the
    /// state after it.
    fn first_row(&self, start: &[u16], random: &mut Random) -> Option<(Vec<u8>, Vec<u16>)> {
        let model = self.model;
        for attempt in 0..2 * ROWS {
            let size = if attempt < ROWS { self.palette.min(model.colors) } else { model.colors };
            let mut palette: Vec<usize> = (0..model.colors).collect();
            for i in 0..size {
                palette.swap(i, i + random.below(model.colors - i));
            }
            let (mut row, mut state) = (Vec::new(), start.to_vec());
            for column in 0..model.width {
                let mut tried = state.clone();
                let given = model.given(At { row: 0, column });
                // A few draws a cell: most rows of a set with few dominoes would die early.
                let draws = if given.is_some() { 1 } else { 4 * size };
                let draw = |_| given.unwrap_or_else(|| palette[random.below(size)]);
                let color = (0..draws).map(draw).find(|&color| {
                    tried.clone_from(&state);
                    model.place(&mut tried, &[], At { row: 0, column }, color).is_some()
                });
                let Some(color) = color else { break };
                row.push(color as u8);
                state = tried;
            }
            if row.len() == model.width {
                return Some((row, state));
            }
        }
        None
    }
}

/// Bits of a key for the number of a child.
const NUMBER: u32 = 24;

/// Children are compared by score and noise, then by number.
fn key(value: i64, number: usize) -> i64 {
    value << NUMBER | number as i64
}

fn number_of(key: i64) -> usize {
    (key & ((1 << NUMBER) - 1)) as usize
}

/// Keeps the `width` largest keys, in the order in which they stand.
fn keep_best(keys: &mut Vec<i64>, width: usize, ranked: &mut Vec<i64>) {
    if keys.len() <= width {
        return;
    }
    ranked.clone_from(keys);
    let (_, &mut least, _) = ranked.select_nth_unstable(keys.len() - width);
    keys.retain(|&key| key >= least);
}

/// The colors of all cells, by going back from the first state of the last level.
fn read(mut cells: Vec<u8>, trace: &[Vec<(u32, u8)>]) -> Vec<u8> {
    let (begin, mut state) = (cells.len(), 0);
    for level in trace.iter().rev() {
        let (parent, color) = level[state];
        cells.push(color);
        state = parent as usize;
    }
    cells[begin..].reverse();
    cells
}

//! One step of the count: the first digit of every state goes, a new one comes at its end.
//!
//! A state is a queue of digits and, at its low end, what the row begun remembers:
//!
//! ```text
//! | lead | rest of the digits | row |   ->   | rest of the digits | digit | row |
//! ```
//!
//! Sorted states with the same lead are sorted by the rest. So there are as many sorted runs as
//! there are leads; they are merged by the rest, and what comes of all states with the same rest,
//! at most a few, is added up at once. The new states come out sorted: nothing is looked up.
//!
//! Threads take ranges of the rest.

use super::table::{Chunk, Table, add};
use rayon::prelude::*;

/// Where the digits of a state are before a step and after it, and what becomes of what.
#[derive(Debug, Clone)]
pub(super) struct Step {
    /// Bits of the row before.
    pub(super) row_before: u32,
    /// Bits of the rest.
    pub(super) rest: u32,
    /// Bits of the new digit and the row after it, which are one *slot*.
    pub(super) slot: u32,
    /// By lead and row before (`lead << row_before | row`): the slots that follow, and whether the
    /// tile that leads there is counted.
    pub(super) moves: Vec<Vec<(u32, bool)>>,
    /// Whether tiles are counted, so that numbers for one more count are needed.
    pub(super) counts: bool,
}

/// Fewer states are not worth a thread.
const FEWEST: usize = 1 << 14;
/// Parts for a thread, so that none waits long for the last.
const PARTS: usize = 4;
/// The rest of a lead that has no more states.
const END: u64 = u64::MAX;

impl Step {
    fn lead(&self, state: u64) -> usize {
        (u128::from(state) >> (self.rest + self.row_before)) as usize
    }

    fn rest(&self, state: u64) -> u64 {
        let rest = u128::from(state) >> self.row_before;
        (rest & ((1 << self.rest) - 1)) as u64
    }

    /// How many leads there are.
    fn leads(&self) -> usize {
        self.moves.len() >> self.row_before
    }

    /// The states after this step. `spare` is a table no longer needed, for its memory.
    pub(super) fn take(&self, from: &Table, spare: Table) -> Table {
        let threads = rayon::current_num_threads();
        let states = from.len();
        let parts = match states {
            ..FEWEST => 1,
            _ if threads == 1 => 1,
            _ => threads * PARTS,
        };
        // The leads, chunk by chunk.
        let ranges: Vec<Vec<(usize, usize)>> = from
            .chunks
            .iter()
            .map(|chunk| {
                let from = |lead| chunk.states.partition_point(|&state| self.lead(state) < lead);
                (0..self.leads()).map(|lead| (from(lead), from(lead + 1))).collect()
            })
            .collect();
        let bounds = self.bounds(from, &ranges, parts);
        let mut spare = spare.chunks;
        spare.resize_with(bounds.len() - 1, Chunk::default);
        let counts = from.counts + usize::from(self.counts);
        let stride = from.limbs * counts;
        let jobs = bounds.windows(2).map(|bounds| (bounds[0], bounds[1])).zip(spare);
        let jobs: Vec<_> = jobs.collect();
        let part = |((low, high), mut chunk): ((u64, u64), Chunk)| {
            chunk.states.clear();
            chunk.numbers.clear();
            let runs = (0..self.leads()).map(|lead| self.run(from, &ranges, lead, low, high));
            let runs: Vec<Run<'_>> = runs.collect();
            let most: usize =
                runs.iter().map(|run| run.parts.iter().map(|p| p.0.len()).sum::<usize>()).sum();
            if chunk.states.capacity() == 0 {
                chunk.states.reserve_exact(most + most / 3);
                chunk.numbers.reserve_exact((most + most / 3) * stride);
            }
            let mut merge = Merge { step: self, runs, from, counts, chunk, highest: 0 };
            match (self.counts, stride) {
                (false, 1) => merge.all::<1>(),
                (false, 2) => merge.all::<2>(),
                (false, 3) => merge.all::<3>(),
                (false, 4) => merge.all::<4>(),
                _ => merge.all::<0>(),
            }
            (merge.chunk, merge.highest)
        };
        let done: Vec<(Chunk, u64)> = match parts {
            1 => jobs.into_iter().map(part).collect(),
            _ => jobs.into_par_iter().map(part).collect(),
        };
        let highest = done.iter().fold(0, |all, (_, highest)| all | highest);
        let chunks = done.into_iter().map(|(chunk, _)| chunk).filter(|c| !c.states.is_empty());
        Table { chunks: chunks.collect(), limbs: from.limbs, counts, highest }
    }

    /// Bounds between parts: rests, from 0 to [`END`], that divide the longest run evenly.
    fn bounds(&self, from: &Table, ranges: &[Vec<(usize, usize)>], parts: usize) -> Vec<u64> {
        let length = |lead: &usize| ranges.iter().map(|r| r[*lead].1 - r[*lead].0).sum::<usize>();
        let longest = (0..self.leads()).max_by_key(length).unwrap_or(0);
        let total = length(&longest);
        let mut bounds = vec![0];
        let mut before = 0;
        let mut part = 1;
        for (chunk, range) in from.chunks.iter().zip(ranges) {
            let (low, high) = range[longest];
            while part < parts && total * part / parts < before + high - low {
                let at = low + total * part / parts - before;
                bounds.push(self.rest(chunk.states[at]));
                part += 1;
            }
            before += high - low;
        }
        bounds.push(END);
        bounds.dedup();
        bounds
    }

    /// The states with a lead whose rests lie in a range.
    fn run<'a>(
        &self,
        from: &'a Table,
        ranges: &[Vec<(usize, usize)>],
        lead: usize,
        low: u64,
        high: u64,
    ) -> Run<'a> {
        let stride = from.stride();
        let mut run = Run { parts: Vec::new(), part: 0, at: 0, rest: END };
        for (chunk, range) in from.chunks.iter().zip(ranges) {
            let (begin, end) = range[lead];
            let states = &chunk.states[begin..end];
            let begin_at = begin + states.partition_point(|&state| self.rest(state) < low);
            let end_at = begin + states.partition_point(|&state| self.rest(state) < high);
            if begin_at < end_at {
                let numbers = &chunk.numbers[begin_at * stride..end_at * stride];
                run.parts.push((&chunk.states[begin_at..end_at], numbers));
            }
        }
        if let Some((states, _)) = run.parts.first() {
            run.rest = self.rest(states[0]);
        }
        run
    }
}

/// The states with one lead, from the chunks that have some.
#[derive(Debug)]
struct Run<'a> {
    /// States and their limbs.
    parts: Vec<(&'a [u64], &'a [u64])>,
    part: usize,
    at: usize,
    /// The rest of the next one, or [`END`].
    rest: u64,
}

impl Run<'_> {
    #[inline(always)]
    fn advance(&mut self, step: &Step) {
        self.at += 1;
        if self.at == self.parts[self.part].0.len() {
            (self.part, self.at) = (self.part + 1, 0);
            if self.part == self.parts.len() {
                self.rest = END;
                return;
            }
        }
        self.rest = step.rest(self.parts[self.part].0[self.at]);
    }
}

/// A merge under way.
struct Merge<'a> {
    step: &'a Step,
    runs: Vec<Run<'a>>,
    from: &'a Table,
    counts: usize,
    chunk: Chunk,
    highest: u64,
}

impl Merge<'_> {
    /// Merges all; `N` is the number of limbs of a state, if it does not change, or 0.
    fn all<const N: usize>(&mut self) {
        let limbs = self.from.limbs;
        let before = if N > 0 { N } else { self.from.stride() };
        let after = if N > 0 { N } else { limbs * self.counts };
        let step = self.step;
        let row_mask = (1u64 << step.row_before) - 1;
        let slots = 1usize << step.slot;
        let mut sums = vec![0u64; slots * after];
        let mut touched = vec![0u64; slots.div_ceil(64)];
        let mut highest = 0;
        loop {
            let rest = self.runs.iter().map(|run| run.rest).min().unwrap_or(END);
            if rest == END {
                break;
            }
            for (lead, run) in self.runs.iter_mut().enumerate() {
                while run.rest == rest {
                    let (states, numbers) = run.parts[run.part];
                    let row = (states[run.at] & row_mask) as usize;
                    let number = &numbers[run.at * before..][..before];
                    for &(slot, counted) in &step.moves[lead << step.row_before | row] {
                        let (word, bit) = (slot as usize / 64, 1 << (slot % 64));
                        let sum = &mut sums[slot as usize * after..][..after];
                        if N > 0 {
                            if touched[word] & bit == 0 {
                                sum.copy_from_slice(number);
                            } else {
                                add(sum, number);
                            }
                        } else {
                            if touched[word] & bit == 0 {
                                sum.fill(0);
                            }
                            add(&mut sum[if counted { limbs } else { 0 }..], number);
                        }
                        touched[word] |= bit;
                    }
                    run.advance(step);
                }
            }
            for (word, bits) in touched.iter_mut().enumerate() {
                while *bits != 0 {
                    let slot = 64 * word + bits.trailing_zeros() as usize;
                    *bits &= *bits - 1;
                    self.chunk.states.push(rest << step.slot | slot as u64);
                    let sum = &sums[slot * after..][..after];
                    self.chunk.numbers.extend_from_slice(sum);
                    if N > 0 {
                        highest |= sum[N - 1];
                    } else {
                        highest |= sum.iter().skip(limbs - 1).step_by(limbs).fold(0, |a, b| a | b);
                    }
                }
            }
        }
        self.highest = highest;
    }
}

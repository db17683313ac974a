//! All walks of a few pairs of lines with one end in common, in groups by the other end.

use super::law::Mask;
use super::line::{Dominoes, Lines, State};
use rayon::prelude::*;
use std::collections::HashMap;

/// A walk.
#[derive(Debug, Clone, Copy)]
pub struct Walk {
    /// The tiles it uses.
    pub mask: Mask,
    /// Their key.
    pub key: u64,
    /// Its *sum*: a number for the dominoes along those of its lines that are counted.
    pub sum: u32,
    /// How many of these lines are of the class in question.
    pub alike: u8,
}

/// Walks, in groups of those with one end in common, and in a group by their sums.
#[derive(Debug, Default)]
pub struct Walks {
    groups: Vec<std::ops::Range<usize>>,
    walks: Vec<Walk>,
    /// Letters of a walk; all have as many, with one that conflicts with nothing for those
    /// missing.
    stride: usize,
    letters: Vec<u8>,
}

/// Walks of one group.
#[derive(Debug, Clone, Copy)]
pub struct Group<'a> {
    /// The walks.
    pub walks: &'a [Walk],
    /// Their letters, one walk after the other.
    pub letters: &'a [u8],
    /// Letters of a walk.
    pub stride: usize,
}

impl Group<'_> {
    /// No more than `most` of them, from `begin` on.
    pub fn part(&self, begin: usize, most: usize) -> Self {
        let end = self.walks.len().min(begin + most);
        let letters = &self.letters[begin * self.stride..end * self.stride];
        Self { walks: &self.walks[begin..end], letters, stride: self.stride }
    }
}

/// Numbers for sums of dominoes.
#[derive(Debug, Default)]
pub struct Sums {
    numbers: HashMap<Dominoes, u32>,
    /// By number.
    pub dominoes: Vec<Dominoes>,
}

impl Sums {
    /// All sums of so many kinds.
    pub fn new(lines: &Lines, terms: usize) -> Self {
        let mut sums = Self::default();
        let mut last = vec![0];
        for _ in 0..terms {
            last = last.iter().flat_map(|sum| lines.kinds.iter().map(move |k| sum + k)).collect();
            last.sort_unstable();
            last.dedup();
        }
        for sum in last {
            sums.numbers.insert(sum, sums.dominoes.len() as u32);
            sums.dominoes.push(sum);
        }
        sums
    }

    /// The number of a sum, if it is one.
    pub fn number(&self, dominoes: Dominoes) -> Option<u32> {
        self.numbers.get(&dominoes).copied()
    }
}

/// Which walks are wanted.
#[derive(Debug, Clone, Copy)]
pub struct Wanted<'a> {
    /// The lines.
    pub lines: &'a Lines,
    /// Lines of earlier classes do not occur.
    pub class: u8,
    /// Numbers of the sums of the lines counted.
    pub sums: &'a Sums,
    /// The end that all have in common, which is not counted.
    pub end: State,
    /// Whether that is where they lead to.
    pub towards: bool,
    /// Pairs of lines.
    pub pairs: usize,
    /// Whether the other end, by which they are grouped, is counted.
    pub counts: bool,
}

/// A walk being extended.
#[derive(Debug, Clone, Copy)]
struct Part {
    mask: Mask,
    dominoes: Dominoes,
    alike: u8,
}

impl Wanted<'_> {
    fn has(&self, state: State) -> bool {
        self.lines.class[usize::from(state)] >= self.class
    }

    fn counted(&self, part: Part, state: State) -> Part {
        let alike = u8::from(self.lines.class[usize::from(state)] == self.class);
        let dominoes = part.dominoes + self.lines.dominoes(state);
        Part { dominoes, alike: part.alike + alike, ..part }
    }

    /// The walks whose other end is this state.
    fn group(&self, other: State) -> Vec<Walk> {
        let mut walks = Vec::new();
        if self.has(other) {
            let (from, to) = if self.towards { (other, self.end) } else { (self.end, other) };
            let start = Part { mask: 0, dominoes: 0, alike: 0 };
            let start = if self.counts { self.counted(start, other) } else { start };
            self.extend(from, to, start, self.pairs, &mut walks);
        }
        walks.sort_unstable_by_key(|walk| walk.sum);
        walks
    }

    fn extend(&self, at: State, to: State, part: Part, pairs: usize, walks: &mut Vec<Walk>) {
        let law = &self.lines.law;
        if pairs == 1 {
            let last = self.lines.between(at, to);
            if let Some(mask) = last.and_then(|tiles| law.join(part.mask, tiles)) {
                let sum = self.sums.number(part.dominoes).unwrap_or(0);
                walks.push(Walk { mask, key: law.key(mask), sum, alike: part.alike });
            }
            return;
        }
        for &(next, tiles) in &self.lines.after[usize::from(at)] {
            if let Some(mask) = law.join(part.mask, tiles).filter(|_| self.has(next)) {
                self.extend(next, to, self.counted(Part { mask, ..part }, next), pairs - 1, walks);
            }
        }
    }

    /// All of them.
    pub fn walks(&self) -> Walks {
        let law = &self.lines.law;
        let states: Vec<State> = (0..self.lines.states() as State).collect();
        let groups: Vec<Vec<Walk>> = states.par_iter().map(|&state| self.group(state)).collect();
        let longest = |walks: &Vec<Walk>| {
            walks.iter().map(|walk| law.letters(walk.mask).count()).max().unwrap_or(0)
        };
        let stride = groups.par_iter().map(longest).max().unwrap_or(0);
        let count = groups.iter().map(Vec::len).sum();
        let mut all = Walks { stride, walks: Vec::with_capacity(count), ..Walks::default() };
        all.letters.reserve_exact(count * stride);
        let none = law.alphabet() as u8;
        for group in groups {
            let first = all.walks.len();
            for walk in group {
                let before = all.letters.len();
                all.letters.extend(law.letters(walk.mask));
                all.letters.resize(before + stride, none);
                all.walks.push(walk);
            }
            all.groups.push(first..all.walks.len());
        }
        all
    }
}

impl Walks {
    /// The walks of a group.
    pub fn of(&self, state: State) -> Group<'_> {
        let range = self.groups[usize::from(state)].clone();
        let letters = range.start * self.stride..range.end * self.stride;
        Group { walks: &self.walks[range], letters: &self.letters[letters], stride: self.stride }
    }
}

//! All walks of a few pairs of lines with one end in common, in groups by the other end.

use super::law::{Law, Mask};
use super::line::{Between, Dominoes, Lines, State};
use rayon::prelude::*;

/// A walk.
#[derive(Debug, Clone, Copy, Default)]
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
#[derive(Debug)]
pub struct Walks {
    /// The walks and their letters.
    groups: Vec<(Vec<Walk>, Vec<u8>)>,
    /// Letters of a walk: as many as there are, with one that conflicts with nothing for those
    /// missing.
    stride: usize,
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

/// Numbers for the sums of the dominoes along so many lines.
#[derive(Debug)]
pub struct Sums {
    kinds: usize,
    /// By lines added so far: by the number of their sum and the kind of the next line the number
    /// of the new sum.
    next: Vec<Vec<u32>>,
    /// By number: the sum of all.
    pub dominoes: Vec<Dominoes>,
}

impl Sums {
    /// All sums of so many lines.
    pub fn new(lines: &Lines, count: usize) -> Self {
        let kinds = &lines.kinds;
        let mut sums = Self { kinds: kinds.len(), next: Vec::new(), dominoes: vec![0] };
        for _ in 0..count {
            let longer = sums.dominoes.iter().flat_map(|sum| kinds.iter().map(move |k| sum + k));
            let longer: Vec<Dominoes> = longer.collect();
            let mut distinct = longer.clone();
            distinct.sort_unstable();
            distinct.dedup();
            let number = |sum| distinct.partition_point(|other| other < sum) as u32;
            sums.next.push(longer.iter().map(number).collect());
            sums.dominoes = distinct;
        }
        sums
    }

    #[inline(always)]
    fn add(&self, count: usize, sum: u32, kind: u16) -> u32 {
        self.next[count][sum as usize * self.kinds + usize::from(kind)]
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
    tiles: Between,
    /// Lines counted.
    count: usize,
    sum: u32,
    alike: u8,
}

/// What two parts use together, if they go together.
fn join(law: &Law, one: Between, other: Between) -> Option<Between> {
    let mask = law.join(one.mask, other.mask)?;
    Some(Between { mask, key: one.key.wrapping_add(other.key) })
}

/// By their sums: there are few of them, so counting is quickest.
fn sorted(walks: &[Walk], sums: usize) -> Vec<Walk> {
    let mut places = vec![0u32; sums];
    walks.iter().for_each(|walk| places[walk.sum as usize] += 1);
    let mut end = 0;
    for place in &mut places {
        (*place, end) = (end, end + *place);
    }
    let mut sorted = vec![Walk::default(); walks.len()];
    for walk in walks {
        let place = &mut places[walk.sum as usize];
        sorted[*place as usize] = *walk;
        *place += 1;
    }
    sorted
}

impl Wanted<'_> {
    fn has(&self, state: State) -> bool {
        self.lines.class[usize::from(state)] >= self.class
    }

    fn counted(&self, part: Part, state: State) -> Part {
        let alike = u8::from(self.lines.class[usize::from(state)] == self.class);
        let sum = self.sums.add(part.count, part.sum, self.lines.kind[usize::from(state)]);
        Part { count: part.count + 1, sum, alike: part.alike + alike, ..part }
    }

    /// The walks whose other end is this state.
    fn group(&self, other: State) -> Vec<Walk> {
        let mut walks = Vec::new();
        if self.has(other) {
            let (from, to) = if self.towards { (other, self.end) } else { (self.end, other) };
            let start = Part { tiles: Between::default(), count: 0, sum: 0, alike: 0 };
            let start = if self.counts { self.counted(start, other) } else { start };
            self.extend(from, to, start, self.pairs, &mut walks);
        }
        sorted(&walks, self.sums.dominoes.len())
    }

    fn extend(&self, at: State, to: State, part: Part, pairs: usize, walks: &mut Vec<Walk>) {
        let law = &self.lines.law;
        if pairs == 1 {
            let last = self.lines.between(at, to);
            if let Some(Between { mask, key }) = last.and_then(|last| join(law, part.tiles, last)) {
                let Part { sum, alike, .. } = part;
                walks.push(Walk { mask, key, sum, alike });
            }
            return;
        }
        for &(next, tiles) in &self.lines.after[usize::from(at)] {
            if let Some(tiles) = join(law, part.tiles, tiles).filter(|_| self.has(next)) {
                self.extend(next, to, self.counted(Part { tiles, ..part }, next), pairs - 1, walks);
            }
        }
    }

    /// All of them.
    pub fn walks(&self) -> Walks {
        let stride = self.pairs * self.lines.frame.length;
        let law = &self.lines.law;
        let group = |state: State| {
            let walks = self.group(state);
            let mut letters = vec![law.alphabet() as u8; walks.len() * stride];
            for (walk, letters) in walks.iter().zip(letters.chunks_exact_mut(stride)) {
                law.letters(walk.mask, letters);
            }
            (walks, letters)
        };
        let states: Vec<State> = (0..self.lines.states() as State).collect();
        let groups = states.par_iter().map(|&state| group(state)).collect();
        Walks { groups, stride }
    }
}

impl Walks {
    /// The walks of a group.
    pub fn of(&self, state: State) -> Group<'_> {
        let (walks, letters) = &self.groups[usize::from(state)];
        Group { walks, letters, stride: self.stride }
    }
}

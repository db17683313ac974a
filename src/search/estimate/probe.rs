//! One probe: a depth-first walk that leaves out subtrees at random.
//!
//! Every level has an *aim*. A node reached with weight `w` (the inverse of the probability of
//! being there) is kept for sure when `w` is at least the aim, and else with probability
//! `w / aim`, its weight then growing to the aim. So at every level the sum of the weights has
//! the number of nodes there as its expectation (Knuth 1975 with one path, Chen 1992 with many;
//! Grassberger 1997 walks them depth first as here).
//!
//! Nodes are kept not by independent coins but by one random point in every unit of the sum of
//! the probabilities (stratified sampling): neighbors in the walk, which are alike, share the
//! luck, and the number kept is nearly certain. A node may catch two points; it then counts
//! twice. Points equally far apart could fall into step with the colors; these cannot.

use super::replicates::Job;
use crate::search::{Alternatives, Problem};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Nodes between two looks at whether to stop.
const SLICE: u64 = 1 << 14;

/// How a probe thins the tree.
#[derive(Debug, Clone, PartialEq)]
pub struct Thinning {
    /// By level: the weight up to which nodes are thinned out, 0 where every node is kept.
    pub aims: Vec<f64>,
}

/// What a probe, or several, saw.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Sums {
    /// By level: the sum of the weights of the valid choices there, an unbiased estimate of
    /// their number. At the last level these are the solutions.
    pub choices: Vec<f64>,
    /// By level: the choices made.
    pub kept: Vec<u64>,
}

impl Sums {
    /// Nothing seen.
    pub fn new(levels: usize) -> Self {
        Self { choices: vec![0.0; levels], kept: vec![0; levels] }
    }

    /// Adds what another probe saw.
    pub fn add(&mut self, other: &Sums) {
        for (a, b) in self.choices.iter_mut().zip(&other.choices) {
            *a += b;
        }
        for (a, b) in self.kept.iter_mut().zip(&other.kept) {
            *a += b;
        }
    }

    /// Choices made.
    pub fn probed(&self) -> u64 {
        self.kept.iter().sum()
    }

    /// The number of nodes of the tree.
    pub fn nodes(&self) -> f64 {
        self.choices.iter().sum()
    }

    /// The number of solutions.
    pub fn solutions(&self) -> f64 {
        self.choices.last().copied().unwrap_or(1.0)
    }
}

/// Where a probe stands on a level.
#[derive(Debug, Clone, Copy)]
struct Frame<A> {
    /// Alternatives not yet looked at.
    left: A,
    /// The inverse of the probability of being here.
    weight: f64,
    choice: u32,
}

/// The random points of a level: how far along the sum of probabilities the next one is.
#[derive(Debug, Clone, Copy)]
struct Points {
    /// Up to the next point.
    next: f64,
    /// From that point to the end of its unit.
    rest: f64,
}

impl Points {
    fn new(random: &mut Pcg64Mcg) -> Self {
        let next = random.random();
        Self { next, rest: 1.0 - next }
    }

    /// Goes along by `step`, at most 1; how many points lie in it.
    #[inline(always)]
    fn step(&mut self, step: f64, random: &mut Pcg64Mcg) -> u32 {
        let mut caught = 0;
        self.next -= step;
        while self.next < 0.0 {
            caught += 1;
            let point: f64 = random.random();
            self.next += self.rest + point;
            self.rest = 1.0 - point;
        }
        caught
    }
}

/// Walks once; `None` when asked to stop, or after more than `most` nodes.
///
/// Nothing below a node that `hopeless` recognizes (given the number of choices made) is
/// visited or counted.
pub(super) fn probe<P: Problem>(
    problem: &mut P,
    thinning: &Thinning,
    mut hopeless: impl FnMut(&P, usize) -> bool,
    seed: u64,
    most: u64,
    job: &Job<'_>,
) -> Option<Sums> {
    let levels = problem.levels();
    let mut sums = Sums::new(levels);
    if levels == 0 {
        return Some(sums);
    }
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let mut points: Vec<Points> = (0..levels).map(|_| Points::new(&mut random)).collect();
    let start = Frame { left: P::Alternatives::EMPTY, weight: 1.0, choice: 0 };
    let mut frames = vec![start; levels];
    frames[0].left = problem.alternatives(0);
    sums.choices[0] = f64::from(frames[0].left.count());
    let (mut level, mut probed, mut pause) = (0, 0, SLICE);
    let mut here = frames[0];
    loop {
        if here.left.is_empty() {
            if level == 0 {
                return Some(sums);
            }
            level -= 1;
            here = frames[level];
            problem.pop(level, here.choice);
            continue;
        }
        let choice = here.left.first();
        here.left.remove(choice);
        let (mut weight, aim) = (here.weight, thinning.aims[level]);
        if weight < aim {
            let caught = points[level].step(weight / aim, &mut random);
            if caught == 0 {
                continue;
            }
            weight = aim * f64::from(caught);
        }
        sums.kept[level] += 1;
        probed += 1;
        if probed >= pause {
            pause = probed + SLICE;
            if probed > most || job.report(SLICE) {
                // The state of the problem is of no further use: the caller drops it.
                return None;
            }
        }
        if level + 1 == levels {
            continue;
        }
        here.choice = choice;
        frames[level] = here;
        problem.push(level, choice);
        level += 1;
        if hopeless(problem, level) {
            level -= 1;
            problem.pop(level, choice);
            continue;
        }
        let left = problem.alternatives(level);
        here = Frame { left, weight, choice: 0 };
        sums.choices[level] += weight * f64::from(left.count());
    }
}

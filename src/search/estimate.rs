//! How large a tree is and how many solutions it has, from a random part of it.
//!
//! A [probe](mod@probe) walks the tree depth first and leaves out subtrees at random, with known
//! probabilities; sums of inverse probabilities are unbiased estimates (Knuth 1975; Chen 1992).
//! How much to leave out at which level is learned first ([`survey`], then a few pilot probes);
//! then a fixed number of independent replicates is run with the same plan, and their scatter
//! gives the interval. All that is random comes from the seed and the number of the replicate,
//! so the answer does not depend on the number of threads.
//!
//! A tree small enough is walked completely instead; then the numbers are exact.

mod interval;
pub mod probe;
mod replicates;
pub mod survey;

pub use interval::Interval;

use super::{Limits, Plan, Problem, Progress, Sink, State, Stop, Values};
use probe::{Sums, Thinning, probe};
use replicates::{Job, in_parallel};

/// Independent replicates: enough for the scatter to be known within a tenth.
const REPLICATES: usize = 64;
/// Replicates without which there is no interval.
const FEWEST: usize = 8;
/// Nodes that go down the tree in the survey.
const SURVEYED: usize = 1000;
/// Pilot probes of a round.
const PILOTS: usize = 4;
/// The share of the effort for the size of the tree, when it needs probes of its own.
const SIZE_SHARE: f64 = 0.05;
/// By how much, in logarithms, more nodes are kept at each level than at the one before when
/// solutions are sought: what is rare lies deep. Measured on the C = 3 corner tiles.
const RAMP: f64 = 0.13;
/// Nodes kept at a level at least.
const FLOOR: f64 = 10.0;
/// The ramp ends at this many times fewer nodes, in logarithms.
const RAMP_MOST: f64 = 10.0;

/// How to estimate.
#[derive(Clone, Copy)]
pub struct Settings<'a> {
    /// The number of threads.
    pub threads: usize,
    /// Nodes to visit, about; also the largest tree that is walked completely.
    pub effort: u64,
    /// Of all random choices.
    pub seed: u64,
    /// Asked regularly whether to stop early.
    pub stop: &'a dyn Stop,
    /// Called some twenty times a second.
    pub watch: &'a dyn Fn(&Progress),
}

/// What was estimated.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// Nodes of the tree; `None` when stopped before there is an interval.
    pub nodes: Option<Interval>,
    /// Solutions; `None` also when no probe met one.
    pub solutions: Option<Interval>,
    /// Whether the tree was walked completely.
    pub exact: bool,
    /// Whether everything planned was done.
    pub complete: bool,
    /// Nodes visited.
    pub probed: u64,
    /// Replicates that the interval of the solutions comes from.
    pub replicates: usize,
}

/// Estimates the tree of a problem without choices.
///
/// `look` makes, for each probe, something that sees after each push (given the number of
/// choices made) whether no solution lies below; it only serves the number of solutions. `sink`
/// takes the solutions of a tree that is walked completely, and must never break off.
pub fn estimate<P, H, F, S>(
    problem: &P,
    look: Option<F>,
    sink: impl Fn() -> S,
    settings: &Settings<'_>,
) -> Estimate
where
    P: Problem,
    S: Sink<P>,
    H: FnMut(&P, usize) -> bool,
    F: Fn() -> H + Sync,
{
    let choices = survey::survey(&mut problem.clone(), SURVEYED, settings.seed);
    let size: f64 = choices.iter().sum();
    let mut effort = settings.effort as f64;
    if size <= effort / 4.0 {
        let limits = Limits { stop: settings.stop, nodes: settings.effort / 2 + 1 };
        let mut plan = Plan {
            threads: settings.threads,
            limits,
            watch: settings.watch,
            ..Plan::simple(problem.clone(), Values::Lexicographic)
        };
        let state = State::whole(&mut plan.problem);
        let (outcome, _) = super::run(&mut plan, state, sink);
        let (probed, complete) = (outcome.nodes, outcome.is_complete());
        if complete || settings.stop.should_stop() {
            let exact = |number: u64| complete.then(|| Interval::exact(number as f64));
            let (nodes, solutions) = (exact(outcome.nodes), exact(outcome.solutions));
            let exact = complete;
            return Estimate { nodes, solutions, exact, complete, probed, replicates: 0 };
        }
        // The survey lost its way and took the tree for a small one.
        effort /= 2.0;
    }
    let never = || |_: &P, _: usize| false;
    let Some(look) = look else {
        let sampler = Sampler { problem, look: never, settings, kind: 1 };
        let sample = sampler.sample(&choices, effort, RAMP);
        let nodes = Interval::of(&sample.each(Sums::nodes), FEWEST);
        return sample.estimate(nodes, 0, true);
    };
    let sampler = Sampler { problem, look: never, settings, kind: 1 };
    let sizes = sampler.sample(&choices, effort * SIZE_SHARE, 0.0);
    let nodes = Interval::of(&sizes.each(Sums::nodes), FEWEST);
    let sampler = Sampler { problem, look, settings, kind: 2 };
    let sample = sampler.sample(&choices, effort * (1.0 - SIZE_SHARE), RAMP);
    sample.estimate(nodes, sizes.probed, sizes.complete)
}

/// Makes probes of one kind.
struct Sampler<'a, P, F> {
    problem: &'a P,
    look: F,
    settings: &'a Settings<'a>,
    /// Keeps the random numbers of different samplers apart.
    kind: u64,
}

/// The replicates of a sampler.
struct Sample {
    sums: Vec<Sums>,
    probed: u64,
    complete: bool,
}

impl Sample {
    fn each(&self, number: fn(&Sums) -> f64) -> Vec<f64> {
        self.sums.iter().map(number).collect()
    }

    fn estimate(self, nodes: Option<Interval>, probed: u64, complete: bool) -> Estimate {
        let solutions = Interval::of(&self.each(Sums::solutions), FEWEST);
        Estimate {
            nodes,
            solutions: solutions.filter(|solutions| solutions.mean > 0.0),
            exact: false,
            complete: complete && self.complete,
            probed: probed + self.probed,
            replicates: self.sums.len(),
        }
    }
}

impl<P, H, F> Sampler<'_, P, F>
where
    P: Problem,
    H: FnMut(&P, usize) -> bool,
    F: Fn() -> H + Sync,
{
    /// Pilot probes from rough numbers of choices by level, then the replicates.
    fn sample(&self, choices: &[f64], effort: f64, ramp: f64) -> Sample {
        let mut choices = choices.to_vec();
        let each = (effort / (REPLICATES + PILOTS + 1) as f64).max(1.0);
        let (mut kept, mut spent) = (each / choices.len().max(1) as f64 / 16.0, 0);
        let mut round = 0;
        for share in [0.05, 0.2, 1.0] {
            // A pilot that runs away has learned nothing, but that it kept too much.
            for _ in 0..40 {
                round += 1;
                let thinning = Thinning::new(&choices, kept, ramp);
                let most = (8.0 * share * each) as u64 + 64;
                let sums = self.run(PILOTS, &thinning, most, round);
                if self.settings.stop.should_stop() {
                    return Sample { sums: Vec::new(), probed: spent, complete: false };
                }
                if sums.len() < PILOTS {
                    kept /= 4.0;
                    continue;
                }
                let mut total = Sums::new(choices.len());
                sums.iter().for_each(|sums| total.add(sums));
                spent += total.probed();
                for (known, seen) in choices.iter_mut().zip(&total.choices) {
                    // Where none got, the last that is known is better than no plan at all.
                    if *seen > 0.0 {
                        *known = seen / PILOTS as f64;
                    }
                }
                let used = total.probed().max(1) as f64 / PILOTS as f64;
                kept *= (share * each / used).clamp(0.125, 8.0);
                break;
            }
            kept *= if share < 1.0 { 4.0 } else { 1.0 };
        }
        let thinning = Thinning::new(&choices, kept, ramp);
        let sums = self.run(REPLICATES, &thinning, u64::MAX, 0);
        spent += sums.iter().map(Sums::probed).sum::<u64>();
        Sample { complete: sums.len() == REPLICATES, probed: spent, sums }
    }

    /// Probes with one thinning: the first that were finished.
    fn run(&self, count: usize, thinning: &Thinning, most: u64, round: u64) -> Vec<Sums> {
        let (problem, look) = (self.problem, &self.look);
        let (seed, kind) = (self.settings.seed, self.kind);
        let work = |number: usize, job: &Job<'_>| {
            let seed = mix(seed, kind, round, number);
            probe(&mut problem.clone(), thinning, look(), seed, most, job)
        };
        in_parallel(count, self.problem.levels(), self.settings, &work)
    }
}

impl Thinning {
    /// Keeps about `kept` nodes at the last level, where there are that many, and `ramp` less
    /// (in logarithms) at each level before.
    fn new(choices: &[f64], kept: f64, ramp: f64) -> Self {
        let last = choices.len().saturating_sub(1);
        let aim = |(level, &choices): (usize, &f64)| {
            let less = (ramp * (last - level) as f64).min(RAMP_MOST);
            choices / (kept * (-less).exp()).max(kept.min(FLOOR))
        };
        Self { aims: choices.iter().enumerate().map(aim).collect() }
    }
}

/// A seed of its own for everything that is random.
fn mix(seed: u64, kind: u64, round: u64, number: usize) -> u64 {
    let scramble = super::values::scramble;
    scramble(seed ^ scramble(kind << 48 ^ round << 32 ^ number as u64))
}

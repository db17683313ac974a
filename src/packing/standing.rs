//! Running a job from where it stands, and saving it on the way.
//!
//! What a search stands at is held in plain numbers ([`Standing`]), whatever the words of its
//! problem. To be saved, the search stops for a moment, hands over what it stands at, and goes
//! on while that is written: being stopped and taken up again is the ordinary case, not a
//! second way of working that only accidents would test.

use super::dispatch::{Visitor, with_job};
use super::job::Job;
use super::sinks::{Leaves, Purpose};
use super::solve::SolveError;
use super::{Labeled, Settings};
use crate::search::{self, Alternatives, Limits, Path, Plan, State, Stop, Trail};
use num_bigint::BigUint;
use std::time::Instant;

/// What a search stands at.
#[derive(Debug, Clone, PartialEq)]
pub struct Standing {
    /// What is left to visit and what was visited; of a packing that ends the search its labels.
    pub state: State<Trail, Vec<u8>>,
    /// The number of choices of a solution.
    pub levels: usize,
    /// Canonical packings met; of a count by lines, the walks looked up.
    pub orbits: u64,
    /// The sum of the sizes of their orbits; of a count by lines, the packings in its unit.
    pub orbit_sizes: BigUint,
    /// The labels of packings to keep, in no order: those that nobody has taken yet.
    pub kept: Vec<Vec<u8>>,
}

impl Standing {
    /// Whether the answer is final.
    pub fn is_complete(&self) -> bool {
        self.state.is_complete()
    }

    /// What a search without levels to visit comes to.
    pub fn nothing() -> Self {
        let state = State::start(Vec::new());
        Self { state, levels: 0, orbits: 0, orbit_sizes: BigUint::ZERO, kept: Vec::new() }
    }
}

/// Something that saves a search while it runs.
pub trait Keeper: Sync {
    /// Whether the search should hand over what it stands at; asked some twenty times a second.
    fn is_due(&self) -> bool;

    /// Takes what the search stands at. The search waits meanwhile, so this must be quick.
    fn keep(&self, standing: Standing);
}

/// Runs a job from its beginning, or from where it stood.
///
/// # Errors
/// When the job makes no sense, or what it stood at belongs to another one.
pub fn run(
    job: &Job,
    from: Option<Standing>,
    settings: &Settings<'_>,
) -> Result<Standing, SolveError> {
    job.check()?;
    let purpose = job.purpose()?;
    with_job(job, Search { job, from, settings, purpose })
}

/// A search waiting for its problem.
struct Search<'a> {
    job: &'a Job,
    from: Option<Standing>,
    settings: &'a Settings<'a>,
    purpose: Purpose,
}

impl Visitor for Search<'_> {
    type Output = Standing;

    fn visit<P: Labeled>(self, problem: Option<P>) -> Result<Standing, SolveError> {
        let Some(mut problem) = problem else { return Ok(Standing::nothing()) };
        let Self { job, from, settings, purpose } = self;
        let levels = problem.levels();
        let mut leaves = Leaves::new(purpose.clone());
        let mut state = match from {
            None => match job.part {
                None => State::whole(&mut problem),
                Some(part) => State::part(&mut problem, part),
            },
            Some(standing) => {
                (leaves.orbits, leaves.orbit_sizes) = (standing.orbits, standing.orbit_sizes);
                leaves.kept = standing.kept;
                standing.state.try_map(|trail| trail.path(&mut problem))?
            }
        };
        let (first_node, before, begin) = (state.nodes, state.elapsed, Instant::now());
        let due = Due(settings.keeper);
        let stop = (settings.limits.stop, &due);
        let mut plan = Plan::simple(problem, job.values);
        (plan.threads, plan.watch) = (settings.threads, settings.watch);
        plan.part = job.part;
        if state.is_complete() {
            return Ok(leaves.standing(&state, levels));
        }
        loop {
            let visited = state.nodes - first_node;
            let nodes = settings.limits.nodes - visited;
            plan.limits = Limits { stop: &stop, nodes };
            let sink;
            (state, sink) = search::run(&mut plan, state, || Leaves::new(purpose.clone()));
            search::Sink::<P>::join(&mut leaves, sink);
            // Also the time between two runs.
            state.elapsed = before + begin.elapsed();
            let visited = state.nodes - first_node;
            let over = visited >= settings.limits.nodes || settings.limits.stop.should_stop();
            let standing = leaves.standing(&state, levels);
            match settings.keeper {
                Some(keeper) if !state.is_complete() && !over => keeper.keep(standing),
                _ => return Ok(standing),
            }
        }
    }
}

/// Asks a search to stop when it is to be saved.
struct Due<'a>(Option<&'a dyn Keeper>);

impl Stop for Due<'_> {
    fn should_stop(&self) -> bool {
        self.0.is_some_and(Keeper::is_due)
    }
}

impl Leaves {
    /// What the search stands at; the packings kept are handed over.
    fn standing<A>(&mut self, state: &State<Path<A>, Vec<u8>>, levels: usize) -> Standing
    where
        A: Alternatives,
    {
        Standing {
            state: state.map(Trail::of),
            levels,
            orbits: self.orbits,
            orbit_sizes: self.orbit_sizes.clone(),
            kept: std::mem::take(&mut self.kept),
        }
    }
}

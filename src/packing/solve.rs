//! Answers to tasks: the first packing, their number, all of them.
//!
//! A task is reduced ([`Reduction`]), made into the problem that fits its kind, set and size in
//! words, and searched. The number of packings is the number of solutions met times what the
//! reduction left out; up to symmetry, canonical packings are counted and the sizes of their
//! orbits must add up to the same number, or the count is refused.

use super::dispatch::{Visitor, with_problem};
use super::reduction::Reduction;
use super::sinks::{Leaves, Purpose};
use super::{Labeled, Task, TaskError};
use crate::search::{self, Limits, Outcome, Plan, Progress, Values};
use crate::symmetry::{Canonizer, Group, GroupError, orbits};
use crate::tiles::TileError;
use num_bigint::BigUint;
use rayon::prelude::*;

/// How to search.
#[derive(Clone, Copy)]
pub struct Settings<'a> {
    /// The number of threads.
    pub threads: usize,
    /// When to stop early.
    pub limits: Limits<'a>,
    /// Called some twenty times a second.
    pub watch: &'a dyn Fn(&Progress),
    /// The order in which the alternatives of a level are tried.
    pub values: Values,
    /// Whether symmetry may be removed before the search (the answer is the same).
    pub reduce: bool,
}

impl Settings<'_> {
    /// One thread, no limits or reports, lexicographic order, reduced.
    pub const PLAIN: Settings<'static> = Settings {
        threads: 1,
        limits: Limits::NONE,
        watch: &|_| {},
        values: Values::Lexicographic,
        reduce: true,
    };
}

/// What a search did.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Work {
    /// Whether everything that matters was visited.
    pub complete: bool,
    /// Nodes visited.
    pub nodes: u64,
    /// The largest number of choices made at once.
    pub deepest: usize,
    /// The number of choices of a solution.
    pub levels: usize,
}

/// An answer and the work it took.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Answer<T> {
    /// The answer; not final when the work is not complete.
    pub value: T,
    /// What the search did.
    pub work: Work,
}

/// A number of packings.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Counted {
    /// All packings; a lower bound when the search was not complete.
    pub packings: BigUint,
    /// Packings up to symmetry, when asked for.
    pub fundamental: Option<u64>,
    /// Packings up to translation, where every packing has as many translates as cells.
    pub up_to_translation: Option<BigUint>,
}

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
pub enum SolveError {
    /// The question makes no sense.
    #[error(transparent)]
    Task(#[from] TaskError),
    /// The symmetries cannot be had.
    #[error(transparent)]
    Group(#[from] GroupError),
    /// Symmetry is asked for where labels given beforehand break it.
    #[error("up to symmetry: pins break the symmetry, so there are no orbits to count")]
    PinnedOrbits,
    /// The check of the count by orbits failed: an error in this program.
    #[error(
        "internal error: {direct} packings counted, but the orbits add up to {orbits}; please report this"
    )]
    Disagreement {
        /// By the reduction.
        direct: BigUint,
        /// By the orbits.
        orbits: BigUint,
    },
    /// A tile set could not be made: an error in this program.
    #[error("internal error: {0}; please report this")]
    Tiles(#[from] TileError),
}

/// The labels of the first packing of the search, or `None` when there is none.
///
/// The packing, and the number of nodes before it, do not depend on the number of threads,
/// unless a limit ends the search first.
///
/// # Errors
/// When the task makes no sense.
pub fn find(task: &Task, settings: &Settings<'_>) -> Result<Answer<Option<Vec<u8>>>, SolveError> {
    let reduction = if settings.reduce { Reduction::full(task) } else { Reduction::none() };
    let answer = run(task, &reduction, settings, Purpose::First)?;
    let value = answer.value.found;
    Ok(Answer { value, work: answer.work })
}

/// The number of packings.
///
/// # Errors
/// When the task makes no sense, or has no orbits to count.
pub fn count(
    task: &Task,
    settings: &Settings<'_>,
    up_to_symmetry: bool,
) -> Result<Answer<Counted>, SolveError> {
    let reduction = match (settings.reduce, up_to_symmetry) {
        (false, _) => Reduction::none(),
        (true, true) => Reduction::anchored(task),
        (true, false) => Reduction::full(task),
    };
    let purpose = match up_to_symmetry {
        true => orbits_of(task, &reduction, false)?,
        false => Purpose::Count,
    };
    let answer = run(task, &reduction, settings, purpose)?;
    let packings = reduction.packings(answer.value.met);
    let complete = answer.work.complete;
    if up_to_symmetry && complete && answer.value.leaves.orbit_sizes != packings {
        let orbits = answer.value.leaves.orbit_sizes;
        return Err(SolveError::Disagreement { direct: packings, orbits });
    }
    // No two translates agree: each tile (or one tile of a compact class) has one cell.
    let free = !task.cover && !task.has_pins();
    let up_to_translation = (free && complete).then(|| &packings / task.shape.cells());
    let fundamental = up_to_symmetry.then_some(answer.value.leaves.orbits);
    Ok(Answer { value: Counted { packings, fundamental, up_to_translation }, work: answer.work })
}

/// The labels of all packings, or of one canonical packing of every orbit, sorted.
///
/// They are held in memory: one byte a label each.
///
/// # Errors
/// When the task makes no sense, or has no orbits to count.
pub fn list(
    task: &Task,
    settings: &Settings<'_>,
    up_to_symmetry: bool,
) -> Result<Answer<Vec<Vec<u8>>>, SolveError> {
    let reduction = if settings.reduce { Reduction::anchored(task) } else { Reduction::none() };
    let purpose = match up_to_symmetry {
        true => orbits_of(task, &reduction, true)?,
        false => Purpose::Keep,
    };
    let answer = run(task, &reduction, settings, purpose)?;
    let mut packings = answer.value.leaves.kept;
    if !up_to_symmetry && !reduction.is_none() {
        let translations = Group::translations(&task.set, task.shape);
        packings = packings
            .par_iter()
            .flat_map_iter(|labels| orbits::expand(&translations, labels))
            .collect();
    }
    packings.par_sort_unstable();
    // A compact packing is met with either of its two windows at the origin.
    packings.dedup();
    Ok(Answer { value: packings, work: answer.work })
}

fn orbits_of(task: &Task, reduction: &Reduction, keep: bool) -> Result<Purpose, SolveError> {
    if task.has_pins() {
        return Err(SolveError::PinnedOrbits);
    }
    task.check()?;
    let group = Group::of(&task.set, task.shape, task.automorphism.as_ref())?;
    let canonizer = Box::new(Canonizer::new(&group, reduction.anchor));
    Ok(Purpose::Orbits { canonizer, keep })
}

/// What a run over a problem gives.
struct Met {
    found: Option<Vec<u8>>,
    /// Solutions met.
    met: u64,
    leaves: Leaves,
}

fn run(
    task: &Task,
    reduction: &Reduction,
    settings: &Settings<'_>,
    purpose: Purpose,
) -> Result<Answer<Met>, SolveError> {
    with_problem(task, reduction, Search { settings, purpose })
}

/// A search waiting for its problem.
struct Search<'a> {
    settings: &'a Settings<'a>,
    purpose: Purpose,
}

impl Visitor for Search<'_> {
    type Output = Answer<Met>;

    fn visit<P: Labeled>(self, problem: Option<P>) -> Result<Answer<Met>, SolveError> {
        let Some(problem) = problem else {
            let work = Work { complete: true, nodes: 0, deepest: 0, levels: 0 };
            let leaves = Leaves::new(self.purpose);
            return Ok(Answer { value: Met { found: None, met: 0, leaves }, work });
        };
        let Settings { threads, limits, watch, values, .. } = *self.settings;
        let levels = problem.levels();
        let plan = Plan { threads, limits, watch, ..Plan::whole(problem, values) };
        let outcome: Outcome<_, Leaves, _> =
            search::run(plan, || Leaves::new(self.purpose.clone()));
        let Outcome { complete, found, nodes, solutions, deepest, sink, .. } = outcome;
        let work = Work { complete, nodes, deepest, levels };
        Ok(Answer { value: Met { found, met: solutions, leaves: sink }, work })
    }
}

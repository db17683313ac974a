//! Answers to tasks: the first packing, their number, all of them.
//!
//! A task is reduced (see [`reduction`](super::reduction)), made into the problem that fits its
//! kind, set and size in words, and searched. The number of packings is the number of solutions
//! met times what the reduction left out; up to symmetry, canonical packings are counted and the
//! sizes of their orbits must add up to the same number, or the count is refused.

use super::TaskError;
use super::halves::HalvesError;
use super::job::{Job, Question};
use super::rows::{Rows, RowsError, line::Frame};
use super::standing::{Keeper, Standing, run};
use crate::search::{Effort, Limits, Progress, TrailError};
use crate::symmetry::{Group, GroupError, orbits};
use crate::tiles::{Kind, TileError};
use num_bigint::BigUint;
use rayon::prelude::*;

/// How to search, as far as it changes no answer.
#[derive(Clone, Copy)]
pub struct Settings<'a> {
    /// The number of threads.
    pub threads: usize,
    /// When to stop early; nodes are those visited from now on.
    pub limits: Limits<'a>,
    /// Called some twenty times a second.
    pub watch: &'a dyn Fn(&Progress),
    /// Saves the search while it runs.
    pub keeper: Option<&'a dyn Keeper>,
}

impl Settings<'_> {
    /// One thread, no limits or reports, nothing saved.
    pub const PLAIN: Settings<'static> =
        Settings { threads: 1, limits: Limits::NONE, watch: &|_| {}, keeper: None };
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

impl Counted {
    /// None at all, which no search was needed to see.
    pub fn nothing(job: &Job) -> Self {
        let fundamental = job.up_to_symmetry().then_some(0);
        let up_to_translation = Some(BigUint::ZERO);
        Self { packings: BigUint::ZERO, fundamental, up_to_translation }
    }
}

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
pub enum SolveError {
    /// The question makes no sense.
    #[error(transparent)]
    Task(#[from] TaskError),
    /// The packings cannot be counted by lines.
    #[error(transparent)]
    Rows(#[from] RowsError),
    /// The packings cannot be counted by halves.
    #[error(transparent)]
    Halves(#[from] HalvesError),
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
    /// Packings counted by lines do not add up to a whole number: an error in this program.
    #[error(
        "internal error: the packings counted by lines are no multiple of 1/{0}; please report this"
    )]
    Fraction(BigUint),
    /// What is to be taken up again belongs to another search.
    #[error("what was saved does not fit this search: {0}")]
    Trail(#[from] TrailError),
    /// A tile set could not be made: an error in this program.
    #[error("internal error: {0}; please report this")]
    Tiles(#[from] TileError),
}

/// The labels of the first packing of the search of a task or job, or `None` when there is none.
///
/// The packing, and the number of nodes before it, do not depend on the number of threads,
/// unless a limit ends the search first.
///
/// # Errors
/// When the task makes no sense.
pub fn find(
    job: impl Into<Job>,
    settings: &Settings<'_>,
) -> Result<Answer<Option<Vec<u8>>>, SolveError> {
    let job = Job { question: Question::First, ..job.into() };
    let standing = run(&job, None, settings)?;
    Ok(Answer { work: Work::of(&standing), value: standing.first().cloned() })
}

/// The number of packings of a task or job.
///
/// # Errors
/// When the task makes no sense, or has no orbits to count.
pub fn count(
    job: impl Into<Job>,
    settings: &Settings<'_>,
    up_to_symmetry: bool,
) -> Result<Answer<Counted>, SolveError> {
    let job = Job { question: Question::Count { up_to_symmetry }, ..job.into() };
    let standing = run(&job, None, settings)?;
    Ok(Answer { value: counted(&job, &standing)?, work: Work::of(&standing) })
}

/// The labels of all packings of a task or job, or of one canonical packing of every orbit,
/// sorted.
///
/// They are held in memory: one byte a label each.
///
/// # Errors
/// When the task makes no sense, or has no orbits to count.
pub fn list(
    job: impl Into<Job>,
    settings: &Settings<'_>,
    up_to_symmetry: bool,
) -> Result<Answer<Vec<Vec<u8>>>, SolveError> {
    let job = Job { question: Question::List { up_to_symmetry }, ..job.into() };
    let mut standing = run(&job, None, settings)?;
    let kept = std::mem::take(&mut standing.kept);
    Ok(Answer { value: listed(&job, kept), work: Work::of(&standing) })
}

impl Standing {
    /// The labels of the packing that ends the search; the first when the search is complete.
    pub fn first(&self) -> Option<&Vec<u8>> {
        self.state.best.as_ref().map(|best| &best.found)
    }
}

impl Work {
    /// The work that led to where a search stands.
    pub fn of(standing: &Standing) -> Self {
        let Effort { nodes, deepest, .. } = standing.state.effort();
        Self { complete: standing.is_complete(), nodes, deepest, levels: standing.levels }
    }
}

/// The number of packings, from what the search of a job met.
///
/// # Errors
/// When the check by orbits fails, which is an error in this program.
pub fn counted(job: &Job, standing: &Standing) -> Result<Counted, SolveError> {
    let task = &job.task;
    let packings = match job.by_lines {
        false => job.reduction().packings(standing.state.solutions),
        true => by_lines(job, standing)?,
    };
    // A part does not meet all translates that make up an orbit.
    let whole = standing.is_complete() && job.part.is_none();
    if job.up_to_symmetry() && whole && standing.orbit_sizes != packings {
        let orbits = standing.orbit_sizes.clone();
        return Err(SolveError::Disagreement { direct: packings, orbits });
    }
    // No two translates agree: each tile (or one tile of a compact class) has one cell.
    let free = !task.cover && !task.has_pins() && task.board.is_plain();
    let up_to_translation = (free && whole).then(|| &packings / task.shape.cells());
    let fundamental = job.up_to_symmetry().then_some(standing.orbits);
    Ok(Counted { packings, fundamental, up_to_translation })
}

/// The number of packings counted by lines; of a part or a count not yet complete, as many as it
/// shows there are.
fn by_lines(job: &Job, standing: &Standing) -> Result<BigUint, SolveError> {
    let unit = BigUint::from(match job.task.set.kind() {
        Kind::Corner => Rows::unit(Frame::of(&job.task).lines),
        _ => 1,
    });
    let packings = &standing.orbit_sizes / &unit;
    let whole = standing.is_complete() && job.part.is_none();
    if whole && &packings * &unit != standing.orbit_sizes {
        return Err(SolveError::Fraction(unit));
    }
    Ok(packings)
}

/// The labels of all packings asked for, sorted, from those that the search of a job kept.
pub fn listed(job: &Job, kept: Vec<Vec<u8>>) -> Vec<Vec<u8>> {
    let mut packings = kept;
    if !job.up_to_symmetry() && !job.reduction().is_none() {
        let translations = Group::translations(&job.task.set, job.task.shape);
        packings = packings
            .par_iter()
            .flat_map_iter(|labels| orbits::expand(&translations, labels))
            .collect();
    }
    packings.par_sort_unstable();
    // A compact packing is met with either of its two windows at the origin.
    packings.dedup();
    packings
}

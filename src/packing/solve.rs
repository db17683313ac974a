//! Answers to tasks: the first packing, their number, all of them.
//!
//! A task is reduced ([`Reduction`]), made into the problem that fits its kind, set and size in
//! words, and searched. The number of packings is the number of solutions met times what the
//! reduction left out; up to symmetry, canonical packings are counted and the sizes of their
//! orbits must add up to the same number, or the count is refused.

use super::reduction::Reduction;
use super::sinks::{Leaves, Purpose};
use super::task::tiles_to_choose;
use super::{Labeled, Task, TaskError, ring, rule, wang_rule};
use super::{
    corner::Corner,
    wang::{Shown, Wang},
};
use crate::search::{self, Limits, Outcome, Plan, Progress, Values};
use crate::symmetry::{Canonizer, Group, GroupError, orbits};
use crate::tiles::{Kind, TileError};
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
    task.check()?;
    let search = Search { settings, purpose };
    match task.set.kind() {
        Kind::Corner => corner(task, reduction, search),
        Kind::Wang => wang(task, reduction, Shown::Both, search),
        Kind::Domino => {
            let (wang_task, reduction) = (ring::task(task)?, ring::reduction(task, reduction)?);
            wang(&wang_task, &reduction, ring::shown(task), search)
        }
    }
}

/// A search waiting for its problem.
struct Search<'a> {
    settings: &'a Settings<'a>,
    purpose: Purpose,
}

impl Search<'_> {
    fn over<P: Labeled>(
        self,
        problem: Result<Option<P>, TaskError>,
    ) -> Result<Answer<Met>, SolveError> {
        let Some(problem) = problem? else {
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

fn corner(
    task: &Task,
    reduction: &Reduction,
    search: Search<'_>,
) -> Result<Answer<Met>, SolveError> {
    let cells = task.shape.cells();
    match (task.set.colors().horizontal(), cells) {
        (0..=4, 0..=511) => corner_words::<1, 4, 64, 512>(task, reduction, search),
        (0..=8, 0..=8191) => corner_words::<2, 8, 512, 8192>(task, reduction, search),
        _ => corner_words::<16, 64, 262_144, 65536>(task, reduction, search),
    }
}

fn corner_words<const W: usize, const C: usize, const ROWS: usize, const L: usize>(
    task: &Task,
    reduction: &Reduction,
    search: Search<'_>,
) -> Result<Answer<Met>, SolveError> {
    use rule::{Cover, Once, Pairs};
    let spare = task.shape.cells() as u64 - task.set.size();
    let compact = task.set.is_compact();
    let cover = |rows| Cover::<ROWS>::new(rows, spare, compact.then_some(2));
    match (task.cover, compact, task.automorphism.is_some()) {
        (true, _, _) => search.over(Corner::<_, W, C, L, true>::new(task, reduction, cover)),
        (_, true, true) => {
            search.over(Corner::<_, W, C, L, true>::new(task, reduction, Pairs::<ROWS>::new))
        }
        (_, true, false) => {
            search.over(Corner::<_, W, C, L, false>::new(task, reduction, Pairs::<ROWS>::new))
        }
        (_, false, true) => {
            search.over(Corner::<_, W, C, L, true>::new(task, reduction, Once::<ROWS>::new))
        }
        (_, false, false) => {
            search.over(Corner::<_, W, C, L, false>::new(task, reduction, Once::<ROWS>::new))
        }
    }
}

fn wang(
    task: &Task,
    reduction: &Reduction,
    shown: Shown,
    search: Search<'_>,
) -> Result<Answer<Met>, SolveError> {
    let tiles = tiles_to_choose(&task.set);
    let cells = task.shape.cells();
    match (tiles, cells) {
        (0..=64, 0..=127) => wang_words::<1, 128>(task, reduction, shown, search),
        (0..=256, 0..=511) => wang_words::<4, 512>(task, reduction, shown, search),
        (0..=1024, 0..=1023) => wang_words::<16, 1024>(task, reduction, shown, search),
        _ => wang_words::<64, 8192>(task, reduction, shown, search),
    }
}

fn wang_words<const N: usize, const L: usize>(
    task: &Task,
    reduction: &Reduction,
    shown: Shown,
    search: Search<'_>,
) -> Result<Answer<Met>, SolveError> {
    let (set, colors) = (&task.set, task.set.colors());
    let class = || -> Vec<u32> {
        let north_west = |tile| {
            let [n, _, _, w] = set.kind().unpack(tile, colors).map(u32::from);
            n * colors.vertical() as u32 + w
        };
        set.allowed().map(north_west).collect()
    };
    let tiles = || set.size() as usize;
    let spare = task.shape.cells() as u64 - set.size();
    if task.cover {
        let class = set.is_compact().then(class);
        let count = class.as_ref().map_or_else(tiles, Vec::len);
        let rule = wang_rule::Cover::<N>::new(count, spare, class);
        search.over(Wang::<N, L, _, true>::new(task, reduction, shown, rule))
    } else if set.is_compact() {
        let rule = wang_rule::Pairs::<N>::new(class());
        search.over(Wang::<N, L, _, true>::new(task, reduction, shown, rule))
    } else {
        let rule = wang_rule::Once::<N, L>::new(tiles());
        match task.automorphism.is_some() {
            true => search.over(Wang::<N, L, _, true>::new(task, reduction, shown, rule)),
            false => search.over(Wang::<N, L, _, false>::new(task, reduction, shown, rule)),
        }
    }
}

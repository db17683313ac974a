//! From a task to the problem that fits its kind, set and size in words.
//!
//! The problems are generic over the number of words, the law of the set and the presence of an
//! automorphism, so that the inner loop is compiled for each; here is the one place where the
//! type is chosen. What is to be done with the problem comes as a [`Visitor`].

use super::board::Planned;
use super::corner::Corner;
use super::halves::Halves;
use super::last_lines::LastLines;
use super::reduction::Reduction;
use super::rows::Rows;
use super::solve::SolveError;
use super::task::tiles_to_choose;
use super::wang::{Shown, Wang};
use super::watched::Watched;
use super::{Job, Labeled, Task, TaskError, ring, rule, wang_rule};
use crate::tiles::Kind;

/// Something to do with a problem of any type.
pub trait Visitor {
    /// What comes of it.
    type Output;

    /// Does it. There is no problem when what the reduction fixes already contradicts itself:
    /// then there is no solution either.
    ///
    /// # Errors
    /// Whatever the visitor reports.
    fn visit<P: Labeled>(self, problem: Option<P>) -> Result<Self::Output, SolveError>;
}

/// Makes the problem of a job, which has been checked, and lets the visitor do with it what it
/// is for.
///
/// # Errors
/// What the visitor reports.
pub fn with_job<V: Visitor>(job: &Job, visitor: V) -> Result<V::Output, SolveError> {
    match (job.by_lines, job.task.set.kind()) {
        (true, Kind::Wang) => visitor.visit(Some(Halves::new(&job.task))),
        (true, _) => visitor.visit(Some(Rows::new(&job.task))),
        (false, _) => with_problem(&job.task, &job.reduction(), visitor),
    }
}

/// Makes the problem of a task and lets the visitor do with it what it is for.
///
/// # Errors
/// When the task makes no sense, or what the visitor reports.
pub fn with_problem<V: Visitor>(
    task: &Task,
    reduction: &Reduction,
    visitor: V,
) -> Result<V::Output, SolveError> {
    task.check()?;
    if !task.board.is_plain() {
        return on_board(task, visitor);
    }
    match task.set.kind() {
        Kind::Corner => corner(task, reduction, visitor),
        Kind::Wang => wang(task, reduction, Shown::Both, visitor),
        Kind::Domino => {
            let (wang_task, reduction) = (ring::task(task)?, ring::reduction(task, reduction)?);
            wang(&wang_task, &reduction, ring::shown(task), visitor)
        }
    }
}

fn on_board<V: Visitor>(task: &Task, visitor: V) -> Result<V::Output, SolveError> {
    let planned = Planned::new(task, true);
    match planned.words() {
        0..=1 => visitor.visit(Some(planned.problem::<1>())),
        2..=8 => visitor.visit(Some(planned.problem::<8>())),
        _ => visitor.visit(Some(planned.problem::<64>())),
    }
}

fn over<V: Visitor, P: Labeled>(
    visitor: V,
    problem: Result<Option<P>, TaskError>,
) -> Result<V::Output, SolveError> {
    visitor.visit(problem?)
}

fn corner<V: Visitor>(
    task: &Task,
    reduction: &Reduction,
    visitor: V,
) -> Result<V::Output, SolveError> {
    if task.prunings.last_lines
        && let Some(last) = LastLines::new(task, reduction)
    {
        return watched(task, reduction, last, visitor);
    }
    let cells = task.shape.cells();
    match (task.set.colors().horizontal(), cells) {
        (0..=4, 0..=511) => corner_words::<1, 4, 64, 512, V>(task, reduction, visitor),
        (0..=8, 0..=8191) => corner_words::<2, 8, 512, 8192, V>(task, reduction, visitor),
        _ => corner_words::<16, 64, 262_144, 65536, V>(task, reduction, visitor),
    }
}

/// Packings over few colors, with a look at the last lines.
fn watched<V: Visitor>(
    task: &Task,
    reduction: &Reduction,
    last: LastLines,
    visitor: V,
) -> Result<V::Output, SolveError> {
    fn over<V: Visitor, P: Labeled>(
        visitor: V,
        problem: Result<Option<P>, TaskError>,
        last: LastLines,
    ) -> Result<V::Output, SolveError> {
        visitor.visit(problem?.map(|problem| Watched::new(problem, last)))
    }
    type Small<R, const QUOTIENT: bool> = Corner<R, 1, 4, 512, QUOTIENT>;
    let (once, pairs) = (rule::Once::<64>::new, rule::Pairs::<64>::new);
    match (task.set.is_compact(), task.automorphism.is_some()) {
        (true, true) => over(visitor, Small::<_, true>::new(task, reduction, pairs), last),
        (true, false) => over(visitor, Small::<_, false>::new(task, reduction, pairs), last),
        (false, true) => over(visitor, Small::<_, true>::new(task, reduction, once), last),
        (false, false) => over(visitor, Small::<_, false>::new(task, reduction, once), last),
    }
}

fn corner_words<const W: usize, const C: usize, const ROWS: usize, const L: usize, V: Visitor>(
    task: &Task,
    reduction: &Reduction,
    visitor: V,
) -> Result<V::Output, SolveError> {
    use rule::{Cover, Once, Pairs};
    let spare = task.shape.cells() as u64 - task.set.size();
    let compact = task.set.is_compact();
    let cover = |rows| Cover::<ROWS>::new(rows, spare, compact.then_some(2));
    match (task.cover, compact, task.automorphism.is_some()) {
        (true, _, _) => over(visitor, Corner::<_, W, C, L, true>::new(task, reduction, cover)),
        (_, true, true) => {
            over(visitor, Corner::<_, W, C, L, true>::new(task, reduction, Pairs::<ROWS>::new))
        }
        (_, true, false) => {
            over(visitor, Corner::<_, W, C, L, false>::new(task, reduction, Pairs::<ROWS>::new))
        }
        (_, false, true) => {
            over(visitor, Corner::<_, W, C, L, true>::new(task, reduction, Once::<ROWS>::new))
        }
        (_, false, false) => {
            over(visitor, Corner::<_, W, C, L, false>::new(task, reduction, Once::<ROWS>::new))
        }
    }
}

fn wang<V: Visitor>(
    task: &Task,
    reduction: &Reduction,
    shown: Shown,
    visitor: V,
) -> Result<V::Output, SolveError> {
    let tiles = tiles_to_choose(&task.set);
    let cells = task.shape.cells();
    match (tiles, cells) {
        (0..=64, 0..=127) => wang_words::<1, 128, V>(task, reduction, shown, visitor),
        (0..=256, 0..=511) => wang_words::<4, 512, V>(task, reduction, shown, visitor),
        (0..=1024, 0..=1023) => wang_words::<16, 1024, V>(task, reduction, shown, visitor),
        _ => wang_words::<64, 8192, V>(task, reduction, shown, visitor),
    }
}

fn wang_words<const N: usize, const L: usize, V: Visitor>(
    task: &Task,
    reduction: &Reduction,
    shown: Shown,
    visitor: V,
) -> Result<V::Output, SolveError> {
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
        over(visitor, Wang::<N, L, _, true>::new(task, reduction, shown, rule))
    } else if set.is_compact() {
        let rule = wang_rule::Pairs::<N>::new(class());
        over(visitor, Wang::<N, L, _, true>::new(task, reduction, shown, rule))
    } else {
        let rule = wang_rule::Once::<N, L>::new(tiles());
        match task.automorphism.is_some() {
            true => over(visitor, Wang::<N, L, _, true>::new(task, reduction, shown, rule)),
            false => over(visitor, Wang::<N, L, _, false>::new(task, reduction, shown, rule)),
        }
    }
}

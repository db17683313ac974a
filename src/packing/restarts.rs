//! A first packing by search that is begun again and again.

use super::dispatch::{Visitor, with_problem};
use super::sinks::{Leaves, Purpose};
use super::solve::SolveError;
use super::{Job, Labeled};
use crate::search::{Limits, Race, Restarts, restart};

/// What a search with restarts came to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Restarted {
    /// The labels of a packing.
    pub labels: Option<Vec<u8>>,
    /// Whether a run has visited the whole tree and met no packing.
    pub none: bool,
    /// The run that gave the answer, from 0, or the runs that ended without.
    pub run: u64,
    /// Nodes of all runs up to that one.
    pub nodes: u64,
    /// The largest number of choices made at once.
    pub deepest: usize,
    /// The number of choices of a packing.
    pub levels: usize,
}

/// Looks for a packing of a job in the orders of the restarts, until it is found, it is plain that
/// there is none, or the limits say stop. The answer does not depend on the number of threads.
///
/// # Errors
/// When the task makes no sense.
pub fn find_restarting(
    job: &Job,
    restarts: Restarts,
    threads: usize,
    limits: &Limits<'_>,
) -> Result<Restarted, SolveError> {
    let runs = Runs { restarts, threads, limits };
    with_problem(&job.task, &job.reduction(), runs)
}

/// Runs waiting for their problem.
struct Runs<'a> {
    restarts: Restarts,
    threads: usize,
    limits: &'a Limits<'a>,
}

impl Visitor for Runs<'_> {
    type Output = Restarted;

    fn visit<P: Labeled>(self, problem: Option<P>) -> Result<Restarted, SolveError> {
        let Self { restarts, threads, limits } = self;
        let Some(problem) = problem else {
            let (labels, none) = (None, true);
            return Ok(Restarted { labels, none, run: 0, nodes: 0, deepest: 0, levels: 0 });
        };
        let levels = problem.levels();
        let sink = || Leaves::new(Purpose::First);
        let Race { found, nodes, ended, depth: deepest } =
            restart(&problem, restarts, threads, limits, sink);
        let (run, labels, none) = match found {
            Some((run, Some(labels))) => (run, Some(labels), false),
            Some((run, None)) => (run, None, true),
            None => (ended, None, false),
        };
        Ok(Restarted { labels, none, run, nodes, deepest, levels })
    }
}

//! Where the search of a job is cut into parts.

use super::dispatch::{Visitor, with_job};
use super::sinks::{Leaves, Purpose};
use super::solve::SolveError;
use super::{Job, Labeled};
use crate::search::{self, Frontier};

/// How to choose the depth of a frontier.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cut {
    /// So deep.
    Depth(usize),
    /// No deeper than needed for so many nodes, where there are so many at any depth.
    Nodes(u64),
}

/// The frontier of the search of a job; without nodes when there is nothing to search.
///
/// # Errors
/// When the job makes no sense.
pub fn frontier(job: &Job, cut: Cut) -> Result<Frontier, SolveError> {
    job.check()?;
    with_job(job, cut)
}

impl Visitor for Cut {
    type Output = Frontier;

    fn visit<P: Labeled>(self, problem: Option<P>) -> Result<Frontier, SolveError> {
        // The sink of every search, told to do nothing: it makes no second copy of the walk.
        let mut sink = Leaves::new(Purpose::Count);
        let nothing = Frontier { depth: 1, nodes: 0, above: 0 };
        Ok(match (problem, self) {
            (None, _) => nothing,
            (Some(problem), _) if problem.levels() == 0 => nothing,
            (Some(problem), Cut::Depth(depth)) => {
                search::cut(&problem, depth.clamp(1, problem.levels()), &mut sink)
            }
            (Some(problem), Cut::Nodes(nodes)) => search::frontier(&problem, nodes, &mut sink),
        })
    }
}

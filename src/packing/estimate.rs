//! How many packings there are, and how long counting them would take, from random probes.
//!
//! The estimate is that of [`crate::search::estimate`] for the same reduced tree that an exact
//! count walks, multiplied by what the reduction left out. Corner packings are probed with a
//! look at their last lines ([`LastLines`]); what that saves is not saved by the count, so the
//! size of the tree gets probes of its own.
//!
//! How long a count would take is told by the rate of the search itself, measured on the
//! beginning of its walk: probes are slower.

use super::dispatch::{Visitor, with_problem};
use super::last_lines::LastLines;
use super::reduction::Reduction;
use super::sinks::{Leaves, Purpose};
use super::solve::SolveError;
use super::{Labeled, Task};
use crate::search::estimate::{Estimate, Interval, Settings, estimate as estimate_tree};
use crate::search::{Slice, Stop, Values, Walk};
use std::time::{Duration, Instant};

/// How long the search is run to learn its rate.
const TRIAL: Duration = Duration::from_millis(300);
/// Nodes between two looks at the clock.
const TRIAL_NODES: u64 = 1 << 16;

/// An estimate for a task.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimated {
    /// Of the tree; its solutions are packings, multiplied by what the reduction left out.
    pub tree: Estimate,
    /// Nodes per second of the search on one thread; `None` when it was over too soon to tell.
    pub rate: Option<f64>,
}

/// Estimates the nodes of the search tree and the packings of a task; `reduce` as for counts.
///
/// # Errors
/// When the task makes no sense.
pub fn estimate(
    task: &Task,
    settings: &Settings<'_>,
    reduce: bool,
) -> Result<Estimated, SolveError> {
    let reduction = if reduce { Reduction::full(task) } else { Reduction::none() };
    task.check()?;
    let last = LastLines::new(task, &reduction);
    let mut estimated = with_problem(task, &reduction, Probing { last: last.as_ref(), settings })?;
    let factor = reduction.packings_per_solution();
    let solutions = &mut estimated.tree.solutions;
    *solutions = solutions.map(|number| number.times(factor));
    Ok(estimated)
}

/// An estimate waiting for its problem.
struct Probing<'a> {
    last: Option<&'a LastLines>,
    settings: &'a Settings<'a>,
}

impl Visitor for Probing<'_> {
    type Output = Estimated;

    fn visit<P: Labeled>(self, problem: Option<P>) -> Result<Estimated, SolveError> {
        let Some(problem) = problem else {
            let none = Some(Interval::exact(0.0));
            let tree = Estimate {
                nodes: none,
                solutions: none,
                exact: true,
                complete: true,
                probed: 0,
                replicates: 0,
            };
            return Ok(Estimated { tree, rate: None });
        };
        let look = self.last.map(|last| {
            move || {
                let mut found = last.begin();
                move |problem: &P, level: usize| problem.is_hopeless(last, level, &mut found)
            }
        });
        let tree = estimate_tree(&problem, look, || Leaves::new(Purpose::Count), self.settings);
        let rate = if tree.exact { None } else { rate(problem, self.settings.stop) };
        Ok(Estimated { tree, rate })
    }
}

/// Nodes per second of the search on one thread.
fn rate<P: Labeled>(problem: P, stop: &dyn Stop) -> Option<f64> {
    let mut walk = Walk::whole(problem, Values::Lexicographic);
    let mut sink = Leaves::new(Purpose::Count);
    let begin = Instant::now();
    while begin.elapsed() < TRIAL && !stop.should_stop() {
        if matches!(walk.run(TRIAL_NODES, &mut sink), Slice::Exhausted) {
            break;
        }
    }
    (walk.nodes >= TRIAL_NODES).then(|| walk.nodes as f64 / begin.elapsed().as_secs_f64())
}

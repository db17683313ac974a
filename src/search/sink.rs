//! Sinks: what to do with a solution.

use super::Problem;
use std::convert::Infallible;
use std::ops::ControlFlow;

/// Takes the solutions of a search, one part of it per thread.
pub trait Sink<P: Problem>: Send {
    /// What ends the search early; [`Infallible`] for sinks that want every solution.
    type Found: Send;

    /// Whether it may ever break off.
    fn breaks(&self) -> bool;

    /// Whether the number of solutions, which the search knows, is all it wants.
    fn counts(&self) -> bool {
        false
    }

    /// Takes the solution at which `problem` stands; `choices` are those of all levels.
    /// Breaking ends the search: of several such solutions the first of the walk counts.
    fn solution(&mut self, problem: &P, choices: &[u32]) -> ControlFlow<Self::Found>;

    /// Adds what another thread's sink took. The result must not depend on the order in which
    /// sinks are joined.
    fn join(&mut self, other: Self);
}

/// Counts solutions only; the search itself does that already.
#[derive(Debug, Clone, Copy, Default)]
pub struct Count;

impl<P: Problem> Sink<P> for Count {
    type Found = Infallible;

    fn breaks(&self) -> bool {
        false
    }

    fn counts(&self) -> bool {
        true
    }

    #[inline(always)]
    fn solution(&mut self, _: &P, _: &[u32]) -> ControlFlow<Infallible> {
        ControlFlow::Continue(())
    }

    fn join(&mut self, _: Self) {}
}

/// Ends at the first solution and gives its choices.
#[derive(Debug, Clone, Copy, Default)]
pub struct First;

impl<P: Problem> Sink<P> for First {
    type Found = Vec<u32>;

    fn breaks(&self) -> bool {
        true
    }

    fn solution(&mut self, _: &P, choices: &[u32]) -> ControlFlow<Vec<u32>> {
        ControlFlow::Break(choices.to_vec())
    }

    fn join(&mut self, _: Self) {}
}

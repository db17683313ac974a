//! How far a search has come, for people who wait.

use std::time::Duration;

/// A look at a running search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Nodes visited.
    pub nodes: u64,
    /// Solutions met.
    pub solutions: u64,
    /// The largest number of choices made at once.
    pub deepest: usize,
    /// The number of choices of a solution.
    pub levels: usize,
    /// The part of the tree that has been visited, 0 to 1, by Knuth's measure: every
    /// alternative of a node counts the same. Never falls, and is 1 only at the end.
    pub fraction: f64,
    /// Time since the start.
    pub elapsed: Duration,
}

//! Sprints: a problem walks a stretch of its tree itself.
//!
//! The walk asks its problem step by step: alternatives, push, pop. A problem that knows its
//! next levels can do better, for example see for all children of a node at once which of them
//! have children of their own. So below a node it may take over ([`Problem::sprint`]), and must
//! then visit the same nodes in the same order. It works on the arrays of the path, so whatever
//! ends a sprint early, the walk goes on from there step by step. Everything else (budgets,
//! parts, threads, sinks) stays with the walk, which is also the oracle of every sprint.
//!
//! [`Problem::sprint`]: super::Problem::sprint

/// What a sprint is given.
#[derive(Debug)]
pub struct Stretch<'a, A> {
    /// The level where it begins; levels below it have been pushed.
    pub level: usize,
    /// The choices of all levels, as many as make a solution.
    pub choices: &'a mut [u32],
    /// By level: the alternatives left. At `level`, all are still to visit, and there are some.
    pub left: &'a mut [A],
    /// It visits no more nodes than this.
    pub budget: u64,
    /// Whether solutions need only be counted. Otherwise it must end before one is visited.
    pub counts: bool,
}

/// How a sprint ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sprint {
    /// The level where the problem stands now: that where it began, with no alternatives left
    /// there, when all was visited; else any from there on, with `left` and `choices` set.
    pub level: usize,
    /// Nodes visited.
    pub nodes: u64,
    /// Solutions among them.
    pub solutions: u64,
    /// The largest number of choices made at once; at least the level where it began.
    pub deepest: usize,
}

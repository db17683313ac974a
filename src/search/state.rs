//! What a search stands at: what is left to visit, and what came of the rest.
//!
//! A search that stops leaves a state; run again from it, it goes on as if nothing had happened.
//! That is all there is to checkpoints: a search that is to be saved stops, hands over a copy of
//! its state, and goes on.
//!
//! A search for a first solution counts only what lies before that solution in the undivided
//! walk, whatever other threads did behind it. So it keeps a record of every interval visited.
//! Neighboring records with nothing left between them can no longer be told apart by a solution
//! found later, and become one: there are never more records than paths left, plus one.

use super::{Alternatives, Part, Path, Problem, Values};
use std::time::Duration;

/// What a search stands at. `T` is a path left to visit, `F` what is kept of a solution that
/// ends the search.
#[derive(Debug, Clone, PartialEq)]
pub struct State<T, F> {
    /// What is left to visit; nothing when the answer is final.
    pub left: Vec<T>,
    /// Nodes visited, also those that do not matter for the answer.
    pub nodes: u64,
    /// Solutions met.
    pub solutions: u64,
    /// The largest number of choices made at once.
    pub deepest: usize,
    /// The first solution known that ends the search.
    pub best: Option<Best<F>>,
    /// What was visited up to that solution; only when solutions may end the search.
    pub records: Vec<Record>,
    /// The time all of this took.
    pub elapsed: Duration,
}

/// A solution that ends the search.
#[derive(Debug, Clone, PartialEq)]
pub struct Best<F> {
    /// The choices of all levels.
    pub choices: Vec<u32>,
    /// What the sink kept of it.
    pub found: F,
}

/// An interval of the walk that has been visited.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Record {
    /// The choices that lead to its first node.
    pub start: Vec<u32>,
    /// Nodes visited.
    pub nodes: u64,
    /// Solutions met.
    pub solutions: u64,
    /// The largest number of choices made at once.
    pub deepest: usize,
}

/// The work that an answer took.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Effort {
    /// Nodes visited; when complete, up to the solution found, whatever other threads did.
    pub nodes: u64,
    /// Solutions met, as far as nodes count.
    pub solutions: u64,
    /// The largest number of choices made at once, as far as nodes count.
    pub deepest: usize,
}

impl<T, F> State<T, F> {
    /// Nothing visited yet, these paths left.
    pub fn start(left: Vec<T>) -> Self {
        Self {
            left,
            nodes: 0,
            solutions: 0,
            deepest: 0,
            best: None,
            records: Vec::new(),
            elapsed: Duration::ZERO,
        }
    }

    /// Whether the answer is final: everything was visited, or a first solution found and
    /// everything before it visited.
    pub fn is_complete(&self) -> bool {
        self.left.is_empty()
    }

    /// The work so far; of a complete search for a first solution, that before the solution.
    pub fn effort(&self) -> Effort {
        let Self { nodes, solutions, deepest, .. } = *self;
        if !self.is_complete() || self.best.is_none() {
            return Effort { nodes, solutions, deepest };
        }
        Effort {
            nodes: self.records.iter().map(|record| record.nodes).sum(),
            solutions: self.records.iter().map(|record| record.solutions).sum(),
            deepest: self.records.iter().map(|record| record.deepest).max().unwrap_or(0),
        }
    }

    /// The same with the paths in another form.
    pub fn map<U>(&self, change: impl FnMut(&T) -> U) -> State<U, F>
    where
        F: Clone,
    {
        let Self { nodes, solutions, deepest, elapsed, .. } = *self;
        let left = self.left.iter().map(change).collect();
        let (best, records) = (self.best.clone(), self.records.clone());
        State { left, nodes, solutions, deepest, best, records, elapsed }
    }

    /// The same with the paths in another form, unless one of them has none.
    ///
    /// # Errors
    /// What `change` reports.
    pub fn try_map<U, E>(self, change: impl FnMut(T) -> Result<U, E>) -> Result<State<U, F>, E> {
        let Self { left, nodes, solutions, deepest, best, records, elapsed } = self;
        let left = left.into_iter().map(change).collect::<Result<_, E>>()?;
        Ok(State { left, nodes, solutions, deepest, best, records, elapsed })
    }
}

impl<A: Alternatives, F> State<Path<A>, F> {
    /// The whole tree of a problem, nothing visited.
    pub fn whole<P: Problem<Alternatives = A>>(problem: &mut P) -> Self {
        Self::start(vec![Path::root(problem)])
    }

    /// A part of the tree of a problem, nothing visited.
    pub fn part<P: Problem<Alternatives = A>>(problem: &mut P, part: Part) -> Self {
        let part = part.within(problem.levels());
        let path = Path::part(problem, part);
        Self::start(if path.is_exhausted() { Vec::new() } else { vec![path] })
    }

    /// Drops what no longer matters: paths with nothing left, what lies behind the solution
    /// found; and joins records that will always count together.
    pub(super) fn tidy(&mut self, values: Values) {
        self.left.retain(|path| !path.is_exhausted());
        if let Some(best) = &self.best {
            let counts = |start: &[u32]| !is_before(values, &best.choices, start);
            self.left.retain(|path| counts(&path.start(values)));
            self.records.retain(|record| counts(&record.start));
        }
        let order = |a: &[u32], b: &[u32]| match (is_before(values, a, b), is_before(values, b, a))
        {
            (true, _) => std::cmp::Ordering::Less,
            (_, true) => std::cmp::Ordering::Greater,
            // One continues the other and comes later.
            _ => a.len().cmp(&b.len()),
        };
        let mut starts: Vec<Vec<u32>> = self.left.iter().map(|path| path.start(values)).collect();
        starts.sort_by(|a, b| order(a, b));
        self.records.sort_by(|a, b| order(&a.start, &b.start));
        let before =
            |record: &Record| starts.partition_point(|start| order(start, &record.start).is_lt());
        let mut joined: Vec<(usize, Record)> = Vec::new();
        for record in std::mem::take(&mut self.records) {
            let place = before(&record);
            match joined.last_mut() {
                Some((last, into)) if *last == place => {
                    into.nodes += record.nodes;
                    into.solutions += record.solutions;
                    into.deepest = into.deepest.max(record.deepest);
                }
                _ => joined.push((place, record)),
            }
        }
        self.records = joined.into_iter().map(|(_, record)| record).collect();
    }
}

/// Whether the choices `a` come before the choices `b` in the walk; where one continues the
/// other they do not come before each other.
pub(super) fn is_before(values: Values, a: &[u32], b: &[u32]) -> bool {
    let differ = a.iter().zip(b).enumerate().find(|(_, (a, b))| a != b);
    differ.is_some_and(|(level, (&a, &b))| values.before(level, a, b))
}

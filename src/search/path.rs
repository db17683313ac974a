//! The path: where a walk stands and what it has still to visit.
//!
//! Level `i` below [`Path::level`] holds a choice that has been made and the alternatives not
//! yet tried there; level [`Path::level`] itself holds only alternatives. A path with no
//! alternative left anywhere is exhausted. Handing out alternatives of the shallowest level
//! that has any splits the work in two large parts that are visited one after the other in the
//! undivided walk; that is how threads share it.

use super::{Alternatives, Part, Problem, Values};

/// The position of a walk: choices made and alternatives left, level by level.
#[derive(Debug, Clone)]
pub struct Path<A> {
    level: usize,
    choices: Vec<u32>,
    left: Vec<A>,
}

impl<A: Alternatives> Path<A> {
    /// The path of the whole tree, nothing visited.
    ///
    /// A problem without levels has one solution, the empty one; its path has one dummy
    /// alternative, so that it is not exhausted before that solution is visited.
    pub fn root<P: Problem<Alternatives = A>>(problem: &mut P) -> Self {
        let levels = problem.levels();
        let mut left = vec![A::EMPTY; levels.max(1)];
        if levels == 0 {
            left[0].insert(0);
        } else {
            left[0] = problem.alternatives(0);
        }
        Self { level: 0, choices: vec![0; levels], left }
    }

    /// The path of the first `depth` levels of the tree, nothing visited: to a walk, the choices
    /// of so many levels are a solution. `depth` is at least 1 and no more than the levels.
    pub(super) fn top<P: Problem<Alternatives = A>>(problem: &mut P, depth: usize) -> Self {
        let Self { level, mut choices, mut left } = Self::root(problem);
        choices.truncate(depth);
        left.truncate(depth);
        Self { level, choices, left }
    }

    /// The path of one part of the tree, nothing visited. A problem without levels is all in
    /// part 0.
    pub fn part<P: Problem<Alternatives = A>>(problem: &mut P, part: Part) -> Self {
        let mut path = Self::root(problem);
        if problem.levels() > 0 {
            path.left[0] = part.of(&[], path.left[0]);
        } else if part.number > 0 {
            path.left[0] = A::EMPTY;
        }
        path
    }

    /// The path with these choices made and these alternatives left, in a tree of so many levels.
    pub(super) fn with(levels: usize, made: &[u32], left: Vec<A>) -> Self {
        let mut choices = vec![0; levels];
        choices[..made.len()].copy_from_slice(made);
        Self { level: made.len(), choices, left }
    }

    /// The number of choices made.
    pub fn level(&self) -> usize {
        self.level
    }

    /// The choices made, from level 0.
    pub fn choices(&self) -> &[u32] {
        &self.choices[..self.level]
    }

    /// The alternatives left at every level up to [`Path::level`].
    pub fn left(&self) -> &[A] {
        let end = self.left.len().min(self.level + 1);
        &self.left[..end]
    }

    /// Whether nothing is left to visit.
    pub fn is_exhausted(&self) -> bool {
        self.left().iter().all(Alternatives::is_empty)
    }

    /// The choices that lead to the next node of the walk: nothing still to visit comes before
    /// it. For an exhausted path, the choices made.
    pub fn start(&self, values: Values) -> Vec<u32> {
        let mut start = self.choices().to_vec();
        if let Some(level) = self.left().iter().rposition(|left| !left.is_empty()) {
            start.truncate(level);
            start.push(values.first(level, self.left[level]));
        }
        start
    }

    /// Gives away the later half of the alternatives at the shallowest level that has any, or
    /// `None` when there are too few for two.
    pub fn split(&mut self, values: Values) -> Option<Self> {
        let level = self.left().iter().position(|left| !left.is_empty())?;
        let count = self.left[level].count();
        // A path that stands on this level has nothing else, so it keeps one alternative.
        let keep = if level < self.level { count / 2 } else { count.div_ceil(2) };
        if keep == count {
            return None;
        }
        let mut given = self.left[level];
        let mut kept = A::EMPTY;
        for _ in 0..keep {
            let first = values.first(level, given);
            given.remove(first);
            kept.insert(first);
        }
        self.left[level] = kept;
        let mut part = Self { level, choices: self.choices.clone(), left: self.left.clone() };
        part.left.fill(A::EMPTY);
        part.left[level] = given;
        Some(part)
    }

    /// Brings a problem without choices to where this path stands.
    pub fn replay<P: Problem<Alternatives = A>>(&self, problem: &mut P) {
        for (level, &choice) in self.choices().iter().enumerate() {
            problem.push(level, choice);
        }
    }

    /// Takes back what [`Path::replay`] did.
    pub fn rewind<P: Problem<Alternatives = A>>(&self, problem: &mut P) {
        for (level, &choice) in self.choices().iter().enumerate().rev() {
            problem.pop(level, choice);
        }
    }

    /// How much of the whole tree, or of a part of it, is still to visit, 0 to 1, if all
    /// alternatives of a node had equally large trees below them (Knuth's estimate of progress,
    /// exact at 0 and 1).
    ///
    /// `problem` must stand where the path stands, and is left there.
    pub fn remaining<P>(&self, problem: &mut P, part: Option<Part>) -> f64
    where
        P: Problem<Alternatives = A>,
    {
        if self.choices.is_empty() {
            return f64::from(u8::from(!self.is_exhausted()));
        }
        self.rewind(problem);
        let (mut share, mut remaining) = (1.0, 0.0);
        for (level, left) in self.left().iter().enumerate() {
            let mut of = problem.alternatives(level);
            if let Some(part) = part {
                of = part.of(&self.choices[..level], of);
            }
            let of = of.count();
            if of > 0 {
                share /= f64::from(of);
                remaining += share * f64::from(left.count());
            }
            if level < self.level {
                problem.push(level, self.choices[level]);
            }
        }
        remaining
    }

    /// The arrays a walk works on: the level, and choices and alternatives of all levels.
    pub(super) fn parts(&mut self) -> (&mut usize, &mut [u32], &mut [A]) {
        (&mut self.level, &mut self.choices, &mut self.left)
    }
}

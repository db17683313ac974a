//! Depth-first search begun again and again, every time in another random order.
//!
//! How long a search in random order takes until its first solution varies enormously: some
//! orders meet one at once, others are lost for hours below an early mistake. Cutting every run
//! short and beginning anew takes the long ones away. Without knowing how long runs take, budgets
//! in the proportions 1, 1, 2, 1, 1, 2, 4, 1, ... lose no more than a logarithmic factor against
//! the best plan there is. As the budgets grow without bound, a tree that can be searched is at
//! last searched completely, so this, too, finds that there is no solution.
//!
//! Source: Luby, Sinclair, Zuckerman 1993.

use super::race::{Attempt, Race, Turn, race};
use super::values::scramble;
use super::{Limits, Problem, Sink, Slice, Values, Walk};

/// Nodes between two looks at the other threads.
const SLICE: u64 = 1 << 14;

/// When to begin again, and with which orders.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Restarts {
    /// The nodes of the shortest runs, at least 1.
    pub unit: u64,
    /// All orders follow from it.
    pub seed: u64,
}

impl Restarts {
    /// The order of run `number`.
    pub fn values(self, number: u64) -> Values {
        Values::Random(scramble(self.seed ^ scramble(number)))
    }

    /// The most nodes of run `number`, from 0.
    pub fn nodes(self, number: u64) -> u64 {
        self.unit.max(1).saturating_mul(luby(number + 1))
    }
}

/// The Luby sequence from `luby(1)` on: 1, 1, 2, 1, 1, 2, 4, 1, ...: number `2^k - 1` is
/// `2^(k-1)`, and what follows it repeats the beginning.
pub fn luby(mut number: u64) -> u64 {
    loop {
        // The largest power of two up to `number`; where it is all ones a block ends.
        let top = 1 << number.max(1).ilog2();
        if number <= 1 || number == top | (top - 1) {
            return top;
        }
        number -= top - 1;
    }
}

/// Searches until a run meets a solution that ends the search, visits the whole tree (then
/// nothing is found: `Some((number, None))`), or the limits say stop.
pub fn restart<P, S>(
    problem: &P,
    restarts: Restarts,
    threads: usize,
    limits: &Limits<'_>,
    sink: impl Fn() -> S + Sync,
) -> Race<Option<S::Found>>
where
    P: Problem,
    S: Sink<P>,
{
    race(u64::MAX, threads, limits, || {
        let (mut kept, mut sink) = (Some(problem.clone()), sink());
        move |turn: &Turn<'_>| {
            let problem = kept.take().unwrap_or_else(|| problem.clone());
            let values = restarts.values(turn.number);
            let mut walk = Walk::whole(problem, values);
            let attempt = run(&mut walk, restarts.nodes(turn.number), &mut sink, turn);
            kept = Some(walk.into_problem());
            attempt
        }
    })
}

/// One run of at most `nodes` nodes.
fn run<P: Problem, S: Sink<P>>(
    walk: &mut Walk<P>,
    nodes: u64,
    sink: &mut S,
    turn: &Turn<'_>,
) -> Attempt<Option<S::Found>> {
    let (mut found, mut cut) = (None, false);
    while found.is_none() && !cut && walk.nodes < nodes {
        match walk.run(SLICE.min(nodes - walk.nodes), sink) {
            Slice::Found(solution) => found = Some(Some(solution)),
            Slice::Exhausted => found = Some(None),
            Slice::Paused => cut = turn.visited(walk.nodes),
        }
    }
    Attempt { found, nodes: walk.nodes, depth: walk.deepest, cut }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_luby_sequence() {
        let first: Vec<u64> = (1..=15).map(luby).collect();
        assert_eq!(first, [1, 1, 2, 1, 1, 2, 4, 1, 1, 2, 1, 1, 2, 4, 8]);
        // By the definition, as a list that is doubled.
        let mut list = vec![1];
        while list.len() < 5000 {
            let last = 2 * list[list.len() - 1];
            list.extend(list.clone());
            list.push(last);
        }
        assert!(list.iter().zip(1..).all(|(&value, number)| luby(number) == value));
        assert_eq!(luby(u64::MAX), 1 << 63);
        assert_eq!(luby(u64::MAX - 1), 1 << 62);
    }
}

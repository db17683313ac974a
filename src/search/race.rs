//! Attempts side by side, the least number that succeeds wins.
//!
//! Where luck decides, many short attempts are better than a long one, and threads may make them
//! at the same time. Whoever succeeds tells those with a higher number to give up and waits for
//! those with a lower one. So the answer depends neither on the number of threads nor on which of
//! them was fast, and the nodes told are those of the attempts up to the winner.

use super::{Limits, Stop};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::SeqCst};
use std::sync::{Mutex, PoisonError};

/// What an attempt came to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Attempt<T> {
    /// What ends the race, if it succeeded.
    pub found: Option<T>,
    /// Nodes visited.
    pub nodes: u64,
    /// How deep it came.
    pub depth: usize,
    /// Whether it was told to stop.
    pub cut: bool,
}

/// What a race came to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Race<T> {
    /// The number of the attempt that won, and what it found.
    pub found: Option<(u64, T)>,
    /// Nodes of the attempts up to that one, or of all.
    pub nodes: u64,
    /// Attempts that ended by themselves, up to that one.
    pub ended: u64,
    /// The deepest of these attempts.
    pub depth: usize,
}

/// What the threads share.
struct Shared<T> {
    next: AtomicU64,
    /// The lowest number that succeeded.
    lowest: AtomicU64,
    nodes: AtomicU64,
    stopped: AtomicBool,
    ended: Mutex<Vec<(u64, Attempt<T>)>>,
}

/// The turn of an attempt: which it is, and whether it should go on.
pub struct Turn<'a> {
    /// The number of the attempt, from 0.
    pub number: u64,
    lowest: &'a AtomicU64,
    nodes: &'a AtomicU64,
    stopped: &'a AtomicBool,
    limits: &'a Limits<'a>,
    known: AtomicU64,
}

impl Turn<'_> {
    /// Takes the number of nodes that the attempt has visited so far; says whether to stop.
    pub fn visited(&self, nodes: u64) -> bool {
        let more = nodes.saturating_sub(self.known.fetch_max(nodes, SeqCst));
        self.nodes.fetch_add(more, SeqCst);
        self.should_stop()
    }
}

impl Stop for Turn<'_> {
    fn should_stop(&self) -> bool {
        if self.nodes.load(SeqCst) >= self.limits.nodes || self.limits.stop.should_stop() {
            self.stopped.store(true, SeqCst);
        }
        self.stopped.load(SeqCst) || self.lowest.load(SeqCst) < self.number
    }
}

/// Attempts the numbers below `most` until one succeeds or the limits say stop. Every thread
/// makes something of its own that attempts.
pub fn race<T, A>(
    most: u64,
    threads: usize,
    limits: &Limits<'_>,
    attempts: impl Fn() -> A + Sync,
) -> Race<T>
where
    T: Send,
    A: FnMut(&Turn<'_>) -> Attempt<T>,
{
    let shared = Shared {
        next: AtomicU64::new(0),
        lowest: AtomicU64::new(u64::MAX),
        nodes: AtomicU64::new(0),
        stopped: AtomicBool::new(false),
        ended: Mutex::new(Vec::new()),
    };
    std::thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(|| work(most, &shared, limits, attempts()));
        }
        work(most, &shared, limits, attempts());
    });
    let mut ended = shared.ended.into_inner().unwrap_or_else(PoisonError::into_inner);
    let lowest = shared.lowest.into_inner();
    ended.retain(|&(number, _)| number <= lowest);
    Race {
        nodes: ended.iter().map(|(_, attempt)| attempt.nodes).sum(),
        ended: ended.iter().filter(|(_, attempt)| !attempt.cut).count() as u64,
        depth: ended.iter().map(|(_, attempt)| attempt.depth).max().unwrap_or(0),
        found: ended
            .into_iter()
            .find_map(|(number, attempt)| (number == lowest).then_some((number, attempt.found?))),
    }
}

fn work<T>(
    most: u64,
    shared: &Shared<T>,
    limits: &Limits<'_>,
    mut attempt: impl FnMut(&Turn<'_>) -> Attempt<T>,
) {
    loop {
        let number = shared.next.fetch_add(1, SeqCst);
        let Shared { lowest, nodes, stopped, .. } = shared;
        let turn = Turn { number, lowest, nodes, stopped, limits, known: AtomicU64::new(0) };
        if number >= most || turn.should_stop() {
            return;
        }
        let attempt = attempt(&turn);
        turn.visited(attempt.nodes);
        if attempt.found.is_some() {
            shared.lowest.fetch_min(number, SeqCst);
        }
        shared.ended.lock().unwrap_or_else(PoisonError::into_inner).push((number, attempt));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Attempt `n` takes `n % 5` nodes and finds its number from 7 on.
    fn run(most: u64, threads: usize, limits: &Limits<'_>) -> Race<u64> {
        race(most, threads, limits, || {
            |turn: &Turn<'_>| {
                let (number, nodes) = (turn.number, turn.number % 5);
                // Later numbers are sooner ready.
                std::thread::sleep(std::time::Duration::from_millis(20 - number.min(20)));
                Attempt {
                    found: (number >= 7).then_some(number),
                    nodes,
                    depth: number as usize,
                    cut: turn.visited(nodes),
                }
            }
        })
    }

    #[test]
    fn the_least_number_wins() {
        for threads in [1, 2, 5, 12] {
            let won = run(u64::MAX, threads, &Limits::NONE);
            assert_eq!((won.found, won.nodes, won.depth), (Some((7, 7)), 1 + 2 + 3 + 4 + 1 + 2, 7));
            let none = run(6, threads, &Limits::NONE);
            assert_eq!((none.found, none.ended), (None, 6));
            let few = run(u64::MAX, threads, &Limits { nodes: 3, ..Limits::NONE });
            assert!(few.nodes >= 3 && few.found.is_none_or(|(number, _)| number >= 7), "{few:?}");
        }
        let no = run(9, 2, &Limits { stop: &std::time::Instant::now(), nodes: u64::MAX });
        assert_eq!(no, Race { found: None, nodes: 0, ended: 0, depth: 0 });
    }
}

//! Many rounds on all threads, the best of them.
//!
//! Rounds are numbered, and each draws its random numbers by the seed and its number alone. So a
//! given number of rounds gives the same answer on any number of threads: the fewest corner
//! tiles, of those the lowest number. A target ends it at the lowest-numbered round that reaches
//! it. A stop from outside ends it where it is; which rounds were finished then depends on the
//! machine.

use super::anneal::{Found, MOST_COLORS, Round, Schedule, Tables, round};
use super::condition::Condition;
use super::vertices::Vertices;
use crate::search::Stop;
use std::sync::atomic::{AtomicU64, Ordering::SeqCst};
use std::sync::{Mutex, PoisonError};
use std::thread;

/// Moves of a round unless it is said otherwise.
pub const MOVES: u64 = 1 << 20;

/// What to look for, and how long.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Search {
    /// What a coloring must meet.
    pub condition: Condition,
    /// The most colors, at least 2.
    pub colors: usize,
    /// The seed of all rounds.
    pub seed: u64,
    /// Moves of a round.
    pub moves: u64,
    /// Rounds at most.
    pub rounds: u64,
    /// So few tiles are enough.
    pub target: usize,
    /// Threads.
    pub threads: usize,
}

/// What the rounds came to.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Outcome {
    /// The best coloring and the number of its round.
    pub best: Option<(u64, Found)>,
    /// Rounds finished: up to the one that reached the target, if one did.
    pub rounds: u64,
    /// Their moves.
    pub moves: u64,
    /// States that they examined closely.
    pub examined: u64,
    /// For each number of tiles the rounds that ended with it; without any, those that met the
    /// condition nowhere.
    pub ends: std::collections::BTreeMap<Option<usize>, u64>,
}

impl Search {
    /// The schedule of a round: colors, and conflicts that are allowed, take turns.
    pub fn schedule(&self, number: u64) -> Schedule {
        let most = self.colors.clamp(2, MOST_COLORS);
        let few = match self.condition {
            Condition::Pair => 5,
            Condition::Radius(_) => 4,
        };
        let choices = (most + 1).saturating_sub(few).max(1) as u64;
        let colors = (few + (number % choices) as usize).min(most);
        let (allowed, penalty) = match self.condition {
            Condition::Pair => (0, 8),
            Condition::Radius(_) => (1 + (number / choices % 4 / 3) as i32, 7),
        };
        Schedule { colors, moves: self.moves, temperature: [3.0, 0.4], penalty, allowed }
    }
}

/// The rounds finished so far, and the lowest-numbered that reached the target.
struct Shared {
    next: AtomicU64,
    last: AtomicU64,
    finished: Mutex<(Outcome, Vec<(u64, Round)>)>,
}

/// Asks a round to stop when one with a lower number has reached the target.
struct Beaten<'a> {
    number: u64,
    last: &'a AtomicU64,
    stop: &'a dyn Stop,
}

impl Stop for Beaten<'_> {
    fn should_stop(&self) -> bool {
        self.number > self.last.load(SeqCst) || self.stop.should_stop()
    }
}

/// Runs the rounds; `watch` is told after each one what all have come to.
pub fn run(
    vertices: &Vertices,
    search: &Search,
    stop: &dyn Stop,
    watch: &(dyn Fn(&Outcome) + Sync),
) -> Outcome {
    let tables = Tables::new(vertices);
    let last = AtomicU64::new(search.rounds.saturating_sub(1));
    let shared = Shared { next: AtomicU64::new(0), last, finished: Mutex::default() };
    if search.rounds == 0 {
        return Outcome::default();
    }
    let work = || {
        loop {
            let number = shared.next.fetch_add(1, SeqCst);
            if number > shared.last.load(SeqCst) || stop.should_stop() {
                return;
            }
            let stop = Beaten { number, last: &shared.last, stop };
            let schedule = search.schedule(number);
            let seeds = [search.seed, number];
            let done = round(vertices, &tables, search.condition, &schedule, seeds, &stop);
            if done.cut {
                continue;
            }
            if done.found.as_ref().is_some_and(|found| found.tiles <= search.target) {
                shared.last.fetch_min(number, SeqCst);
            }
            let mut finished = shared.finished.lock().unwrap_or_else(PoisonError::into_inner);
            let (so_far, rounds) = &mut *finished;
            so_far.add(number, &done);
            watch(so_far);
            rounds.push((number, kept(done, so_far, search.target)));
        }
    };
    thread::scope(|scope| {
        for _ in 1..search.threads {
            scope.spawn(work);
        }
        work();
    });
    let (_, finished) = shared.finished.into_inner().unwrap_or_else(PoisonError::into_inner);
    let last = shared.last.load(SeqCst);
    let mut outcome = Outcome::default();
    for (number, round) in finished.iter().filter(|(number, _)| *number <= last) {
        outcome.add(*number, round);
    }
    outcome
}

/// A round without its coloring, if another one is better and it does not reach the target: then
/// it will not be the best, whichever rounds are left out in the end.
fn kept(mut round: Round, so_far: &Outcome, target: usize) -> Round {
    let best = so_far.best.as_ref().map_or(usize::MAX, |(_, best)| best.tiles);
    if let Some(found) = round.found.as_mut().filter(|found| found.tiles > best.max(target)) {
        found.colors = Vec::new();
    }
    round
}

impl Outcome {
    /// Takes in another round.
    fn add(&mut self, number: u64, round: &Round) {
        self.rounds += 1;
        self.moves += round.moves;
        self.examined += round.examined;
        let tiles = round.found.as_ref().map(|found| found.tiles);
        *self.ends.entry(tiles).or_insert(0) += 1;
        let Some(found) = &round.found else { return };
        let better = |(of, best): &(u64, Found)| (found.tiles, number) < (best.tiles, *of);
        if self.best.as_ref().is_none_or(better) {
            self.best = Some((number, found.clone()));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::aperiodic::coloring::language::{patterns, windows};
    use crate::aperiodic::coloring::partition::{JEANDEL_RAO, Partition};

    #[test]
    fn threads_change_nothing() {
        let windows = windows(&Partition::jeandel_rao(), [5, 3]).unwrap();
        let vertices = Vertices::new(JEANDEL_RAO.to_vec(), [4, 2], &patterns(&windows)).unwrap();
        for (condition, target) in
            [(Condition::Pair, 0), (Condition::Pair, 31), (Condition::Radius(1), 0)]
        {
            let search = |threads| Search {
                condition,
                colors: 6,
                seed: 3,
                moves: 1 << 17,
                rounds: 6,
                target,
                threads,
            };
            let one = run(&vertices, &search(1), &(), &|_| ());
            let three = run(&vertices, &search(3), &(), &|_| ());
            assert_eq!(one, three);
            assert!(one.rounds == 6 || target > 0);
        }
    }
}

//! Several ways to a first packing, in turns, until one of them gets there.
//!
//! Which way is quick differs from problem to problem by orders of magnitude, and nobody knows
//! before. So each way gets a turn in every round, and twice as many nodes as in the round before:
//! then no more is lost than the number of ways, and a factor for what is begun anew. Turns are
//! numbered, and the least number that ends with an answer wins, so that it depends neither on the
//! number of threads nor on their speed.
//!
//! The ways: exhaustive search in order; in random order, another one every round; beam search
//! for corner tiles; and where packings with a symmetry will do, search among these. A search
//! that is not restricted to these may also find that there is none.

use crate::beam::{self, Options};
use crate::packing::solve::{SolveError, find};
use crate::packing::{Job, Question, Settings, Task};
use crate::search::{Attempt, Limits, Race, Turn, Values, race};
use crate::symmetry::{Automorphism, suggest};
use crate::tiles::Kind;

/// Nodes of a turn in the first round.
const NODES: u64 = 1 << 20;

/// A way to a packing.
#[derive(Debug, Clone, PartialEq)]
pub enum Way {
    /// Exhaustive search, smallest values first.
    InOrder,
    /// Exhaustive search in a random order.
    AtRandom,
    /// Beam search.
    Beam,
    /// Search, in a random order, among the packings with this automorphism.
    Symmetric(Automorphism),
}

/// What a portfolio came to.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The way that gave the answer, and in which round, from 0.
    pub won: Option<(Way, u64)>,
    /// The labels of a packing; `None` with a way that won means that there is none.
    pub labels: Option<Vec<u8>>,
    /// Turns taken, up to the last that matters.
    pub turns: u64,
    /// Nodes of these turns.
    pub nodes: u64,
}

/// The ways that suit a task; those restricted to a symmetry only if that will do.
pub fn ways(task: &Task, symmetric: bool) -> Vec<Way> {
    let mut ways = vec![Way::InOrder, Way::AtRandom];
    let plain = !task.cover && task.automorphism.is_none();
    let none = Limits { nodes: 0, ..Limits::NONE };
    let options = Options::for_set(&task.set);
    if plain
        && task.set.kind() == Kind::Corner
        && beam::find_around(&task.set, task.shape, Some(&task.pins), &options, &none).is_ok()
    {
        ways.push(Way::Beam);
    }
    if symmetric && task.automorphism.is_none() && !task.has_pins() {
        ways.extend(suggest(&task.set, task.shape, task.cover).map(Way::Symmetric));
    }
    ways
}

/// Looks for a packing until it is found, it is plain that there is none, or the limits say stop.
///
/// # Errors
/// When the task makes no sense.
pub fn run(
    task: &Task,
    symmetric: bool,
    seed: u64,
    threads: usize,
    limits: &Limits<'_>,
) -> Result<Outcome, SolveError> {
    Job::from(task).check()?;
    let ways = ways(task, symmetric);
    let number = ways.len() as u64;
    let Race { found, nodes, ended, .. } = race(u64::MAX, threads, limits, || {
        |turn: &Turn<'_>| {
            let (round, way) = (turn.number / number, &ways[(turn.number % number) as usize]);
            // Small rounds give seeds apart, as a seed of the user's and the next one do not.
            take_turn(task, way, seed.wrapping_add(round << 32), NODES << round.min(43), turn)
        }
    });
    let Some((last, answer)) = found else {
        return Ok(Outcome { won: None, labels: None, turns: ended, nodes });
    };
    let won = Some((ways[(last % number) as usize].clone(), last / number));
    Ok(Outcome { won, labels: answer?, turns: last + 1, nodes })
}

/// One turn of a way: a packing, none at all, or nothing known.
fn take_turn(
    task: &Task,
    way: &Way,
    seed: u64,
    nodes: u64,
    turn: &Turn<'_>,
) -> Attempt<Result<Option<Vec<u8>>, SolveError>> {
    let limits = Limits { stop: turn, nodes };
    let values = match way {
        Way::InOrder => Values::Lexicographic,
        _ => Values::Random(seed),
    };
    let mut job = Job { values, ..Job::new(task.clone(), Question::First) };
    match way {
        Way::Beam => {
            let options = Options { seed, threads: 1, ..Options::for_set(&task.set) };
            let beam =
                beam::find_around(&task.set, task.shape, Some(&task.pins), &options, &limits);
            // Refused is what `ways` has left out.
            let (labels, nodes, depth) =
                beam.map_or((None, 0, 0), |outcome| (outcome.labels, outcome.nodes, outcome.depth));
            let cut = turn.visited(nodes);
            return Attempt { found: labels.map(|labels| Ok(Some(labels))), nodes, depth, cut };
        }
        Way::Symmetric(automorphism) => job.task.automorphism = Some(automorphism.clone()),
        Way::InOrder | Way::AtRandom => {}
    }
    let watch = |progress: &crate::search::Progress| {
        turn.visited(progress.nodes);
    };
    match find(job, &Settings { limits, watch: &watch, ..Settings::PLAIN }) {
        Err(error) => Attempt { found: Some(Err(error)), nodes: 0, depth: 0, cut: false },
        Ok(answer) => {
            let work = answer.work;
            let restricted = matches!(way, Way::Symmetric(_));
            // A search that is stopped may have met a packing, but perhaps not the first.
            let found = match answer.value {
                Some(labels) if work.complete => Some(Ok(Some(labels))),
                None if work.complete && !restricted => Some(Ok(None)),
                _ => None,
            };
            let cut = turn.visited(work.nodes) && found.is_none();
            Attempt { found, nodes: work.nodes, depth: work.deepest, cut }
        }
    }
}

//! How many dappled tilings there are, exactly, and random ones of them.
//!
//! The cells are filled one after the other. What matters of those filled is how long the runs are
//! that end at the rim: a state, of which there are few, and each carries the number of its fillings
//! (`sweep`). One step changes one digit of a state; sorted states stay sorted on the way, so that
//! nothing is ever looked up (`merge`). Lines are automata (`line`): limits of any kind, sets of
//! tiles, cells given, and rows that meet their own end differ only there. Columns that meet their end
//! are counted start by start (`turns`). [`Sampler`] goes the same way backwards.
//!
//! * [`Counting`] is a count that can be stopped, saved and gone on with at any cell;
//! * [`numbers`] counts small rectangles by how often a tile occurs.
//!
//! The cost grows exponentially with the shorter side and linearly with the longer one. All numbers
//! are exact.

mod line;
mod merge;
mod need;
mod plane;
mod sample;
mod save;
mod sweep;
mod table;
mod turns;
mod words;

pub use need::Need;
pub use sample::Sampler;

use super::{Field, FieldError, MOST_CELLS, Rule};
use num_bigint::BigUint;
use plane::Plane;
use rayon::prelude::*;
use sweep::{Lines, Sweep};
use turns::Start;

/// The memory that a count may take if nothing else is asked for, in bytes.
pub const MEMORY: usize = 4 << 30;

/// Why tilings cannot be counted.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum CountError {
    /// No cells, or too many.
    #[error(transparent)]
    Size(#[from] FieldError),
    /// Cells given for another rectangle.
    #[error("{found:?} cells are given, expected {expected:?}")]
    Given {
        /// Columns and rows of those given.
        found: (usize, usize),
        /// Columns and rows of the rule.
        expected: (usize, usize),
    },
    /// A line has too many states.
    #[error("the limits of a line need more states than are handled")]
    Line,
    /// The states of a row do not fit in a word.
    #[error("{columns} cells across: states do not fit in 63 bits")]
    Word {
        /// The shorter side.
        columns: usize,
    },
    /// More memory than there may be.
    #[error("counting needs {} of memory, the limit is {}", spoken(*.need), spoken(*.limit))]
    Memory {
        /// What is needed, at least.
        need: usize,
        /// The limit.
        limit: usize,
    },
}

/// Bytes in words.
fn spoken(bytes: usize) -> String {
    match bytes >> 20 {
        0 => format!("{} KiB", bytes.div_ceil(1024)),
        mebibytes @ 1..9999 => format!("{mebibytes} MiB"),
        mebibytes => format!("{:.1} GiB", mebibytes as f64 / 1024.0),
    }
}

/// Checks a need against the limit.
fn within(limit: usize, need: usize) -> Result<(), CountError> {
    if need > limit { Err(CountError::Memory { need, limit }) } else { Ok(()) }
}

/// A count under way.
#[derive(Debug)]
pub struct Counting {
    work: Work,
    memory: usize,
}

#[derive(Debug)]
enum Work {
    /// Columns that do not meet their end.
    Once(Box<Sweep>),
    /// Columns that do.
    Turns(Box<Turns>),
    /// One that is done, read again: the numbers.
    Done(Vec<BigUint>),
}

/// Starts, one after the other.
#[derive(Debug)]
struct Turns {
    plane: Plane,
    by: Option<u8>,
    starts: Vec<Start>,
    done: usize,
    numbers: Vec<BigUint>,
    lines: Lines,
}

impl Counting {
    /// Begins to count the tilings that keep a rule and agree with the cells given; by the number of
    /// tiles `by`, if that is asked for. It may take so many bytes of memory.
    ///
    /// # Errors
    /// Too many states for a word, or for the memory.
    pub fn new(
        rule: &Rule,
        given: Option<&Field>,
        by: Option<u8>,
        memory: usize,
    ) -> Result<Self, CountError> {
        check(rule, given)?;
        let plane = Plane::new(rule, given);
        let work = if plane.columns_meet() {
            let starts = turns::starts(&plane, &turns::images(&plane, by), memory)?;
            let cells = if by.is_some() { plane.width() * plane.height() } else { 0 };
            let numbers = vec![BigUint::ZERO; cells + 1];
            let lines = Lines::default();
            Work::Turns(Box::new(Turns { plane, by, starts, done: 0, numbers, lines }))
        } else {
            Work::Once(Box::new(Sweep::of(&plane, by, true)?))
        };
        Ok(Self { work, memory })
    }

    /// One cell more, or, where columns meet their end, some starts.
    ///
    /// # Errors
    /// More memory than there may be.
    pub fn step(&mut self) -> Result<(), CountError> {
        match &mut self.work {
            Work::Once(sweep) => {
                sweep.step();
                within(self.memory, sweep.bytes())
            }
            Work::Turns(turns) => turns.step(self.memory),
            Work::Done(_) => Ok(()),
        }
    }

    /// Steps done, and steps in all.
    pub fn progress(&self) -> (usize, usize) {
        match &self.work {
            Work::Once(sweep) => (sweep.done(), sweep.steps()),
            Work::Turns(turns) => (turns.done, turns.starts.len()),
            Work::Done(_) => (1, 1),
        }
    }

    /// Whether all is counted.
    pub fn is_done(&self) -> bool {
        let (done, all) = self.progress();
        done >= all
    }

    /// States at present, or starts in all.
    pub fn states(&self) -> usize {
        match &self.work {
            Work::Once(sweep) => sweep.table().len(),
            Work::Turns(turns) => turns.starts.len(),
            Work::Done(_) => 0,
        }
    }

    /// Whether this is a good moment to be saved: little is lost.
    pub fn is_at_row(&self) -> bool {
        match &self.work {
            Work::Once(sweep) => sweep.is_at_row(),
            Work::Turns(_) | Work::Done(_) => true,
        }
    }

    /// When all is counted: the number of tilings, by how many tiles they have of that which is
    /// counted, from none on, if one is.
    pub fn numbers(&self) -> Vec<BigUint> {
        match &self.work {
            Work::Once(sweep) => sweep.numbers(),
            Work::Turns(turns) => turns.numbers.clone(),
            Work::Done(numbers) => numbers.clone(),
        }
    }
}

impl Turns {
    fn step(&mut self, memory: usize) -> Result<(), CountError> {
        let threads = rayon::current_num_threads();
        let end = self.starts.len().min(self.done + 4 * threads);
        let starts = &self.starts[self.done..end];
        let sweeps = starts.iter().map(|start| {
            let sweep = turns::sweep(&self.plane, start, self.by, &mut self.lines)?;
            Ok((sweep, start.alike))
        });
        let sweeps: Vec<(Sweep, u32)> = sweeps.collect::<Result<_, CountError>>()?;
        let counted = |(mut sweep, alike): (Sweep, u32)| {
            while !sweep.is_done() {
                sweep.step();
                within(memory, threads * sweep.bytes())?;
            }
            let numbers = sweep.numbers().into_iter().map(|number| number * alike);
            Ok(numbers.collect::<Vec<_>>())
        };
        let counted: Vec<Vec<BigUint>> =
            sweeps.into_par_iter().map(counted).collect::<Result<_, CountError>>()?;
        for numbers in counted {
            for (sum, number) in self.numbers.iter_mut().zip(numbers) {
                *sum += number;
            }
        }
        self.done = end;
        Ok(())
    }
}

/// Checks that the cells given are those of the rule.
fn check(rule: &Rule, given: Option<&Field>) -> Result<(), CountError> {
    let expected @ (width, height) = (rule.width(), rule.height());
    if width.checked_mul(height).is_none_or(|cells| cells == 0 || cells > MOST_CELLS) {
        return Err(FieldError::Size { width, height }.into());
    }
    match given.map(|field| (field.width(), field.height())) {
        Some(found) if found != expected => Err(CountError::Given { found, expected }),
        _ => Ok(()),
    }
}

/// The number of tilings that keep a rule and agree with the cells given.
///
/// # Errors
/// More states or memory than there may be.
pub fn count(rule: &Rule, given: Option<&Field>) -> Result<BigUint, CountError> {
    Ok(finished(Counting::new(rule, given, None, MEMORY)?)?.into_iter().sum())
}

/// How often a tile can occur in tilings that keep a rule and agree with the cells given, and in how
/// many of them it does.
///
/// # Errors
/// More states or memory than there may be: for narrow fields.
pub fn numbers(
    rule: &Rule,
    given: Option<&Field>,
    tile: u8,
) -> Result<Vec<(usize, BigUint)>, CountError> {
    let numbers = finished(Counting::new(rule, given, Some(tile), MEMORY)?)?;
    Ok(numbers.into_iter().enumerate().filter(|(_, number)| *number != BigUint::ZERO).collect())
}

fn finished(mut counting: Counting) -> Result<Vec<BigUint>, CountError> {
    while !counting.is_done() {
        counting.step()?;
    }
    Ok(counting.numbers())
}

//! A path in plain numbers: what is written to a file.
//!
//! A [`Path`] keeps its alternatives in words, as many as its problem needs. A trail holds the
//! same as lists of numbers, whatever the problem. Read back from a file it is not believed: a
//! trail becomes a path only if the problem itself offers every choice made and every
//! alternative left, so that no damaged or foreign file leads to a wrong count.

use super::{Alternatives, Path, Problem};

/// The choices made from level 0, and the alternatives left at every level up to the next one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Trail {
    /// The choice at each level below the one where the walk stands.
    pub choices: Vec<u32>,
    /// The alternatives left at each level, increasing, up to that where the walk stands.
    pub left: Vec<Vec<u32>>,
}

/// Why a trail does not belong to a problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum TrailError {
    /// More or fewer levels than fit.
    #[error(
        "a path of {choices} choices and {left} sets of alternatives in a search of {levels} levels"
    )]
    Length {
        /// Choices made.
        choices: usize,
        /// Sets of alternatives.
        left: usize,
        /// Levels of the problem.
        levels: usize,
    },
    /// A choice that the problem does not offer.
    #[error("level {level}: {choice} is not among the alternatives")]
    Choice {
        /// The level.
        level: usize,
        /// The choice made or left there.
        choice: u32,
    },
    /// A choice made that is still to be tried, or alternatives out of order.
    #[error("level {level}: {choice} stands twice or out of order")]
    Order {
        /// The level.
        level: usize,
        /// The choice at fault.
        choice: u32,
    },
}

impl Trail {
    /// What a path holds.
    pub fn of<A: Alternatives>(path: &Path<A>) -> Self {
        let left = path.left().iter().map(|left| left.numbers().collect()).collect();
        Self { choices: path.choices().to_vec(), left }
    }

    /// The path it stands for, in a problem without choices.
    ///
    /// # Errors
    /// When the problem does not offer what the trail says.
    pub fn path<P: Problem>(&self, problem: &mut P) -> Result<Path<P::Alternatives>, TrailError> {
        let levels = problem.levels();
        let Self { choices, left } = self;
        let fits = choices.len() < levels.max(1) && left.len() == choices.len() + 1;
        if !fits {
            let (choices, left) = (choices.len(), left.len());
            return Err(TrailError::Length { choices, left, levels });
        }
        let whole = Path::root(problem);
        let mut sets = vec![P::Alternatives::EMPTY; levels.max(1)];
        let mut pushed = 0;
        let mut fill = || {
            for (level, left) in left.iter().enumerate() {
                let offered =
                    if level == 0 { whole.left()[0] } else { problem.alternatives(level) };
                let made = choices.get(level).copied();
                check(level, left, made, offered)?;
                for &number in left {
                    sets[level].insert(number);
                }
                if let Some(choice) = made {
                    problem.push(level, choice);
                    pushed = level + 1;
                }
            }
            Ok(())
        };
        let filled = fill();
        for (level, &choice) in choices[..pushed].iter().enumerate().rev() {
            problem.pop(level, choice);
        }
        filled.map(|()| Path::with(levels, choices, sets))
    }
}

/// Checks the choice made and the alternatives left at a level against those offered.
fn check<A: Alternatives>(
    level: usize,
    left: &[u32],
    made: Option<u32>,
    offered: A,
) -> Result<(), TrailError> {
    // A set knows only numbers up to its words, so look for each among those offered.
    let offered: Vec<u32> = offered.numbers().collect();
    if let Some(pair) = left.windows(2).find(|pair| pair[0] >= pair[1]) {
        return Err(TrailError::Order { level, choice: pair[1] });
    }
    if let Some(choice) = made.filter(|choice| left.contains(choice)) {
        return Err(TrailError::Order { level, choice });
    }
    let foreign = |&choice: &u32| offered.binary_search(&choice).is_err();
    match left.iter().copied().chain(made).find(foreign) {
        Some(choice) => Err(TrailError::Choice { level, choice }),
        None => Ok(()),
    }
}

//! The results of all parts put together.
//!
//! Every part walks the nodes above the frontier; they are counted once. Solutions, orbits and
//! nodes below the frontier are those of disjoint parts of one tree, so the sums are what the
//! undivided search comes to, if every part is there exactly once.

use crate::packing::Standing;
use crate::store::{PartResult, SearchPlan};
use std::fmt::Write;
use std::path::PathBuf;

/// The parts that are there.
#[derive(Debug)]
pub struct Merged {
    /// What the undivided search comes to, if no part is missing; else what the parts that are
    /// there come to.
    pub standing: Standing,
    /// The numbers of the parts that are missing.
    pub missing: Vec<u64>,
    /// The results in the order of the parts.
    pub results: Vec<(PathBuf, PartResult)>,
}

/// Why results do not belong together.
#[derive(Debug, thiserror::Error, PartialEq, Eq)]
pub enum MergeError {
    /// A result of another plan.
    #[error(
        "{}: is the result of another plan ({found}, expected {expected})", .file.display()
    )]
    Plan {
        /// The result.
        file: PathBuf,
        /// The name of its plan.
        found: String,
        /// The name of ours.
        expected: String,
    },
    /// A part that the plan does not have.
    #[error("{}: is part {number} of {of}, but the plan has {parts} parts, from 0", .file.display())]
    Number {
        /// The result.
        file: PathBuf,
        /// The number it gives.
        number: u64,
        /// Of how many.
        of: u64,
        /// Parts of the plan.
        parts: u64,
    },
    /// The same part twice.
    #[error("{} and {}: both are part {number}", .first.display(), .second.display())]
    Twice {
        /// The one.
        first: PathBuf,
        /// The other.
        second: PathBuf,
        /// The part.
        number: u64,
    },
    /// A result that says less than the plan asks for.
    #[error("{}: visited fewer nodes than there are above the frontier", .file.display())]
    Nodes {
        /// The result.
        file: PathBuf,
    },
    /// More than this program can add up.
    #[error("{}: with it the sum of {what} is beyond all measure", .file.display())]
    TooMuch {
        /// The result.
        file: PathBuf,
        /// What is summed.
        what: &'static str,
    },
    /// Parts made by versions of the program that may not agree.
    #[error("{}: was made by version {found}, {} by version {expected}", .file.display(), .other.display())]
    Version {
        /// The result.
        file: PathBuf,
        /// Its version.
        found: String,
        /// Another result.
        other: PathBuf,
        /// The version of that.
        expected: String,
    },
}

/// Puts results of the parts of a plan together.
///
/// # Errors
/// Results of another plan or version, parts twice, parts that the plan does not have.
pub fn merge(
    plan: &SearchPlan,
    mut results: Vec<(PathBuf, PartResult)>,
) -> Result<Merged, MergeError> {
    results.sort_by(|(file, a), (other, b)| (a.number, file).cmp(&(b.number, other)));
    for (file, result) in &results {
        let file = || file.clone();
        if result.plan != plan.name {
            let (found, expected) = (result.plan.clone(), plan.name.clone());
            return Err(MergeError::Plan { file: file(), found, expected });
        }
        let PartResult { number, of, .. } = *result;
        if number >= plan.parts || of != plan.parts {
            return Err(MergeError::Number { file: file(), number, of, parts: plan.parts });
        }
        if result.standing.state.nodes < plan.frontier.above {
            return Err(MergeError::Nodes { file: file() });
        }
    }
    for pair in results.windows(2) {
        let [(first, a), (second, b)] = pair else { continue };
        if a.number == b.number {
            let (first, second) = (first.clone(), second.clone());
            return Err(MergeError::Twice { first, second, number: a.number });
        }
        if a.version != b.version {
            let (found, expected) = (b.version.clone(), a.version.clone());
            let (file, other) = (second.clone(), first.clone());
            return Err(MergeError::Version { file, found, other, expected });
        }
    }
    let mut sum = Standing::nothing();
    for (file, result) in &results {
        let Standing { state, levels, orbits, orbit_sizes, .. } = &result.standing;
        // A wrong number would be worse than none.
        let add = |a: u64, b: u64, what| {
            a.checked_add(b).ok_or_else(|| MergeError::TooMuch { file: file.clone(), what })
        };
        let own = state.nodes - plan.frontier.above;
        sum.state.nodes = add(sum.state.nodes, own, "nodes")?;
        sum.state.solutions = add(sum.state.solutions, state.solutions, "solutions")?;
        sum.state.deepest = sum.state.deepest.max(state.deepest);
        sum.state.elapsed = sum.state.elapsed.saturating_add(state.elapsed);
        sum.levels = sum.levels.max(*levels);
        sum.orbits = add(sum.orbits, *orbits, "orbits")?;
        sum.orbit_sizes += orbit_sizes;
    }
    if let Some((file, _)) = results.first() {
        let above = sum.state.nodes.checked_add(plan.frontier.above);
        let too_much = || MergeError::TooMuch { file: file.clone(), what: "nodes" };
        sum.state.nodes = above.ok_or_else(too_much)?;
    }
    let is_there =
        |number: &u64| results.binary_search_by_key(number, |(_, result)| result.number).is_ok();
    let missing = (0..plan.parts).filter(|number| !is_there(number)).collect();
    Ok(Merged { standing: sum, missing, results })
}

/// Numbers of parts in words: `3, 7-9`.
pub fn missing_words(numbers: &[u64]) -> String {
    let mut words = String::new();
    for run in numbers.chunk_by(|a, b| a + 1 == *b) {
        let comma = if words.is_empty() { "" } else { ", " };
        // Writing to a string does not fail.
        let _ = match run {
            [first, .., last] => write!(words, "{comma}{first}-{last}"),
            [only] => write!(words, "{comma}{only}"),
            [] => Ok(()),
        };
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_words() {
        assert_eq!(missing_words(&[]), "");
        assert_eq!(missing_words(&[3]), "3");
        assert_eq!(missing_words(&[0, 1, 3, 7, 8, 9, 12]), "0-1, 3, 7-9, 12");
    }
}

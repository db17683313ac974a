//! A search in parts on disk: the plan, and what each part came to.
//!
//! Both are sealed JSON, for they are what a published count rests on. A plan names the search
//! in full; its checksum is its name, which every result repeats, so that results of one plan
//! cannot be taken for those of another.

use super::sealed::{read_sealed, write_sealed};
use super::{Extent, StoreError, read_job, write_job};
use crate::packing::{Job, Question, Standing};
use crate::search::{Frontier, Part, State};
use num_bigint::BigUint;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The largest number of parts. A merge looks at every one of them.
pub const MAX_PARTS: u64 = 1_000_000;

const PLAN: &str = "tilepack-plan/1";
const PART: &str = "tilepack-part/1";

/// A search in parts.
#[derive(Debug, Clone)]
pub struct SearchPlan {
    /// The undivided search.
    pub job: Job,
    /// The number of parts.
    pub parts: u64,
    /// Where it is cut.
    pub frontier: Frontier,
    /// The checksum of the plan, which is its name; empty before it is written.
    pub name: String,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct PlanText {
    search: Box<RawValue>,
    parts: u64,
    depth: usize,
    frontier: u64,
    above: u64,
}

impl SearchPlan {
    /// The search of one part.
    pub fn part(&self, number: u64) -> Job {
        let part = Part { depth: self.frontier.depth, number, of: self.parts };
        Job { part: Some(part), ..self.job.clone() }
    }

    /// Writes the plan.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write(&self, file: &Path) -> Result<(), StoreError> {
        let search = RawValue::from_string(write_job(&self.job)).map_err(|error| {
            StoreError::Unwritable { file: file.into(), message: error.to_string() }
        })?;
        let Frontier { depth, nodes, above } = self.frontier;
        let text = PlanText { search, parts: self.parts, depth, frontier: nodes, above };
        write_sealed(file, PLAN, &text)
    }

    /// Reads a plan.
    ///
    /// # Errors
    /// A file that is no plan, was changed, or is of a search that this version does not run.
    pub fn read(file: &Path) -> Result<Self, StoreError> {
        let (text, name): (PlanText, _) = read_sealed(file, PLAN)?;
        let wrong = |message: String| StoreError::Content { file: file.into(), message };
        let job = read_job(text.search.get()).map_err(wrong)?;
        let PlanText { parts, depth, frontier, above, .. } = text;
        if parts == 0 || parts > MAX_PARTS || depth == 0 {
            let range = format!("a plan has 1 to {MAX_PARTS} parts, cut below at least one choice");
            return Err(wrong(range));
        }
        if job.part.is_some() || job.question == Question::First {
            return Err(wrong("a plan divides a whole count or list".into()));
        }
        Ok(Self { job, parts, frontier: Frontier { depth, nodes: frontier, above }, name })
    }
}

/// The files of a part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PartFiles {
    /// Its checkpoint.
    pub checkpoint: PathBuf,
    /// Its packings, if they are kept.
    pub packings: PathBuf,
    /// Its result.
    pub result: PathBuf,
}

impl PartFiles {
    /// Those in a folder, for part `number` of `parts`: names in the order of the numbers.
    pub fn new(folder: &Path, number: u64, parts: u64) -> Self {
        let digits = (parts - 1).to_string().len();
        let name = |end: &str| folder.join(format!("part-{number:0digits$}.{end}"));
        Self {
            checkpoint: name("checkpoint"),
            packings: name("packings"),
            result: name("result.json"),
        }
    }
}

/// What a part came to.
#[derive(Debug, Clone, PartialEq)]
pub struct PartResult {
    /// The name of the plan.
    pub plan: String,
    /// The number of the part.
    pub number: u64,
    /// How many parts there are.
    pub of: u64,
    /// What the search of the part came to; it is complete.
    pub standing: Standing,
    /// How much of its file of packings counts.
    pub kept: Option<Extent>,
    /// The version of the program.
    pub version: String,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct ResultText {
    plan: String,
    part: u64,
    parts: u64,
    solutions_met: u64,
    nodes: u64,
    deepest: usize,
    levels: usize,
    seconds: f64,
    orbits: u64,
    orbit_sizes: String,
    packings: Option<ExtentText>,
    version: String,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct ExtentText {
    bytes: u64,
    hash: String,
}

impl PartResult {
    /// Writes the result.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write(&self, file: &Path) -> Result<(), StoreError> {
        let Standing { state, levels, orbits, orbit_sizes, .. } = &self.standing;
        let extent =
            |kept: Extent| ExtentText { bytes: kept.length, hash: super::hexadecimal(&kept.hash) };
        let text = ResultText {
            plan: self.plan.clone(),
            part: self.number,
            parts: self.of,
            solutions_met: state.solutions,
            nodes: state.nodes,
            deepest: state.deepest,
            levels: *levels,
            seconds: state.elapsed.as_secs_f64(),
            orbits: *orbits,
            orbit_sizes: orbit_sizes.to_string(),
            packings: self.kept.map(extent),
            version: self.version.clone(),
        };
        write_sealed(file, PART, &text)
    }

    /// Reads a result.
    ///
    /// # Errors
    /// A file that is no result, or was changed.
    pub fn read(file: &Path) -> Result<Self, StoreError> {
        let (text, _): (ResultText, _) = read_sealed(file, PART)?;
        let wrong =
            |what: &str| StoreError::Content { file: file.into(), message: format!("{what}?") };
        let mut state = State::start(Vec::new());
        state.nodes = text.nodes;
        state.solutions = text.solutions_met;
        state.deepest = text.deepest;
        state.elapsed =
            Duration::try_from_secs_f64(text.seconds).map_err(|_| wrong("so many seconds"))?;
        let orbit_sizes: BigUint = text.orbit_sizes.parse().map_err(|_| wrong("orbit_sizes"))?;
        let standing = Standing {
            state,
            levels: text.levels,
            orbits: text.orbits,
            orbit_sizes,
            kept: Vec::new(),
        };
        let extent = |text: ExtentText| {
            let digits = |at: usize| u8::from_str_radix(text.hash.get(at..at + 2)?, 16).ok();
            let mut hash = [0; 32];
            for (i, byte) in hash.iter_mut().enumerate() {
                *byte = digits(2 * i).ok_or_else(|| wrong("hash"))?;
            }
            Ok(Extent { length: text.bytes, hash })
        };
        let kept = text.packings.map(extent).transpose()?;
        let (number, of) = (text.part, text.parts);
        if number >= of || of > MAX_PARTS {
            let message = format!("there is no part {number} of {of}");
            return Err(StoreError::Content { file: file.into(), message });
        }
        Ok(Self { plan: text.plan, number, of, standing, kept, version: text.version })
    }
}

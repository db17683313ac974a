//! A search saved while it runs.
//!
//! A checkpoint holds the [job](super::write_job) in words and what the search stands at in
//! numbers, in a [`frame`]. A new one is complete on the disk before it takes the
//! name, and the one before it is kept as `NAME.previous`: whatever happens, one of the two is
//! whole. What is read is not believed beyond its checksum: paths must fit the search.

use super::atomic::{folder, sync_folder};
use super::frame::{self, FrameKind};
use super::{Extent, StoreError, beside, codec, fingerprint};
use crate::packing::Standing;
use crate::search::{Best, Record, State, Trail};
use num_bigint::BigUint;
use serde::{Deserialize, Serialize};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// What a checkpoint holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Checkpoint {
    /// How many were written before it.
    pub generation: u64,
    /// The search, as [`super::write_job`] writes it.
    pub job: String,
    /// What is to be done with the answer, in the words of the command line.
    pub request: String,
    /// What the search stands at; packings kept are in the file of their own.
    pub standing: Standing,
    /// How much of that file counts, if the search keeps packings.
    pub kept: Option<Extent>,
}

/// The payload of version 1.
#[derive(Debug, Serialize, Deserialize)]
struct Payload {
    generation: u64,
    job: String,
    request: String,
    nodes: u64,
    solutions: u64,
    deepest: u64,
    levels: u64,
    nanoseconds: u64,
    orbits: u64,
    /// Little-endian.
    orbit_sizes: Vec<u8>,
    left: Vec<TrailText>,
    best: Option<(Vec<u32>, Vec<u8>)>,
    records: Vec<(Vec<u32>, u64, u64, u64)>,
    kept: Option<(u64, [u8; 32])>,
}

#[derive(Debug, Serialize, Deserialize)]
struct TrailText {
    choices: Vec<u32>,
    /// Each number less the one before it, so that most take one byte.
    left: Vec<Vec<u32>>,
}

impl Checkpoint {
    /// The bytes of the file.
    ///
    /// # Errors
    /// When the content has no form in bytes, which is an error in this program.
    pub fn bytes(&self) -> Result<Vec<u8>, String> {
        let Standing { state, levels, orbits, orbit_sizes, .. } = &self.standing;
        let payload = Payload {
            generation: self.generation,
            job: self.job.clone(),
            request: self.request.clone(),
            nodes: state.nodes,
            solutions: state.solutions,
            deepest: state.deepest as u64,
            levels: *levels as u64,
            nanoseconds: state.elapsed.as_nanos() as u64,
            orbits: *orbits,
            orbit_sizes: orbit_sizes.to_bytes_le(),
            left: state.left.iter().map(TrailText::of).collect(),
            best: state.best.as_ref().map(|best| (best.choices.clone(), best.found.clone())),
            records: state.records.iter().map(plain).collect(),
            kept: self.kept.map(|kept| (kept.length, kept.hash)),
        };
        let payload = codec::encode(&payload)?;
        Ok(frame::write(FrameKind::Checkpoint, &fingerprint(&self.job), &payload))
    }

    /// Reads the bytes of a file.
    ///
    /// # Errors
    /// When they are not those of a checkpoint, cut short or damaged.
    pub fn from_bytes(file: &Path, bytes: &[u8]) -> Result<Self, StoreError> {
        let wrong =
            |message: &str| StoreError::Content { file: file.into(), message: message.into() };
        let frame = frame::read(file, FrameKind::Checkpoint, bytes)?;
        let payload: Payload = codec::decode(frame.payload)
            .map_err(|error| wrong(&format!("is not what a checkpoint holds: {error}")))?;
        if fingerprint(&payload.job) != frame.fingerprint {
            return Err(wrong("its fingerprint is that of another search"));
        }
        Ok(payload.checkpoint())
    }
}

impl Payload {
    fn checkpoint(self) -> Checkpoint {
        let record = |(start, nodes, solutions, deepest)| Record {
            start,
            nodes,
            solutions,
            deepest: deepest as usize,
        };
        let state = State {
            left: self.left.into_iter().map(TrailText::trail).collect(),
            nodes: self.nodes,
            solutions: self.solutions,
            deepest: self.deepest as usize,
            best: self.best.map(|(choices, found)| Best { choices, found }),
            records: self.records.into_iter().map(record).collect(),
            elapsed: Duration::from_nanos(self.nanoseconds),
        };
        let standing = Standing {
            state,
            levels: self.levels as usize,
            orbits: self.orbits,
            orbit_sizes: BigUint::from_bytes_le(&self.orbit_sizes),
            kept: Vec::new(),
        };
        Checkpoint {
            generation: self.generation,
            job: self.job,
            request: self.request,
            standing,
            kept: self.kept.map(|(length, hash)| Extent { length, hash }),
        }
    }
}

fn plain(record: &Record) -> (Vec<u32>, u64, u64, u64) {
    (record.start.clone(), record.nodes, record.solutions, record.deepest as u64)
}

impl TrailText {
    fn of(trail: &Trail) -> Self {
        let gaps = |numbers: &Vec<u32>| {
            let before = std::iter::once(0).chain(numbers.iter().copied());
            numbers
                .iter()
                .zip(before)
                .map(|(&number, before)| number.wrapping_sub(before))
                .collect()
        };
        Self { choices: trail.choices.clone(), left: trail.left.iter().map(gaps).collect() }
    }

    fn trail(self) -> Trail {
        let numbers = |gaps: Vec<u32>| {
            let add = |sum: &mut u32, gap: u32| {
                *sum = sum.wrapping_add(gap);
                Some(*sum)
            };
            gaps.into_iter().scan(0, add).collect()
        };
        Trail { choices: self.choices, left: self.left.into_iter().map(numbers).collect() }
    }
}

/// The name under which the checkpoint before the newest is kept.
pub fn previous(file: &Path) -> PathBuf {
    beside(file, ".previous")
}

/// Writes a checkpoint; the one before it is kept. Gives the size of the file in bytes.
///
/// The file is locked by this process, so the name of what is not yet complete needs not be
/// unique; what a killed process left under it is written over.
///
/// # Errors
/// When it cannot be written; the newest one is then that before it.
pub fn write_checkpoint(file: &Path, checkpoint: &Checkpoint) -> Result<usize, StoreError> {
    let wrong = |message: String| StoreError::Unwritable { file: file.into(), message };
    let bytes = checkpoint.bytes().map_err(wrong)?;
    let part = beside(file, ".part");
    let written = write_whole(&part, &bytes).and_then(|()| take_place(file, &part));
    match written {
        Ok(()) => Ok(bytes.len()),
        Err(error) => {
            // Room for the next attempt.
            let _ = fs::remove_file(&part);
            Err(wrong(error.to_string()))
        }
    }
}

fn write_whole(file: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut out = File::create(file)?;
    out.write_all(bytes)?;
    out.sync_all()
}

/// Gives a complete file its name, and what had that name the name of the one before. Between
/// the two steps there is only the one before.
pub(super) fn take_place(file: &Path, complete: &Path) -> io::Result<()> {
    match fs::rename(file, previous(file)) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
        _ => {}
    }
    fs::rename(complete, file)?;
    sync_folder(folder(file));
    Ok(())
}

/// A checkpoint from disk.
#[derive(Debug)]
pub struct Opened {
    /// The newest that is whole.
    pub checkpoint: Checkpoint,
    /// What is wrong with the newest, when that one is older.
    pub fault: Option<StoreError>,
}

/// Reads the newest checkpoint that is whole. One that is whole but cannot be read here (no
/// permission, a newer format) is no reason to go back to an older one.
///
/// # Errors
/// When there is none: what is wrong with the newest.
pub fn read_checkpoint(file: &Path) -> Result<Opened, StoreError> {
    let fault = match read_one(file) {
        Ok(checkpoint) => return Ok(Opened { checkpoint, fault: None }),
        Err(fault @ (StoreError::Missing { .. } | StoreError::Content { .. })) => fault,
        Err(error) => return Err(error),
    };
    match read_one(&previous(file)) {
        Ok(checkpoint) => Ok(Opened { checkpoint, fault: Some(fault) }),
        Err(_) => Err(fault),
    }
}

fn read_one(file: &Path) -> Result<Checkpoint, StoreError> {
    let bytes = fs::read(file).map_err(|source| match source.kind() {
        io::ErrorKind::NotFound => StoreError::Missing { file: file.into() },
        io::ErrorKind::IsADirectory => StoreError::Directory { file: file.into() },
        _ => StoreError::Unreadable { file: file.into(), source },
    })?;
    Checkpoint::from_bytes(file, &bytes)
}

/// Moves a damaged file out of the way, so that nothing overwrites it; gives its new name, or
/// `None` when there is no such file.
///
/// # Errors
/// When it cannot be renamed.
pub fn set_aside(file: &Path) -> Result<Option<PathBuf>, StoreError> {
    if !file.exists() {
        return Ok(None);
    }
    let names = (1..).map(|number| beside(file, &format!(".damaged-{number}")));
    let free = names.into_iter().find(|name| !name.exists());
    let name = free.unwrap_or_else(|| beside(file, ".damaged"));
    match fs::rename(file, &name) {
        Ok(()) => Ok(Some(name)),
        Err(error) => {
            let message = format!("it is damaged and cannot be set aside: {error}");
            Err(StoreError::Unwritable { file: file.into(), message })
        }
    }
}

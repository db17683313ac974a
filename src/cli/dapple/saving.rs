//! A count saved while it runs, as searches are: another count in the file is refused, a damaged file
//! set aside, the one before it gone on with.

use super::job::Job;
use crate::cli::{duration, output};
use crate::dappled::count::Counting;
use crate::store::{Lock, StoreError, check_writable, previous, read_long, set_aside, write_long};
use anyhow::{Context, bail};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What is to be done with the answer, and what is known beyond the count.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Request {
    /// Whether the answer is a JSON object.
    pub(super) json: bool,
    /// Memory for tables.
    pub(super) memory: usize,
    /// The time that earlier runs took.
    pub(super) before: Duration,
}

impl Request {
    fn text(self, time: Duration) -> String {
        let seconds = (self.before + time).as_secs_f64();
        json!({"json": self.json, "memory": self.memory, "seconds": seconds}).to_string()
    }

    /// Reads it; what is missing is as if nothing had been asked for.
    pub(super) fn read(text: &str) -> Self {
        let request: Value = serde_json::from_str(text).unwrap_or_default();
        let seconds = request["seconds"].as_f64().unwrap_or(0.0);
        Self {
            json: request["json"] == true,
            memory: request["memory"].as_u64().unwrap_or(0) as usize,
            before: Duration::try_from_secs_f64(seconds).unwrap_or_default(),
        }
    }
}

/// A count being saved, its file locked.
#[derive(Debug)]
pub(super) struct Saving {
    /// The checkpoint.
    pub(super) file: PathBuf,
    job: String,
    every: Duration,
    last: Instant,
    _lock: Lock,
}

impl Saving {
    /// Locks the file, and goes on from what it holds, if it is there; gives the time that took.
    ///
    /// # Errors
    /// Another process at work on it, another count in it, damage without an older checkpoint, or a
    /// folder that cannot be written to.
    pub(super) fn open(
        file: &Path,
        job: &Job,
        counting: &mut Counting,
        every: Duration,
        quiet: bool,
    ) -> anyhow::Result<(Self, Duration)> {
        let lock = Lock::take(file)?;
        let (job, last) = (job.text(), Instant::now());
        let saving = |job| Self { file: file.into(), job, every, last, _lock: lock };
        if !file.exists() && !previous(file).exists() {
            check_writable(file)?;
            return Ok((saving(job), Duration::ZERO));
        }
        let mut opened = read_long(file)?;
        if opened.job != job {
            bail!("{}: holds another count: name another file, or resume that one", file.display());
        }
        let restored = counting.restore(&mut opened.content);
        restored.with_context(|| format!("{}: cannot be gone on with", file.display()))?;
        if let Some(fault) = opened.fault {
            let aside = match set_aside(file)? {
                Some(name) => format!(" (kept as {})", name.display()),
                None => String::new(),
            };
            output::remark(&format!("warning: {fault}{aside}; going on from the one before it"));
        }
        let before = Request::read(&opened.request).before;
        if !counting.is_done() {
            check_writable(file)?;
            if !quiet {
                let (done, all) = counting.progress();
                let (file, time) = (file.display(), duration::words(before));
                output::remark(&format!("going on from {file}: {done} steps of {all} in {time}"));
            }
        }
        Ok((saving(job), before))
    }

    /// Whether it is time for a checkpoint; between rows a little earlier.
    pub(super) fn is_due(&self, counting: &Counting) -> bool {
        let early = if counting.is_at_row() { self.every / 2 } else { self.every };
        self.last.elapsed() >= early.max(Duration::from_millis(1))
    }

    /// Writes a checkpoint.
    ///
    /// # Errors
    /// When it cannot be written; the one before it is still there.
    pub(super) fn save(
        &mut self,
        counting: &Counting,
        request: Request,
        time: Duration,
    ) -> Result<(), StoreError> {
        let texts = (&self.job[..], &request.text(time)[..]);
        let written =
            write_long(&self.file, texts, counting.saved_bytes(), |out| counting.save(out));
        self.last = Instant::now();
        written
    }
}

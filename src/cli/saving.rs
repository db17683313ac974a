//! Saving a search where the user asked for it, and finding it again.
//!
//! A file that holds another search, or is damaged, is never overwritten: the first is refused,
//! the second set aside. While a search is at work on a file, another process is refused.

use super::request::Request;
use super::{describe, duration, output};
use crate::packing::{Job, Keeper, Standing};
use crate::store::{
    Extent, Keeping, Kept, Lock, StoreError, Writer, beside, check_writable, fingerprint, previous,
    read_checkpoint, read_job, set_aside, write_job,
};
use anyhow::{Context, bail};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Where a search is saved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Save {
    /// The checkpoint.
    pub file: PathBuf,
    /// The packings met, if they are kept.
    pub kept: PathBuf,
}

impl Save {
    /// At this checkpoint.
    pub fn at(file: &Path) -> Self {
        Self { file: file.into(), kept: beside(file, ".packings") }
    }

    /// Where `--checkpoint` asks for: a file, or (with a slash at its end) a folder, which is
    /// made if it is not there, and in it a name made of the search.
    ///
    /// # Errors
    /// When the folder cannot be made.
    pub fn asked(file: Option<&Path>, job: &Job) -> anyhow::Result<Option<Self>> {
        let Some(file) = file else { return Ok(None) };
        if !file.as_os_str().as_encoded_bytes().ends_with(b"/") {
            return Ok(Some(Self::at(file)));
        }
        fs::create_dir_all(file).with_context(|| format!("{}: cannot be made", file.display()))?;
        let fingerprint = fingerprint(&write_job(job));
        let short: String = fingerprint[..4].iter().map(|byte| format!("{byte:02x}")).collect();
        let name = format!("{}-{short}.checkpoint", describe::slug(job));
        Ok(Some(Self::at(&file.join(name))))
    }
}

/// A search that may be saved, locked.
#[derive(Debug)]
pub struct Saving {
    save: Save,
    writer: Writer,
    lock: Lock,
}

impl Saving {
    /// Locks the file, and reads what it holds, if it is there.
    ///
    /// # Errors
    /// Another process at work on it, another search in it, damage without an older checkpoint,
    /// or a folder that cannot be written to.
    pub fn open(
        save: Save,
        job: &Job,
        request: &Request,
        quiet: bool,
    ) -> anyhow::Result<(Self, Option<Standing>)> {
        let lock = Lock::take(&save.file)?;
        let there = save.file.exists() || previous(&save.file).exists();
        let (job_text, request) = (write_job(job), request.text());
        if !there {
            check_writable(&save.file)?;
            let kept = job.is_list().then(|| Kept::new(save.kept.clone()));
            let file = save.file.clone();
            let (generation, waiting) = (0, Vec::new());
            let writer = Writer { file, job: job_text, request, generation, kept, waiting };
            return Ok((Self { save, writer, lock }, None));
        }
        let opened = read_checkpoint(&save.file)?;
        let checkpoint = opened.checkpoint;
        if checkpoint.job != job_text {
            bail!("{}: {}", save.file.display(), another(&checkpoint.job));
        }
        let kept = match (job.is_list(), checkpoint.kept) {
            (false, _) => None,
            (true, Some(extent)) => Some(Kept::open(save.kept.clone(), extent)?),
            (true, None) => bail!("{}: does not say which packings it met", save.file.display()),
        };
        if let Some(fault) = opened.fault {
            let aside = match set_aside(&save.file)? {
                Some(name) => format!(" (kept as {})", name.display()),
                None => String::new(),
            };
            output::remark(&format!("warning: {fault}{aside}; going on from the one before it"));
        }
        let Standing { state, .. } = &checkpoint.standing;
        if !quiet && !state.is_complete() {
            let time = duration::words(state.elapsed);
            let file = save.file.display();
            output::remark(&format!("going on from {file}: {} nodes in {time}", state.nodes));
        }
        if !state.is_complete() {
            check_writable(&save.file)?;
        }
        let writer = Writer {
            file: save.file.clone(),
            job: job_text,
            request,
            generation: checkpoint.generation + 1,
            kept,
            waiting: Vec::new(),
        };
        Ok((Self { save, writer, lock }, Some(checkpoint.standing)))
    }

    /// Begins to save every so often.
    pub fn start(self, every: Duration) -> Started {
        let Self { save, writer, lock } = self;
        let report = Box::new(|written: &Result<_, StoreError>| {
            if let Err(error) = written {
                let meaning = "going on; the next attempt comes with the next checkpoint";
                output::remark(&format!("warning: no checkpoint: {error}; {meaning}"));
            }
        });
        Started { save, keeping: Keeping::start(writer, every, report), _lock: lock }
    }
}

/// A search being saved.
#[derive(Debug)]
pub struct Started {
    save: Save,
    keeping: Keeping,
    _lock: Lock,
}

impl Started {
    /// What the search hands itself over to.
    pub fn keeper(&self) -> &dyn Keeper {
        &self.keeping
    }

    /// Writes the last checkpoint and brings back all packings kept: whether that was written,
    /// and how much of the file of packings counts.
    ///
    /// # Errors
    /// When the packings kept cannot be read again.
    pub fn finish(
        self,
        job: &Job,
        standing: &mut Standing,
        was_complete: bool,
    ) -> anyhow::Result<(Result<Save, StoreError>, Option<Extent>)> {
        let mut writer = self.keeping.finish();
        let written = match was_complete {
            true => Ok(()),
            false => writer.write(standing.clone()).map(drop),
        };
        if let Some(kept) = &writer.kept {
            standing.kept = kept.packings(job.task.labels())?;
            standing.kept.append(&mut writer.waiting);
        }
        let extent = writer.kept.as_ref().map(Kept::extent);
        Ok((written.map(|()| self.save), extent))
    }
}

/// What else a checkpoint is of.
fn another(job: &str) -> String {
    let advice = "name another file, or resume that search";
    match read_job(job) {
        Ok(job) => format!("holds another search ({}): {advice}", describe::job(&job)),
        Err(error) => format!("holds a search that cannot be gone on with: {error}"),
    }
}

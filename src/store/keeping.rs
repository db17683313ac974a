//! Checkpoints written while a search goes on.
//!
//! The search hands over what it stands at and goes on at once; a thread of its own writes it.
//! While that is busy (a slow disk) nothing new is asked for. A checkpoint that cannot be
//! written (a full disk) is told and tried again when the next is due: the search does not end
//! for it, and packings not yet in their file wait in memory.

use super::checkpoint::{Checkpoint, write_checkpoint};
use super::{Kept, StoreError};
use crate::packing::{Keeper, Standing};
use crossbeam::channel::{Receiver, Sender, bounded};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Writes the checkpoints of one search.
#[derive(Debug)]
pub struct Writer {
    /// The file.
    pub file: PathBuf,
    /// The search in words.
    pub job: String,
    /// What is to be done with the answer.
    pub request: String,
    /// How many checkpoints were written.
    pub generation: u64,
    /// The file of packings, if the search keeps any.
    pub kept: Option<Kept>,
    /// Packings not yet in that file.
    pub waiting: Vec<Vec<u8>>,
}

/// A checkpoint that was written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Written {
    /// Its size in bytes.
    pub bytes: usize,
    /// The time that took.
    pub time: Duration,
}

impl Writer {
    /// Writes what the search stands at.
    ///
    /// # Errors
    /// When it cannot be written; nothing is lost then.
    pub fn write(&mut self, mut standing: Standing) -> Result<Written, StoreError> {
        let begin = Instant::now();
        self.waiting.append(&mut standing.kept);
        if let Some(kept) = &mut self.kept {
            kept.add(&self.waiting)?;
            self.waiting.clear();
        }
        let checkpoint = Checkpoint {
            generation: self.generation,
            job: self.job.clone(),
            request: self.request.clone(),
            standing,
            kept: self.kept.as_ref().map(Kept::extent),
        };
        let bytes = write_checkpoint(&self.file, &checkpoint)?;
        self.generation += 1;
        Ok(Written { bytes, time: begin.elapsed() })
    }
}

/// Told of every checkpoint written while the search runs, and of every failure.
pub type Report = Box<dyn FnMut(&Result<Written, StoreError>) + Send>;

/// Saves a search every so often.
#[derive(Debug)]
pub struct Keeping {
    every: Duration,
    /// When the last checkpoint was asked for.
    last: Mutex<Instant>,
    busy: Arc<AtomicBool>,
    sender: Sender<Standing>,
    thread: JoinHandle<Writer>,
}

impl Keeping {
    /// Begins to save every so often, the first time after that time.
    pub fn start(writer: Writer, every: Duration, report: Report) -> Self {
        // One waits at most: while the writer is busy nothing is due.
        let (sender, receiver) = bounded(1);
        let busy = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&busy);
        let thread = std::thread::spawn(move || write_all(writer, &receiver, &flag, report));
        Self { every, last: Mutex::new(Instant::now()), busy, sender, thread }
    }

    /// Ends when all is written; gives back the writer, for the last checkpoint.
    pub fn finish(self) -> Writer {
        drop(self.sender);
        match self.thread.join() {
            Ok(writer) => writer,
            Err(panic) => std::panic::resume_unwind(panic),
        }
    }
}

fn write_all(
    mut writer: Writer,
    standings: &Receiver<Standing>,
    busy: &AtomicBool,
    mut report: Report,
) -> Writer {
    for standing in standings {
        let written = writer.write(standing);
        report(&written);
        busy.store(false, Ordering::SeqCst);
    }
    writer
}

impl Keeper for Keeping {
    fn is_due(&self) -> bool {
        let last = *self.last.lock().unwrap_or_else(PoisonError::into_inner);
        !self.busy.load(Ordering::SeqCst) && last.elapsed() >= self.every
    }

    fn keep(&self, standing: Standing) {
        *self.last.lock().unwrap_or_else(PoisonError::into_inner) = Instant::now();
        self.busy.store(true, Ordering::SeqCst);
        // The thread that receives ends only after this sender is gone.
        let _ = self.sender.send(standing);
    }
}

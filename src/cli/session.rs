//! One search as a user runs it: its limits, signals, progress, checkpoints and time.
//!
//! A stopped search is no failure. It says what stopped it and how far it got, and its exit code
//! asks to run it again.

use super::args::RunArgs;
use super::exit::Exit;
use super::request::Request;
use super::saving::{Save, Saving};
use super::status::Status;
use super::{describe, duration, output, progress, signal};
use crate::packing::solve::Work;
use crate::packing::{self, Job, Settings, Standing};
use crate::search::{Limits, Stop};
use crate::store::{Extent, StoreError};
use anyhow::Context;
use serde_json::{Value, json};
use std::num::NonZero;
use std::sync::atomic::AtomicBool;
use std::thread::available_parallelism;
use std::time::{Duration, Instant};

/// A search about to be run.
#[derive(Debug)]
pub struct Session<'a> {
    args: &'a RunArgs,
    clock: Clock,
}

/// Threads, and what ends their work early.
#[derive(Debug)]
pub struct Clock {
    /// The number of threads.
    pub threads: usize,
    begin: Instant,
    signal: &'static AtomicBool,
    deadline: Option<Instant>,
}

impl Clock {
    /// Begins to listen to signals, and starts the clock.
    ///
    /// # Errors
    /// When threads or signals cannot be had.
    pub fn start(time_limit: Option<Duration>, threads: Option<u16>) -> anyhow::Result<Self> {
        let threads = self::threads(threads)?;
        let signal = signal::listen()?;
        let begin = Instant::now();
        // A limit beyond what a clock can show is none.
        let deadline = time_limit.and_then(|limit| begin.checked_add(limit));
        Ok(Self { threads, begin, signal, deadline })
    }

    /// What asks to stop.
    pub fn stop(&self) -> impl Stop + use<> {
        (self.signal, self.deadline)
    }

    /// The time since the start.
    pub fn elapsed(&self) -> Duration {
        self.begin.elapsed()
    }

    /// Whether something has asked to stop.
    pub fn elapsed_limit(&self) -> bool {
        self.stop().should_stop()
    }

    /// What has asked to stop, if something has: `signal` or `time-limit`.
    pub fn stopped_by(&self) -> &'static str {
        if self.signal.should_stop() { "signal" } else { "time-limit" }
    }
}

/// A search that has been run.
#[derive(Debug)]
pub struct Done {
    /// What it stands at.
    pub standing: Standing,
    /// What it did, in all runs.
    pub work: Work,
    /// The time it took, in all runs.
    pub time: Duration,
    /// What ended it early.
    pub stopped: Option<Stopped>,
    /// Whether and where what it stands at was saved.
    pub saved: Option<Result<Save, StoreError>>,
    /// How much of the file of packings counts, where they are kept in one.
    pub kept: Option<Extent>,
}

/// An early end.
#[derive(Debug, Clone, PartialEq)]
pub struct Stopped {
    /// `signal`, `time-limit` or `node-limit`.
    pub by: &'static str,
    /// How far it got, in words.
    pub how_far: String,
}

/// The end of a search that keeps no standing.
#[derive(Debug, Clone, Copy, Default)]
pub struct Ended {
    /// The time it took.
    pub time: Duration,
    /// What ended it if it came to nothing: `signal`, `time-limit` or `node-limit`.
    pub by: &'static str,
}

impl Ended {
    /// The time in words.
    pub fn time(&self) -> String {
        duration::words(self.time)
    }

    /// Says on standard error what stopped it and how far it was.
    pub fn tell(&self, how_far: &str) {
        let (by, time) = (spoken(self.by), self.time());
        output::remark(&format!("stopped early by {by}: {time}, {how_far}"));
    }
}

impl<'a> Session<'a> {
    /// Takes the options, begins to listen to signals, and starts the clock.
    ///
    /// # Errors
    /// When threads or signals cannot be had.
    pub fn new(args: &'a RunArgs) -> anyhow::Result<Self> {
        Ok(Self { args, clock: Clock::start(args.time_limit, args.threads)? })
    }

    /// Runs a search, from where it was saved if it was, saving it where asked.
    ///
    /// # Errors
    /// What the search reports; a file that cannot be read or written.
    pub fn run(&self, job: &Job, request: &Request, save: Option<Save>) -> anyhow::Result<Done> {
        let quiet = self.args.quiet;
        let status = Status::new(self.args, self.clock.threads, save.as_ref(), job)?;
        let opened = save.map(|save| Saving::open(save, job, request, quiet)).transpose()?;
        let (saving, from) = match opened {
            Some((saving, from)) => (Some(saving), from),
            None => (None, None),
        };
        let before = from.as_ref().map_or(0, |standing| standing.state.nodes);
        let was_complete = from.as_ref().is_some_and(Standing::is_complete);
        let keeping = saving.map(|saving| saving.start(self.args.checkpoint_every));
        let display = progress::Display::new(quiet, describe::leaf(job));
        let stop = self.clock.stop();
        let nodes = self.args.node_limit.unwrap_or(u64::MAX);
        let standing = packing::run(
            job,
            from,
            &Settings {
                threads: self.clock.threads,
                limits: Limits { stop: &stop, nodes },
                watch: &|progress| {
                    display.show(progress);
                    status.look(progress, display.left());
                },
                keeper: keeping.as_ref().map(|keeping| keeping.keeper()),
            },
        );
        let last = display.finish();
        let mut standing = standing?;
        let work = Work::of(&standing);
        let time = standing.state.elapsed;
        let stopped = (!work.complete).then(|| {
            let by = match self.clock.stopped_by() {
                "time-limit" if standing.state.nodes - before >= nodes => "node-limit",
                by => by,
            };
            let about = last.map_or(String::new(), |last| {
                format!(", about {} of the tree", progress::percent(last.fraction))
            });
            let how_far = format!(
                "{} nodes in {}{about}, deepest level {} of {}",
                work.nodes,
                duration::words(time),
                work.deepest,
                work.levels
            );
            Stopped { by, how_far }
        });
        let (saved, kept) = match keeping {
            None => (None, None),
            Some(keeping) => {
                let (saved, kept) = keeping.finish(job, &mut standing, was_complete)?;
                (Some(saved), kept)
            }
        };
        status.end(&standing, stopped.is_none());
        Ok(Done { standing, work, time, stopped, saved, kept })
    }

    /// Runs a search that knows nothing of paths and checkpoints, with the threads and limits
    /// asked for, and says how long it took and which limit it would have met.
    pub fn bounded<T>(&self, search: impl FnOnce(usize, &Limits<'_>) -> T) -> (T, Ended) {
        let stop = self.clock.stop();
        let nodes = self.args.node_limit.unwrap_or(u64::MAX);
        let found = search(self.clock.threads, &Limits { stop: &stop, nodes });
        let by = if stop.should_stop() { self.clock.stopped_by() } else { "node-limit" };
        (found, Ended { time: self.clock.elapsed(), by })
    }

    /// What was done when no search was needed.
    pub fn without_search(&self) -> Done {
        let mut standing = Standing::nothing();
        standing.state.elapsed = self.clock.elapsed();
        let (work, time) = (Work::of(&standing), standing.state.elapsed);
        Done { standing, work, time, stopped: None, saved: None, kept: None }
    }

    /// Says something on standard error, unless asked to be quiet.
    pub fn remark(&self, text: &str) {
        if !self.args.quiet {
            output::remark(text);
        }
    }
}

impl Done {
    /// `complete` or `stopped`.
    pub fn state(&self) -> &'static str {
        if self.stopped.is_some() { "stopped" } else { "complete" }
    }

    /// `260513 nodes in 0.02 s`.
    pub fn effort(&self) -> String {
        format!("{} nodes in {}", self.work.nodes, duration::words(self.time))
    }

    /// Says on standard error that, why and how far along the search was stopped, also when
    /// asked to be quiet: the answer is not what it seems. Then whether it was saved.
    pub fn tell_stop(&self, meaning: &str) {
        if let Some(Stopped { by, how_far }) = &self.stopped {
            let saved = match &self.saved {
                Some(Ok(save)) => format!("; saved: tilepack resume {}", save.file.display()),
                _ => String::new(),
            };
            output::remark(&format!(
                "stopped early by {}: {how_far}; {meaning}{saved}",
                spoken(by)
            ));
        }
        if let Some(Err(error)) = &self.saved {
            output::remark(&format!("the last checkpoint was not saved: {error}"));
        }
    }

    /// The exit code of an early end: it says that all is saved where asked.
    pub fn stopped_exit(&self) -> Exit {
        if matches!(self.saved, Some(Err(_))) { Exit::Bad } else { Exit::Stopped }
    }

    /// The JSON fields that every search has.
    pub fn fields(&self) -> Vec<(&'static str, Value)> {
        let mut fields = vec![
            ("nodes", json!(self.work.nodes.to_string())),
            ("seconds", json!(self.time.as_secs_f64())),
            ("stopped_by", json!(self.stopped.as_ref().map(|stopped| stopped.by))),
        ];
        if let Some(saved) = &self.saved {
            let file = saved.as_ref().ok().map(|save| save.file.to_string_lossy());
            fields.push(("checkpoint", json!(file)));
        }
        fields
    }
}

/// What ended a search early, in a sentence.
pub fn spoken(by: &str) -> &str {
    match by {
        "signal" => "a signal",
        "node-limit" => "the node limit",
        _ => "the time limit",
    }
}

/// The number of threads to use: that asked for, else one a core. Sorting and checking use as
/// many.
///
/// # Errors
/// When the threads cannot be had.
pub fn threads(asked: Option<u16>) -> anyhow::Result<usize> {
    let threads = match asked {
        Some(threads) => usize::from(threads),
        None => available_parallelism().map_or(1, NonZero::get),
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
    pool.with_context(|| format!("{threads} threads cannot be started"))?;
    Ok(threads)
}

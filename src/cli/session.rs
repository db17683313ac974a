//! One search as a user runs it: its limits, signals, progress and time.
//!
//! A stopped search is no failure. It says what stopped it and how far it got, and its exit code
//! asks to run it again.

use super::args::SearchArgs;
use super::{duration, output, progress, signal};
use crate::packing::solve::{SolveError, Work};
use crate::packing::{Answer, Settings};
use crate::search::{Limits, Stop, Values};
use anyhow::Context;
use serde_json::{Value, json};
use std::num::NonZero;
use std::sync::atomic::AtomicBool;
use std::thread::available_parallelism;
use std::time::{Duration, Instant};

/// A search about to be run.
#[derive(Debug)]
pub struct Session<'a> {
    args: &'a SearchArgs,
    values: Values,
    begin: Instant,
    signal: &'static AtomicBool,
    deadline: Option<Instant>,
    threads: usize,
}

/// A search that has been run.
#[derive(Debug)]
pub struct Done<T> {
    /// The answer; not final when stopped.
    pub value: T,
    /// What the search did.
    pub work: Work,
    /// The time it took.
    pub time: Duration,
    /// What ended it early.
    pub stopped: Option<Stopped>,
}

/// An early end.
#[derive(Debug, Clone, PartialEq)]
pub struct Stopped {
    /// `signal`, `time-limit` or `node-limit`.
    pub by: &'static str,
    /// How far it got, in words.
    pub how_far: String,
}

impl<'a> Session<'a> {
    /// Takes the options, begins to listen to signals, and starts the clock.
    ///
    /// # Errors
    /// When threads or signals cannot be had.
    pub fn new(args: &'a SearchArgs, values: Values) -> anyhow::Result<Self> {
        let threads = threads(args.threads)?;
        let signal = signal::listen()?;
        let begin = Instant::now();
        // A limit beyond what a clock can show is none.
        let deadline = args.time_limit.and_then(|limit| begin.checked_add(limit));
        Ok(Self { args, values, begin, signal, deadline, threads })
    }

    /// Runs a search.
    ///
    /// # Errors
    /// What the search reports.
    pub fn run<T>(
        &self,
        search: impl FnOnce(&Settings<'_>) -> Result<Answer<T>, SolveError>,
    ) -> anyhow::Result<Done<T>> {
        let display = progress::Display::new(self.args.quiet);
        let stop = (self.signal, self.deadline);
        let nodes = self.args.node_limit.unwrap_or(u64::MAX);
        let answer = search(&Settings {
            threads: self.threads,
            limits: Limits { stop: &stop, nodes },
            watch: &|progress| display.show(progress),
            values: self.values,
            reduce: !self.args.plain,
        });
        let last = display.finish();
        let Answer { value, work } = answer?;
        let time = self.begin.elapsed();
        let stopped = (!work.complete).then(|| {
            let by = match () {
                () if self.signal.should_stop() => "signal",
                () if work.nodes >= nodes => "node-limit",
                () => "time-limit",
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
        Ok(Done { value, work, time, stopped })
    }

    /// What was done when no search was needed.
    pub fn without_search<T>(&self, value: T) -> Done<T> {
        let work = Work { complete: true, nodes: 0, deepest: 0, levels: 0 };
        Done { value, work, time: self.begin.elapsed(), stopped: None }
    }

    /// Says something on standard error, unless asked to be quiet.
    pub fn remark(&self, text: &str) {
        if !self.args.quiet {
            output::remark(text);
        }
    }
}

impl<T> Done<T> {
    /// `complete` or `stopped`.
    pub fn state(&self) -> &'static str {
        if self.stopped.is_some() { "stopped" } else { "complete" }
    }

    /// `260513 nodes in 0.02 s`.
    pub fn effort(&self) -> String {
        format!("{} nodes in {}", self.work.nodes, duration::words(self.time))
    }

    /// Says on standard error that, why and how far along the search was stopped, also when
    /// asked to be quiet: the answer is not what it seems.
    pub fn tell_stop(&self, meaning: &str) {
        if let Some(Stopped { by, how_far }) = &self.stopped {
            output::remark(&format!("stopped early by {}: {how_far}; {meaning}", spoken(by)));
        }
    }

    /// The JSON fields that every search has.
    pub fn fields(&self) -> [(&'static str, Value); 3] {
        [
            ("nodes", json!(self.work.nodes.to_string())),
            ("seconds", json!(self.time.as_secs_f64())),
            ("stopped_by", json!(self.stopped.as_ref().map(|stopped| stopped.by))),
        ]
    }
}

fn spoken(by: &str) -> &str {
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

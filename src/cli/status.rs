//! How far a search is, in a small file for dashboards, written whole once a checkpoint.

use super::args::RunArgs;
use super::output;
use super::saving::Save;
use crate::packing::{Job, Standing};
use crate::search::Progress;
use crate::store::{check_writable, write_file};
use serde_json::{Value, json};
use std::cell::Cell;
use std::io::Write;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Writes the file, where one is asked for.
#[derive(Debug)]
pub struct Status {
    file: Option<PathBuf>,
    every: Duration,
    /// When it was last written.
    last: Cell<Option<Instant>>,
    /// The latest progress told.
    progress: Cell<Option<Progress>>,
    threads: usize,
    /// Whether what the search meets are solutions.
    solutions: bool,
    checkpoint: Option<String>,
}

impl Status {
    /// Nothing written yet.
    ///
    /// # Errors
    /// When the file could not be written.
    pub fn new(
        args: &RunArgs,
        threads: usize,
        save: Option<&Save>,
        job: &Job,
    ) -> anyhow::Result<Self> {
        let file = args.status.clone();
        if let Some(file) = &file {
            check_writable(file)?;
        }
        Ok(Self {
            file,
            every: args.checkpoint_every,
            last: Cell::new(None),
            progress: Cell::new(None),
            threads,
            solutions: !job.by_lines,
            checkpoint: save.map(|save| save.file.to_string_lossy().into_owned()),
        })
    }

    /// Takes a look at the search; writes the file at the first one and whenever it is time.
    pub fn look(&self, progress: &Progress, left: Option<(Duration, Duration)>) {
        self.progress.set(Some(*progress));
        if self.last.get().is_none_or(|last| last.elapsed() >= self.every) {
            self.write("running", progress, left);
        }
    }

    /// Writes how the search ended.
    pub fn end(&self, standing: &Standing, complete: bool) {
        let last = self.progress.get();
        let fraction = if complete { 1.0 } else { last.map_or(0.0, |last| last.fraction) };
        let progress = Progress {
            nodes: standing.state.nodes,
            solutions: standing.state.solutions,
            deepest: standing.state.deepest,
            levels: standing.levels,
            fraction,
            elapsed: standing.state.elapsed,
        };
        self.write(if complete { "complete" } else { "stopped" }, &progress, None);
    }

    fn write(&self, state: &str, progress: &Progress, left: Option<(Duration, Duration)>) {
        let Some(file) = &self.file else { return };
        self.last.set(Some(Instant::now()));
        let Progress { nodes, solutions, deepest, levels, fraction, elapsed } = *progress;
        let seconds = elapsed.as_secs_f64();
        // The longest time may be without bound.
        let bounded = |time: Duration| (time < Duration::MAX).then_some(time.as_secs_f64());
        let left_seconds: Option<Value> =
            left.map(|(shortest, longest)| json!([bounded(shortest), bounded(longest)]));
        let fields = [
            ("state", json!(state)),
            ("fraction", json!(fraction)),
            ("seconds", json!(seconds)),
            ("seconds_left", json!(left_seconds)),
            ("nodes", json!(nodes.to_string())),
            ("nodes_per_second", json!((nodes as f64 / seconds.max(1e-9)).round())),
            ("solutions_met", json!(self.solutions.then(|| solutions.to_string()))),
            ("deepest", json!(deepest)),
            ("levels", json!(levels)),
            ("threads", json!(self.threads)),
            ("process", json!(std::process::id())),
            ("checkpoint", json!(self.checkpoint)),
        ];
        let text = output::object_text(&fields);
        if let Err(error) = write_file(file, |out| writeln!(out, "{text}")) {
            // A dashboard is not worth a search.
            output::remark(&format!("warning: no status: {error}"));
        }
    }
}

//! Independent probes on several threads, in order of their numbers.
//!
//! Threads take the next number each. When stopped early only the probes before the first
//! unfinished one count: a probe must not be dropped for having taken long.

use super::Settings;
use super::probe::Sums;
use crate::search::Progress;
use crossbeam::channel::{RecvTimeoutError, bounded};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering::SeqCst};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Time between two looks at the limits and two reports of progress.
const TICK: Duration = Duration::from_millis(50);

/// What a probe tells and is told while it runs.
pub(super) struct Job<'a> {
    stop: &'a AtomicBool,
    probed: &'a AtomicU64,
}

impl Job<'_> {
    /// Reports nodes visited; whether to stop.
    pub(super) fn report(&self, nodes: u64) -> bool {
        self.probed.fetch_add(nodes, SeqCst);
        self.stop.load(SeqCst)
    }
}

/// Stops the others when one thread panics.
struct StopOnPanic<'a>(&'a AtomicBool);

impl Drop for StopOnPanic<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.store(true, SeqCst);
        }
    }
}

/// Does work `0..count`; the results before the first that was not finished.
pub(super) fn in_parallel(
    count: usize,
    levels: usize,
    settings: &Settings<'_>,
    work: &(dyn Fn(usize, &Job<'_>) -> Option<Sums> + Sync),
) -> Vec<Sums> {
    let begin = Instant::now();
    let (stop, probed) = (AtomicBool::new(settings.stop.should_stop()), AtomicU64::new(0));
    let (next, finished) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let results: Mutex<Vec<Option<Sums>>> = Mutex::new(vec![None; count]);
    let (done, all_done) = bounded::<()>(0);
    std::thread::scope(|scope| {
        for _ in 0..settings.threads.clamp(1, count.max(1)) {
            let done = done.clone();
            let (stop, probed, next, finished, results) =
                (&stop, &probed, &next, &finished, &results);
            scope.spawn(move || {
                let _guard = StopOnPanic(stop);
                let _done = done;
                loop {
                    let number = next.fetch_add(1, SeqCst);
                    if number >= count || stop.load(SeqCst) {
                        return;
                    }
                    let Some(sums) = work(number, &Job { stop, probed }) else { return };
                    results.lock().unwrap_or_else(PoisonError::into_inner)[number] = Some(sums);
                    finished.fetch_add(1, SeqCst);
                }
            });
        }
        drop(done);
        let _guard = StopOnPanic(&stop);
        while let Err(RecvTimeoutError::Timeout) = all_done.recv_timeout(TICK) {
            if settings.stop.should_stop() {
                stop.store(true, SeqCst);
            }
            (settings.watch)(&Progress {
                nodes: probed.load(SeqCst),
                solutions: 0,
                deepest: levels,
                levels,
                fraction: finished.load(SeqCst) as f64 / count as f64,
                elapsed: begin.elapsed(),
            });
        }
    });
    let results = results.into_inner().unwrap_or_else(PoisonError::into_inner);
    results.into_iter().map_while(|sums| sums).collect()
}

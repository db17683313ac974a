//! Descents one after the other, or several at a time, until one finds a packing.
//!
//! The answer is that of the lowest number that finds one: whoever finds one tells those with a
//! higher number to give up and waits for those with a lower one. So it depends neither on the
//! number of threads nor on which of them was fast.

use super::descent::{Beam, Descent};
use super::rule::Rule;
use crate::search::Limits;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// What a run of descents came to, in plain colors.
#[derive(Debug)]
pub(super) struct Run {
    /// The number of the descent that found it, and the colors.
    pub(super) found: Option<(u64, Vec<u8>)>,
    /// Nodes of the descents up to that one, or of all.
    pub(super) nodes: u64,
    /// Descents that ended by themselves, up to that one.
    pub(super) ended: u64,
    /// The most cells that a descent filled.
    pub(super) depth: usize,
}

/// What the threads share.
struct Shared {
    next: AtomicU64,
    /// The lowest number that found a packing.
    lowest: AtomicU64,
    nodes: AtomicU64,
    stopped: AtomicBool,
    ended: Mutex<Vec<(u64, Descent)>>,
}

/// Descends until a packing is found, `most` times have been in vain or the limits say stop.
pub(super) fn run<R: Rule>(
    beam: &Beam<'_, R>,
    most: u64,
    threads: usize,
    limits: &Limits<'_>,
) -> Run {
    let shared = Shared {
        next: AtomicU64::new(0),
        lowest: AtomicU64::new(u64::MAX),
        nodes: AtomicU64::new(0),
        stopped: AtomicBool::new(false),
        ended: Mutex::new(Vec::new()),
    };
    std::thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(|| work(beam, most, &shared, limits));
        }
        work(beam, most, &shared, limits);
    });
    let mut descents = shared.ended.into_inner().unwrap_or_else(|poison| poison.into_inner());
    let lowest = shared.lowest.into_inner();
    descents.retain(|&(number, _)| number <= lowest);
    let depth = descents.iter().map(|(_, descent)| descent.depth).max().unwrap_or(0);
    Run {
        nodes: descents.iter().map(|(_, descent)| descent.nodes).sum(),
        ended: descents.iter().filter(|(_, descent)| !descent.cut).count() as u64,
        depth,
        found: descents
            .into_iter()
            .find_map(|(number, descent)| (number == lowest).then_some((number, descent.found?))),
    }
}

fn work<R: Rule>(beam: &Beam<'_, R>, most: u64, shared: &Shared, limits: &Limits<'_>) {
    loop {
        let number = shared.next.fetch_add(1, Ordering::Relaxed);
        let mut known = 0;
        let stopped = |nodes: u64, known: &mut u64| {
            let all = shared.nodes.fetch_add(nodes - *known, Ordering::Relaxed) + nodes - *known;
            *known = nodes;
            let stop = all >= limits.nodes
                || shared.stopped.load(Ordering::Relaxed)
                || limits.stop.should_stop();
            if stop {
                shared.stopped.store(true, Ordering::Relaxed);
            }
            stop || shared.lowest.load(Ordering::Relaxed) < number
        };
        if number >= most || stopped(0, &mut known) {
            return;
        }
        let descent = beam.descend(number, |nodes| stopped(nodes, &mut known));
        stopped(descent.nodes, &mut known);
        if descent.found.is_some() {
            shared.lowest.fetch_min(number, Ordering::Relaxed);
        }
        if let Ok(mut ended) = shared.ended.lock() {
            ended.push((number, descent));
        }
    }
}

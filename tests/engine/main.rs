//! The generic search: inverses, paths, splitting, stopping and going on, threads, panics.

#![allow(clippy::unwrap_used, clippy::panic)]

mod batches;
mod inverses;
mod paths;
mod problems;
mod resuming;
mod sprints;
#[path = "../common/step_by_step.rs"]
mod step_by_step;
mod threads;

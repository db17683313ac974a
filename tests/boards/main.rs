//! Boards: squares that may be turned, outer sides, a prescribed border.

#![allow(clippy::unwrap_used)]

mod answers;
mod command;
mod files;
mod naive;
mod orbits;
mod puzzles;
mod sprints;
#[path = "../common/step_by_step.rs"]
mod step_by_step;

//! Boards: squares that may be turned, outer sides, a prescribed border.

#![allow(clippy::unwrap_used)]

mod answers;
mod naive;
mod puzzles;

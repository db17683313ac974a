//! Dappled tilings: every answer against slow and obvious ones.

#![allow(clippy::unwrap_used)]

mod brick;
mod command;
mod decide;
mod exact;
mod make;
#[path = "../sat/proof.rs"]
mod proof;
mod random;

//! Dappled tilings: every answer against slow and obvious ones.

#![allow(clippy::unwrap_used)]

mod closest;
mod decide;
mod exact;
#[path = "../sat/proof.rs"]
mod proof;

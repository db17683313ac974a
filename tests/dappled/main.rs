//! Dappled tilings: every answer against slow and obvious ones.

#![allow(clippy::unwrap_used)]

mod decide;
mod exact;
#[path = "../sat/proof.rs"]
mod proof;

//! Dappled tilings: every answer against slow and obvious ones.

#![allow(clippy::unwrap_used, clippy::panic)]

mod command;
mod count;
mod decide;
mod exact;
mod oracle;
#[path = "../sat/proof.rs"]
mod proof;
mod sample;
mod tables;

//! Dappled tilings: every answer against slow and obvious ones.

#![allow(clippy::unwrap_used, clippy::panic)]

mod brick;
mod closest;
mod command;
mod count;
mod counting;
mod decide;
mod exact;
mod flow;
mod make;
mod oracle;
mod program;
#[path = "../sat/proof.rs"]
mod proof;
mod random;
mod sample;
mod tables;

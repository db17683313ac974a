//! Dappled tilings: counted, made, decided, checked.

#![allow(clippy::unwrap_used, clippy::panic)]

mod command;
mod count;
mod oracle;
mod sample;
mod tables;

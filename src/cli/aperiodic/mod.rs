//! `aperiodic`: sets of tiles that fill the plane, but never periodically. One file a command.

pub mod claims;
pub mod classify;
pub mod decide;
mod merge;
mod published;

use super::args::AperiodicCommand;
use super::exit::Exit;

/// Runs one of the commands.
///
/// # Errors
/// Bad input, or files that cannot be written.
pub fn run(command: &AperiodicCommand) -> anyhow::Result<Exit> {
    match command {
        AperiodicCommand::Decide(args) => decide::run(args),
        AperiodicCommand::Classify(args) => classify::run(args),
    }
}

//! `aperiodic`: sets of tiles that fill the plane, but never periodically. One file a command;
//! [`certificate`] and [`claims`] are what `verify` says about proofs.

pub mod certificate;
pub mod claims;
pub mod classify;
pub mod color;
pub mod convert;
pub mod decide;
mod merge;
pub mod patch;
mod published;
pub mod sets;
mod source;
pub mod tables;

use super::args::AperiodicCommand;
use super::exit::Exit;

/// Runs one of the commands.
///
/// # Errors
/// Bad input, or files that cannot be written.
pub fn run(command: &AperiodicCommand) -> anyhow::Result<Exit> {
    match command {
        AperiodicCommand::Sets(args) => sets::run(args),
        AperiodicCommand::Convert(args) => convert::run(args),
        AperiodicCommand::Tables(args) => tables::run(args),
        AperiodicCommand::Decide(args) => decide::run(args),
        AperiodicCommand::Classify(args) => classify::run(args),
        AperiodicCommand::Color(args) => color::run(args),
        AperiodicCommand::Patch(args) => patch::run(args),
    }
}

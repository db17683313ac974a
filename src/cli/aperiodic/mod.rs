//! `aperiodic`: sets of tiles that fill the plane, but never periodically. One file a command;
//! [`certificate`] is what `verify` says about proofs.

pub mod certificate;
pub mod color;

use super::args::AperiodicCommand;
use super::exit::Exit;

/// Runs one of the commands.
///
/// # Errors
/// Bad input, or files that cannot be written.
pub fn run(command: &AperiodicCommand) -> anyhow::Result<Exit> {
    match command {
        AperiodicCommand::Color(args) => color::run(args),
    }
}

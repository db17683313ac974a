//! `dapple`: tilings in which nothing repeats for too long. One file a command; `rule` reads what
//! they have in common, `write` puts tilings out.

pub mod check;
pub mod closest;
pub mod decide;
mod rule;
mod write;

use super::args::DappleCommand;
use super::exit::Exit;

/// Runs one of the commands.
///
/// # Errors
/// Bad input, or files that cannot be written.
pub fn run(command: &DappleCommand) -> anyhow::Result<Exit> {
    match command {
        DappleCommand::Check(args) => check::run(args),
        DappleCommand::Closest(args) => closest::run(args),
        DappleCommand::Decide(args) => decide::run(args),
    }
}

//! `dapple`: tilings in which nothing repeats for too long. One file a command; `rule` reads what
//! they have in common, `write` puts tilings out.

pub mod check;
pub mod closest;
pub mod count;
pub mod decide;
pub mod draw;
pub mod flow;
mod job;
pub mod make;
mod rule;
pub mod sample;
mod saving;
mod write;

use super::args::DappleCommand;
use super::exit::Exit;

/// Runs one of the commands.
///
/// # Errors
/// Bad input, or files that cannot be written.
pub fn run(command: &DappleCommand) -> anyhow::Result<Exit> {
    match command {
        DappleCommand::Make(args) => make::run(args),
        DappleCommand::Check(args) => check::run(args),
        DappleCommand::Closest(args) => closest::run(args),
        DappleCommand::Decide(args) => decide::run(args),
        DappleCommand::Count(args) => count::run(args),
        DappleCommand::Sample(args) => sample::run(args),
        DappleCommand::Draw(args) => draw::run(args),
        DappleCommand::Flow(args) => flow::run(args),
    }
}

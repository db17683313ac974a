//! The options of the commands about dappled tilings.

mod decide;
mod make;
mod rule;

pub use decide::DappleDecideArgs;
pub use make::{DappleMakeArgs, OrderArg, StartArg};
pub use rule::{DappleCheckArgs, RuleArgs};

use super::super::help;
use clap::Subcommand;

/// What to do with dappled tilings.
#[derive(Debug, Clone, Subcommand)]
pub enum DappleCommand {
    /// Make a tiling, of a field that is given or of a random one
    #[command(after_help = help::DAPPLE_MAKE)]
    Make(DappleMakeArgs),
    /// Check a tiling from the definition
    #[command(after_help = help::DAPPLE_CHECK)]
    Check(DappleCheckArgs),
    /// Complete a partial tiling, or show which cells make that impossible
    #[command(after_help = help::DAPPLE_DECIDE)]
    Decide(DappleDecideArgs),
}

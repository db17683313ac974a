//! The options of the commands about dappled tilings.

mod closest;
mod decide;
mod rule;

pub use closest::DappleClosestArgs;
pub use decide::DappleDecideArgs;
pub use rule::{DappleCheckArgs, RuleArgs};

use super::super::help;
use clap::Subcommand;

/// What to do with dappled tilings.
#[derive(Debug, Clone, Subcommand)]
pub enum DappleCommand {
    /// Find the nearest tiling of a field, with proof
    #[command(after_help = help::DAPPLE_CLOSEST)]
    Closest(DappleClosestArgs),
    /// Check a tiling from the definition
    #[command(after_help = help::DAPPLE_CHECK)]
    Check(DappleCheckArgs),
    /// Complete a partial tiling, or show which cells make that impossible
    #[command(after_help = help::DAPPLE_DECIDE)]
    Decide(DappleDecideArgs),
}

//! The options of the commands about dappled tilings.

mod count;
mod rule;

pub use count::{DappleCountArgs, DappleSampleArgs};
pub use rule::{DappleCheckArgs, RuleArgs};

use super::super::help;
use clap::Subcommand;

/// What to do with dappled tilings.
#[derive(Debug, Clone, Subcommand)]
pub enum DappleCommand {
    /// Check a tiling from the definition
    #[command(after_help = help::DAPPLE_CHECK)]
    Check(DappleCheckArgs),
    /// Count all dappled tilings, exactly
    #[command(after_help = help::DAPPLE_COUNT)]
    Count(DappleCountArgs),
    /// Draw random dappled tilings, all equally likely
    #[command(after_help = help::DAPPLE_SAMPLE)]
    Sample(DappleSampleArgs),
}

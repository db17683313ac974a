//! The options of the commands about dappled tilings.

mod rule;

pub use rule::{DappleCheckArgs, RuleArgs};

use super::super::help;
use clap::Subcommand;

/// What to do with dappled tilings.
#[derive(Debug, Clone, Subcommand)]
pub enum DappleCommand {
    /// Check a tiling from the definition
    #[command(after_help = help::DAPPLE_CHECK)]
    Check(DappleCheckArgs),
}

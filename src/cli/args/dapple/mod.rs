//! The options of the commands about dappled tilings.

mod closest;
mod count;
mod decide;
mod draw;
mod flow;
mod make;
mod rule;

pub use closest::DappleClosestArgs;
pub use count::{DappleCountArgs, DappleSampleArgs};
pub use decide::DappleDecideArgs;
pub use draw::DappleDrawArgs;
pub use flow::DappleFlowArgs;
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
    /// Find the nearest tiling of a field, with proof
    #[command(after_help = help::DAPPLE_CLOSEST)]
    Closest(DappleClosestArgs),
    /// Check a tiling from the definition
    #[command(after_help = help::DAPPLE_CHECK)]
    Check(DappleCheckArgs),
    /// Complete a partial tiling, or show which cells make that impossible
    #[command(after_help = help::DAPPLE_DECIDE)]
    Decide(DappleDecideArgs),
    /// Count all dappled tilings, exactly
    #[command(after_help = help::DAPPLE_COUNT)]
    Count(DappleCountArgs),
    /// Draw random dappled tilings, all equally likely
    #[command(after_help = help::DAPPLE_SAMPLE)]
    Sample(DappleSampleArgs),
    /// Draw a tiling, and where it differs from another
    #[command(after_help = help::DAPPLE_DRAW)]
    Draw(DappleDrawArgs),
    /// Draw streams through a tiling by two tiles
    #[command(after_help = help::DAPPLE_FLOW)]
    Flow(DappleFlowArgs),
}

//! The options of the commands about aperiodic sets.

mod color;
mod decide;
mod sets;

pub use color::{ColorArgs, ConditionArg};
pub use decide::{ClassifyArgs, DecideArgs, UpToArg};
pub use sets::{ConvertArgs, PatchArgs, SetsArgs as AperiodicSetsArgs, TablesArgs};

use super::super::help;
use clap::Subcommand;

/// What to do with sets of tiles.
#[derive(Debug, Clone, Subcommand)]
pub enum AperiodicCommand {
    /// List the sets that are known, with what is known about them
    #[command(after_help = help::APERIODIC_SETS)]
    Sets(AperiodicSetsArgs),
    /// Make corner tiles of Wang tiles, or Wang tiles of corner tiles
    #[command(after_help = help::CONVERT)]
    Convert(ConvertArgs),
    /// Give the tables of all conversions of the published sets, and say which of them are sound
    #[command(after_help = help::TABLES)]
    Tables(TablesArgs),
    /// Find out whether a set fills the plane: not at all, with two periods, or as a published
    /// aperiodic set
    #[command(after_help = help::DECIDE)]
    Decide(DecideArgs),
    /// Decide all sets of a size
    #[command(after_help = help::CLASSIFY)]
    Classify(ClassifyArgs),
    /// Find a small aperiodic set of corner tiles, by coloring the vertices of a Wang tiling
    #[command(after_help = help::APERIODIC_COLOR)]
    Color(ColorArgs),
    /// Fill a rectangle with the tiles of a set
    #[command(after_help = help::PATCH)]
    Patch(PatchArgs),
}

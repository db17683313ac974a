//! The options of `walk`.

use super::super::duration;
use super::ClaimArgs;
use clap::Args;
use std::path::PathBuf;
use std::time::Duration;

/// A walk from a packing.
#[derive(Debug, Clone, Args)]
pub struct WalkArgs {
    /// Solution file, list (its first packing) or text grid; - is standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What the file is.
    #[command(flatten)]
    pub claim: ClaimArgs,
    /// Patches to try
    #[arg(long, value_name = "N", default_value_t = 10_000, help_heading = "Walk")]
    pub steps: u64,
    /// Columns and rows of cells in a patch
    #[arg(long, value_name = "WxH", default_value = "6x6", help_heading = "Walk")]
    pub patch: String,
    /// Seed of random choices
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = "Walk")]
    pub seed: u64,
    /// Stop after this time: 500ms, 90s, 10m, 2h, 1d; a number alone is in seconds
    #[arg(long, value_name = "TIME", value_parser = duration::parse, help_heading = "Walk")]
    pub time_limit: Option<Duration>,
    /// No remarks on standard error, only errors, warnings and early stops
    #[arg(long, help_heading = "Walk")]
    pub quiet: bool,
    /// Write the packing to this file (JSON) instead of a grid to standard output
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

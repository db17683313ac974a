//! The options of `dapple closest`.

use super::RuleArgs;
use crate::cli::duration;
use clap::Args;
use std::path::PathBuf;
use std::time::Duration;

/// A field whose nearest dappled tiling is asked for.
#[derive(Debug, Clone, Args)]
pub struct DappleClosestArgs {
    /// Text or PNG, a level of gray for each tile; a free cell is near to any tile; - is standard
    /// input, as text
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What the tiling keeps.
    #[command(flatten)]
    pub rule: RuleArgs,
    /// Cells that must hold these tiles, all others free: text or PNG
    #[arg(long, value_name = "FILE", help_heading = "Problem")]
    pub fixed: Option<PathBuf>,
    /// What it costs to change each cell: numbers with blanks between them, or PNG, from 0 for black
    /// to 255 for white [default: 1]
    #[arg(long, value_name = "FILE", help_heading = "Problem")]
    pub weights: Option<PathBuf>,
    /// Seed of random choices
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = "Search")]
    pub seed: u64,
    /// Stop after this time with the best so far: 500ms, 90s, 10m, 2h, 1d; a number alone is in
    /// seconds
    #[arg(long, value_name = "TIME", value_parser = duration::parse, help_heading = "Search")]
    pub time_limit: Option<Duration>,
    /// Threads; the result does not depend on them, unless time ends the search [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024), help_heading = "Search")]
    pub threads: Option<u16>,
    /// Write the tiling to this file, as PNG if its name ends so, else as text
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
    /// No remarks on standard error, only errors and early stops
    #[arg(long, help_heading = "Result")]
    pub quiet: bool,
}

//! The options of `dapple count` and `dapple sample`.

use super::RuleArgs;
use crate::cli::{duration, memory};
use clap::Args;
use std::path::PathBuf;
use std::time::Duration;

/// Tilings to count.
#[derive(Debug, Clone, Args)]
pub struct DappleCountArgs {
    /// Columns and rows
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, help_heading = "Problem")]
    pub size: String,
    /// What they keep.
    #[command(flatten)]
    pub rule: RuleArgs,
    /// Cells given beforehand: text with . for free cells
    #[arg(long, value_name = "FILE", help_heading = "Problem")]
    pub given: Option<PathBuf>,
    /// Also by how often this tile occurs [without T: tile 1]
    #[arg(long, value_name = "T", num_args = 0..=1, default_missing_value = "1", help_heading = "Result")]
    pub by_number: Option<u8>,
    /// Save the count to this file while it runs; if the file is there, go on from it
    #[arg(long, value_name = "FILE", help_heading = "Search")]
    pub checkpoint: Option<PathBuf>,
    /// Time between two checkpoints
    #[arg(long, value_name = "TIME", value_parser = duration::parse, default_value = "60s", help_heading = "Search")]
    pub checkpoint_every: Duration,
    /// Stop after this time: 500ms, 90s, 10m, 2h, 1d; a number alone is in seconds
    #[arg(long, value_name = "TIME", value_parser = duration::parse, help_heading = "Search")]
    pub time_limit: Option<Duration>,
    /// Memory for tables; a count that needs more is refused
    #[arg(long, value_name = "SIZE", value_parser = memory::parse, default_value = "4GiB", help_heading = "Search")]
    pub memory: usize,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024), help_heading = "Search")]
    pub threads: Option<u16>,
    /// No progress and no remarks on standard error, only errors, warnings and early stops
    #[arg(long, help_heading = "Search")]
    pub quiet: bool,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// Tilings to draw.
#[derive(Debug, Clone, Args)]
pub struct DappleSampleArgs {
    /// Columns and rows
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, help_heading = "Problem")]
    pub size: String,
    /// What they keep.
    #[command(flatten)]
    pub rule: RuleArgs,
    /// Cells given beforehand: text with . for free cells
    #[arg(long, value_name = "FILE", help_heading = "Problem")]
    pub given: Option<PathBuf>,
    /// Seed of the random numbers
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = "Search")]
    pub seed: u64,
    /// How many tilings, each independent of the others
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..), help_heading = "Search")]
    pub number: u32,
    /// Memory for tables; what needs more is refused
    #[arg(long, value_name = "SIZE", value_parser = memory::parse, default_value = "4GiB", help_heading = "Search")]
    pub memory: usize,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024), help_heading = "Search")]
    pub threads: Option<u16>,
    /// Write to this file instead of standard output; NAME.png is a picture with a texel a cell
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

//! The options of `dapple decide`.

use super::RuleArgs;
use crate::cli::duration;
use clap::{ArgGroup, Args};
use std::path::PathBuf;
use std::time::Duration;

/// A partial tiling to complete.
#[derive(Debug, Clone, Args)]
#[command(group = ArgGroup::new("cells").required(true).args(["file", "size"]))]
pub struct DappleDecideArgs {
    /// The cells that are given, as text or PNG, . for a free one; - is standard input, as text
    #[arg(value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// A rectangle without given cells, instead of a file
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, help_heading = "Problem")]
    pub size: Option<String>,
    /// What it keeps.
    #[command(flatten)]
    pub rule: RuleArgs,
    /// Only tilings with exactly N of tile T
    #[arg(long, value_name = "T=N", help_heading = "Problem")]
    pub count: Option<String>,
    /// Tell which numbers of tile T there can be
    #[arg(long, value_name = "T", help_heading = "Problem", conflicts_with_all = ["count", "output"])]
    pub counts: Option<u8>,
    /// Chooses among completions
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = "Search")]
    pub seed: u64,
    /// Stop after this time: 500ms, 90s, 10m, 2h, 1d; a number alone is in seconds
    #[arg(long, value_name = "TIME", value_parser = duration::parse, help_heading = "Search")]
    pub time_limit: Option<Duration>,
    /// Write the completion to this file: PNG by its name, else text
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// If there is no completion, write a proof of that in the format DRAT
    #[arg(long, value_name = "FILE", help_heading = "Result", conflicts_with_all = ["count", "counts"])]
    pub proof: Option<PathBuf>,
    /// The formula that the proof is about, in the format DIMACS
    #[arg(long, value_name = "FILE", help_heading = "Result", requires = "proof")]
    pub formula: Option<PathBuf>,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
    /// No remarks on standard error, only errors, warnings and early stops
    #[arg(long, help_heading = "Result")]
    pub quiet: bool,
}

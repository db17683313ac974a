//! The options of `dapple make`.

use super::super::super::duration;
use super::RuleArgs;
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use std::time::Duration;

/// A tiling to make.
#[derive(Debug, Clone, Args)]
pub struct DappleMakeArgs {
    /// What it keeps.
    #[command(flatten)]
    pub rule: RuleArgs,
    /// Width and height [default: those of --from]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, help_heading = "Problem")]
    pub size: Option<String>,
    /// Change this field as little as the algorithm does: text or PNG, a level of gray for each
    /// tile; - is standard input, as text
    #[arg(long, value_name = "FILE", help_heading = "Problem")]
    pub from: Option<PathBuf>,
    /// What cells without a tile begin with
    #[arg(long, value_enum, default_value_t = StartArg::Random, help_heading = "Search")]
    pub start: StartArg,
    /// Seed of random choices
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = "Search")]
    pub seed: u64,
    /// In which order cells are looked at; for two tiles results differ
    #[arg(long, value_enum, default_value_t = OrderArg::Diagonal, help_heading = "Search")]
    pub order: OrderArg,
    /// Threads of --order wavefront; the result does not depend on them [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024), help_heading = "Search")]
    pub threads: Option<u16>,
    /// Stop after this time: 500ms, 90s, 10m, 2h, 1d; a number alone is in seconds
    #[arg(long, value_name = "TIME", value_parser = duration::parse, help_heading = "Search")]
    pub time_limit: Option<Duration>,
    /// No remarks on standard error, only errors
    #[arg(long, help_heading = "Search")]
    pub quiet: bool,
    /// Write the tiling to this file, as PNG if its name ends so, else as text
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// What a tiling is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum StartArg {
    /// Random tiles, all alike
    Random,
    /// Tile 0
    Empty,
}

/// The order of cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum OrderArg {
    /// Anti-diagonals, each from west to east, as in the paper
    Diagonal,
    /// Anti-diagonals, in each first even columns, then odd ones: on several threads
    Wavefront,
}

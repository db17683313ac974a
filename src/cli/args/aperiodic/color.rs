//! The options of `aperiodic color`.

use super::super::super::duration;
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use std::time::Duration;

/// How vertices are colored.
#[derive(Debug, Clone, Args)]
pub struct ColorArgs {
    /// The Wang tiles: jeandel-rao, or a tile set file
    #[arg(value_name = "BASE")]
    pub base: PathBuf,
    /// Rows and columns of tiles around a vertex that its color may depend on
    #[arg(long, value_name = "RxC", default_value = "4x2")]
    pub window: String,
    /// How the corner tiles give back the Wang tiles
    #[arg(long, value_enum, default_value_t = ConditionArg::Radius1)]
    pub condition: ConditionArg,
    /// The most colors
    #[arg(long, value_name = "MAX", default_value_t = 6, value_parser = clap::value_parser!(u8).range(2..=8))]
    pub colors: u8,
    /// Columns and rows of the patch that shows the windows of a set from a file
    #[arg(long, value_name = "WxH", default_value = "60x60")]
    pub patch: String,
    /// Rounds of annealing [default: 100 without --time-limit]
    #[arg(long, value_name = "N", help_heading = "Search")]
    pub rounds: Option<u64>,
    /// Moves of a round
    #[arg(long, value_name = "N", default_value_t = 1 << 20, help_heading = "Search")]
    pub moves: u64,
    /// Stop at the first round that ends with so few corner tiles
    #[arg(long, value_name = "TILES", default_value_t = 0, help_heading = "Search")]
    pub target: usize,
    /// Seed of random choices
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = "Search")]
    pub seed: u64,
    /// Stop after this time: 500ms, 90s, 10m, 2h, 1d; a number alone is in seconds
    #[arg(long, value_name = "TIME", value_parser = duration::parse, help_heading = "Search")]
    pub time_limit: Option<Duration>,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    #[arg(help_heading = "Search")]
    pub threads: Option<u16>,
    /// No progress and no remarks on standard error, only errors
    #[arg(long, help_heading = "Search")]
    pub quiet: bool,
    /// Write the certificate to this file
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// Write the corner tiles to this tile set file
    #[arg(long, value_name = "FILE", help_heading = "Result")]
    pub set_out: Option<PathBuf>,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// Conditions that keep a set of corner tiles aperiodic.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ConditionArg {
    /// The two colors of a side say its label
    Pair,
    /// A tile and its four neighbors say the Wang tile
    Radius1,
    /// The tiles up to two steps away say it
    Radius2,
}

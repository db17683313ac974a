//! The options of `aperiodic decide` and `aperiodic classify`.

use super::super::super::duration;
use crate::tiles::Kind;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use std::time::Duration;

/// A set to decide.
#[derive(Debug, Clone, Args)]
pub struct DecideArgs {
    /// Tile set file, Wang or corner tiles; - is standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The highest power (strips of so many rows and columns), and the largest square
    #[arg(long, value_name = "K", default_value_t = 40, value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub limit: u16,
    /// Stop after this time: 500ms, 90s, 10m, 2h, 1d; a number alone is in seconds
    #[arg(long, value_name = "TIME", value_parser = duration::parse)]
    pub time_limit: Option<Duration>,
    /// Write what proves the verdict to this file (JSON), for verify
    #[arg(long, value_name = "FILE", help_heading = "Result")]
    pub certificate: Option<PathBuf>,
    /// No remarks on standard error, only errors
    #[arg(long, help_heading = "Result")]
    pub quiet: bool,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// Sets to classify.
#[derive(Debug, Clone, Args)]
pub struct ClassifyArgs {
    /// Wang or corner tiles
    #[arg(long, value_name = "KIND", value_parser = PossibleValuesParser::new(["wang", "corner"]).try_map(|name| name.parse::<Kind>()))]
    pub kind: Option<Kind>,
    /// Tiles of a set; of corner tiles at most so many
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=81))]
    pub tiles: Option<u8>,
    /// Colors of corner tiles
    #[arg(long, value_name = "C", value_parser = clap::value_parser!(u8).range(2..=3))]
    pub colors: Option<u8>,
    /// Which sets of Wang tiles are the same, besides those with other names of labels
    #[arg(long, value_enum, default_value = "graphs", value_name = "WHAT")]
    pub up_to: UpToArg,
    /// The highest power of a set
    #[arg(long, value_name = "K", default_value_t = 40, value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub limit: u16,
    /// Only part R of M, counted from 0: parts can be added with --merge
    #[arg(long, value_name = "R/M")]
    pub part: Option<String>,
    /// Add the results of parts, each written with --json
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with_all = ["kind", "tiles", "colors", "part"])]
    pub merge: Vec<PathBuf>,
    /// Stop after this time: 500ms, 90s, 10m, 2h, 1d; a number alone is in seconds
    #[arg(long, value_name = "TIME", value_parser = duration::parse)]
    pub time_limit: Option<Duration>,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Write the JSON object to this file instead
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// No progress on standard error
    #[arg(long, help_heading = "Result")]
    pub quiet: bool,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// Which sets of Wang tiles count as one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum UpToArg {
    /// A set and its transpose, unless both graphs of labels are the same
    Graphs,
    /// A set and its transpose
    Transposition,
    /// Sets that differ by one of the eight symmetries of the square
    Square,
}

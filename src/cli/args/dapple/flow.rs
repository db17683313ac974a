//! The options of `dapple flow`.

use clap::Args;
use std::path::PathBuf;

/// Streams through a tiling.
#[derive(Debug, Clone, Args)]
pub struct DappleFlowArgs {
    /// A tiling by two tiles, as text or PNG; - is standard input, as text
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Opposite edges meet, east and west as well as north and south
    #[arg(long, help_heading = "Problem")]
    pub cyclic: bool,
    /// East and west edges meet, north and south are free
    #[arg(long, conflicts_with = "cyclic", help_heading = "Problem")]
    pub cylinder: bool,
    /// The picture, by its name: svg, png, or html, where particles follow the streams
    #[arg(short, long, value_name = "FILE", required = true, help_heading = "Result")]
    pub output: PathBuf,
    /// Pixels of a cell
    #[arg(long, value_name = "N", default_value_t = 24, value_parser = clap::value_parser!(u32).range(4..=256), help_heading = "Result")]
    pub cell_size: u32,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
    /// No remarks on standard error, only errors, warnings and early stops
    #[arg(long, help_heading = "Result")]
    pub quiet: bool,
}

//! The options of `dapple draw`.

use clap::Args;
use std::path::PathBuf;

/// A tiling to look at.
#[derive(Debug, Clone, Args)]
pub struct DappleDrawArgs {
    /// Text or PNG, a level of gray for each tile; - is standard input, as text
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// How many different tiles there are
    #[arg(long, value_name = "K", default_value_t = 2, value_parser = clap::value_parser!(u8).range(1..=64), help_heading = "Problem")]
    pub tiles: u8,
    /// Put a dot on every cell that differs from this tiling
    #[arg(long, value_name = "FILE", help_heading = "Problem")]
    pub against: Option<PathBuf>,
    /// The picture: svg or png, by its name
    #[arg(short, long, value_name = "FILE", required = true, help_heading = "Result")]
    pub output: PathBuf,
    /// Pixels of a cell
    #[arg(long, value_name = "N", default_value_t = 8, value_parser = clap::value_parser!(u32).range(1..=256), help_heading = "Result")]
    pub cell_size: u32,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

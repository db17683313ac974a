//! The options that all commands about dappled tilings share, and those of `dapple check`.

use clap::Args;
use std::path::PathBuf;

/// What the tiling keeps.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Problem")]
pub struct RuleArgs {
    /// How many different tiles there are
    #[arg(long, value_name = "K", default_value_t = 2, value_parser = clap::value_parser!(u8).range(1..=64))]
    pub tiles: u8,
    /// How many may repeat in a row and in a column: H,V for every tile, T:H,V for tile T,
    /// T+U:H,V for several taken together; a number from 1, inf, or @FILE for a limit of each cell
    #[arg(long, value_name = "LIMITS", default_value = "2,2")]
    pub limits: Vec<String>,
    /// Opposite edges meet, east and west as well as north and south
    #[arg(long)]
    pub cyclic: bool,
    /// East and west edges meet, north and south are free
    #[arg(long, conflicts_with = "cyclic")]
    pub cylinder: bool,
}

/// A tiling to check.
#[derive(Debug, Clone, Args)]
pub struct DappleCheckArgs {
    /// Text or PNG, a level of gray for each tile; - is standard input, as text
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What it keeps.
    #[command(flatten)]
    pub rule: RuleArgs,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

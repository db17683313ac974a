//! The options of `aperiodic convert`, `tables`, `sets` and `patch`.

use crate::aperiodic::convert::Method;
use clap::Args;
use std::path::PathBuf;
use std::time::Duration;

use super::super::super::duration;

/// A set to convert.
#[derive(Debug, Clone, Args)]
pub struct ConvertArgs {
    /// Tile set file, or the name of a published set (see aperiodic sets); - is standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// diagonal, horizontal, vertical, rotation or subdivision of Wang tiles, or to-wang of corner
    /// tiles
    #[arg(long, value_name = "METHOD")]
    pub method: Method,
    /// How often; in between the corner tiles become Wang tiles
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=16))]
    pub repeat: u8,
    /// Write the tiles to this file
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// The tables of conversions.
#[derive(Debug, Clone, Args)]
pub struct TablesArgs {
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// The sets that are known.
#[derive(Debug, Clone, Args)]
pub struct SetsArgs {
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// A rectangle to fill.
#[derive(Debug, Clone, Args)]
pub struct PatchArgs {
    /// Tile set file, or the name of a published set (see aperiodic sets); - is standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Width and height in tiles [default: 32x32, or the smallest torus]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    pub size: Option<String>,
    /// A patch that fits itself at opposite sides; for sets that have periodic tilings
    #[arg(long)]
    pub torus: bool,
    /// Seed of random choices
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    /// Stop after this time: 500ms, 90s, 10m, 2h, 1d; a number alone is in seconds
    #[arg(long, value_name = "TIME", value_parser = duration::parse)]
    pub time_limit: Option<Duration>,
    /// Write to this file: .svg and .png are pictures, .json tells more, else rows of tile numbers
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// Texels of a tile's side in pictures
    #[arg(long, value_name = "TEXELS", default_value_t = 16, value_parser = clap::value_parser!(u32).range(1..=1024), help_heading = "Result")]
    pub tile_size: u32,
    /// No remarks on standard error
    #[arg(long, help_heading = "Result")]
    pub quiet: bool,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

//! The options of `fill`.

use super::super::duration;
use super::SetArgs;
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use std::time::Duration;

/// Tile images from examples.
#[derive(Debug, Clone, Args)]
pub struct FillArgs {
    /// Pictures of what the tiles shall show
    #[arg(value_name = "EXAMPLE.png", required_unless_present = "example")]
    pub examples: Vec<PathBuf>,
    /// A map of the same size as its example (normals, heights), cut along with it; of several
    /// examples one each, with commas; its samples are proportional to light. Once for each map
    #[arg(long, value_name = "FILE,...")]
    pub map: Vec<String>,
    /// What opacity does to the samples of colors
    #[arg(long, value_name = "HOW")]
    pub alpha: Option<AlphaArg>,
    /// The samples of the examples are proportional to light, too, not sRGB
    #[arg(long)]
    pub linear: bool,
    /// Draw an example instead: stone, grass, bricks, leaves; with -height or -normal its map
    #[arg(long, value_name = "NAME", conflicts_with = "examples")]
    pub example: Option<String>,
    /// Texels of the example that is drawn
    #[arg(long, value_name = "WxH", default_value = "256x256")]
    pub size: String,
    /// The tiles.
    #[command(flatten)]
    pub set: SetArgs,
    /// Take the tiles of this packing; a sheet then shows them where it has them
    #[arg(long, value_name = "FILE", help_heading = "Problem")]
    pub packing: Option<PathBuf>,
    /// Texels of a tile's side; even
    #[arg(long, value_name = "TEXELS", default_value_t = 64, help_heading = "Tiles")]
    pub tile_size: usize,
    /// Texels along each side of a tile that depend on the colors of that side alone [default: 4,
    /// or a quarter of small tiles]
    #[arg(long, value_name = "TEXELS", help_heading = "Tiles")]
    pub strip: Option<usize>,
    /// How tiles are put together [default: ng for corner tiles, cohen for Wang tiles]
    #[arg(long, value_name = "METHOD", help_heading = "Tiles")]
    pub method: Option<FillMethod>,
    /// Choices of patches that are tried
    #[arg(long, value_name = "N", default_value_t = 32, help_heading = "Search")]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub candidates: u32,
    /// Patches that are tried for the middle of each tile
    #[arg(long, value_name = "N", default_value_t = 6, help_heading = "Search")]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=48))]
    pub tries: u32,
    /// Seed of random choices
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = "Search")]
    pub seed: u64,
    /// Try no more after this time, and take the best so far: 500ms, 90s, 10m, 2h, 1d; a number
    /// alone is in seconds
    #[arg(long, value_name = "TIME", value_parser = duration::parse, help_heading = "Search")]
    pub time_limit: Option<Duration>,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    #[arg(help_heading = "Search")]
    pub threads: Option<u16>,
    /// No progress and no remarks on standard error, only errors and early stops
    #[arg(long, help_heading = "Result")]
    pub quiet: bool,
    /// Write a sheet (OUT.png), or a new folder with a PNG for each tile
    #[arg(short, long, value_name = "OUT", help_heading = "Result")]
    pub output: PathBuf,
    /// Write how good the tiles are to this file (JSON)
    #[arg(long, value_name = "FILE.json", help_heading = "Result")]
    pub report: Option<PathBuf>,
    /// Compare with one periodic tile, and with image quilting at full size
    #[arg(long, help_heading = "Result")]
    pub baselines: bool,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// Ways to put tiles together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum FillMethod {
    /// Wang tiles of diamonds (Cohen et al. 2003)
    Cohen,
    /// The middle of each tile covered along the cheapest cut (Ng et al. 2005)
    Ng,
    /// The middle covered along four staircases (Schlömer 2012)
    Schlomer,
}

/// What opacity does to colors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum AlphaArg {
    /// Colors are not yet multiplied by opacity
    Straight,
    /// Colors are already multiplied by opacity
    Premultiplied,
}

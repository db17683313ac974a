//! The options of `brick`.

use clap::Args;
use std::path::PathBuf;

/// A brick wall.
#[derive(Debug, Clone, Args)]
pub struct BrickArgs {
    /// Width and height, in tiles
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, help_heading = "Problem")]
    pub size: Option<String>,
    /// How many positions joints have on the edges of tiles
    #[arg(long, value_name = "C", default_value_t = 5, value_parser = clap::value_parser!(u8).range(2..=64), help_heading = "Problem")]
    pub positions: u8,
    /// How many tiles a joint goes through at most, in a row and in a column: numbers from 1, or
    /// inf [default: 2,2; inf,inf for regions]
    #[arg(long, value_name = "P,Q", conflicts_with_all = ["labels", "region"], help_heading = "Problem")]
    pub limits: Option<String>,
    /// Which tiles a joint goes through from west to east (0) and from north to south (1): text or
    /// PNG, as of dapple make
    #[arg(long, value_name = "FILE", help_heading = "Problem")]
    pub labels: Option<PathBuf>,
    /// A region instead of a rectangle, a line for each row: . is outside, # a tile
    #[arg(long, value_name = "FILE", conflicts_with_all = ["labels", "size"], help_heading = "Problem")]
    pub region: Option<PathBuf>,
    /// Positions on the boundary, in lines: SIDE POSITION... or ROW COLUMN SIDE POSITION; . is free
    #[arg(long, value_name = "FILE", help_heading = "Problem")]
    pub boundary: Option<PathBuf>,
    /// Opposite edges meet: a wall that repeats
    #[arg(long, conflicts_with_all = ["region", "boundary"], help_heading = "Problem")]
    pub cyclic: bool,
    /// Seed of random choices
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = "Search")]
    pub seed: u64,
    /// No remarks on standard error, only errors
    #[arg(long, help_heading = "Search")]
    pub quiet: bool,
    /// Count the walls instead: of all labels, or of those of --labels
    #[arg(long, conflicts_with_all = ["region", "limits", "output"], help_heading = "Result")]
    pub count: bool,
    /// Write the wall to this file: a picture (.svg or .png), or the numbers of its tiles as text;
    /// those of a wall that repeats as a covering by the tiles that occur (.json, else text)
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// Texels to a tile, in pictures
    #[arg(long, value_name = "N", default_value_t = 64, value_parser = clap::value_parser!(u16).range(8..=512), help_heading = "Result")]
    pub tile_size: u16,
    /// Write the set of all brick Wang tiles over these positions
    #[arg(long, value_name = "FILE", help_heading = "Result")]
    pub set_out: Option<PathBuf>,
    /// Draw all brick Wang tiles: to a folder, a picture for each, as atlas --fill reads it, or to
    /// one sheet (.png) in the order of the set
    #[arg(long, value_name = "DIR|SHEET", help_heading = "Result")]
    pub tiles_out: Option<PathBuf>,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

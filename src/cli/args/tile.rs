//! The options of `tile`.

use super::{ClaimArgs, ColoringArg};
use clap::Args;
use std::path::PathBuf;

/// Places of an endless tiling.
#[derive(Debug, Clone, Args)]
pub struct TileArgs {
    /// Tiles to the east of the origin
    #[arg(value_name = "X", allow_negative_numbers = true)]
    pub x: i64,
    /// Tiles to the north of the origin
    #[arg(value_name = "Y", allow_negative_numbers = true)]
    pub y: i64,
    /// All tiles of a window, of which X and Y are the south-west one
    #[arg(long, value_name = "WxH", help_heading = "Problem")]
    pub size: Option<String>,
    /// What gives the tiling its colors: hash, scanline (tile after tile), compact (direct, of a
    /// compact set), diagonal, two-hash (Wang tiles), halton:WxH (colors that keep apart, for a
    /// grid of W x H tiles, then repeated), table, long-period (permutations),
    /// probabilities:FILE, or map:FILE (the tiling of this file, repeated)
    #[arg(long, value_name = "COLORING", default_value = "hash", help_heading = "Problem")]
    pub coloring: ColoringArg,
    /// Which tiling, where --coloring is random: 0 to 4294967295
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = "Problem")]
    pub seed: u32,
    /// Look the tiles up in this packing
    #[arg(long, value_name = "FILE", help_heading = "Problem")]
    pub packing: Option<PathBuf>,
    /// The tiles; a packing or a map knows them.
    #[command(flatten)]
    pub claim: ClaimArgs,
    /// Write the tiles that can occur to this file, as a tile set for find --set
    #[arg(long, value_name = "FILE", help_heading = "Result")]
    pub set_out: Option<PathBuf>,
    /// Count the window of --size instead of listing it
    #[arg(long, requires = "size", help_heading = "Result")]
    pub stats: bool,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

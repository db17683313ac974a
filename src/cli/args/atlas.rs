//! The options of the commands that make and check atlases.

use super::ClaimArgs;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// A packing as a texture.
#[derive(Debug, Clone, Args)]
pub struct AtlasArgs {
    /// File with a packing on a torus; - is standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What the file does not say itself.
    #[command(flatten)]
    pub claim: ClaimArgs,
    /// Write the atlas to this file
    #[arg(short, long, value_name = "OUT.png", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// Write the mip levels beside it, too: OUT.1.png, OUT.2.png, ... to one texel a tile
    #[arg(long, requires = "output", help_heading = "Result")]
    pub mips: bool,
    /// Write tables from tiles to cells and back to this folder: JSON, CSV, C, PNG
    #[arg(long, value_name = "DIR", help_heading = "Result")]
    pub tables: Option<PathBuf>,
    /// Write a page that draws endless tilings, shows repeats, and what filtering does
    #[arg(long, value_name = "OUT.html", help_heading = "Result")]
    pub html: Option<PathBuf>,
    /// Find out through which level filtering the atlas is filtering the tiling, exactly
    #[arg(long, help_heading = "Result")]
    pub check: bool,
    /// What the tiles show
    #[command(flatten)]
    pub tiles: TilePictureArgs,
    /// Tiles where the packing has them, or by number as in most sheets
    #[arg(long, value_name = "ORDER", default_value = "packed", help_heading = "Layout")]
    pub arrange: ArrangeArg,
    /// Texels around each tile, for engines that cut tiles out of the atlas
    #[arg(long, value_name = "TEXELS", default_value_t = 0, help_heading = "Layout")]
    pub gutter: usize,
    /// What gutters show: the neighbors in the packing, or the border texels again
    #[arg(long, value_name = "WHAT", default_value = "neighbor", help_heading = "Layout")]
    pub gutter_fill: GutterArg,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// No remarks on standard error
    #[arg(long, help_heading = "Result")]
    pub quiet: bool,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// What tiles show.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Tiles")]
pub struct TilePictureArgs {
    /// marks (the colors, plainly), noise (random but for the strip), truchet (curves that go
    /// on), a folder of PNGs named by tile number or colors (0-1-1-0.png), or a sheet (PNG)
    #[arg(long, value_name = "FILL", default_value = "marks")]
    pub fill: PathBuf,
    /// Which tiles the sheet shows, row by row: a tile set file or a packing
    #[arg(long, value_name = "FILE")]
    pub sheet: Option<PathBuf>,
    /// Texels of a tile's side [default: 64, or that of the pictures]
    #[arg(long, value_name = "TEXELS")]
    pub tile_size: Option<usize>,
    /// Texels along each side of a tile in which the picture depends on the colors of that side
    /// alone [default: 4, or a quarter of small tiles]; pictures from files are checked, 0 is
    /// no promise
    #[arg(long, value_name = "TEXELS")]
    pub strip: Option<usize>,
    /// Seed of what is random in the pictures
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    /// Samples of a texel
    #[arg(long, value_name = "SAMPLES", default_value = "rgba")]
    pub channels: ChannelsArg,
    /// Bits of a sample
    #[arg(long, value_name = "BITS", default_value_t = 8, value_parser = clap::value_parser!(u8).range(8..=16))]
    pub depth: u8,
    /// Samples are proportional to light (normals, heights), not sRGB
    #[arg(long)]
    pub linear: bool,
}

/// Samples of a texel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ChannelsArg {
    /// Brightness
    Gray,
    /// Brightness and opacity
    GrayAlpha,
    /// Red, green, blue
    Rgb,
    /// Red, green, blue, opacity
    Rgba,
}

/// The order of tiles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ArrangeArg {
    /// As in the packing: what can be filtered
    Packed,
    /// By tile number
    ByNumber,
}

/// What gutters show.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum GutterArg {
    /// The neighbors in the packing
    Neighbor,
    /// The border texels again and again
    Clamp,
}

/// A sheet of tiles that somebody made.
#[derive(Debug, Clone, Args)]
pub struct LintArgs {
    /// The sheet, a PNG
    #[arg(value_name = "IMAGE")]
    pub image: PathBuf,
    /// Which tiles it shows, row by row: a tile set file or a packing
    #[arg(long, value_name = "FILE")]
    pub tiles: PathBuf,
    /// Tiles of a row [default: that of the packing, or what makes the tiles square]
    #[arg(long, value_name = "N")]
    pub columns: Option<usize>,
    /// Texels around each tile that belong to no tile
    #[arg(long, value_name = "TEXELS", default_value_t = 0)]
    pub gutter: usize,
    /// Texels along each side in which tiles with the same colors there must agree; 0: look at
    /// the seams only
    #[arg(long, value_name = "TEXELS", default_value_t = 1)]
    pub strip: usize,
    /// Differences up to this many 1/255 are none
    #[arg(long, value_name = "N", default_value_t = 0.0)]
    pub tolerance: f64,
    /// The sheet should have every tile over its colors
    #[arg(long)]
    pub complete: bool,
    /// Find out, too, how far filtering in the sheet is off
    #[arg(long)]
    pub filter: bool,
    /// Write a picture of what is off
    #[arg(long, value_name = "OUT.png", help_heading = "Result")]
    pub heat: Option<PathBuf>,
    /// Write a table of every pair of tiles that may lie side by side
    #[arg(long, value_name = "OUT.csv", help_heading = "Result")]
    pub seams: Option<PathBuf>,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

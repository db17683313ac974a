//! The options of `cube`.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// A packing of cubes.
#[derive(Debug, Clone, Args)]
pub struct CubeArgs {
    /// What carries the colors
    #[arg(long, value_enum, value_name = "KIND", help_heading = "Problem")]
    pub kind: CubeKindArg,
    /// Number of colors C; for Wang cubes also CH,CV,CZ: those of the north and south faces, of
    /// the east and west faces, of the bottom and top faces
    #[arg(long, value_name = "C", help_heading = "Problem")]
    pub colors: String,
    /// Width, height and depth of the torus [default: C^2 x C^2 x C^4 for corner cubes, CV^2 x
    /// CH^2 x CZ^2 for Wang cubes]
    #[arg(long, value_name = "WxHxD", help_heading = "Problem")]
    pub size: Option<String>,
    /// Which member of the family; 0 is the closed form itself
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = "Problem")]
    pub seed: u64,
    /// No remarks on standard error
    #[arg(long, help_heading = "Result")]
    pub quiet: bool,
    /// Write the packing to this file instead of standard output
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// Kinds of cubes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum CubeKindArg {
    /// A color on each of eight corners
    Corner,
    /// A color on each of six faces
    Wang,
}

//! How an endless tiling gets its colors and finds its tiles: options of `tile`, and of `export` to
//! the languages of shaders.

use clap::{Args, ValueEnum};
use std::path::PathBuf;
use std::str::FromStr;

/// A shader.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Shader")]
pub struct ShaderArgs {
    /// What gives the tiling its colors: hash, halton:WxH (colors that keep apart, for a grid of
    /// W x H tiles, then repeated), or map:FILE (the tiling of this file, repeated) [default: hash]
    #[arg(long, value_name = "COLORING")]
    pub coloring: Option<ColoringArg>,
    /// How tiles are looked up in the atlas [default: table]
    #[arg(long, value_enum)]
    pub lookup: Option<Lookup>,
    /// What the names of all functions begin with [default: tilepack]
    #[arg(long, value_name = "PREFIX")]
    pub name: Option<String>,
}

/// What gives an endless tiling its colors.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ColoringArg {
    /// A hash of the place.
    Hash,
    /// The Halton sequence, over a grid of this size, still as text.
    Halton(String),
    /// The tiling of a file.
    Map(PathBuf),
}

impl FromStr for ColoringArg {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.split_once(':') {
            None if text == "hash" => Ok(ColoringArg::Hash),
            Some(("halton", size)) if !size.is_empty() => Ok(ColoringArg::Halton(size.to_owned())),
            Some(("map", file)) if !file.is_empty() => Ok(ColoringArg::Map(file.into())),
            _ => Err("expected hash, halton:WxH or map:FILE".to_owned()),
        }
    }
}

/// How tiles are looked up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Lookup {
    /// In a texture with the cell of every tile; for any packing
    Table,
    /// In closed form; for the constructed packings of complete sets
    Formula,
}

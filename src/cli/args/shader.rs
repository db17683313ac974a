//! How an endless tiling gets its colors and finds its tiles: options of `tile`, and of `export` to
//! the languages of shaders.

use clap::{Args, ValueEnum};
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

/// A shader.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Shader")]
pub struct ShaderArgs {
    /// What gives the tiling its colors: hash, compact, diagonal, two-hash, halton:WxH, table,
    /// long-period, probabilities:FILE, or map:FILE [default: hash]
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
    /// Tile after tile.
    Scanline,
    /// The direct tiling of a compact set.
    Compact,
    /// That of a diagonal set.
    Diagonal,
    /// Wang tiles by two hashes of their corners.
    TwoHash,
    /// A table of a permutation.
    Table,
    /// Seven of them.
    LongPeriod,
    /// A map of probabilities, and the points of its cells, still as text.
    Probabilities(Option<String>, PathBuf),
}

impl ColoringArg {
    /// Whether a seed chooses among tilings.
    pub fn is_random(&self) -> bool {
        !matches!(self, Self::Halton(_) | Self::Map(_))
    }
}

impl fmt::Display for ColoringArg {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Hash => f.write_str("hash"),
            Self::Halton(size) => write!(f, "halton:{size}"),
            Self::Map(file) => write!(f, "map:{}", file.display()),
            Self::Scanline => f.write_str("scanline"),
            Self::Compact => f.write_str("compact"),
            Self::Diagonal => f.write_str("diagonal"),
            Self::TwoHash => f.write_str("two-hash"),
            Self::Table => f.write_str("table"),
            Self::LongPeriod => f.write_str("long-period"),
            Self::Probabilities(Some(scale), file) => {
                write!(f, "probabilities:{scale}:{}", file.display())
            }
            Self::Probabilities(None, file) => write!(f, "probabilities:{}", file.display()),
        }
    }
}

impl FromStr for ColoringArg {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.split_once(':') {
            None => match text {
                "hash" => Ok(Self::Hash),
                "scanline" => Ok(Self::Scanline),
                "compact" => Ok(Self::Compact),
                "diagonal" => Ok(Self::Diagonal),
                "two-hash" => Ok(Self::TwoHash),
                "table" => Ok(Self::Table),
                "long-period" => Ok(Self::LongPeriod),
                _ => Err(EXPECTED.to_owned()),
            },
            Some(("halton", size)) if !size.is_empty() => Ok(Self::Halton(size.to_owned())),
            Some(("map", file)) if !file.is_empty() => Ok(Self::Map(file.into())),
            Some(("probabilities", rest)) if !rest.is_empty() => {
                // A file may have any name, but a size is nothing else.
                let size = |text: &str| {
                    text.split_once('x').is_some_and(|(w, h)| {
                        let digits = |side: &str| side.bytes().all(|byte| byte.is_ascii_digit());
                        !w.is_empty() && !h.is_empty() && digits(w) && digits(h)
                    })
                };
                Ok(match rest.split_once(':') {
                    Some((scale, file)) if size(scale) && !file.is_empty() => {
                        Self::Probabilities(Some(scale.to_owned()), file.into())
                    }
                    _ => Self::Probabilities(None, rest.into()),
                })
            }
            _ => Err(EXPECTED.to_owned()),
        }
    }
}

/// What a coloring is.
const EXPECTED: &str = "expected hash, halton:WxH or map:FILE; scanline, compact, diagonal, \
                        two-hash, table, long-period, probabilities:FILE or \
                        probabilities:WxH:FILE";

/// How tiles are looked up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Lookup {
    /// In a texture with the cell of every tile; for any packing
    Table,
    /// In closed form; for the constructed packings of complete sets
    Formula,
}

//! The options of the commands that write packings for other programs, and read their tile sets.

use super::{ClaimArgs, ShaderArgs};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// A packing for another program.
#[derive(Debug, Clone, Args)]
pub struct ExportArgs {
    /// File with a packing; - is standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The format
    #[arg(long, value_name = "FORMAT", help_heading = "Result")]
    pub to: To,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// The picture of the packing, as the file is to name it; for ktx2 and dds the PNG file that is
    /// read [default: the name of the result with .png]
    #[arg(long, value_name = "NAME", help_heading = "Picture")]
    pub image: Option<String>,
    /// For maps: the tile set, as the file is to name it [default: the name of the result with .tsx]
    #[arg(long, value_name = "NAME", help_heading = "Picture")]
    pub tileset: Option<String>,
    /// Side of a tile: texels (default 64), for puzzle-svg millimeters (default 40)
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=16384), help_heading = "Picture")]
    pub tile_size: Option<u32>,
    /// Texels around all tiles of the picture [default: 0]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=16384), help_heading = "Picture")]
    pub margin: Option<u32>,
    /// Texels between two tiles of the picture [default: 0]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=16384), help_heading = "Picture")]
    pub spacing: Option<u32>,
    /// For ktx2 and dds: the samples are proportional to light (normals, heights), not sRGB
    #[arg(long, help_heading = "Picture")]
    pub linear: bool,
    /// Write the number of every tile into it
    #[arg(long, help_heading = "Picture")]
    pub indices: bool,
    /// Width and height of the tiling that a map, model or demo shows, in tiles [default: 16x16]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, help_heading = "Tiling")]
    pub size: Option<String>,
    /// Seed of that tiling [default: 0]
    #[arg(long, value_name = "N", help_heading = "Tiling")]
    pub seed: Option<u64>,
    /// What the file does not say itself.
    #[command(flatten)]
    pub claim: ClaimArgs,
    /// What a shader draws.
    #[command(flatten)]
    pub shader: ShaderArgs,
    /// No remarks on standard error
    #[arg(long, help_heading = "Result")]
    pub quiet: bool,
    /// One JSON object on standard output; it needs -o
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// Formats of other programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum To {
    /// A picture of the packing with its colors, as SVG; around it the other side of the torus
    PreviewSvg,
    /// The same as PNG
    PreviewPng,
    /// Every tile once, by number, as SVG
    ContactSheet,
    /// A piece of a tiling, as SVG
    DemoSvg,
    /// The same as PNG
    DemoPng,
    /// Jigsaw pieces for a laser cutter, as SVG in millimeters
    PuzzleSvg,
    /// A tile set for Tiled, in XML
    TiledTsx,
    /// A tile set for Tiled, in JSON
    TiledTsj,
    /// A map for Tiled: a piece of a tiling
    TiledTmx,
    /// A TileSet for Godot 4
    GodotTres,
    /// Frames by name, as TexturePacker writes them (JSON hash)
    TexturepackerHash,
    /// A list of frames, as TexturePacker writes it (JSON array)
    TexturepackerArray,
    /// A 3-D model: a grid of squares that shows a piece of a tiling (OBJ, with its MTL)
    Obj,
    /// The picture as KTX 2.0
    Ktx2,
    /// The picture as DirectDraw Surface
    Dds,
    /// Functions of a shader that draws an endless tiling: OpenGL
    #[value(name = "glsl-330")]
    Glsl330,
    /// The same for WebGL 2 and OpenGL ES
    #[value(name = "glsl-es-300")]
    GlslEs300,
    /// The same for Direct3D, shader model 5
    Hlsl,
    /// The same for WebGPU
    Wgsl,
}

impl To {
    /// Options, of those that only some formats know, that this one knows.
    pub fn options(self) -> &'static [&'static str] {
        match self {
            To::PreviewSvg | To::PreviewPng => &["--tile-size", "--indices"],
            To::ContactSheet | To::PuzzleSvg => &["--tile-size"],
            To::DemoSvg | To::DemoPng => &["--tile-size", "--indices", "--size", "--seed"],
            To::TiledTmx => &["--tile-size", "--tileset", "--size", "--seed"],
            To::TiledTsx
            | To::TiledTsj
            | To::GodotTres
            | To::TexturepackerHash
            | To::TexturepackerArray => &["--tile-size", "--image", "--margin", "--spacing"],
            To::Obj => &["--tile-size", "--image", "--margin", "--spacing", "--size", "--seed"],
            To::Ktx2 | To::Dds => &["--image", "--linear"],
            To::Glsl330 | To::GlslEs300 | To::Hlsl | To::Wgsl => {
                &["--coloring", "--lookup", "--seed", "--name"]
            }
        }
    }

    /// The name of the format.
    pub fn name(self) -> String {
        self.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
    }
}

impl ExportArgs {
    /// An option that was given, but that the format does not know.
    pub fn misplaced(&self) -> Option<&'static str> {
        let given = [
            (self.image.is_some(), "--image"),
            (self.tileset.is_some(), "--tileset"),
            (self.tile_size.is_some(), "--tile-size"),
            (self.margin.is_some(), "--margin"),
            (self.spacing.is_some(), "--spacing"),
            (self.linear, "--linear"),
            (self.indices, "--indices"),
            (self.size.is_some(), "--size"),
            (self.seed.is_some(), "--seed"),
            (self.shader.coloring.is_some(), "--coloring"),
            (self.shader.lookup.is_some(), "--lookup"),
            (self.shader.name.is_some(), "--name"),
        ];
        let known = self.to.options();
        given.into_iter().find(|(is, option)| *is && !known.contains(option)).map(|(_, o)| o)
    }
}

/// A tile set of Tiled.
#[derive(Debug, Clone, Args)]
pub struct ImportArgs {
    /// A tile set of Tiled (.tsx, .tsj), or a map that holds one; - is standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Write the tile set to this file instead of standard output
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// The wangset (in Tiled: terrain set) to take; needed when there are several
    #[arg(long, value_name = "NAME", help_heading = "Tiles")]
    pub wangset: Option<String>,
    /// Of tiles with the same colors keep the first
    #[arg(long, help_heading = "Tiles")]
    pub keep_first: bool,
    /// Leave out tiles some of whose colors are not set
    #[arg(long, help_heading = "Tiles")]
    pub skip_unset: bool,
    /// No remarks on standard error
    #[arg(long, help_heading = "Result")]
    pub quiet: bool,
    /// One JSON object on standard output; it needs -o
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

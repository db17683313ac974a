//! The options of the command that writes packings for other programs.

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
    /// A picture of the packing with its colors, as SVG
    PreviewSvg,
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

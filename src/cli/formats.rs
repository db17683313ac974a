//! `export`: a packing in the formats of other programs. It is checked first.

use super::args::{ExportArgs, To};
use super::exit::Exit;
use super::{export_shader, set, source};
use crate::store::read_solution;
use crate::torus::Packing;
use crate::verify;
use anyhow::bail;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &ExportArgs) -> anyhow::Result<Exit> {
    let packing = read(args)?;
    match args.to {
        To::PreviewSvg => bail!("{}: nothing is drawn yet", packing.shape),
        To::Glsl330 | To::GlslEs300 | To::Hlsl | To::Wgsl => export_shader::run(args, &packing),
    }
}

/// The packing, which must be one, on a torus.
fn read(args: &ExportArgs) -> anyhow::Result<Packing> {
    let claim = set::packing_claim(&args.claim)?;
    let input = source::open(&args.file)?;
    let packing = read_solution(&input, &claim)?.packing;
    let verdict = verify::check(&packing);
    if !verdict.is_valid() {
        bail!("{}: not a packing: {verdict}", args.file.display());
    }
    Ok(packing)
}

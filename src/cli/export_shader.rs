//! `export --to glsl-330|glsl-es-300|hlsl|wgsl`: functions of a shader that draws an endless tiling
//! from the atlas of a packing.

use super::args::{ColoringArg, ExportArgs, Lookup, To};
use super::tiling;
use crate::atlas::shader::{Language, Shader};
use crate::tiling::Cells;
use crate::torus::Packing;
use anyhow::{Context, bail};

/// The text of the shader, and what it is.
///
/// # Errors
/// Bad input: a tiling that the set does not have, a formula that is not that of the packing.
pub fn text(args: &ExportArgs, packing: &Packing) -> anyhow::Result<(String, &'static str)> {
    let language = match args.to {
        To::Glsl330 => Language::Glsl330,
        To::GlslEs300 => Language::GlslEs300,
        To::Hlsl => Language::Hlsl,
        To::Wgsl => Language::Wgsl,
        _ => bail!("not a language of shaders"),
    };
    let (kind, colors) = (packing.set.kind(), packing.set.colors());
    let options = &args.shader;
    let seed = args.seed.unwrap_or(0);
    let seed = u32::try_from(seed)
        .with_context(|| format!("--seed {seed}: expected 0 to {}", u32::MAX))?;
    let coloring = options.coloring.as_ref().unwrap_or(&ColoringArg::Hash);
    let tiling = tiling::tiling(coloring, seed, Some(kind), Some(colors))?;
    let cells = match options.lookup {
        None | Some(Lookup::Table) => Cells::table(packing),
        Some(Lookup::Formula) => Cells::formula(packing)?,
    };
    let name = options.name.as_deref().unwrap_or("tilepack");
    Ok((Shader::new(language, &tiling, &cells, name)?.text(), language.title()))
}

//! `export --to glsl-330|glsl-es-300|hlsl|wgsl`: functions of a shader that draws an endless tiling
//! from the atlas of a packing.

use super::args::{ExportArgs, Lookup, To};
use super::exit::Exit;
use super::{output, tiling};
use crate::atlas::shader::{Language, Shader};
use crate::store::{check_writable, write_file};
use crate::tiling::Cells;
use crate::torus::Packing;
use anyhow::{Context, bail};
use serde_json::json;
use std::io::Write;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &ExportArgs, packing: &Packing) -> anyhow::Result<Exit> {
    let language = match args.to {
        To::Glsl330 => Language::Glsl330,
        To::GlslEs300 => Language::GlslEs300,
        To::Hlsl => Language::Hlsl,
        To::Wgsl => Language::Wgsl,
        _ => bail!("not a language of shaders"),
    };
    if args.json && args.output.is_none() {
        bail!("--json: expected -o FILE, for standard output is taken");
    }
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    tiling::on_torus(packing).with_context(|| args.file.display().to_string())?;
    let (kind, colors) = (packing.set.kind(), packing.set.colors());
    let options = &args.shader;
    let tiling = tiling::tiling(&options.coloring, options.seed, Some(kind), Some(colors))?;
    let cells = match options.lookup {
        Lookup::Table => Cells::table(packing),
        Lookup::Formula => Cells::formula(packing)?,
    };
    let text = Shader::new(language, &tiling, &cells, &options.name)?.text();
    let Some(file) = &args.output else {
        output::result(|out| out.write_all(text.as_bytes()))?;
        return Ok(Exit::Yes);
    };
    write_file(file, |out| out.write_all(text.as_bytes()))?;
    let name = language.name();
    if args.json {
        let file = json!(file.display().to_string());
        output::object(&[("result", json!("written")), ("format", json!(name)), ("file", file)])?;
    } else if !args.quiet {
        output::remark(&format!("{}, written to {}", language.title(), file.display()));
    }
    Ok(Exit::Yes)
}

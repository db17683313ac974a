//! `dapple draw`: a tiling as a picture for people, and where it differs from another.

use super::rule;
use crate::atlas::picture::{field as picture, raster, svg};
use crate::atlas::write_png;
use crate::cli::args::DappleDrawArgs;
use crate::cli::exit::Exit;
use crate::cli::output;
use crate::store::{check_writable, write_file};
use anyhow::{bail, ensure};
use serde_json::json;

/// Cells of a picture at most.
const MAX_CELLS: usize = 1 << 20;

/// Texels of a PNG at most.
const MAX_TEXELS: usize = 1 << 28;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &DappleDrawArgs) -> anyhow::Result<Exit> {
    let file = &args.output;
    let ends = |end: &str| file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(end));
    if !ends("svg") && !ends("png") {
        bail!("{}: expected a name that ends in svg or png", file.display());
    }
    check_writable(file)?;
    let field = rule::field(&args.file, args.tiles)?;
    let size = (field.width(), field.height());
    let (name, cells) = (args.file.display(), size.0 * size.1);
    ensure!(
        cells <= MAX_CELLS,
        "{name}: {cells} cells, expected {MAX_CELLS} or fewer for a picture"
    );
    let texels = cells * (args.cell_size as usize).pow(2);
    ensure!(
        ends("svg") || texels <= MAX_TEXELS,
        "--cell-size {}: {texels} texels, expected {MAX_TEXELS} or fewer",
        args.cell_size
    );
    let against = match &args.against {
        None => None,
        Some(file) => {
            let other = rule::field(file, args.tiles)?;
            let found = (other.width(), other.height());
            let (width, height) = size;
            ensure!(
                found == size,
                "{}: {}x{} cells, expected {width}x{height}",
                file.display(),
                found.0,
                found.1
            );
            Some(other)
        }
    };
    let differ = against
        .as_ref()
        .map(|other| field.cells().iter().zip(other.cells()).filter(|(a, b)| a != b).count());
    let scene = picture::scene(&field, args.tiles.into(), against.as_ref());
    let about = format!("{}x{} cells", size.0, size.1);
    write_file(file, |out| match ends("svg") {
        true => svg::write_svg(out, &scene, args.cell_size, &about),
        false => {
            let image = raster::draw(&scene, args.cell_size);
            write_png(out, &image, &[("Description", about.as_str())])
        }
    })?;
    if args.json {
        output::object(&[
            ("result", json!("drawn")),
            ("width", json!(size.0)),
            ("height", json!(size.1)),
            ("differ", json!(differ)),
            ("file", json!(file.to_string_lossy())),
        ])?;
    } else if let Some(differ) = differ {
        output::line(&format!("{differ} of {cells} cells differ"))?;
    }
    Ok(Exit::Yes)
}

//! `dapple flow`: streams through a tiling by two tiles, as a picture or a page.

use super::rule;
use crate::atlas::picture::{flow as picture, raster, sheets, svg};
use crate::atlas::write_png;
use crate::cli::args::DappleFlowArgs;
use crate::cli::describe::number;
use crate::cli::exit::Exit;
use crate::cli::output;
use crate::dappled::Edges;
use crate::dappled::flow::flow;
use crate::store::{check_writable, write_file};
use anyhow::{anyhow, bail, ensure};
use serde_json::json;

/// Texels of a PNG at most.
const MAX_TEXELS: usize = 1 << 26;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &DappleFlowArgs) -> anyhow::Result<Exit> {
    let file = &args.output;
    let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let ending = ending.to_ascii_lowercase();
    if !["svg", "png", "html"].contains(&ending.as_str()) {
        bail!("{}: expected a name that ends in svg, png or html", file.display());
    }
    check_writable(file)?;
    let field = rule::field(&args.file, 2)?;
    let edges = match (args.cyclic, args.cylinder) {
        (true, _) => Edges::Torus,
        (_, true) => Edges::Cylinder,
        _ => Edges::Free,
    };
    let name = args.file.display();
    let (width, height) = (field.width(), field.height());
    let (cells, most) = (width * height, sheets::MAX_TILES);
    ensure!(cells <= most, "{name}: {cells} cells, expected {most} or fewer for a picture");
    let flow = flow(&field, edges)
        .ok_or_else(|| anyhow!("{name}: some cells are free (dapple decide completes them)"))?;
    let longest = flow.streams.iter().map(|stream| stream.strands.len()).max().unwrap_or(0);
    let closed = flow.streams.iter().filter(|stream| stream.closed).count();
    let (in_row, in_column) = flow.straight;
    let about = format!(
        "{width}x{height} cells, {}, straight through at most {in_row} in a row and {in_column} in a \
         column",
        number(flow.streams.len() as u64, "stream")
    );
    let size = args.cell_size;
    if ending == "png" {
        let texels = cells * (size as usize).pow(2);
        ensure!(
            texels <= MAX_TEXELS,
            "--cell-size {size}: {texels} texels, expected {MAX_TEXELS} or fewer"
        );
    }
    write_file(file, |out| match ending.as_str() {
        "svg" => svg::write_svg(out, &picture::scene(&field, &flow), size, &about),
        "html" => picture::page(out, &field, &flow, size, &about),
        _ => {
            let image = raster::draw(&picture::scene(&field, &flow), size);
            write_png(out, &image, &[("Description", about.as_str())])
        }
    })?;
    if args.json {
        output::object(&[
            ("result", json!("drawn")),
            ("width", json!(width)),
            ("height", json!(height)),
            ("streams", json!(flow.streams.len())),
            ("closed", json!(closed)),
            ("longest", json!(longest)),
            ("straight", json!([in_row, in_column])),
            ("file", json!(file.to_string_lossy())),
        ])?;
    } else if !args.quiet {
        output::remark(&format!("{about}; written to {}", file.display()));
    }
    Ok(Exit::Yes)
}

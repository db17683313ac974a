//! `tile`: the tiles at places of an endless tiling, and where they lie in a packing.

use super::args::{ColoringArg, TileArgs};
use super::exit::Exit;
use super::{output, set, tiling};
use crate::tiles::TileId;
use crate::tiling::{Cells, FARTHEST, Tiling};
use crate::torus::{Packing, Shape};
use anyhow::{Context, bail};
use serde_json::{Value, json};

/// The most tiles of a window.
const MOST: u64 = 1 << 24;

/// Runs the command.
///
/// # Errors
/// Bad input.
pub fn run(args: &TileArgs) -> anyhow::Result<Exit> {
    let window = window(args)?;
    let claim = set::packing_claim(&args.claim)?;
    let packing = match &args.packing {
        Some(file) => Some(tiling::packing(file, &claim)?),
        None => None,
    };
    let (kind, colors) = match &packing {
        Some(packing) => (Some(packing.set.kind()), Some(packing.set.colors())),
        None => (claim.kind, claim.colors),
    };
    let tiling = tiling::tiling(&args.coloring, args.seed, kind, colors)?;
    let cells = packing.as_ref().map(Cells::table);
    if let Some(cells) = &cells {
        cells.check(&tiling)?;
    }
    match args.json {
        true => print_json(args, &tiling, window, cells.as_ref())?,
        false => print(args, &tiling, window, cells.as_ref())?,
    }
    Ok(Exit::Yes)
}

/// The size of the window, all of which must be in reach.
fn window(args: &TileArgs) -> anyhow::Result<Shape> {
    let window: Shape = match &args.size {
        None => Shape::new(1, 1)?,
        Some(text) => text.parse().context("--size")?,
    };
    if window.cells() as u64 > MOST {
        bail!("--size {window}: {} tiles, expected at most {MOST}", window.cells());
    }
    for (name, at, size) in [("X", args.x, window.width()), ("Y", args.y, window.height())] {
        if at < -FARTHEST || at > FARTHEST - size as i64 {
            bail!("{name} {at}: expected a number from -2^62 to 2^62 less the window");
        }
    }
    Ok(window)
}

fn print(
    args: &TileArgs,
    tiling: &Tiling,
    window: Shape,
    cells: Option<&Cells>,
) -> anyhow::Result<()> {
    if args.size.is_some() {
        let tiles = tiling.window(args.x, args.y, window);
        let width = tiles.iter().map(|tile| tile.0).max().unwrap_or(0).to_string().len();
        return output::result(|out| {
            let (kind, colors) = (tiling.kind(), tiling.colors());
            writeln!(
                out,
                "# {kind} tiles over {colors} colors; x {} to {}, y {} to {} (north first)",
                args.x,
                args.x + window.width() as i64 - 1,
                args.y,
                args.y + window.height() as i64 - 1
            )?;
            tiles.chunks(window.width()).try_for_each(|row| {
                let row: Vec<_> = row.iter().map(|tile| format!("{:>width$}", tile.0)).collect();
                writeln!(out, "{}", row.join(" "))
            })
        });
    }
    let tile = tiling.tile(args.x, args.y);
    let sides = tiling.kind().describe(tile, tiling.colors());
    let place = cells.and_then(|cells| cells.find(tile));
    let place = place.map(|(row, column)| format!(": row {row}, column {column}"));
    output::line(&format!("tile {tile} ({sides}){}", place.unwrap_or_default()))
}

fn print_json(
    args: &TileArgs,
    tiling: &Tiling,
    window: Shape,
    cells: Option<&Cells>,
) -> anyhow::Result<()> {
    let set = crate::tiles::TileSet::new(
        tiling.kind(),
        tiling.colors(),
        crate::tiles::Members::Complete,
    )?;
    let description = output::description(&Packing::new(set, window, false, Vec::new()));
    let coloring = match &args.coloring {
        ColoringArg::Hash => "hash".to_owned(),
        ColoringArg::Halton(size) => format!("halton:{size}"),
        ColoringArg::Map(file) => format!("map:{}", file.display()),
    };
    let tiles = tiling.window(args.x, args.y, window);
    let list: Vec<Value> = tiles
        .iter()
        .enumerate()
        .map(|(at, &tile)| {
            let (row, column) = (at / window.width(), at % window.width());
            let y = args.y + (window.height() - 1 - row) as i64;
            entry(tiling, tile, args.x + column as i64, y, cells)
        })
        .collect();
    output::object(&[
        ("kind", description["kind"].clone()),
        ("colors", description["colors"].clone()),
        ("coloring", json!(coloring)),
        ("seed", json!(args.seed)),
        ("tiles", json!(list)),
    ])
}

/// A tile in the list.
fn entry(tiling: &Tiling, tile: TileId, x: i64, y: i64, cells: Option<&Cells>) -> Value {
    let mut entry = json!({ "x": x, "y": y, "tile": tile.0, "sides": tiling.sides(x, y) });
    if let Some((row, column)) = cells.and_then(|cells| cells.find(tile)) {
        entry["row"] = json!(row);
        entry["column"] = json!(column);
    }
    entry
}

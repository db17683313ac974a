//! `sets`: the size of a tile set, by formula and by listing it, and its tiles.

use super::args::SetsArgs;
use super::exit::Exit;
use super::{describe, output, set};
use crate::tiles::{Kind, TileId, TileSet};
use crate::torus::{Packing, Shape};
use anyhow::bail;
use serde_json::json;

/// Sets with more tiles to look at are not listed to check their size.
const MAX_LISTED: u64 = 1 << 26;

/// Runs the command.
///
/// # Errors
/// Bad input.
pub fn run(args: &SetsArgs) -> anyhow::Result<Exit> {
    let set = set::tile_set(&args.set, None)?;
    if args.list && set.is_compact() {
        bail!(
            "--list: a compact set has no fixed tiles: any two for each choice of the fixed \
             colors do, and the search chooses them"
        );
    }
    let size = set.size();
    let checked = is_checked(&set)?;
    if args.json {
        print_json(args, &set, size, checked)?;
    } else {
        print(args, &set, size, checked)?;
    }
    Ok(Exit::Yes)
}

/// Lists the tiles where that is feasible; their number must be that of the formula.
fn is_checked(set: &TileSet) -> anyhow::Result<bool> {
    // Which tiles a compact set has is open, so there is nothing to list.
    if set.is_compact() || set.kind().tiles(set.colors()) > MAX_LISTED {
        return Ok(false);
    }
    let (listed, size) = (set.allowed().count() as u64, set.size());
    if listed != size {
        bail!("internal error: {listed} tiles listed, {size} by formula; please report this");
    }
    Ok(true)
}

fn print(args: &SetsArgs, set: &TileSet, size: u64, checked: bool) -> anyhow::Result<()> {
    let (kind, colors) = (set.kind(), set.colors());
    let how = match (checked, set.is_compact()) {
        (true, _) => "by formula and by listing",
        (false, true) => "by formula; the search chooses which",
        (false, false) => "by formula; too many to list",
    };
    output::result(|out| {
        writeln!(out, "{}: {} ({how})", describe::set(set), describe::number(size, "tile"))?;
        if let Ok(shape) = Shape::default_for(set) {
            writeln!(out, "default size of a packing: {shape}")?;
        }
        if !args.list {
            return Ok(());
        }
        let number = |id: u64| id.to_string().len();
        let digits = number(kind.tiles(colors) - 1).max("tile".len());
        let names: Vec<String> = kind.sides().iter().map(|side| format!("{side:>3}")).collect();
        writeln!(out, "{:>digits$}  {}", "tile", names.join(" "))?;
        for tile in set.allowed() {
            let sides = kind.unpack(tile, colors);
            let sides = sides.iter().zip(&names);
            let sides: Vec<_> =
                sides.map(|(side, name)| format!("{side:>width$}", width = name.len())).collect();
            writeln!(out, "{:>digits$}  {}", tile.0, sides.join(" "))?;
        }
        Ok(())
    })
}

fn print_json(args: &SetsArgs, set: &TileSet, size: u64, checked: bool) -> anyhow::Result<()> {
    // Any torus does: only what describes the set is taken.
    let shape = Shape::new(1, if set.kind() == Kind::Domino { 1 } else { 2 })?;
    let packing = Packing::new(set.clone(), shape, false, Vec::new());
    let description = output::description(&packing);
    let fields = [
        ("size", json!(size.to_string())),
        ("kind", description["kind"].clone()),
        ("colors", description["colors"].clone()),
        ("set", description["set"].clone()),
        ("checked", json!(checked)),
    ];
    let head = output::object_text(&fields);
    output::result(|out| {
        if !args.list {
            return writeln!(out, "{head}");
        }
        // A set can have billions of tiles, so they are not collected.
        write!(out, "{},\"tiles\":[", &head[..head.len() - 1])?;
        for (i, TileId(tile)) in set.allowed().enumerate() {
            let comma = if i > 0 { "," } else { "" };
            write!(out, "{comma}{tile}")?;
        }
        writeln!(out, "]}}")
    })
}

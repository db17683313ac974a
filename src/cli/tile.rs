//! `tile`: the tiles at places of an endless tiling, and where they lie in a packing.

use super::args::{ColoringArg, TileArgs};
use super::exit::Exit;
use super::{output, set, tile_stats, tiling};
use crate::store::{Claim, check_writable, write_file, write_tile_set};
use crate::tiles::{Colors, Kind, Members, TileId, TileSet};
use crate::tiling::{Cells, Coloring, FARTHEST, scanline};
use crate::torus::{Packing, Shape};
use anyhow::{Context, bail};
use serde_json::{Value, json};

/// The most tiles of a window.
const MOST: u64 = 1 << 24;

/// A window of a tiling.
pub(super) struct Window {
    pub(super) kind: Kind,
    pub(super) colors: Colors,
    pub(super) shape: Shape,
    /// Its tiles, row by row from the north.
    pub(super) tiles: Vec<TileId>,
    /// The tiles that can occur.
    pub(super) set: TileSet,
    /// Whether they should be all as likely.
    pub(super) even: bool,
    /// Bits of freedom of a tile.
    pub(super) entropy: f64,
}

/// Runs the command.
///
/// # Errors
/// Bad input.
pub fn run(args: &TileArgs) -> anyhow::Result<Exit> {
    let shape = shape(args)?;
    if let Some(file) = &args.set_out {
        check_writable(file)?;
    }
    let claim = set::packing_claim(&args.claim)?;
    let packing = match &args.packing {
        Some(file) => Some(tiling::packing(file, &claim)?),
        None => None,
    };
    let cells = packing.as_ref().map(Cells::table);
    let window = match args.coloring {
        ColoringArg::Scanline => laid(args, shape, packing.as_ref(), claim)?,
        _ => evaluated(args, shape, cells.as_ref(), &claim)?,
    };
    if let Some(file) = &args.set_out {
        let name = format!("tiles of --coloring {}", args.coloring);
        write_file(file, |out| write_tile_set(out, &window.set, Some(&name), Some("tilepack")))?;
    }
    match (args.stats, args.json) {
        (true, _) => tile_stats::print(args, &window)?,
        (_, true) => print_json(args, &window, cells.as_ref())?,
        _ => print(args, &window, cells.as_ref())?,
    }
    Ok(Exit::Yes)
}

/// The size of the window, all of which must be in reach.
fn shape(args: &TileArgs) -> anyhow::Result<Shape> {
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

/// A window of a tiling that knows every place by itself.
fn evaluated(
    args: &TileArgs,
    shape: Shape,
    cells: Option<&Cells>,
    claim: &Claim,
) -> anyhow::Result<Window> {
    let (kind, colors) = match cells {
        Some(cells) => (Some(cells.kind()), Some(cells.colors())),
        None => (claim.kind, claim.colors),
    };
    let tiling = tiling::tiling(&args.coloring, args.seed, kind, colors)?;
    if let Some(cells) = cells {
        cells.check(&tiling)?;
    }
    let (kind, colors) = (tiling.kind(), tiling.colors());
    // Few ask for the set, and some sets are large.
    let set = match args.stats || args.set_out.is_some() {
        true => TileSet::new(kind, colors, tiling.needs())?,
        false => TileSet::new(kind, colors, Members::Complete)?,
    };
    if args.set_out.is_some() || args.stats {
        few(&set)?;
    }
    if let (Coloring::Probabilities(map), Some(_)) = (tiling.coloring(), &args.set_out) {
        let pairs = map.never_together();
        let pairs: Vec<String> = pairs.iter().map(|(a, b)| format!("{}-{}", a.0, b.0)).collect();
        output::remark(&match pairs.is_empty() {
            true => "every two colors come together on some tile".to_owned(),
            false => format!("a pruned set with all these tiles: --set pruned:{}", pairs.join(",")),
        });
    }
    let even = matches!(
        tiling.coloring(),
        Coloring::Hash { .. } | Coloring::Compact(_) | Coloring::Sums(_)
    );
    let tiles = tiling.window(args.x, args.y, shape);
    Ok(Window { kind, colors, shape, tiles, set, even, entropy: tiling.entropy() })
}

/// A window laid tile by tile.
fn laid(
    args: &TileArgs,
    shape: Shape,
    packing: Option<&Packing>,
    claim: Claim,
) -> anyhow::Result<Window> {
    let set = match packing {
        Some(packing) => {
            let mut tiles = packing.tiles.clone();
            tiles.sort_unstable();
            tiles.dedup();
            TileSet::new(packing.set.kind(), packing.set.colors(), Members::Explicit(tiles))?
        }
        None => {
            let missing = |option| format!("{option} is missing (a packing or a set can stand in)");
            let kind = claim.kind.with_context(|| missing("--kind corner|wang"))?;
            let colors = claim.colors.with_context(|| missing("--colors C"))?;
            TileSet::new(kind, colors, claim.members.unwrap_or(Members::Complete))?
        }
    };
    if set.kind() != Kind::Domino {
        few(&set)?;
    }
    let laid = scanline(&set, args.x, args.y, shape, args.seed)?;
    let (kind, colors) = (set.kind(), set.colors());
    let (tiles, entropy) = (laid.tiles, laid.entropy);
    Ok(Window { kind, colors, shape, tiles, set, even: true, entropy })
}

/// Sets whose tiles are gone through have not too many.
fn few(set: &TileSet) -> anyhow::Result<()> {
    let all = set.kind().tiles(set.colors());
    if all > MOST {
        bail!("{all} tiles over {} colors: expected at most {MOST}", set.colors());
    }
    Ok(())
}

fn print(args: &TileArgs, window: &Window, cells: Option<&Cells>) -> anyhow::Result<()> {
    let (tiles, shape) = (&window.tiles, window.shape);
    if args.size.is_some() {
        let width = tiles.iter().map(|tile| tile.0).max().unwrap_or(0).to_string().len();
        return output::result(|out| {
            writeln!(
                out,
                "# {} tiles over {} colors; x {} to {}, y {} to {} (north first)",
                window.kind,
                window.colors,
                args.x,
                args.x + shape.width() as i64 - 1,
                args.y,
                args.y + shape.height() as i64 - 1
            )?;
            tiles.chunks(shape.width()).try_for_each(|row| {
                let row: Vec<_> = row.iter().map(|tile| format!("{:>width$}", tile.0)).collect();
                writeln!(out, "{}", row.join(" "))
            })
        });
    }
    let tile = tiles[0];
    let sides = window.kind.describe(tile, window.colors);
    let place = cells.and_then(|cells| cells.find(tile));
    let place = place.map(|(row, column)| format!(": row {row}, column {column}"));
    output::line(&format!("tile {tile} ({sides}){}", place.unwrap_or_default()))
}

fn print_json(args: &TileArgs, window: &Window, cells: Option<&Cells>) -> anyhow::Result<()> {
    let shape = window.shape;
    let list: Vec<Value> = window
        .tiles
        .iter()
        .enumerate()
        .map(|(at, &tile)| {
            let (row, column) = (at / shape.width(), at % shape.width());
            let y = args.y + (shape.height() - 1 - row) as i64;
            entry(window, tile, args.x + column as i64, y, cells)
        })
        .collect();
    let mut fields = head(args, window)?;
    fields.push(("tiles", json!(list)));
    output::object(&fields)
}

/// What tiling it is.
pub(super) fn head(args: &TileArgs, window: &Window) -> anyhow::Result<Vec<(&'static str, Value)>> {
    let set = TileSet::new(window.kind, window.colors, Members::Complete)?;
    let description = output::description(&Packing::new(set, window.shape, false, Vec::new()));
    Ok(vec![
        ("kind", description["kind"].clone()),
        ("colors", description["colors"].clone()),
        ("coloring", json!(args.coloring.to_string())),
        ("seed", json!(args.seed)),
    ])
}

/// A tile in the list.
fn entry(window: &Window, tile: TileId, x: i64, y: i64, cells: Option<&Cells>) -> Value {
    let sides = window.kind.unpack(tile, window.colors);
    let mut entry = json!({ "x": x, "y": y, "tile": tile.0, "sides": sides });
    if let Some((row, column)) = cells.and_then(|cells| cells.find(tile)) {
        entry["row"] = json!(row);
        entry["column"] = json!(column);
    }
    entry
}

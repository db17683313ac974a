//! Walls as pictures and as coverings, brick Wang tiles as a set and as pictures.

use crate::atlas::fill::{Bricks, Canvas};
use crate::atlas::picture::{raster, svg, wall};
use crate::atlas::{Format, TileImages, assemble, write_png};
use crate::cli::args::BrickArgs;
use crate::cli::output;
use crate::dappled::brick::{self, Wall};
use crate::store::{self, write_file, write_grid, write_solution, write_tile_set};
use crate::tiles::{Colors, Kind, Members, TileId, TileSet};
use crate::torus::{Packing, Shape};
use anyhow::{Context, ensure};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::Path;

/// Texels of a picture at most.
const MAX_TEXELS: usize = 1 << 28;

pub(super) fn ends_with(file: &Path, end: &str) -> bool {
    file.extension().is_some_and(|found| found.eq_ignore_ascii_case(end))
}

/// The set of all brick Wang tiles and their pictures, where they are asked for.
///
/// # Errors
/// Files that cannot be written, a sheet that is too large.
pub(super) fn tiles(args: &BrickArgs) -> anyhow::Result<()> {
    if args.set_out.is_none() && args.tiles_out.is_none() {
        return Ok(());
    }
    let colors = Colors::one(args.positions.into())?;
    let tiles = brick::tiles(args.positions).into_iter();
    let tiles = tiles.map(|sides| Kind::Wang.pack(&sides, colors)).collect::<Result<_, _>>()?;
    let set = TileSet::new(Kind::Wang, colors, Members::Explicit(tiles))?;
    if let Some(file) = &args.set_out {
        let name = format!("brick Wang tiles over {} positions", args.positions);
        let source = "Derouet-Jourdan, Mizoguchi, Salvati, 2015";
        write_file(file, |out| write_tile_set(out, &set, Some(&name), Some(source)))?;
    }
    let Some(to) = &args.tiles_out else { return Ok(()) };
    let side = usize::from(args.tile_size);
    let texels = set.size() as usize * side * side;
    ensure!(texels <= MAX_TEXELS, "--tiles-out: {texels} texels, expected {MAX_TEXELS} or fewer");
    let format = Format::RGBA8;
    let canvas = Canvas { kind: Kind::Wang, colors, side, strip: side / 16, format };
    let bricks = Bricks { canvas, seed: args.seed };
    if ends_with(to, "png") {
        let tiles: Vec<TileId> = set.allowed().collect();
        let square = |columns: &usize| tiles.len().is_multiple_of(*columns);
        let root = tiles.len().isqrt();
        let columns = (root..=tiles.len()).find(square).unwrap_or(tiles.len());
        let sheet = assemble(&bricks, &tiles, columns)?;
        write_file(to, |out| write_png(out, &sheet, &[]))?;
        return Ok(());
    }
    fs::create_dir_all(to).with_context(|| format!("{}: cannot be made", to.display()))?;
    for tile in set.allowed() {
        let image = bricks.draw(tile)?;
        write_file(to.join(format!("{tile}.png")), |out| write_png(out, &image, &[]))?;
    }
    Ok(())
}

/// The wall, to a file or as text to standard output.
///
/// # Errors
/// A file that cannot be written, a picture that is too large.
pub(super) fn wall(args: &BrickArgs, wall: &Wall, how: &str) -> anyhow::Result<()> {
    let title = format!("brick wall, {} positions, seed {}, by {how}", args.positions, args.seed);
    let Some(file) = &args.output else {
        if args.json {
            return Ok(());
        }
        return match covering(args, wall)? {
            Some(packing) => output::result(|out| write_grid(out, &packing)),
            None => output::result(|out| out.write_all(rows(wall).as_bytes())),
        };
    };
    let (png, side) = (ends_with(file, "png"), usize::from(args.tile_size));
    if png || ends_with(file, "svg") {
        let texels = wall.width() * wall.height() * side * side;
        ensure!(
            !png || texels <= MAX_TEXELS,
            "--tile-size {side}: {texels} texels, expected {MAX_TEXELS} or fewer"
        );
        let scene = wall::wall(wall, args.cyclic, args.seed);
        write_file(file, |out| match png {
            true => {
                let image = raster::draw(&scene, args.tile_size.into());
                write_png(out, &image, &[("Description", &title)])
            }
            false => svg::write_svg(out, &scene, args.tile_size.into(), &title),
        })?;
        return Ok(());
    }
    match covering(args, wall)? {
        None => write_file(file, |out| write!(out, "# {title}\n{}", rows(wall)))?,
        Some(packing) if ends_with(file, "json") => {
            let provenance = json!({ "method": how, "seed": args.seed });
            write_file(file, |out| {
                write_solution(out, &packing, &provenance, store::Layout::Pretty)
            })?;
        }
        Some(packing) => write_file(file, |out| {
            writeln!(out, "# {title}")?;
            write_grid(out, &packing)
        })?,
    }
    Ok(())
}

fn number(wall: &Wall, column: usize, row: usize) -> anyhow::Result<TileId> {
    let colors = Colors::one(wall.positions().into())?;
    Ok(Kind::Wang.pack(&wall.tile(column, row), colors)?)
}

/// A wall that repeats as a covering by the tiles that occur in it: a file that the other commands
/// read.
fn covering(args: &BrickArgs, wall: &Wall) -> anyhow::Result<Option<Packing>> {
    if !args.cyclic {
        return Ok(None);
    }
    let tiles = wall.cells().map(|(column, row)| number(wall, column, row));
    let tiles = tiles.collect::<Result<Vec<_>, _>>()?;
    let members: BTreeSet<TileId> = tiles.iter().copied().collect();
    let members = Members::Explicit(members.into_iter().collect());
    let set = TileSet::new(Kind::Wang, Colors::one(wall.positions().into())?, members)?;
    let shape = Shape::new(wall.width() as u64, wall.height() as u64)?;
    Ok(Some(Packing::new(set, shape, true, tiles)))
}

/// The numbers of the tiles as text; `.` outside.
fn rows(wall: &Wall) -> String {
    let mut text = String::new();
    for row in tile_rows(wall) {
        let cells = row.iter().map(|tile| tile.map_or(".".to_owned(), |tile| tile.to_string()));
        text.push_str(&cells.collect::<Vec<_>>().join(" "));
        text.push('\n');
    }
    text
}

/// The same as JSON, `null` outside.
pub(super) fn rows_json(wall: &Wall) -> Value {
    tile_rows(wall).map(|row| json!(row)).collect()
}

fn tile_rows(wall: &Wall) -> impl Iterator<Item = Vec<Option<u32>>> {
    (0..wall.height()).map(|row| {
        let cell = |column| {
            let tile = wall.holds(column, row).then(|| number(wall, column, row).ok());
            tile.flatten().map(|tile| tile.0)
        };
        (0..wall.width()).map(cell).collect()
    })
}

//! `aperiodic patch`: a rectangle filled with the tiles of a set, as text, JSON or a picture.

use super::source;
use crate::aperiodic::Set;
use crate::aperiodic::decide::torus::smallest;
use crate::aperiodic::decide::{Bounds, wang};
use crate::aperiodic::patch::{Machine, Patch, Unfilled, code, compute, fill};
use crate::atlas::demo::{Demo, How};
use crate::atlas::picture::{raster, sheets, svg};
use crate::atlas::write_png;
use crate::cli::args::PatchArgs;
use crate::cli::exit::Exit;
use crate::cli::{output, signal};
use crate::store::{check_writable, write_file};
use crate::tiles::{Colors, Kind, Members, TileId, TileSet};
use crate::torus::{Packing, Shape};
use anyhow::{Context, bail, ensure};
use serde_json::{Value, json};
use std::io::{self, Write};
use std::path::Path;
use std::time::Instant;

/// What the labels of published sets compute, which makes them quick; for any other set, and
/// when it is not theirs, there is a search.
const MACHINES: [Machine; 2] = [
    // Kari: x/2 from 4/3 on, else 3x/2, downward.
    Machine { values: &[1, 0, 2], ratios: &[(2.0, 1.0), (2.0, 3.0)], range: (2.0 / 3.0, 2.0) },
    // Culik: 2x or x/3, downward.
    Machine { values: &[0, 0, 1, 2], ratios: &[(1.0, 2.0), (3.0, 1.0)], range: (1.0 / 3.0, 2.0) },
];

/// Tiles of a patch at most: 8192 x 8192, half a gigabyte.
const MAX_CELLS: usize = 1 << 26;

/// Texels of a picture at most.
const MAX_TEXELS: usize = 1 << 28;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &PatchArgs) -> anyhow::Result<Exit> {
    let begin = Instant::now();
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    let set = source::set(&args.file)?;
    let size = args.size.as_deref().map(str::parse::<Shape>).transpose()?;
    let cells = size.map_or(0, Shape::cells);
    ensure!(cells <= MAX_CELLS, "--size: {cells} tiles, expected {MAX_CELLS} or fewer");
    let deadline = args.time_limit.and_then(|time| begin.checked_add(time));
    let stop = (signal::listen()?, deadline);
    let tiles = wang(&set);
    let patch = if args.torus {
        let strips = Bounds::default().strips;
        let Some(torus) = smallest(&tiles, 12, strips, &stop) else {
            let reason = "no torus was found; aperiodic decide says more";
            return none(args, "none", reason, Exit::No);
        };
        let (width, height) = (torus.width, torus.height);
        let (w, h) = size.map_or((width, height), |size| (size.width(), size.height()));
        ensure!(
            w.is_multiple_of(width) && h.is_multiple_of(height),
            "--size {w}x{h}: expected multiples of {width} and {height}, the torus that was found"
        );
        let cell = |i: usize| torus.cells[i / w % height * width + i % w % width];
        let cells = (0..w * h).map(cell).collect();
        Patch { width: w, height: h, cells, ahead: 0, back: 0 }
    } else {
        let (w, h) = size.map_or((32, 32), |size| (size.width(), size.height()));
        let computed =
            MACHINES.iter().find_map(|machine| compute(&tiles, machine, w, h, args.seed));
        let computed = computed.or_else(|| code(&tiles, w, h, args.seed));
        match computed.map_or_else(|| fill(&tiles, w, h, args.seed, &stop), Ok) {
            Ok(patch) => patch,
            Err(Unfilled::Impossible { rows }) => {
                let reason = format!("no strip of {rows} rows or columns can be filled");
                return none(args, "none", &reason, Exit::No);
            }
            Err(Unfilled::Stopped { best }) => {
                let reason = format!("stopped; {best} rows or columns were filled at best");
                return none(args, "stopped", &reason, Exit::Stopped);
            }
        }
    };
    ensure!(fits(&set, &patch, args.torus), "internal error: tiles that do not fit; please report");
    give(args, &set, &patch)?;
    if args.json {
        output::object(&[
            ("result", json!("filled")),
            ("kind", json!(set.kind().name())),
            ("width", json!(patch.width)),
            ("height", json!(patch.height)),
            ("seed", json!(args.seed)),
            ("ahead", json!(patch.ahead)),
            ("back", json!(patch.back)),
            ("seconds", json!(begin.elapsed().as_secs_f64())),
            ("file", json!(args.output.as_ref().map(|file| file.to_string_lossy()))),
        ])?;
    } else if !args.quiet {
        let how = match (args.torus, patch.ahead) {
            (true, _) => "a torus".to_owned(),
            (_, 0) => "computed".to_owned(),
            (_, ahead) => format!("{ahead} rows ahead, {} times back", patch.back),
        };
        output::remark(&format!(
            "{}x{} tiles, {how}; every side checked",
            patch.width, patch.height
        ));
    }
    Ok(Exit::Yes)
}

/// Says that there is no patch.
fn none(args: &PatchArgs, result: &str, reason: &str, exit: Exit) -> anyhow::Result<Exit> {
    match args.json {
        true => output::object(&[("result", json!(result)), ("reason", json!(reason))])?,
        false => output::line(&format!("{result}: {reason}"))?,
    }
    Ok(exit)
}

/// Whether all neighbors match; around the rim, too, if it is a torus.
fn fits(set: &Set, patch: &Patch, torus: bool) -> bool {
    let (width, height) = (patch.width, patch.height);
    let tile = |row: usize, column: usize| set.tiles()[patch.cells[row * width + column]];
    (0..width * height).all(|cell| {
        let (row, column) = (cell / width, cell % width);
        let (east, south) = ((column + 1) % width, (row + 1) % height);
        let here = tile(row, column);
        ((east == 0 && !torus) || set.fits_east(here, tile(row, east)))
            && ((south == 0 && !torus) || set.fits_south(here, tile(south, column)))
    })
}

/// Writes the patch in the form that the file's name asks for.
fn give(args: &PatchArgs, set: &Set, patch: &Patch) -> anyhow::Result<()> {
    let Some(file) = &args.output else {
        if args.json {
            return Ok(());
        }
        return output::result(|out| write_text(out, patch));
    };
    let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    match ending {
        "svg" | "png" => picture(args, set, patch, file, ending == "svg"),
        "json" => Ok(write_file(file, |out| write_json(out, set, patch))?),
        _ => Ok(write_file(file, |out| write_text(out, patch))?),
    }
}

fn write_text(out: &mut dyn Write, patch: &Patch) -> io::Result<()> {
    for row in patch.cells.chunks(patch.width) {
        let row: Vec<String> = row.iter().map(usize::to_string).collect();
        writeln!(out, "{}", row.join(" "))?;
    }
    Ok(())
}

fn write_json(out: &mut dyn Write, set: &Set, patch: &Patch) -> io::Result<()> {
    let rows: Vec<Value> = patch.cells.chunks(patch.width).map(|row| json!(row)).collect();
    let object = output::object_text(&[
        ("kind", json!(set.kind().name())),
        ("tiles", json!(set.tiles())),
        ("width", json!(patch.width)),
        ("height", json!(patch.height)),
        ("rows", json!(rows)),
    ]);
    writeln!(out, "{object}")
}

fn picture(
    args: &PatchArgs,
    set: &Set,
    patch: &Patch,
    file: &Path,
    is_svg: bool,
) -> anyhow::Result<()> {
    let texels = patch.cells.len().saturating_mul((args.tile_size as usize).pow(2));
    ensure!(
        is_svg || texels <= MAX_TEXELS,
        "a picture of {texels} texels: expected {MAX_TEXELS} or fewer; see --tile-size"
    );
    let packing = packing(set, patch).with_context(|| format!("{}", file.display()))?;
    let demo = Demo { shape: packing.shape, tiles: packing.tiles.clone(), how: How::TileByTile };
    let scene = sheets::tiling(&packing, &demo, args.tile_size, false);
    let title = format!("{} tiles, {}x{}", set.tiles().len(), patch.width, patch.height);
    match is_svg {
        true => write_file(file, |out| svg::write_svg(out, &scene, args.tile_size, &title))?,
        false => {
            let image = raster::draw(&scene, args.tile_size);
            write_file(file, |out| write_png(out, &image, &[]))?;
        }
    }
    Ok(())
}

/// The patch as tiles over colors, for pictures.
fn packing(set: &Set, patch: &Patch) -> anyhow::Result<Packing> {
    let largest = |sides: &[usize]| -> u64 {
        let labels = set.tiles().iter().flat_map(|tile| sides.iter().map(|&side| tile[side]));
        u64::from(labels.max().unwrap_or(0)) + 1
    };
    let colors = match set.kind() {
        Kind::Wang => Colors::pair(largest(&[0, 2]), largest(&[1, 3])),
        _ => Colors::one(largest(&[0, 1, 2, 3])),
    };
    let colors = colors.context("too many labels for a picture")?;
    let tiles: Vec<TileId> = set
        .tiles()
        .iter()
        .map(|&[a, b, c, d]| {
            let sides = match set.kind() {
                Kind::Wang => [a, b, c, d],
                // NW, NE, SE, SW to NE, SE, SW, NW.
                _ => [b, c, d, a],
            };
            Ok(set.kind().pack(&sides.map(|label| label as u8), colors)?)
        })
        .collect::<anyhow::Result<_>>()?;
    let shape = Shape::new(patch.width as u64, patch.height as u64)?;
    let cells = patch.cells.iter().map(|&tile| tiles[tile]).collect();
    let set = TileSet::new(set.kind(), colors, Members::Explicit(tiles))?;
    if shape.cells() > sheets::MAX_TILES {
        bail!("{} tiles: pictures have at most {}", shape.cells(), sheets::MAX_TILES);
    }
    Ok(Packing::new(set, shape, true, cells))
}

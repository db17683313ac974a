//! Sheets and folders of tiles: all files are there when all are complete.
//!
//! Files are written beside their place under another name and renamed together at the end. A
//! folder must be new: what lies in it would be taken for tiles, too.

use super::super::args::FillArgs;
use super::sources::Wanted;
use crate::atlas::{Layout, PICTURE_LIMIT, assemble, write_png};
use crate::store::{AtomicFile, beside, check_writable, write_tile_set};
use crate::texture::{Drawn, Made, Stock};
use crate::tiles::{Members, TileId, TileSet};
use crate::torus::Shape;
use anyhow::{Context, ensure};
use rayon::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};

/// What is to be written: for the picture and each map a sheet or a folder.
pub(super) struct Outputs {
    places: Vec<PathBuf>,
    /// Whether they are sheets.
    sheets: bool,
    /// The list of tiles that goes with sheets.
    list: Option<PathBuf>,
}

/// What was written.
pub(super) struct Written {
    /// Sheets or folders.
    pub(super) files: Vec<PathBuf>,
    /// The list of tiles.
    pub(super) list: Option<PathBuf>,
    /// Bytes of all pictures.
    pub(super) bytes: u64,
}

/// A name with something added before its ending.
fn with_word(file: &Path, word: &str) -> PathBuf {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    match file.extension() {
        Some(end) if is_sheet(file) => {
            file.with_file_name(format!("{stem}-{word}.{}", end.to_string_lossy()))
        }
        _ => beside(file, &format!("-{word}")),
    }
}

fn is_sheet(file: &Path) -> bool {
    file.extension().is_some_and(|end| end.eq_ignore_ascii_case("png"))
}

/// Where everything goes; looked at before any work is done.
///
/// # Errors
/// A folder that is there, a place that cannot be written, two outputs of one name.
pub(super) fn outputs(args: &FillArgs) -> anyhow::Result<Outputs> {
    let sheets = is_sheet(&args.output);
    let mut places = vec![args.output.clone()];
    for map in &args.map {
        let first = map.split(',').next().unwrap_or_default();
        let stem = Path::new(first).file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let place = with_word(&args.output, &stem);
        ensure!(
            !places.contains(&place),
            "--map {map}: {} is written for another map; expected files of different names",
            place.display()
        );
        places.push(place);
    }
    let list = (sheets && args.packing.is_none()).then(|| args.output.with_extension("tiles.json"));
    for place in &places {
        if sheets {
            check_writable(place)?;
            continue;
        }
        ensure!(
            !place.exists(),
            "{}: is already there; expected a new folder, or a sheet OUT.png",
            place.display()
        );
        check_writable(hidden(place))?;
    }
    if let Some(list) = &list {
        check_writable(list)?;
    }
    Ok(Outputs { places, sheets, list })
}

/// The name under which a folder is filled.
fn hidden(folder: &Path) -> PathBuf {
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    folder.with_file_name(format!(".{name}.{}.part", std::process::id()))
}

/// Writes all of it.
///
/// # Errors
/// Files that cannot be written; then none is left.
pub(super) fn write(
    outputs: &Outputs,
    stock: &Stock,
    made: &Made,
    wanted: &Wanted,
) -> anyhow::Result<Written> {
    let bytes = match outputs.sheets {
        true => write_sheets(outputs, stock, made, wanted)?,
        false => write_folders(outputs, stock, made)?,
    };
    Ok(Written { files: outputs.places.clone(), list: outputs.list.clone(), bytes })
}

fn about(made: &Made) -> String {
    let order = made.order;
    format!(
        "tilepack fill --kind {} --colors {} --tile-size {} --strip {} --seed {}",
        order.kind, order.colors, order.shape.side, order.shape.strip, order.seed
    )
}

fn write_sheets(
    outputs: &Outputs,
    stock: &Stock,
    made: &Made,
    wanted: &Wanted,
) -> anyhow::Result<u64> {
    let (tiles, columns) = match &wanted.packing {
        Some(packing) if outputs.list.is_none() => (packing.tiles.clone(), packing.shape.width()),
        _ => {
            let tiles: Vec<TileId> = made.tiles.keys().copied().collect();
            let columns = Shape::near_square(tiles.len() as u64)?.width();
            (tiles, columns)
        }
    };
    let order = made.order;
    let layout =
        Layout::of_cells(order.kind, order.colors, tiles.clone(), columns, order.shape.side, 0)?;
    let mut complete = Vec::new();
    let mut bytes = 0;
    let comment = about(made);
    for (map, place) in outputs.places.iter().enumerate() {
        let images = Drawn { made, stock, map };
        let texel = stock.images(0)[map].format().bytes();
        let size = layout.width() as u64 * layout.height() as u64 * texel as u64;
        ensure!(
            size <= PICTURE_LIMIT,
            "a sheet of {} x {} texels takes {} MiB, the limit is {}: expected a folder",
            layout.width(),
            layout.height(),
            size >> 20,
            PICTURE_LIMIT >> 20
        );
        let sheet = assemble(&images, &tiles, columns)?;
        let mut encoded = Vec::new();
        write_png(&mut encoded, &sheet, &[("Comment", &comment)])?;
        bytes += encoded.len() as u64;
        let mut file = AtomicFile::create(place)?;
        let wrote = std::io::Write::write_all(&mut file, &encoded);
        wrote.with_context(|| cannot(place))?;
        complete.push(file);
    }
    if let Some(list) = &outputs.list {
        let mut file = AtomicFile::create(list)?;
        let set = TileSet::new(order.kind, order.colors, Members::Explicit(tiles))?;
        write_tile_set(&mut file, &set, None, None).with_context(|| cannot(list))?;
        complete.push(file);
    }
    complete.into_iter().try_for_each(AtomicFile::commit)?;
    Ok(bytes)
}

fn cannot(file: &Path) -> String {
    format!("{}: cannot be written", file.display())
}

/// A folder that is removed unless it got its name.
struct Part {
    hidden: PathBuf,
    place: PathBuf,
}

impl Drop for Part {
    fn drop(&mut self) {
        // After it got its name there is none of this one.
        let _ = fs::remove_dir_all(&self.hidden);
    }
}

fn write_folders(outputs: &Outputs, stock: &Stock, made: &Made) -> anyhow::Result<u64> {
    let tiles: Vec<TileId> = made.tiles.keys().copied().collect();
    let comment = about(made);
    let mut parts = Vec::new();
    let mut bytes = 0;
    for (map, place) in outputs.places.iter().enumerate() {
        let part = Part { hidden: hidden(place), place: place.clone() };
        fs::create_dir(&part.hidden).with_context(|| cannot(place))?;
        let write = |&tile: &TileId| {
            let mut encoded = Vec::new();
            let image = made.tiles[&tile].draw(stock, map);
            write_png(&mut encoded, &image, &[("Comment", &comment)])?;
            let file = part.hidden.join(format!("{tile}.png"));
            fs::write(&file, &encoded).with_context(|| cannot(&file))?;
            anyhow::Ok(encoded.len() as u64)
        };
        let sizes: Vec<u64> = tiles.par_iter().map(write).collect::<anyhow::Result<_>>()?;
        bytes += sizes.iter().sum::<u64>();
        parts.push(part);
    }
    for part in &parts {
        fs::rename(&part.hidden, &part.place).with_context(|| cannot(&part.place))?;
    }
    Ok(bytes)
}

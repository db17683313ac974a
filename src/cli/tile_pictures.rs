//! The pictures of tiles that an option asks for: made up, from a folder, from a sheet.

use super::args::{ChannelsArg, TilePictureArgs};
use super::source;
use crate::atlas::fill::{Canvas, Marks, Noise, Truchet};
use crate::atlas::{
    Channels, Depth, Folder, Format, Image, Layout, Light, Sheet, StripCheck, TileImages, open_png,
};
use crate::store::{Claim, Input, read_listed_tiles, read_solution};
use crate::tiles::{Colors, Kind, TileId};
use crate::torus::Packing;
use anyhow::{Context, bail, ensure};
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::path::Path;

/// Texels of a tile's side where nothing says otherwise.
const SIDE: usize = 64;

/// Pictures for the tiles of a packing.
pub struct Pictures {
    /// They themselves.
    pub images: Box<dyn TileImages>,
    /// Texels of the strip that they keep.
    pub strip: usize,
    /// What they are, in words that make them again.
    pub words: String,
}

/// The pictures asked for. Those from files are all looked at.
///
/// # Errors
/// Options that contradict each other, files that are not what was expected, pictures that do not
/// keep the strip.
pub fn pictures(args: &TilePictureArgs, packing: &Packing) -> anyhow::Result<Pictures> {
    let fill = args.fill.to_string_lossy();
    let (kind, colors) = (packing.set.kind(), packing.set.colors());
    if let made_up @ ("marks" | "noise" | "truchet") = &*fill {
        ensure!(args.sheet.is_none(), "--sheet goes with a sheet, not with --fill {fill}");
        let side = args.tile_size.unwrap_or(SIDE);
        let strip = strip(args, side)?;
        let canvas = Canvas { kind, colors, side, strip, format: format(args)? };
        let seed = args.seed;
        let images: Box<dyn TileImages> = match made_up {
            "marks" => Box::new(Marks { canvas }),
            "noise" => Box::new(Noise { canvas, seed, loose_corners: false }),
            _ => Box::new(Truchet { canvas, seed }),
        };
        let words = format!("--fill {made_up} --tile-size {side} --strip {strip} --seed {seed}");
        return Ok(Pictures { images, strip, words });
    }
    let different: BTreeSet<TileId> = packing.tiles.iter().copied().collect();
    let images: Box<dyn TileImages> = if args.fill.is_dir() {
        ensure!(args.sheet.is_none(), "--sheet goes with a sheet, but {fill} is a folder");
        Box::new(Folder::open(&args.fill, kind, colors, different.iter().copied())?)
    } else if args.fill.exists() {
        let Some(tiles) = &args.sheet else {
            bail!("{fill}: a sheet needs --sheet, a file that says which tiles it shows");
        };
        let sheet = sheet(&open_sheet(&args.fill, args.linear)?, tiles, None, 0)
            .with_context(|| fill.to_string())?;
        let shown = (sheet.layout().kind, sheet.layout().colors);
        ensure!(
            shown == (kind, colors),
            "{}: {} tiles over {} colors, but the packing has {kind} tiles over {colors}",
            tiles.display(),
            shown.0,
            shown.1
        );
        if let Some(missing) = different.iter().find(|&&tile| sheet.layout().cell(tile).is_none()) {
            bail!("{fill}: tile {missing} ({}) is missing", kind.describe(*missing, colors));
        }
        Box::new(sheet)
    } else {
        bail!(
            "--fill {fill}: expected marks, noise, truchet, a folder of pictures or a sheet; there \
             is no such file"
        );
    };
    let side = images.side();
    if let Some(asked) = args.tile_size.filter(|&asked| asked != side) {
        bail!("--tile-size {asked}, but the tiles of {fill} have {side} texels a side");
    }
    let strip = strip(args, side)?;
    check_strip(&*images, kind, colors, &different, strip).with_context(|| {
        format!(
            "{fill}: the strip of {strip} texels is not kept (tilepack lint tells more, \
                 --strip 0 goes on without)"
        )
    })?;
    Ok(Pictures { images, strip, words: format!("--strip {strip}") })
}

/// Looks at the pictures of all tiles, some at a time.
fn check_strip(
    images: &dyn TileImages,
    kind: Kind,
    colors: Colors,
    tiles: &BTreeSet<TileId>,
    strip: usize,
) -> anyhow::Result<()> {
    let mut check = StripCheck::new(kind, colors, strip);
    let tiles: Vec<TileId> = tiles.iter().copied().collect();
    for some in tiles.chunks(64) {
        let drawn: Vec<Image> =
            some.par_iter().map(|&tile| images.draw(tile)).collect::<Result<_, _>>()?;
        for (&tile, image) in some.iter().zip(&drawn) {
            if strip > 0 {
                check.add(tile, image)?;
            }
        }
    }
    Ok(())
}

/// The width of the strip.
fn strip(args: &TilePictureArgs, side: usize) -> anyhow::Result<usize> {
    let strip = args.strip.unwrap_or_else(|| 4.min(side / 4));
    ensure!(
        2 * strip <= side,
        "--strip {strip}: at most half a tile, {} of {side} texels",
        side / 2
    );
    Ok(strip)
}

fn format(args: &TilePictureArgs) -> anyhow::Result<Format> {
    let channels = match args.channels {
        ChannelsArg::Gray => Channels::Gray,
        ChannelsArg::GrayAlpha => Channels::GrayAlpha,
        ChannelsArg::Rgb => Channels::Rgb,
        ChannelsArg::Rgba => Channels::Rgba,
    };
    let depth = match args.depth {
        8 => Depth::Eight,
        16 => Depth::Sixteen,
        bits => bail!("--depth {bits}: expected 8 or 16 bits"),
    };
    Ok(Format { channels, depth, light: light(args.linear) })
}

fn light(linear: bool) -> Light {
    if linear { Light::Linear } else { Light::Srgb }
}

/// A picture whose samples are meant as the option says.
fn open_sheet(file: &Path, linear: bool) -> anyhow::Result<Image> {
    let image = open_png(file)?;
    Ok(if linear { image.with_light(Light::Linear) } else { image })
}

/// The tiles of a sheet, as a file says. The number of columns is that given, that of the
/// packing, or the one that makes the tiles square.
///
/// # Errors
/// A file that is neither a tile set nor a packing, a picture that does not suit it.
pub fn sheet(
    image: &Image,
    tiles: &Path,
    columns: Option<usize>,
    gutter: usize,
) -> anyhow::Result<Sheet> {
    let (kind, colors, tiles, said) = listed(&source::open(tiles)?)?;
    let (width, height, count) = (image.width(), image.height(), tiles.len());
    ensure!(kind != Kind::Domino, "a sheet shows corner or Wang tiles, not dominoes");
    let columns = match columns.or(said) {
        Some(columns) => columns,
        None => {
            let square = |columns: &usize| {
                let rows = count / columns;
                count % columns == 0 && width * rows == height * columns && width % columns == 0
            };
            (1..=count).find(square).with_context(|| {
                format!("no grid of {count} square tiles fills {width} x {height} texels")
            })?
        }
    };
    ensure!(
        columns > 0 && width % columns == 0 && width / columns > 2 * gutter,
        "{width} texels do not divide into {columns} columns of tiles with gutters of {gutter}"
    );
    let side = width / columns - 2 * gutter;
    let layout = Layout::of_cells(kind, colors, tiles, columns, side, gutter)?;
    Ok(Sheet::new(image.clone(), layout)?)
}

/// The tiles that a file lists, and their columns where it says.
type Listed = (Kind, Colors, Vec<TileId>, Option<usize>);

fn listed(input: &Input) -> anyhow::Result<Listed> {
    let start = input.text().trim_start();
    let object = start.starts_with('{').then(|| serde_json::from_str(start));
    let is_set = match object {
        Some(Ok(serde_json::Value::Object(fields))) => !fields.contains_key("width"),
        _ => false,
    };
    if is_set {
        let list = read_listed_tiles(input, None)?;
        return Ok((list.kind, list.colors, list.tiles, None));
    }
    let packing = read_solution(input, &Claim::default())?.packing;
    let columns = packing.shape.width();
    Ok((packing.set.kind(), packing.set.colors(), packing.tiles, Some(columns)))
}

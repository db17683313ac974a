//! What tiles are made from, and which.

use super::super::args::{AlphaArg, ClaimArgs, FillArgs};
use super::super::{set, source};
use super::{check_kind, check_size};
use crate::atlas::{Image, Light, open_png};
use crate::construct::construct;
use crate::texture::{Alpha, Shape, Stock};
use crate::tiles::{Colors, Kind, TileId, TileSet};
use crate::torus::{self, Packing};
use anyhow::{Context, ensure};
use std::path::Path;

/// The tiles that are wanted.
pub(super) struct Wanted {
    /// What carries the colors.
    pub(super) kind: Kind,
    /// The palettes.
    pub(super) colors: Colors,
    /// The tiles, in increasing order.
    pub(super) tiles: Vec<TileId>,
    /// The set that they are.
    pub(super) set: TileSet,
    /// Where they lie in a sheet.
    pub(super) packing: Option<Packing>,
}

/// The tiles that the options ask for.
///
/// # Errors
/// Options that contradict each other, files that cannot be read, too many tiles.
pub(super) fn wanted(args: &FillArgs, shape: Shape) -> anyhow::Result<Wanted> {
    if let Some(file) = &args.packing {
        let claim = ClaimArgs { set: args.set.clone(), cover: false };
        let packing = source::packing(file, &claim)?;
        let mut tiles = packing.tiles.clone();
        tiles.sort_unstable();
        tiles.dedup();
        check_kind(packing.set.kind())?;
        check_size(tiles.len() as u64, shape)?;
        let set = packing.set.clone();
        let (kind, colors) = (set.kind(), set.colors());
        return Ok(Wanted { kind, colors, tiles, set, packing: Some(packing) });
    }
    let set = set::tile_set(&args.set, None)?;
    let (kind, colors) = (set.kind(), set.colors());
    check_kind(kind)?;
    check_size(set.size(), shape)?;
    if set.is_compact() {
        // Which two tiles for each choice is for the packing to say: that which find constructs.
        let near = torus::Shape::default_for(&set)?;
        let packing = construct(&set, near, None).map(|constructed| constructed.packing());
        let packing = packing.ok().with_context(|| {
            format!("--set compact: no packing over {colors} colors is known; expected --packing")
        })?;
        let mut tiles = packing.tiles.clone();
        tiles.sort_unstable();
        return Ok(Wanted { kind, colors, tiles, set, packing: Some(packing) });
    }
    let tiles = set.allowed().collect();
    Ok(Wanted { kind, colors, tiles, set, packing: None })
}

/// The examples with their maps.
///
/// # Errors
/// Files that are no pictures, or do not suit each other.
pub(super) fn stock(args: &FillArgs) -> anyhow::Result<Stock> {
    let alpha = args.alpha.map(|alpha| match alpha {
        AlphaArg::Straight => Alpha::Straight,
        AlphaArg::Premultiplied => Alpha::Premultiplied,
    });
    let light = |image: Image, linear: bool| {
        if linear { image.with_light(Light::Linear) } else { image }
    };
    let mut images: Vec<Vec<Image>> = Vec::new();
    for file in &args.examples {
        images.push(vec![light(open_png(file)?, args.linear)]);
    }
    for map in &args.map {
        let files: Vec<&str> = map.split(',').collect();
        ensure!(
            files.len() == images.len(),
            "--map {map}: {} files for {} examples: expected one each",
            files.len(),
            images.len()
        );
        for ((file, of), example) in files.into_iter().zip(&mut images).zip(&args.examples) {
            let image = light(open_png(Path::new(file))?, true);
            let (is, wanted) = ((image.width(), image.height()), (of[0].width(), of[0].height()));
            ensure!(
                is == wanted,
                "{file} is {} x {} texels: expected {} x {}, as {}",
                is.0,
                is.1,
                wanted.0,
                wanted.1,
                example.display()
            );
            of.push(image);
        }
    }
    let names: Vec<String> = args.examples.iter().map(|file| file.display().to_string()).collect();
    Stock::new(images, alpha).with_context(|| names.join(", "))
}

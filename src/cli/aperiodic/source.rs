//! The set that a command is about: a tile set file, whose labels may be any numbers, or the name
//! of a published set.

use super::published::published;
use crate::aperiodic::Set;
use crate::cli::source;
use crate::store::{read_listed_tiles, read_tile_set};
use crate::tiles::{Kind, MAX_COLORS};
use anyhow::Context;
use serde::Deserialize;
use std::path::Path;

/// A set with labels that need not be colors.
#[derive(Debug, Deserialize)]
struct Document {
    kind: String,
    tiles: Vec<[u32; 4]>,
}

/// The tiles of a set, in the order of its file.
///
/// # Errors
/// A file that is no tile set, dominoes, tiles listed twice.
pub(super) fn set(file: &Path) -> anyhow::Result<Set> {
    if !file.exists()
        && let Some(name) = file.to_str()
        && let Some(published) = published()?.into_iter().find(|published| published.short == name)
    {
        return Ok(published.set);
    }
    let input = source::open(file)?;
    let named = || file.display().to_string();
    let large = |tile: &[u32; 4]| tile.iter().any(|&label| label >= u32::from(MAX_COLORS));
    let document = serde_json::from_str::<Document>(input.text().trim_start());
    if let Ok(document) = document
        && document.tiles.iter().any(large)
    {
        let kind: Kind = document.kind.parse().with_context(named)?;
        return Set::new(kind, document.tiles).with_context(named);
    }
    // Faults are told with line and column, also tiles that are listed twice.
    read_tile_set(&input, None)?;
    let listed = read_listed_tiles(&input, None)?;
    let sides = listed.tiles.iter().map(|&tile| listed.kind.unpack(tile, listed.colors));
    let order = |sides: [u8; 4]| match listed.kind {
        // NE, SE, SW, NW to NW, NE, SE, SW.
        Kind::Corner => [sides[3], sides[0], sides[1], sides[2]],
        _ => sides,
    };
    let tiles = sides.map(|sides| order(sides).map(u32::from)).collect();
    Set::new(listed.kind, tiles).with_context(named)
}

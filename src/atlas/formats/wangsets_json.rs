//! The wangsets of a tile set of Tiled in JSON, or of those in a map.

use super::wangsets::{Malformed, Raw, RawSet, RawTile};
use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::value::RawValue;

/// The tile sets of a map.
#[derive(Debug, Deserialize)]
struct Map<'a> {
    #[serde(borrow, default)]
    tilesets: Vec<Tileset<'a>>,
}

#[derive(Debug, Deserialize)]
struct Tileset<'a> {
    #[serde(borrow, default)]
    wangsets: Vec<Wangset<'a>>,
    #[serde(default)]
    transformations: Transformations,
    #[serde(default)]
    source: Option<String>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Transformations {
    hflip: bool,
    vflip: bool,
    rotate: bool,
}

#[derive(Debug, Deserialize)]
struct Wangset<'a> {
    #[serde(default)]
    name: String,
    #[serde(default, rename = "type")]
    kind: String,
    #[serde(default)]
    colors: Vec<IgnoredAny>,
    #[serde(borrow, default)]
    wangtiles: Vec<Wangtile<'a>>,
}

#[derive(Debug, Deserialize)]
struct Wangtile<'a> {
    tileid: u64,
    #[serde(borrow)]
    wangid: &'a RawValue,
}

/// Reads all wangsets.
///
/// # Errors
/// Text that is no JSON, or whose fields are of other types.
pub(super) fn read(text: &str) -> Result<Raw, Malformed> {
    let begin = text.len() - text.trim_start_matches('\u{feff}').len();
    let wrong = |error: serde_json::Error| {
        let mut message = error.to_string();
        if let Some(end) = message.rfind(" at line ") {
            message.truncate(end);
        }
        Malformed { line: error.line(), column: error.column(), message }
    };
    let mut tilesets = serde_json::from_str::<Map<'_>>(&text[begin..]).map_err(wrong)?.tilesets;
    tilesets.push(serde_json::from_str(&text[begin..]).map_err(wrong)?);
    let mut raw = Raw::default();
    for tileset in tilesets {
        let Transformations { hflip, vflip, rotate } = tileset.transformations;
        raw.transformed |= hflip || vflip || rotate;
        raw.elsewhere.extend(tileset.source);
        for wangset in tileset.wangsets {
            raw.wangsets.push(read_set(text, &wangset));
        }
    }
    Ok(raw)
}

fn read_set(text: &str, wangset: &Wangset<'_>) -> RawSet {
    // A wangset is found by its first tile: what is borrowed from the text knows its place.
    let place = |part: &str| (part.as_ptr() as usize).saturating_sub(text.as_ptr() as usize);
    let tiles: Vec<RawTile> = wangset
        .wangtiles
        .iter()
        .map(|tile| {
            let numbers = tile.wangid.get();
            let wangid = numbers.trim_start_matches('[').trim_end_matches(']').trim().to_owned();
            RawTile { id: tile.tileid, wangid, at: place(numbers) }
        })
        .collect();
    RawSet {
        name: wangset.name.clone(),
        kind: wangset.kind.clone(),
        colors: wangset.colors.len(),
        at: tiles.first().map_or(0, |tile| tile.at),
        tiles,
    }
}

//! From a tile set of the map editor Tiled to its colors: `.tsx`, `.tsj`, or a map (`.tmx`,
//! `.tmj`) that holds its tile set itself.
//!
//! Tiled gives each tile a *wangid*, eight colors clockwise from the top ([`super::tiled`]).
//! A set of ours has tiles with four colors each. In a hand-drawn set one color list serves all
//! edges. The horizontal and the vertical ones never meet, so where no color is on both they get
//! palettes of their own, in the order of the list. Where some are on both, one palette holds
//! all: the tiles may then also be turned. Colors that no tile shows are left out.
//!
//! Whatever is not clear is refused, with line and column.

use super::{wangsets_json, wangsets_xml};
use crate::tiles::{Colors, Kind, Members, TileId, TileSet};
use std::collections::{HashMap, HashSet};

/// A file that cannot be understood, or not be taken as a tile set.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{line}:{column}: {message}")]
pub struct Malformed {
    /// 1-based line.
    pub line: usize,
    /// 1-based column, in characters.
    pub column: usize,
    /// What is wrong and what was expected.
    pub message: String,
}

/// What to do where a file leaves a choice.
#[derive(Debug, Clone, Copy, Default)]
pub struct Choice<'a> {
    /// The name of the wangset; needed where there are several.
    pub wangset: Option<&'a str>,
    /// Of tiles with the same colors keep the first instead of refusing them.
    pub keep_first: bool,
    /// Leave tiles with unset colors out instead of refusing them.
    pub skip_unset: bool,
}

/// The tiles of a wangset.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wangset {
    /// Its name.
    pub name: String,
    /// Its tiles.
    pub set: TileSet,
    /// The number of every tile in Tiled, increasing, and its number among ours.
    pub tiles: Vec<(u64, TileId)>,
    /// Colors of Tiled, which count from 1, that our colors 0, 1, 2, ... stand for: on corners or
    /// horizontal edges, and on vertical edges.
    pub colors: [Vec<usize>; 2],
    /// Tiles that were left out because another one, named second, has the same colors.
    pub doubles: Vec<(u64, u64)>,
    /// Tiles that were left out because colors are unset.
    pub unset: Vec<u64>,
    /// Whether Tiled may flip or rotate these tiles, which ours are not.
    pub transformed: bool,
}

/// A file as it stands there.
#[derive(Debug, Default)]
pub(super) struct Raw {
    pub(super) wangsets: Vec<RawSet>,
    pub(super) transformed: bool,
    /// Tile sets that a map names but does not hold.
    pub(super) elsewhere: Vec<String>,
}

/// A wangset as it stands in a file.
#[derive(Debug)]
pub(super) struct RawSet {
    pub(super) name: String,
    /// `corner`, `edge`, `mixed`, or nothing before Tiled 1.5.
    pub(super) kind: String,
    pub(super) colors: usize,
    pub(super) tiles: Vec<RawTile>,
    /// Where it stands, in bytes.
    pub(super) at: usize,
}

/// A tile as it stands in a file.
#[derive(Debug)]
pub(super) struct RawTile {
    pub(super) id: u64,
    /// Numbers with commas between them.
    pub(super) wangid: String,
    pub(super) at: usize,
}

/// What is wrong at a byte of a text.
pub(super) fn malformed(text: &str, at: usize, message: impl Into<String>) -> Malformed {
    let before = text.get(..at).unwrap_or(text);
    let line = before.rfind('\n').map_or(0, |end| end + 1);
    Malformed {
        line: before.matches('\n').count() + 1,
        column: before[line..].chars().count() + 1,
        message: message.into(),
    }
}

/// Reads the tiles of a wangset, in the order of their numbers in Tiled.
///
/// # Errors
/// Another format, several wangsets and none chosen, colors that are unset, unknown or malformed,
/// edges and corners at once, two tiles with the same colors.
pub fn read(text: &str, choice: Choice<'_>) -> Result<Wangset, Malformed> {
    let start = text.len() - text.trim_start_matches('\u{feff}').trim_start().len();
    let raw = match text[start..].chars().next() {
        Some('<') => wangsets_xml::read(text)?,
        Some('{') => wangsets_json::read(text)?,
        _ => {
            let message =
                "expected a tile set or map of Tiled: XML (.tsx, .tmx) or JSON (.tsj, .tmj)";
            return Err(malformed(text, start, message));
        }
    };
    let chosen = choose(text, start, &raw, choice.wangset)?;
    let reader = Reader { text, raw: chosen };
    let mut tiles = reader.tiles(choice.skip_unset)?;
    let kind = reader.kind(&tiles.colored)?;
    tiles.colored.sort_by_key(|tile| tile.id);
    let mut set = reader.set(kind, tiles, choice.keep_first)?;
    set.transformed = raw.transformed;
    Ok(set)
}

/// The wangset in question.
fn choose<'a>(
    text: &str,
    start: usize,
    raw: &'a Raw,
    name: Option<&str>,
) -> Result<&'a RawSet, Malformed> {
    let names: Vec<String> = raw.wangsets.iter().map(|set| format!("'{}'", set.name)).collect();
    match (&raw.wangsets[..], name) {
        ([], _) => {
            let message = match raw.elsewhere.first() {
                Some(source) => format!("the map does not hold its tile set; import {source}"),
                None => "no wangset (in Tiled: terrain set) in the file".to_owned(),
            };
            Err(malformed(text, start, message))
        }
        ([only], None) => Ok(only),
        (several, None) => {
            let message = format!("{} wangsets: choose one of {}", several.len(), names.join(", "));
            Err(malformed(text, several[1].at, message))
        }
        (sets, Some(name)) => {
            let mut named = sets.iter().filter(|set| set.name == name);
            match (named.next(), named.next()) {
                (Some(set), None) => Ok(set),
                (Some(_), Some(other)) => {
                    Err(malformed(text, other.at, format!("a second wangset '{name}'")))
                }
                (None, _) => {
                    let message = format!("no wangset '{name}': expected {}", names.join(" or "));
                    Err(malformed(text, start, message))
                }
            }
        }
    }
}

/// A tile with its colors, from 1, 0 where there is none.
struct Colored {
    id: u64,
    wangid: [usize; 8],
    at: usize,
}

/// Tiles with all their colors, and others.
struct Tiles {
    colored: Vec<Colored>,
    unset: Vec<u64>,
}

struct Reader<'a> {
    text: &'a str,
    raw: &'a RawSet,
}

/// Places of the colors in a wangid.
const EDGES: [usize; 4] = [0, 2, 4, 6];
const CORNERS: [usize; 4] = [1, 3, 5, 7];

impl Reader<'_> {
    fn error(&self, at: usize, message: impl Into<String>) -> Malformed {
        malformed(self.text, at, message)
    }

    /// The tiles whose colors are all there.
    fn tiles(&self, skip_unset: bool) -> Result<Tiles, Malformed> {
        let mut seen = HashSet::new();
        let mut tiles = Tiles { colored: Vec::new(), unset: Vec::new() };
        for tile in &self.raw.tiles {
            let id = tile.id;
            if !seen.insert(id) {
                return Err(self.error(tile.at, format!("tile {id} has a second wangid")));
            }
            let wangid = self.wangid(tile)?;
            let used = |places: [usize; 4]| places.iter().filter(|&&i| wangid[i] > 0).count();
            match (used(EDGES), used(CORNERS)) {
                (4, 0) | (0, 4) => tiles.colored.push(Colored { id, wangid, at: tile.at }),
                (1.., 1..) => {
                    let message = format!(
                        "tile {id} has colors on edges and on corners (wangid {}): expected one \
                         or the other",
                        tile.wangid
                    );
                    return Err(self.error(tile.at, message));
                }
                // Tiled takes a tile without any color for one that is not in the set.
                (0, 0) => {}
                _ if skip_unset => tiles.unset.push(id),
                _ => {
                    let message = format!(
                        "tile {id} has unset colors (wangid {}): set them, or leave such tiles \
                         out with --skip-unset",
                        tile.wangid
                    );
                    return Err(self.error(tile.at, message));
                }
            }
        }
        if tiles.colored.is_empty() {
            let message = format!("wangset '{}' has no tile with colors", self.raw.name);
            return Err(self.error(self.raw.at, message));
        }
        Ok(tiles)
    }

    fn wangid(&self, tile: &RawTile) -> Result<[usize; 8], Malformed> {
        let id = tile.id;
        let numbers: Option<Vec<usize>> =
            tile.wangid.split(',').map(|number| number.trim().parse().ok()).collect();
        let wangid = numbers.and_then(|numbers| <[usize; 8]>::try_from(numbers).ok());
        let Some(wangid) = wangid else {
            let old = if tile.wangid.starts_with("0x") {
                "; it was saved by Tiled before 1.5: open it and save it with a later one"
            } else {
                ""
            };
            let message = format!(
                "tile {id}: wangid '{}': expected eight numbers with commas between them{old}",
                tile.wangid
            );
            return Err(self.error(tile.at, message));
        };
        if let Some(color) = wangid.iter().find(|&&color| color > self.raw.colors) {
            let message =
                format!("tile {id}: color {color}: the wangset has {} colors", self.raw.colors);
            return Err(self.error(tile.at, message));
        }
        Ok(wangid)
    }

    /// What carries the colors; all tiles must agree, and the type must be that or `mixed`.
    fn kind(&self, tiles: &[Colored]) -> Result<Kind, Malformed> {
        let of = |tile: &Colored| if tile.wangid[0] > 0 { Kind::Wang } else { Kind::Corner };
        let said = match self.raw.kind.as_str() {
            "corner" => Some(Kind::Corner),
            "edge" => Some(Kind::Wang),
            "mixed" | "" => None,
            other => {
                let message = format!("wangset of type '{other}': expected corner, edge or mixed");
                return Err(self.error(self.raw.at, message));
            }
        };
        let kind = said.unwrap_or_else(|| tiles.first().map_or(Kind::Corner, of));
        match tiles.iter().find(|tile| of(tile) != kind) {
            None => Ok(kind),
            Some(tile) => {
                let word = |kind| if kind == Kind::Wang { "edges" } else { "corners" };
                let message = format!(
                    "tile {} has its colors on {}, but {} on {}",
                    tile.id,
                    word(of(tile)),
                    if said.is_some() { "the wangset has them" } else { "others have them" },
                    word(kind)
                );
                Err(self.error(tile.at, message))
            }
        }
    }

    fn set(&self, kind: Kind, tiles: Tiles, keep_first: bool) -> Result<Wangset, Malformed> {
        let whole = |error: crate::tiles::TileError| self.error(self.raw.at, error.to_string());
        let sides = if kind == Kind::Wang { EDGES } else { CORNERS };
        let colors = palettes(kind, &tiles.colored);
        let counts = match kind {
            Kind::Wang => Colors::pair(colors[0].len() as u64, colors[1].len() as u64),
            _ => Colors::one(colors[0].len() as u64),
        };
        let counts = counts.map_err(whole)?;
        let mut first: HashMap<TileId, u64> = HashMap::new();
        let mut listed = Vec::new();
        let mut doubles = Vec::new();
        for tile in &tiles.colored {
            let mut packed = [0; 4];
            for (side, place) in sides.into_iter().enumerate() {
                let palette = &colors[if kind == Kind::Wang { side % 2 } else { 0 }];
                packed[side] = palette.binary_search(&tile.wangid[place]).unwrap_or(0) as u8;
            }
            let id = kind.pack(&packed, counts).map_err(whole)?;
            match first.get(&id) {
                None => {
                    first.insert(id, tile.id);
                    listed.push((tile.id, id));
                }
                Some(&before) if keep_first => doubles.push((tile.id, before)),
                Some(before) => {
                    let message = format!(
                        "tile {} has the same colors as tile {before} ({}): keep one of them, or \
                         the first of all such tiles with --keep-first",
                        tile.id,
                        kind.describe(id, counts)
                    );
                    return Err(self.error(tile.at, message));
                }
            }
        }
        let members = Members::Explicit(listed.iter().map(|&(_, tile)| tile).collect());
        Ok(Wangset {
            name: self.raw.name.clone(),
            set: TileSet::new(kind, counts, members).map_err(whole)?,
            tiles: listed,
            colors,
            doubles,
            unset: tiles.unset,
            transformed: false,
        })
    }
}

/// The colors of Tiled, sorted, on corners or horizontal edges, and on vertical edges.
fn palettes(kind: Kind, tiles: &[Colored]) -> [Vec<usize>; 2] {
    let of = |places: &[usize]| {
        let colors = tiles.iter().flat_map(|tile| places.iter().map(|&place| tile.wangid[place]));
        let mut colors: Vec<usize> = colors.collect();
        colors.sort_unstable();
        colors.dedup();
        colors
    };
    if kind == Kind::Corner {
        return [of(&CORNERS), Vec::new()];
    }
    let (horizontal, vertical) = (of(&[0, 4]), of(&[2, 6]));
    let shared = horizontal.iter().any(|color| vertical.binary_search(color).is_ok());
    if shared { [of(&EDGES), of(&EDGES)] } else { [horizontal, vertical] }
}

//! Tile set JSON: a list of tiles by their colors.
//!
//! Colors are listed clockwise as people draw tiles: N, E, S, W for Wang tiles, **NW, NE, SE,
//! SW** for corner tiles (unlike the digits of a tile number, which begin with NE), first and
//! second for dominoes. Without `colors`, the palettes are the smallest that hold every color.

use super::json::{ColorCounts, Field, Number, json_error};
use super::{Input, StoreError};
use crate::tiles::{Colors, Kind, MAX_COLORS, Members, TileError, TileId, TileSet};
use serde::Deserialize;
use serde::de::{self, DeserializeSeed, Deserializer, SeqAccess, Visitor};
use serde_json::value::RawValue;
use std::collections::HashSet;
use std::fmt;
use std::io::{self, Write};

/// A tile set from a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedSet {
    /// The tiles.
    pub set: TileSet,
    /// What it is called.
    pub name: Option<String>,
    /// Where it comes from.
    pub source: Option<String>,
}

#[derive(Debug, Deserialize)]
struct Document<'a> {
    #[serde(borrow)]
    kind: Option<&'a RawValue>,
    #[serde(borrow)]
    colors: Option<&'a RawValue>,
    #[serde(borrow)]
    name: Option<&'a RawValue>,
    #[serde(borrow)]
    source: Option<&'a RawValue>,
    #[serde(borrow)]
    tiles: Option<&'a RawValue>,
}

/// Reads a tile set. `colors`, if given, are the palettes to use (for dominoes those of the
/// ring); else they are those of the file, else the smallest that hold its colors.
///
/// # Errors
/// A malformed file, a color outside the palettes, a tile listed twice, no tile at all, or
/// palettes in the file other than `colors`.
pub fn read_tile_set(input: &Input, colors: Option<Colors>) -> Result<NamedSet, StoreError> {
    read(input, colors, false)
}

/// Reads a set of squares that may be turned: Wang tiles with one palette for all edges, which
/// may be listed again.
///
/// # Errors
/// As [`read_tile_set`], but for tiles listed twice; another kind, or two palettes.
pub fn read_squares(input: &Input, colors: Option<Colors>) -> Result<NamedSet, StoreError> {
    read(input, colors, true)
}

/// Tiles in the order in which a file lists them, as a sheet of pictures shows them; any of them
/// may be listed again.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ListedTiles {
    /// What carries the colors.
    pub kind: Kind,
    /// The palettes.
    pub colors: Colors,
    /// The tiles.
    pub tiles: Vec<TileId>,
}

/// Reads a tile set file as a list.
///
/// # Errors
/// As [`read_tile_set`], but for tiles listed twice.
pub fn read_listed_tiles(input: &Input, colors: Option<Colors>) -> Result<ListedTiles, StoreError> {
    let (tiles, _) = read_list(input, colors, false, true)?;
    Ok(tiles)
}

fn read(input: &Input, colors: Option<Colors>, squares: bool) -> Result<NamedSet, StoreError> {
    let (list, fields) = read_list(input, colors, squares, squares)?;
    let ListedTiles { kind, colors, tiles } = list;
    let set = match squares {
        true => TileSet::squares(colors, tiles),
        false => TileSet::new(kind, colors, Members::Explicit(tiles)),
    };
    let set = set.map_err(|error| fields.tiles.error(error))?;
    Ok(NamedSet { set, name: fields.name, source: fields.source })
}

/// What a file says besides its tiles, and where they stand.
struct Around<'a> {
    tiles: Field<'a>,
    name: Option<String>,
    source: Option<String>,
}

/// The tiles as they are listed; for `squares` with one palette.
fn read_list(
    input: &Input,
    colors: Option<Colors>,
    squares: bool,
    repeated: bool,
) -> Result<(ListedTiles, Around<'_>), StoreError> {
    let start = input.start();
    let text = &input.text()[start..];
    if !text.starts_with('{') {
        return Err(input.error_at(start, "expected '{', the beginning of a tile set"));
    }
    let fields: Document<'_> =
        serde_json::from_str(text).map_err(|error| json_error(input, start, text, &error))?;
    let kind_field = Field::required(input, start, "kind", fields.kind)?;
    let kind = kind_field.kind()?;
    if squares && kind != Kind::Wang {
        return Err(kind_field.error(format!("{kind} tiles are not turned: only Wang tiles are")));
    }
    let colors = match Field::optional(input, fields.colors) {
        None => colors,
        Some(field) => {
            let said = field.read(ColorCounts)?;
            check_palettes(kind, said).map_err(|message| field.error(message))?;
            if let Some(asked) = colors.filter(|&asked| asked != said) {
                let message = format!("colors {said} in the file, but {asked} was asked for");
                return Err(field.error(message));
            }
            Some(said)
        }
    };
    let field = Field::required(input, start, "tiles", fields.tiles)?;
    if let Some(colors) = colors {
        check_palettes(kind, colors).map_err(|message| kind_field.error(message))?;
    }
    let tiles = field.read(Tiles { kind, colors, repeated })?;
    let colors = match (colors, squares) {
        (Some(colors), _) => colors,
        (None, false) => smallest(kind, &tiles).map_err(|error| field.error(error))?,
        (None, true) => {
            let both = smallest(kind, &tiles).map_err(|error| field.error(error))?;
            Colors::one(both.largest() as u64).map_err(|error| field.error(error))?
        }
    };
    let ids = tiles.iter().map(|tile| kind.pack(&tile[..kind.sides().len()], colors));
    let tiles = ids.collect::<Result<Vec<_>, _>>().map_err(|error| field.error(error))?;
    let text = |raw| match Field::optional(input, raw) {
        None => Ok(None),
        Some(field) => field.string().map(Some),
    };
    let around = Around { name: text(fields.name)?, source: text(fields.source)?, tiles: field };
    Ok((ListedTiles { kind, colors, tiles }, around))
}

/// Corner tiles and the dominoes of one ring have one palette.
fn check_palettes(kind: Kind, colors: Colors) -> Result<(), String> {
    match colors.single() {
        None if kind != Kind::Wang => {
            Err(format!("a set of {kind} tiles has one number of colors, but {colors} was given"))
        }
        _ => Ok(()),
    }
}

/// The smallest palettes that hold all colors of the tiles, whose sides are in digit order.
fn smallest(kind: Kind, tiles: &[[u8; 4]]) -> Result<Colors, TileError> {
    let largest = |sides: &[usize]| {
        let colors = tiles.iter().flat_map(|tile| sides.iter().map(|&side| u64::from(tile[side])));
        colors.max().unwrap_or(0) + 1
    };
    match kind {
        Kind::Wang => Colors::pair(largest(&[0, 2]), largest(&[1, 3])),
        Kind::Corner => Colors::one(largest(&[0, 1, 2, 3])),
        Kind::Domino => Colors::one(largest(&[0, 1])),
    }
}

/// For each color in the file, the side that it stands for, as a digit of the tile number.
fn file_order(kind: Kind) -> &'static [usize] {
    match kind {
        Kind::Corner => &[3, 0, 1, 2],
        Kind::Wang => &[0, 1, 2, 3],
        Kind::Domino => &[0, 1],
    }
}

/// The list of tiles; gives their sides in the order of the digits.
struct Tiles {
    kind: Kind,
    colors: Option<Colors>,
    /// A tile may be listed again.
    repeated: bool,
}

impl<'de> DeserializeSeed<'de> for Tiles {
    type Value = Vec<[u8; 4]>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Tiles {
    type Value = Vec<[u8; 4]>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of tiles")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let mut seen = HashSet::new();
        let mut tiles = Vec::new();
        while let Some(tile) =
            list.next_element_seed(Tile { kind: self.kind, colors: self.colors, seen: &seen })?
        {
            if !self.repeated {
                seen.insert(tile);
            }
            tiles.push(tile);
        }
        Ok(tiles)
    }
}

/// One tile that was not seen before.
struct Tile<'s> {
    kind: Kind,
    colors: Option<Colors>,
    seen: &'s HashSet<[u8; 4]>,
}

impl<'de> DeserializeSeed<'de> for Tile<'_> {
    type Value = [u8; 4];

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<[u8; 4], D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Tile<'_> {
    type Value = [u8; 4];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.kind {
            Kind::Corner => "a corner tile [NW, NE, SE, SW]",
            Kind::Wang => "a Wang tile [N, E, S, W]",
            Kind::Domino => "a domino [first, second]",
        })
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut colors: A) -> Result<[u8; 4], A::Error> {
        let radices = self.colors.map(|colors| self.kind.radices(colors));
        let mut tile = [0; 4];
        let order = file_order(self.kind);
        for (read, &side) in order.iter().enumerate() {
            let count = radices.as_ref().map_or(usize::from(MAX_COLORS), |radices| radices[side]);
            let number = Number { what: "a color", max: count as u64 - 1 };
            let color = colors.next_element_seed(number)?;
            tile[side] = color.ok_or_else(|| de::Error::invalid_length(read, &self))? as u8;
        }
        if colors.next_element::<de::IgnoredAny>()?.is_some() {
            return Err(de::Error::invalid_length(order.len() + 1, &self));
        }
        if self.seen.contains(&tile) {
            let listed: Vec<String> = order.iter().map(|&side| tile[side].to_string()).collect();
            let message = format!("tile [{}] is listed twice", listed.join(", "));
            return Err(de::Error::custom(message));
        }
        Ok(tile)
    }
}

/// Writes the tiles of a set, one a line; equal arguments give equal bytes.
///
/// # Errors
/// What `out` reports, and [`io::ErrorKind::InvalidInput`] for a compact set, which does not
/// name its tiles.
pub fn write_tile_set(
    mut out: impl Write,
    set: &TileSet,
    name: Option<&str>,
    source: Option<&str>,
) -> io::Result<()> {
    if set.is_compact() {
        let message = "a compact set does not say which its tiles are";
        return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
    }
    let (kind, colors) = (set.kind(), set.colors());
    write!(out, "{{\n  \"kind\": \"{kind}\",\n  \"colors\": ")?;
    match colors.single() {
        Some(count) => write!(out, "{count}")?,
        None => write!(out, "[{}, {}]", colors.horizontal(), colors.vertical())?,
    }
    for (key, text) in [("name", name), ("source", source)] {
        if let Some(text) = text {
            write!(out, ",\n  \"{key}\": {}", serde_json::Value::from(text))?;
        }
    }
    write!(out, ",\n  \"tiles\": [")?;
    for (i, tile) in set.allowed().enumerate() {
        let sides = kind.unpack(tile, colors);
        let listed: Vec<_> = file_order(kind).iter().map(|&side| sides[side].to_string()).collect();
        write!(out, "{}\n    [{}]", if i > 0 { "," } else { "" }, listed.join(", "))?;
    }
    out.write_all(b"\n  ]\n}\n")
}

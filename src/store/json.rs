//! JSON values with their positions in the file.
//!
//! What a value must be often depends on another one (the range of a tile on the colors) and the
//! fields of an object may come in any order. So an object is first split into the texts of its
//! fields, which is cheap, and each text is then read when what it depends on is known. Being
//! parts of the text of the file, they know where they stand.

use super::{Input, StoreError};
use crate::tiles::{Color, Colors, Kind, Members, TileId};
use crate::torus::{Cell, Shape};
use serde::de::{self, DeserializeSeed, Deserializer, IgnoredAny, SeqAccess, Unexpected, Visitor};
use serde_json::value::RawValue;
use std::fmt;

/// The text of one field of an object.
#[derive(Debug, Clone, Copy)]
pub(super) struct Field<'a> {
    input: &'a Input,
    raw: &'a RawValue,
}

impl<'a> Field<'a> {
    /// The field `name` of an object that begins at `object`.
    pub(super) fn required(
        input: &'a Input,
        object: usize,
        name: &str,
        raw: Option<&'a RawValue>,
    ) -> Result<Self, StoreError> {
        match raw {
            Some(raw) => Ok(Self { input, raw }),
            None => Err(input.error_at(object, format!("expected a field \"{name}\""))),
        }
    }

    /// The same, or `None` when the object lacks it.
    pub(super) fn optional(input: &'a Input, raw: Option<&'a RawValue>) -> Option<Self> {
        raw.map(|raw| Self { input, raw })
    }

    /// An error at the beginning of the field.
    pub(super) fn error(&self, message: impl fmt::Display) -> StoreError {
        self.input.error_at(self.offset(), message.to_string())
    }

    /// Reads the value.
    pub(super) fn read<S: DeserializeSeed<'a>>(&self, seed: S) -> Result<S::Value, StoreError> {
        let mut deserializer = serde_json::Deserializer::from_str(self.raw.get());
        seed.deserialize(&mut deserializer)
            .map_err(|error| json_error(self.input, self.offset(), self.raw.get(), &error))
    }

    /// Reads a string.
    pub(super) fn string(&self) -> Result<String, StoreError> {
        self.read(std::marker::PhantomData)
    }

    /// Reads a string that must be one of a few.
    pub(super) fn word(&self, what: &str, known: &[&str]) -> Result<(), StoreError> {
        let found = self.string()?;
        if known.contains(&found.as_str()) {
            return Ok(());
        }
        let known: Vec<String> = known.iter().map(|word| format!("\"{word}\"")).collect();
        Err(self.error(format!("{what} {found:?}: expected {}", known.join(" or "))))
    }

    /// Reads a kind of tile.
    pub(super) fn kind(&self) -> Result<Kind, StoreError> {
        self.string()?.parse().map_err(|error| self.error(error))
    }

    fn offset(&self) -> usize {
        self.raw.get().as_ptr() as usize - self.input.text().as_ptr() as usize
    }
}

/// Places an error of serde_json, found in `text`, which stands at `start` in the file.
pub(super) fn json_error(
    input: &Input,
    start: usize,
    text: &str,
    error: &serde_json::Error,
) -> StoreError {
    let mut message = error.to_string();
    if let Some(position) = message.rfind(" at line ") {
        message.truncate(position);
    }
    let line = text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum();
    let bytes = text.as_bytes();
    let mut offset: usize = line;
    offset = (offset + error.column().saturating_sub(1)).min(bytes.len());
    // A value is found wrong when it has been read: go back to where it begins.
    if error.is_data() {
        let part = |&b: &u8| b.is_ascii_alphanumeric() || matches!(b, b'-' | b'+' | b'.');
        if bytes.get(offset) == Some(&b'"') {
            offset = bytes[..offset].iter().rposition(|&b| b == b'"').unwrap_or(offset);
        } else if bytes.get(offset).is_some_and(part) {
            offset -= bytes[..offset].iter().rev().take_while(|b| part(b)).count();
        }
    }
    input.error_at(start + offset, message)
}

/// A number from 0 to `max`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Number {
    pub(super) what: &'static str,
    pub(super) max: u64,
}

impl<'de> DeserializeSeed<'de> for Number {
    type Value = u64;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<u64, D::Error> {
        deserializer.deserialize_u64(self)
    }
}

impl Visitor<'_> for Number {
    type Value = u64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.max {
            u64::MAX => f.write_str(self.what),
            max => write!(f, "{} from 0 to {max}", self.what),
        }
    }

    fn visit_u64<E: de::Error>(self, number: u64) -> Result<u64, E> {
        if number > self.max {
            return Err(E::invalid_value(Unexpected::Unsigned(number), &self));
        }
        Ok(number)
    }
}

/// A number, or `null` for a free cell where `free` allows it.
#[derive(Debug, Clone, Copy)]
pub(super) struct CellNumber {
    pub(super) number: Number,
    pub(super) free: bool,
}

impl<'de> DeserializeSeed<'de> for CellNumber {
    type Value = Option<u64>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        if self.free {
            deserializer.deserialize_any(self)
        } else {
            self.number.deserialize(deserializer).map(Some)
        }
    }
}

impl Visitor<'_> for CellNumber {
    type Value = Option<u64>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.number.expecting(f)?;
        f.write_str(" or null")
    }

    fn visit_u64<E: de::Error>(self, number: u64) -> Result<Self::Value, E> {
        self.number.visit_u64(number).map(Some)
    }

    fn visit_unit<E: de::Error>(self) -> Result<Self::Value, E> {
        Ok(None)
    }
}

/// The tiles of a torus by row. They are passed on one by one, so that a large file does not
/// need memory for rows of rows.
pub(super) struct Rows<F> {
    pub(super) shape: Shape,
    pub(super) cell: CellNumber,
    pub(super) take: F,
}

impl<'de, F: FnMut(Cell, Option<u64>)> DeserializeSeed<'de> for Rows<F> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de, F: FnMut(Cell, Option<u64>)> Visitor<'de> for Rows<F> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of rows of tiles")
    }

    fn visit_seq<A: SeqAccess<'de>>(mut self, mut rows: A) -> Result<(), A::Error> {
        let height = self.shape.height();
        for row in 0..height {
            let seed = Row { rows: &mut self, row };
            if rows.next_element_seed(seed)?.is_none() {
                let message = format!("{row} of {height} rows of tiles, the height");
                return Err(de::Error::custom(message));
            }
        }
        if rows.next_element::<IgnoredAny>()?.is_some() {
            let message = format!("more rows of tiles than {height}, the height");
            return Err(de::Error::custom(message));
        }
        Ok(())
    }
}

struct Row<'r, F> {
    rows: &'r mut Rows<F>,
    row: usize,
}

impl<'de, F: FnMut(Cell, Option<u64>)> DeserializeSeed<'de> for Row<'_, F> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de, F: FnMut(Cell, Option<u64>)> Visitor<'de> for Row<'_, F> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "row {}, a list of tiles", self.row)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut tiles: A) -> Result<(), A::Error> {
        let (shape, row) = (self.rows.shape, self.row);
        let width = shape.width();
        for column in 0..width {
            let Some(tile) = tiles.next_element_seed(self.rows.cell)? else {
                let message = format!("row {row} has {column} of {width} tiles, the width");
                return Err(de::Error::custom(message));
            };
            (self.rows.take)(shape.cell(row, column), tile);
        }
        if tiles.next_element::<IgnoredAny>()?.is_some() {
            let message = format!("row {row} has more tiles than {width}, the width");
            return Err(de::Error::custom(message));
        }
        Ok(())
    }
}

/// `3`, or `[2, 3]`: a number of colors, or one for horizontal and one for vertical edges.
pub(super) struct ColorCounts;

impl<'de> DeserializeSeed<'de> for ColorCounts {
    type Value = Colors;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Colors, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for ColorCounts {
    type Value = Colors;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number of colors, or [CH, CV] for Wang tiles and dominoes")
    }

    fn visit_u64<E: de::Error>(self, count: u64) -> Result<Colors, E> {
        Colors::one(count).map_err(E::custom)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut counts: A) -> Result<Colors, A::Error> {
        let length = |n| de::Error::invalid_length(n, &ColorCounts);
        let number = Number { what: "a number of colors", max: u64::MAX };
        let horizontal = counts.next_element_seed(number)?.ok_or_else(|| length(0))?;
        let vertical = counts.next_element_seed(number)?.ok_or_else(|| length(1))?;
        if counts.next_element::<IgnoredAny>()?.is_some() {
            return Err(length(3));
        }
        Colors::pair(horizontal, vertical).map_err(de::Error::custom)
    }
}

/// `"complete"`, `"compact"`, `{"pruned": [[0,1]]}` or `{"tiles": [5, 7]}`.
pub(super) struct SetMembers {
    pub(super) tile: Number,
    pub(super) color: Number,
}

impl<'de> DeserializeSeed<'de> for SetMembers {
    type Value = Members;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Members, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for SetMembers {
    type Value = Members;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(r#""complete", "compact", {"pruned": [[A,B],...]} or {"tiles": [N,...]}"#)
    }

    fn visit_str<E: de::Error>(self, word: &str) -> Result<Members, E> {
        match word {
            "complete" => Ok(Members::Complete),
            "compact" => Ok(Members::Compact),
            _ => Err(E::invalid_value(Unexpected::Str(word), &self)),
        }
    }

    fn visit_map<A: de::MapAccess<'de>>(self, mut map: A) -> Result<Members, A::Error> {
        let key = map.next_key::<String>()?;
        let members = match key.as_deref() {
            Some("pruned") => {
                let color = List { what: "two colors", item: self.color };
                let pairs = List { what: "a list of pairs of colors", item: color };
                let pair = |pair: Vec<u64>| match pair[..] {
                    [a, b] => Ok((Color(a as u8), Color(b as u8))),
                    _ => Err(de::Error::invalid_length(pair.len(), &"a pair of two colors")),
                };
                let pairs = map.next_value_seed(pairs)?;
                Members::Pruned(pairs.into_iter().map(pair).collect::<Result<_, _>>()?)
            }
            Some("tiles") => {
                let tiles = List { what: "a list of tile numbers", item: self.tile };
                let tiles = map.next_value_seed(tiles)?;
                Members::Explicit(tiles.into_iter().map(|tile| TileId(tile as u32)).collect())
            }
            _ => return Err(de::Error::invalid_value(Unexpected::Map, &self)),
        };
        match map.next_key::<String>()? {
            None => Ok(members),
            Some(_) => Err(de::Error::custom("a set is either pruned or a list of tiles")),
        }
    }
}

/// A list of things of one sort.
#[derive(Debug, Clone, Copy)]
pub(super) struct List<S> {
    pub(super) what: &'static str,
    pub(super) item: S,
}

impl<'de, S: DeserializeSeed<'de> + Copy> DeserializeSeed<'de> for List<S> {
    type Value = Vec<S::Value>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de, S: DeserializeSeed<'de> + Copy> Visitor<'de> for List<S> {
    type Value = Vec<S::Value>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.what)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Self::Value, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = items.next_element_seed(self.item)? {
            list.push(item);
        }
        Ok(list)
    }
}

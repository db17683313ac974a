//! Solution JSON: one packing as one object, `tilepack/1`.
//!
//! Fields may come in any order. Fields that are not known are ignored, so that later versions
//! can add some; a known field of the wrong type is an error, and so is another format or
//! topology. The provenance is kept but never trusted.

use super::border::{border_of, border_value};
use super::claim::{Claim, ring_colors};
use super::json::{CellNumber, ColorCounts, Field, Number, Rows, SetMembers};
use super::{Input, StoreError};
use crate::tiles::{Kind, Members, TileId, TileSet};
use crate::torus::{Board, Border, Cell, Packing, Shape, Topology};
use serde::Deserialize;
use serde_json::value::RawValue;
use serde_json::{Value, json};
use std::io::{self, Write};

/// A packing from a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// The tiles, and what the file claims that they are. Not verified.
    pub packing: Packing,
    /// What the file says about where it comes from, `null` if nothing. Not to be trusted.
    pub provenance: Value,
    /// The line of the file where it begins, 1-based.
    pub line: usize,
}

/// The version of the format that is read and written.
pub const FORMAT: &str = "tilepack/1";

/// The fields of a solution, or of pins, as text.
#[derive(Debug, Deserialize)]
pub(super) struct Document<'a> {
    #[serde(borrow)]
    format: Option<&'a RawValue>,
    #[serde(borrow)]
    kind: Option<&'a RawValue>,
    #[serde(borrow)]
    colors: Option<&'a RawValue>,
    #[serde(borrow)]
    set: Option<&'a RawValue>,
    #[serde(borrow)]
    cover: Option<&'a RawValue>,
    #[serde(borrow)]
    width: Option<&'a RawValue>,
    #[serde(borrow)]
    height: Option<&'a RawValue>,
    #[serde(borrow)]
    topology: Option<&'a RawValue>,
    #[serde(borrow)]
    border: Option<&'a RawValue>,
    #[serde(borrow)]
    tiles: Option<&'a RawValue>,
    #[serde(borrow)]
    rotations: Option<&'a RawValue>,
    #[serde(borrow)]
    provenance: Option<&'a RawValue>,
}

/// A document within its file.
pub(super) struct Object<'a> {
    pub(super) input: &'a Input,
    /// The byte offset where it begins.
    pub(super) start: usize,
    pub(super) fields: Document<'a>,
}

impl<'a> Object<'a> {
    pub(super) fn field(
        &self,
        name: &str,
        choose: impl FnOnce(&Document<'a>) -> Option<&'a RawValue>,
    ) -> Result<Field<'a>, StoreError> {
        Field::required(self.input, self.start, name, choose(&self.fields))
    }

    /// The kind, colors and size, with the colors those of a ring for dominoes. The set is
    /// complete: all tiles that can occur.
    pub(super) fn frame(&self) -> Result<(TileSet, Shape), StoreError> {
        self.field("format", |f| f.format)?.word("format", &[FORMAT])?;
        let kind = self.field("kind", |f| f.kind)?.kind()?;
        let known = if kind == Kind::Wang { &Topology::ALL[..] } else { &Topology::ALL[..1] };
        let known: Vec<&str> = known.iter().map(|topology| topology.name()).collect();
        self.field("topology", |f| f.topology)?.word("topology", &known)?;
        let side = Number { what: "a number of cells", max: u64::from(u32::MAX) };
        let width = self.field("width", |f| f.width)?;
        let height = self.field("height", |f| f.height)?.read(side)?;
        let shape = Shape::new(width.read(side)?, height).map_err(|error| width.error(error))?;
        let field = self.field("colors", |f| f.colors)?;
        let colors = ring_colors(kind, shape, field.read(ColorCounts)?);
        let set = TileSet::new(kind, colors, Members::Complete);
        Ok((set.map_err(|error| field.error(error))?, shape))
    }

    /// Which sides meet, whether there are turns, and the border.
    pub(super) fn board(&self, shape: Shape) -> Result<Board, StoreError> {
        let field = self.field("topology", |f| f.topology)?;
        let topology = field.string()?.parse().map_err(|error: String| field.error(error))?;
        let border = match Field::optional(self.input, self.fields.border) {
            None => Border::default(),
            Some(field) => {
                let value: Value = field.read(std::marker::PhantomData)?;
                border_of(&value, topology, shape).map_err(|error| field.error(error))?
            }
        };
        Ok(Board { topology, rotations: self.fields.rotations.is_some(), border })
    }

    /// Passes the quarter turns on, row by row; `null` is a free cell where `free` allows it.
    pub(super) fn turns(
        &self,
        shape: Shape,
        free: bool,
        take: impl FnMut(Cell, Option<u64>),
    ) -> Result<(), StoreError> {
        let number = Number { what: "a number of quarter turns", max: 3 };
        let cell = CellNumber { number, free };
        self.field("rotations", |f| f.rotations)?.read(Rows { shape, cell, take })
    }

    /// Passes the tiles on, row by row; `null` is a free cell where `free` allows it.
    pub(super) fn tiles(
        &self,
        all: &TileSet,
        shape: Shape,
        free: bool,
        take: impl FnMut(Cell, Option<u64>),
    ) -> Result<(), StoreError> {
        let cell = CellNumber { number: tile_number(all), free };
        self.field("tiles", |f| f.tiles)?.read(Rows { shape, cell, take })
    }

    /// The packing and its provenance.
    pub(super) fn packing(&self, claim: &Claim) -> Result<(Packing, Value), StoreError> {
        let (all, shape) = self.frame()?;
        let color = Number { what: "a color", max: all.colors().largest() as u64 - 1 };
        let field = self.field("set", |f| f.set)?;
        let members = field.read(SetMembers { tile: tile_number(&all), color })?;
        let board = self.board(shape)?;
        let set = match members {
            Members::Explicit(tiles) if board.rotations && all.kind() == Kind::Wang => {
                TileSet::squares(all.colors(), tiles)
            }
            members => TileSet::new(all.kind(), all.colors(), members),
        };
        let set = set.map_err(|error| field.error(error))?;
        let cover = match Field::optional(self.input, self.fields.cover) {
            None => false,
            Some(field) => field.read(std::marker::PhantomData)?,
        };
        match claim.contradiction(&set, shape, cover) {
            Ok(None) => {}
            Ok(Some(message)) => return Err(self.input.error_at(self.start, message)),
            Err(error) => return Err(self.input.error_at(self.start, error.to_string())),
        }
        let provenance = match Field::optional(self.input, self.fields.provenance) {
            None => Value::Null,
            Some(field) => field.read(std::marker::PhantomData)?,
        };
        let mut tiles = Vec::new();
        self.tiles(&all, shape, false, |_, tile| {
            tiles.extend(tile.map(|tile| TileId(tile as u32)));
        })?;
        let mut turns = Vec::new();
        if board.rotations {
            self.turns(shape, false, |_, turn| turns.extend(turn.map(|turn| turn as u8)))?;
        }
        Ok((Packing { board, turns, ..Packing::new(set, shape, cover, tiles) }, provenance))
    }
}

fn tile_number(all: &TileSet) -> Number {
    Number { what: "a tile number", max: all.kind().tiles(all.colors()) - 1 }
}

/// How a solution is laid out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    /// One field a line, one row of tiles a line.
    Pretty,
    /// All on one line, for lists.
    Line,
}

/// Writes a packing as solution JSON, ending in a newline; equal arguments give equal bytes.
///
/// `provenance` is written as it is, unless it is `null`.
///
/// # Errors
/// What `out` reports.
pub fn write_solution(
    out: impl Write,
    packing: &Packing,
    provenance: &Value,
    layout: Layout,
) -> io::Result<()> {
    let rows = |take: &mut TakeRow<'_>| packing.rows().try_for_each(take);
    write_solution_rows(out, packing, provenance, layout, rows)
}

/// What is done with each row of tiles.
pub type TakeRow<'a> = dyn FnMut(&[TileId]) -> io::Result<()> + 'a;

/// As [`write_solution`] for a packing that is never whole: `about` says what it is, its tiles
/// are not looked at, and `rows` gives the rows from the north.
///
/// # Errors
/// What `out` or `rows` reports.
pub fn write_solution_rows(
    mut out: impl Write,
    about: &Packing,
    provenance: &Value,
    layout: Layout,
    rows: impl FnOnce(&mut TakeRow<'_>) -> io::Result<()>,
) -> io::Result<()> {
    let pretty = layout == Layout::Pretty;
    let (gap, space) = if pretty { ("\n  ", " ") } else { ("", "") };
    write!(out, "{{{gap}\"format\":{space}\"{FORMAT}\"")?;
    for (name, value) in fields(about) {
        write!(out, ",{gap}\"{name}\":{space}{value}")?;
    }
    write!(out, ",{gap}\"tiles\":{space}[")?;
    let mut line = Vec::new();
    let mut row_of = |out: &mut dyn Write, first: bool, numbers: &mut dyn Iterator<Item = u32>| {
        line.clear();
        if !first {
            line.push(b',');
        }
        line.extend_from_slice(if pretty { b"\n    [" } else { b"[" });
        for (column, number) in numbers.enumerate() {
            if column > 0 {
                line.extend_from_slice(if pretty { b", " } else { b"," });
            }
            push_decimal(&mut line, number);
        }
        line.push(b']');
        out.write_all(&line)
    };
    let mut first = true;
    rows(&mut |tiles| {
        let first = std::mem::replace(&mut first, false);
        row_of(&mut out, first, &mut tiles.iter().map(|tile| tile.0))
    })?;
    write!(out, "{}]", if pretty { "\n  " } else { "" })?;
    if about.board.rotations {
        write!(out, ",{gap}\"rotations\":{space}[")?;
        for (row, turns) in about.turns.chunks(about.shape.width()).enumerate() {
            row_of(&mut out, row == 0, &mut turns.iter().map(|&turns| u32::from(turns)))?;
        }
        write!(out, "{}]", if pretty { "\n  " } else { "" })?;
    }
    if !provenance.is_null() {
        write!(out, ",{gap}\"provenance\":{space}{provenance}")?;
    }
    writeln!(out, "{}}}", if pretty { "\n" } else { "" })
}

/// Adds a number in decimal digits; `write!` takes several times as long.
fn push_decimal(text: &mut Vec<u8>, mut number: u32) {
    let mut digits = [0; 10];
    let mut from = digits.len();
    loop {
        from -= 1;
        digits[from] = b'0' + (number % 10) as u8;
        number /= 10;
        if number == 0 {
            break;
        }
    }
    text.extend_from_slice(&digits[from..]);
}

/// The fields between the format and the tiles.
fn fields(packing: &Packing) -> Vec<(&'static str, Value)> {
    let (set, shape) = (&packing.set, packing.shape);
    let colors = set.colors();
    let colors = match colors.single() {
        Some(count) => json!(count),
        None => json!([colors.horizontal(), colors.vertical()]),
    };
    let members = match set.members() {
        Members::Complete => json!("complete"),
        Members::Compact => json!("compact"),
        Members::Pruned(pairs) => {
            let pairs: Vec<_> = pairs.iter().map(|(a, b)| [a.0, b.0]).collect();
            json!({ "pruned": pairs })
        }
        Members::Explicit(tiles) => {
            json!({ "tiles": tiles.iter().map(|tile| tile.0).collect::<Vec<_>>() })
        }
    };
    let mut fields = vec![("kind", json!(set.kind().name())), ("colors", colors), ("set", members)];
    if packing.cover {
        fields.push(("cover", json!(true)));
    }
    fields.push(("width", json!(shape.width())));
    fields.push(("height", json!(shape.height())));
    let Board { topology, border, .. } = &packing.board;
    fields.push(("topology", json!(topology.name())));
    if !border.is_free() {
        fields.push(("border", border_value(border, *topology, shape)));
    }
    fields
}

//! Tables for mappers: from tiles to cells of the atlas, and back.
//!
//! The formats are described in `docs/atlas.md`. Numbers of tiles count from 0 as everywhere.

use super::shader::CellTable;
use super::{Channels, Depth, Format, Image, Layout, Light};
use crate::tiles::TileId;
use serde_json::json;
use std::io::{self, Write};

/// Entries of a table that is indexed by tile number at most: 4096 x 4096.
const DENSE_LIMIT: u64 = 1 << 24;

/// Everything in one object: the layout, the tile of every cell, the cell of every tile.
///
/// # Errors
/// What `out` reports.
pub fn write_json(mut out: impl Write, layout: &Layout, strip: usize) -> io::Result<()> {
    let (h, v) = (layout.colors.horizontal(), layout.colors.vertical());
    let colors = if layout.colors.single().is_some() { json!(h) } else { json!([h, v]) };
    writeln!(out, "{{")?;
    writeln!(out, "  \"format\": \"tilepack-atlas/1\",")?;
    writeln!(out, "  \"kind\": \"{}\",", layout.kind)?;
    writeln!(out, "  \"colors\": {colors},")?;
    let sizes = [
        ("columns", layout.columns),
        ("rows", layout.rows()),
        ("tile_size", layout.side),
        ("gutter", layout.gutter),
        ("strip", strip),
        ("levels", layout.levels()),
    ];
    for (name, size) in sizes {
        writeln!(out, "  \"{name}\": {size},")?;
    }
    writeln!(out, "  \"tiles\": [")?;
    let rows = layout.rows();
    for (at, row) in layout.tiles.chunks(layout.columns).enumerate() {
        let numbers: Vec<String> = row.iter().map(|tile| tile.0.to_string()).collect();
        let comma = if at + 1 < rows { "," } else { "" };
        writeln!(out, "    [{}]{comma}", numbers.join(","))?;
    }
    writeln!(out, "  ],")?;
    writeln!(out, "  \"cells\": [")?;
    let places = layout.places();
    let count = places.len();
    for (at, (tile, cell)) in places.enumerate() {
        let (column, row) = layout.position(cell);
        let comma = if at + 1 < count { "," } else { "" };
        writeln!(out, "    [{tile},{column},{row}]{comma}")?;
    }
    writeln!(out, "  ]\n}}")
}

/// A line for every cell: column, row, tile, its colors.
///
/// # Errors
/// What `out` reports.
pub fn write_csv(mut out: impl Write, layout: &Layout) -> io::Result<()> {
    writeln!(out, "column,row,tile,{}", layout.kind.sides().join(","))?;
    for (cell, &tile) in layout.tiles.iter().enumerate() {
        let (column, row) = layout.position(cell);
        let [a, b, c, d] = layout.kind.unpack(tile, layout.colors);
        writeln!(out, "{column},{row},{tile},{a},{b},{c},{d}")?;
    }
    Ok(())
}

/// Constants and two arrays for C, C++ and shaders that include it.
///
/// # Errors
/// What `out` reports; sets of too many tiles.
pub fn write_header(mut out: impl Write, layout: &Layout, name: &str) -> io::Result<()> {
    let upper = name.to_uppercase();
    let kind = layout.kind;
    let (h, v) = (layout.colors.horizontal(), layout.colors.vertical());
    writeln!(out, "/* The atlas of {} tiles: where each {kind} tile lies.", layout.tiles.len())?;
    writeln!(out, "   Tile number: {}. */", number_formula(layout))?;
    writeln!(out, "#ifndef {upper}_H\n#define {upper}_H\n#include <stdint.h>\n")?;
    let constants = [
        ("COLORS_H", h),
        ("COLORS_V", v),
        ("COLUMNS", layout.columns),
        ("ROWS", layout.rows()),
        ("TILE_SIZE", layout.side),
        ("GUTTER", layout.gutter),
    ];
    for (constant, value) in constants {
        writeln!(out, "#define {upper}_{constant} {value}")?;
    }
    let list = |out: &mut dyn Write, values: &mut dyn Iterator<Item = u64>| -> io::Result<()> {
        for (at, value) in values.enumerate() {
            let before = match at {
                0 => "    ",
                _ if at % 16 == 0 => ",\n    ",
                _ => ", ",
            };
            write!(out, "{before}{value}")?;
        }
        writeln!(out, "\n}};\n")
    };
    let cells = layout.tiles.len();
    writeln!(out, "\n/* The tile of each cell, row by row from the top. */")?;
    writeln!(out, "static const uint32_t {name}_tiles[{cells}] = {{")?;
    list(&mut out, &mut layout.tiles.iter().map(|tile| tile.0.into()))?;
    let dense = dense(layout)?;
    let (field, none) = if cells < 0xffff { ("uint16_t", 0xffff) } else { ("uint32_t", u32::MAX) };
    writeln!(
        out,
        "/* The cell of each tile, column + row * columns; {none} where there is none. */"
    )?;
    writeln!(out, "static const {field} {name}_cells[{}] = {{", dense.len())?;
    list(&mut out, &mut dense.iter().map(|&cell| cell.unwrap_or(none).into()))?;
    writeln!(out, "#endif")
}

/// How a tile's number is made of its colors.
fn number_formula(layout: &Layout) -> String {
    let [h, v] = [layout.colors.horizontal(), layout.colors.vertical()];
    match layout.kind {
        crate::tiles::Kind::Wang => format!("((N*{v} + E)*{h} + S)*{v} + W"),
        _ => format!("((NE*{h} + SE)*{h} + SW)*{h} + NW"),
    }
}

/// The cell of every tile number.
fn dense(layout: &Layout) -> io::Result<Vec<Option<u32>>> {
    let tiles = layout.kind.tiles(layout.colors);
    if tiles > DENSE_LIMIT {
        return Err(io::Error::other(format!(
            "a table of {tiles} tile numbers: at most {DENSE_LIMIT}; the JSON and CSV tables list \
             only the tiles there are"
        )));
    }
    let mut cells = vec![None; tiles as usize];
    for (tile, cell) in layout.places() {
        cells[tile.index()] = Some(cell as u32);
    }
    Ok(cells)
}

/// The tile of every cell as a picture: a texel a cell, 8 bits where all numbers are below 255,
/// else 16.
///
/// # Errors
/// Tile numbers that need more than 16 bits.
pub fn tile_picture(layout: &Layout) -> io::Result<Image> {
    let largest = layout.tiles.iter().map(|tile| tile.0).max().unwrap_or(0);
    let format = field(largest)?;
    let mut image = Image::new(layout.columns, layout.rows(), format);
    for (cell, &TileId(tile)) in layout.tiles.iter().enumerate() {
        let (column, row) = layout.position(cell);
        image.set_sample(column, row, 0, tile as u16);
    }
    Ok(image)
}

/// The cell of every tile as a picture, as shaders read it ([`CellTable`]): tile n is the texel in
/// column n modulo the width, row n / width, its gray column + row * columns. Tiles that are not
/// there get 0.
///
/// # Errors
/// Sets of too many tiles, cells that need more than 16 bits.
pub fn cell_picture(layout: &Layout) -> io::Result<Image> {
    let dense = dense(layout)?;
    let format = field(layout.tiles.len() as u32 - 1)?;
    let (width, height) = CellTable::size(dense.len() as u64);
    let mut image = Image::new(width, height, format);
    for (tile, cell) in dense.into_iter().enumerate() {
        image.set_sample(tile % width, tile / width, 0, cell.unwrap_or(0) as u16);
    }
    Ok(image)
}

/// Gray with enough bits for values up to this.
fn field(largest: u32) -> io::Result<Format> {
    let depth = match largest {
        0..=255 => Depth::Eight,
        256..=65535 => Depth::Sixteen,
        _ => {
            return Err(io::Error::other(format!(
                "the value {largest} does not fit the 16 bits of a picture; the JSON and CSV \
                 tables have no such limit"
            )));
        }
    };
    Ok(Format { channels: Channels::Gray, depth, light: Light::Linear })
}

//! A tile set of the map editor Tiled in JSON, `.tsj`: the same as [`super::tiled`] says in XML.
//!
//! Source: doc.mapeditor.org, JSON map format 1.8.

use super::Sheet;
use super::tiled::{Colored, VERSION};
use crate::atlas::AtlasError;
use serde_json::Value;
use std::io::Write;

/// Writes a tile set with its wangset.
///
/// # Errors
/// More colors than Tiled knows; what `out` reports.
pub fn write_tsj(out: &mut dyn Write, sheet: &Sheet<'_>, name: &str) -> Result<(), AtlasError> {
    let colored = Colored::new(sheet)?;
    let (width, height) = sheet.size();
    let shape = sheet.packing.shape;
    let (name, image) = (Value::from(name), Value::from(sheet.image));
    writeln!(out, "{{ \"type\":\"tileset\",")?;
    writeln!(out, "  \"version\":\"{VERSION}\",")?;
    writeln!(out, "  \"name\":{name},")?;
    writeln!(out, "  \"columns\":{},", shape.width())?;
    writeln!(out, "  \"tilecount\":{},", shape.cells())?;
    writeln!(out, "  \"tilewidth\":{},", sheet.tile)?;
    writeln!(out, "  \"tileheight\":{},", sheet.tile)?;
    writeln!(out, "  \"margin\":{},", sheet.margin)?;
    writeln!(out, "  \"spacing\":{},", sheet.spacing)?;
    writeln!(out, "  \"image\":{image},")?;
    writeln!(out, "  \"imagewidth\":{width},")?;
    writeln!(out, "  \"imageheight\":{height},")?;
    writeln!(
        out,
        "  \"transformations\":{{\"hflip\":false, \"preferuntransformed\":false, \
         \"rotate\":false, \"vflip\":false}},"
    )?;
    writeln!(out, "  \"wangsets\":[")?;
    writeln!(out, "    {{ \"name\":{name}, \"type\":\"{}\", \"tile\":-1,", colored.kind())?;
    writeln!(out, "      \"colors\":[")?;
    for (number, (name, color)) in colored.colors().enumerate() {
        let before = if number > 0 { ",\n" } else { "" };
        write!(
            out,
            "{before}        {{\"name\":\"{name}\", \"color\":\"{color}\", \"tile\":-1, \
             \"probability\":1}}"
        )?;
    }
    writeln!(out, "],\n      \"wangtiles\":[")?;
    for cell in 0..shape.cells() {
        let before = if cell > 0 { ",\n" } else { "" };
        write!(out, "{before}        {{\"tileid\":{cell}, \"wangid\":[{}]}}", colored.text(cell))?;
    }
    out.write_all(b"]\n    }]\n}\n")?;
    Ok(())
}

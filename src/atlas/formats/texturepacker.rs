//! The JSON of the sprite packer TexturePacker, which most engines and libraries for pictures
//! in one sheet read: frames by name, or as a list.
//!
//! A frame has the name `tile-N` of its tile; a tile that a covering shows again, `tile-N-2`.

use super::Sheet;
use crate::tiles::TileId;
use serde_json::Value;
use std::collections::HashMap;
use std::io::{self, Write};

/// Whether frames are found by name or by place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Frames {
    /// An object with a field for every frame ("JSON hash").
    Named,
    /// A list ("JSON array").
    Listed,
}

/// Writes the frames, row by row.
///
/// # Errors
/// What `out` reports.
pub fn write_frames(out: &mut dyn Write, sheet: &Sheet<'_>, frames: Frames) -> io::Result<()> {
    let named = frames == Frames::Named;
    writeln!(out, "{{\"frames\": {}", if named { "{" } else { "[" })?;
    let (tile, cells) = (sheet.tile, sheet.packing.shape.cells());
    let mut seen: HashMap<TileId, u32> = HashMap::new();
    for (cell, &id) in sheet.packing.tiles.iter().enumerate() {
        let times = seen.entry(id).or_default();
        *times += 1;
        let name = if *times > 1 { format!("tile-{id}-{times}") } else { format!("tile-{id}") };
        let (x, y) = sheet.corner(cell);
        let begin =
            if named { format!("\"{name}\": {{") } else { format!("{{\"filename\":\"{name}\",") };
        let end = if cell + 1 < cells { "," } else { "" };
        writeln!(
            out,
            "{begin}\"frame\":{{\"x\":{x},\"y\":{y},\"w\":{tile},\"h\":{tile}}},\
             \"rotated\":false,\"trimmed\":false,\
             \"spriteSourceSize\":{{\"x\":0,\"y\":0,\"w\":{tile},\"h\":{tile}}},\
             \"sourceSize\":{{\"w\":{tile},\"h\":{tile}}}}}{end}"
        )?;
    }
    let (width, height) = sheet.size();
    writeln!(
        out,
        "{},\n\"meta\": {{\"app\":\"tilepack\",\"version\":\"{}\",\"image\":{},\
         \"format\":\"RGBA8888\",\"size\":{{\"w\":{width},\"h\":{height}}},\"scale\":\"1\"}}\n}}",
        if named { "}" } else { "]" },
        env!("CARGO_PKG_VERSION"),
        Value::from(sheet.image),
    )
}

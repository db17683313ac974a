//! A TileSet of the engine Godot 4, `.tres`: an atlas source with one terrain set.
//!
//! A color is a terrain; the colors of a tile are its *peering bits*. Colors of vertical edges go
//! on where those of horizontal edges end. `use_texture_padding` is off: padding copies the tiles
//! into a picture of Godot's own, without mip-maps and without the neighbors of the packing.
//!
//! Source: docs.godotengine.org, classes TileSet, TileSetAtlasSource and TileData.

use super::Sheet;
use crate::atlas::palette;
use crate::tiles::Kind;
use std::io::{self, Write};

/// `TileSet.TERRAIN_MODE_MATCH_CORNERS` and its bits in the order of the sides.
const CORNERS: (u8, [&str; 4]) =
    (1, ["top_right_corner", "bottom_right_corner", "bottom_left_corner", "top_left_corner"]);

/// `TileSet.TERRAIN_MODE_MATCH_SIDES` and its bits in the order of the sides.
const SIDES: (u8, [&str; 4]) = (2, ["top_side", "right_side", "bottom_side", "left_side"]);

/// Writes the tile set; the picture lies beside it in the project.
///
/// # Errors
/// What `out` reports.
pub fn write_tres(out: &mut dyn Write, sheet: &Sheet<'_>) -> io::Result<()> {
    let set = &sheet.packing.set;
    let colors = set.colors();
    let is_wang = set.kind() == Kind::Wang;
    let (mode, bits) = if is_wang { SIDES } else { CORNERS };
    let tile = sheet.tile;
    writeln!(out, "[gd_resource type=\"TileSet\" load_steps=3 format=3]\n")?;
    writeln!(
        out,
        "[ext_resource type=\"Texture2D\" path=\"res://{}\" id=\"1_atlas\"]\n",
        quoted(sheet.image)
    )?;
    writeln!(out, "[sub_resource type=\"TileSetAtlasSource\" id=\"TileSetAtlasSource_tiles\"]")?;
    writeln!(out, "texture = ExtResource(\"1_atlas\")")?;
    writeln!(out, "margins = Vector2i({0}, {0})", sheet.margin)?;
    writeln!(out, "separation = Vector2i({0}, {0})", sheet.spacing)?;
    writeln!(out, "texture_region_size = Vector2i({tile}, {tile})")?;
    writeln!(out, "use_texture_padding = false")?;
    let width = sheet.packing.shape.width();
    for cell in 0..sheet.packing.shape.cells() {
        let at = format!("{}:{}/0", cell % width, cell / width);
        writeln!(out, "{at} = 0\n{at}/terrain_set = 0\n{at}/terrain = 0")?;
        for (side, &color) in sheet.sides(cell).iter().enumerate() {
            let before = if is_wang && side % 2 == 1 { colors.horizontal() } else { 0 };
            let terrain = before + usize::from(color);
            writeln!(out, "{at}/terrains_peering_bit/{} = {terrain}", bits[side])?;
        }
    }
    writeln!(out, "\n[resource]\ntile_size = Vector2i({tile}, {tile})")?;
    writeln!(out, "terrain_set_0/mode = {mode}")?;
    let first =
        (0..colors.horizontal()).map(|c| (if is_wang { "north-south" } else { "corner" }, c));
    let second = (0..if is_wang { colors.vertical() } else { 0 }).map(|c| ("east-west", c));
    for (terrain, (name, color)) in first.chain(second).enumerate() {
        let [r, g, b] = palette::rgb((terrain % 256) as u8).map(|level| {
            let thousandths = (u32::from(level) * 1000 + 127) / 255;
            format!("{}.{:03}", thousandths / 1000, thousandths % 1000)
        });
        writeln!(out, "terrain_set_0/terrain_{terrain}/name = \"{name} {color}\"")?;
        writeln!(out, "terrain_set_0/terrain_{terrain}/color = Color({r}, {g}, {b}, 1)")?;
    }
    writeln!(out, "sources/0 = SubResource(\"TileSetAtlasSource_tiles\")")
}

/// Text within quotation marks.
fn quoted(text: &str) -> String {
    text.replace('\\', "\\\\").replace('"', "\\\"")
}

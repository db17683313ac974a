//! The viewer: one HTML file that draws the endless tiling from the atlas of a packing.
//!
//! Nothing is fetched, so it works from a disk. The atlas goes along as PNG files, one for every mip
//! level, so that no driver resamples them; the tilings are those of [`super::shader`] that the packed
//! set allows. Its filters are written out in the shader, over texels that are fetched
//! one by one: so *packed*, filtered in the atlas, can be held against *assembled*, every texel from
//! the tile that the tiling has there. An atlas encoded for the eye is decoded as its texels are read
//! (SRGB8_ALPHA8) and encoded again at the end: filters work on light.
//!
//! The page lies in `page/`, whose files are put together here.

mod choices;

use super::Light;
use super::layout::Layout;
use super::shader::CellTable;
use crate::tiles::Kind;
use crate::tiling::Cells;
use crate::torus::Packing;
use base64::engine::general_purpose::STANDARD;
use base64::write::EncoderWriter;
use choices::Choice;
use serde_json::{Value, json};
use std::io::{self, Write};

/// What is shown.
#[derive(Debug, Clone)]
pub struct Scene<'a> {
    /// A packing or covering by corner or Wang tiles.
    pub packing: &'a Packing,
    /// Where its tiles lie in the atlas.
    pub layout: &'a Layout,
    /// The atlas as PNG files, level 0 first; every further level half as wide and high.
    pub levels: Vec<Vec<u8>>,
    /// The width of the common strip in texels.
    pub strip: usize,
    /// The last level through which filtering in the atlas is exact.
    pub exact_to_lod: Option<u32>,
    /// Whether the atlas is encoded for the eye; filters then decode it first.
    pub light: Light,
    /// Chooses the tiling.
    pub seed: u32,
    /// The title of the page.
    pub title: String,
}

/// Writes the page.
///
/// # Errors
/// What `out` reports; [`io::ErrorKind::InvalidInput`] for a packing that no tiling can be made of.
pub fn write(out: &mut dyn Write, scene: &Scene<'_>) -> io::Result<()> {
    let wrong =
        |error: super::AtlasError| io::Error::new(io::ErrorKind::InvalidInput, error.to_string());
    let cells = Cells::table(scene.packing);
    let choices = Choice::all(scene, &cells).map_err(wrong)?;
    let mut texts = Vec::with_capacity(choices.len());
    for choice in &choices {
        texts.push((choice.name, choice.texts(&cells).map_err(wrong)?));
    }
    let script = [
        include_str!("page/gl.js"),
        include_str!("page/tilings.js"),
        include_str!("page/view.js"),
        include_str!("page/time.js"),
        include_str!("page/input.js"),
        include_str!("page/panel.js"),
        include_str!("page/main.js"),
    ];
    let mut rest = include_str!("page/index.html");
    while let Some((before, after)) = rest.split_once("{{") {
        out.write_all(before.as_bytes())?;
        let (word, after) = after.split_once("}}").unwrap_or((after, ""));
        rest = after;
        match word {
            "TITLE" => out.write_all(quoted(&scene.title).as_bytes())?,
            "STYLE" => out.write_all(include_bytes!("page/style.css"))?,
            "SCENE" => write!(out, "{}", in_script(&about(scene, &texts)))?,
            "TILINGS" => {
                for (id, (functions, _)) in &texts {
                    writeln!(
                        out,
                        "<script type=\"text/plain\" id=\"tiling-{id}\">{functions}</script>"
                    )?;
                }
            }
            "FILTER" => out.write_all(include_bytes!("page/filter.glsl"))?,
            "LEVELS" => write_levels(out, &scene.levels)?,
            _ => script.iter().try_for_each(|part| out.write_all(part.as_bytes()))?,
        }
    }
    out.write_all(rest.as_bytes())
}

/// What the script needs to know.
fn about(scene: &Scene<'_>, texts: &[(&str, (String, Value))]) -> Value {
    let (layout, set) = (scene.layout, &scene.packing.set);
    let (kind, colors) = (set.kind(), set.colors());
    let tiles: Vec<u32> = layout.tiles.iter().map(|tile| tile.0).collect();
    let tilings: Vec<&Value> = texts.iter().map(|(_, (_, about))| about).collect();
    json!({
        "width": layout.columns,
        "height": layout.rows(),
        "tiles": tiles,
        "packed": layout.tiles == scene.packing.tiles,
        "colors": [colors.horizontal(), colors.vertical()],
        "sides": if kind == Kind::Corner { Kind::Corner.sides() } else { Kind::Wang.sides() },
        "side": layout.side,
        "gutter": layout.gutter,
        "strip": scene.strip,
        "exact": scene.exact_to_lod,
        "srgb": scene.light == Light::Srgb,
        "levels": scene.levels.len(),
        "table": CellTable::size(kind.tiles(colors)),
        "tilings": tilings,
        "seed": scene.seed,
    })
}

fn write_levels(out: &mut dyn Write, levels: &[Vec<u8>]) -> io::Result<()> {
    for (level, png) in levels.iter().enumerate() {
        write!(out, "<script type=\"text/plain\" id=\"level-{level}\">")?;
        let mut encoder = EncoderWriter::new(&mut *out, &STANDARD);
        encoder.write_all(png)?;
        encoder.finish()?;
        drop(encoder);
        out.write_all(b"</script>\n")?;
    }
    Ok(())
}

/// Text between tags, or of an attribute.
fn quoted(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('"', "&quot;");
    text.replace('<', "&lt;").replace('>', "&gt;")
}

/// JSON inside of a script, which must not end it.
fn in_script(value: &Value) -> String {
    value.to_string().replace('<', "\\u003c")
}

//! The viewer: one HTML file that draws the endless tiling from the atlas of a packing.
//!
//! Nothing is fetched, so it works from a disk. The atlas goes along as PNG files, one for every mip
//! level, so that no driver resamples them; the tiling is that of [`super::shader`], by hash where the
//! packing is of a complete set, else a map ([`crate::tiling::mixed`]). Its filters are written out
//! in the shader, over texels that are fetched one by one: so *packed*, filtered in the atlas, can be
//! held against *assembled*, every texel from the tile that the tiling has there. An atlas encoded for
//! the eye is decoded as its texels are read (SRGB8_ALPHA8) and encoded again at the end: filters work
//! on light.
//!
//! The page lies in `page/`, whose files are put together here.

use super::Light;
use super::shader::{CellTable, Language, Shader};
use crate::tiles::{Kind, Members};
use crate::tiling::{Cells, Coloring, Tiling, mixed};
use crate::torus::Packing;
use base64::engine::general_purpose::STANDARD;
use base64::write::EncoderWriter;
use serde_json::{Value, json};
use std::io::{self, Write};

/// What is shown.
#[derive(Debug, Clone)]
pub struct Scene<'a> {
    /// A packing or covering by corner or Wang tiles.
    pub packing: &'a Packing,
    /// The atlas as PNG files, level 0 first; every further level half as wide and high.
    pub levels: Vec<Vec<u8>>,
    /// Texels of a tile's side.
    pub side: usize,
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
    let wrong = |error: String| io::Error::new(io::ErrorKind::InvalidInput, error);
    let (tiling, words) = tiling(scene).map_err(|error| wrong(error.to_string()))?;
    let cells = Cells::table(scene.packing);
    let shader = Shader::new(Language::GlslEs300, &tiling, &cells, "tp");
    let functions = shader.map_err(|error| wrong(error.to_string()))?.functions();
    let script = [
        include_str!("page/gl.js"),
        include_str!("page/view.js"),
        include_str!("page/input.js"),
        include_str!("page/main.js"),
    ];
    let mut rest = include_str!("page/index.html");
    while let Some((before, after)) = rest.split_once("{{") {
        out.write_all(before.as_bytes())?;
        let (word, after) = after.split_once("}}").unwrap_or((after, ""));
        rest = after;
        match word {
            "TITLE" => out.write_all(quoted(&scene.title).as_bytes())?,
            "TILING" => out.write_all(quoted(&words).as_bytes())?,
            "STYLE" => out.write_all(include_bytes!("page/style.css"))?,
            "SCENE" => write!(out, "{}", in_script(&about(scene, &tiling, &words)))?,
            "FUNCTIONS" => out.write_all(functions.as_bytes())?,
            "FILTER" => out.write_all(include_bytes!("page/filter.glsl"))?,
            "LEVELS" => write_levels(out, &scene.levels)?,
            _ => script.iter().try_for_each(|part| out.write_all(part.as_bytes()))?,
        }
    }
    out.write_all(rest.as_bytes())
}

/// The tiling that is drawn, and what it is in words.
fn tiling(scene: &Scene<'_>) -> Result<(Tiling, String), crate::tiling::TilingError> {
    let set = &scene.packing.set;
    let (kind, colors) = (set.kind(), set.colors());
    if *set.members() == Members::Complete {
        let coloring = Coloring::Hash { seed: scene.seed };
        let words = format!("endless: colors by hash, seed {}", scene.seed);
        return Ok((Tiling::new(kind, colors, coloring)?, words));
    }
    let mixed = mixed(scene.packing, scene.seed)?;
    let shape = mixed.map.shape();
    let words = match mixed.changed {
        0 => format!("the packing of {shape} tiles, repeated: nothing in it can be changed"),
        _ => format!(
            "a patch of {shape} tiles, repeated: the packing several times, with {} of {} tiles \
             exchanged at random",
            mixed.changed,
            shape.cells()
        ),
    };
    Ok((Tiling::new(kind, colors, Coloring::Map(mixed.map))?, words))
}

/// What the script needs to know.
fn about(scene: &Scene<'_>, tiling: &Tiling, words: &str) -> Value {
    let (kind, colors, shape) = (tiling.kind(), tiling.colors(), scene.packing.shape);
    let map = match tiling.coloring() {
        Coloring::Map(map) => json!({
            "width": map.shape().width(), "height": map.shape().height(), "labels": map.labels(),
        }),
        _ => Value::Null,
    };
    let tiles: Vec<u32> = scene.packing.tiles.iter().map(|tile| tile.0).collect();
    json!({
        "width": shape.width(),
        "height": shape.height(),
        "tiles": tiles,
        "colors": [colors.horizontal(), colors.vertical()],
        "sides": if kind == Kind::Corner { Kind::Corner.sides() } else { Kind::Wang.sides() },
        "side": scene.side,
        "strip": scene.strip,
        "exact": scene.exact_to_lod,
        "srgb": scene.light == Light::Srgb,
        "levels": scene.levels.len(),
        "table": CellTable::size(kind.tiles(colors)),
        "map": map,
        "coloring": words,
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

/// Text between tags.
fn quoted(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// JSON inside of a script, which must not end it.
fn in_script(value: &Value) -> String {
    value.to_string().replace('<', "\\u003c")
}

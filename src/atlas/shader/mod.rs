//! Shaders: an endless tiling drawn from the atlas of a packing, in four languages.
//!
//! One template ([`Language`] says how it becomes four) computes what [`crate::tiling`] does, bit
//! for bit: the colors around a tile, its number, its cell in the atlas by a table ([`CellTable`])
//! or in closed form, and the texture there, sampled with the derivatives of the position in the
//! tiling (with those of the place in the atlas, which jumps from tile to tile, mip mapping would
//! show every border). A text has functions and constants only, to be pasted into any shader;
//! textures are handed over as arguments.

mod coloring;
mod language;
mod map;
mod table;

pub use language::Language;
pub use map::MapTexture;
pub use table::CellTable;

use super::AtlasError;
use crate::construct::corner_even::WINDOWS;
use crate::tiling::{Cells, Formula, Tiling, hash};

/// What is asked for.
#[derive(Debug, Clone, Copy)]
pub struct Shader<'a> {
    language: Language,
    tiling: &'a Tiling,
    cells: &'a Cells,
    name: &'a str,
}

impl<'a> Shader<'a> {
    /// A shader for a tiling whose tiles lie in these cells; all names begin with `name`.
    ///
    /// # Errors
    /// A tile without a cell, a name that is none, numbers that do not fit 32 bits, a table or map
    /// that is too large for a texture.
    pub fn new(
        language: Language,
        tiling: &'a Tiling,
        cells: &'a Cells,
        name: &'a str,
    ) -> Result<Self, AtlasError> {
        cells.check(tiling).map_err(|error| AtlasError::Asked(error.to_string()))?;
        let letter = |c: char| c.is_ascii_alphabetic();
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
        // GLSL keeps names with two underscores, or with gl_, for itself.
        let reserved = name.contains("__") || name.starts_with("gl_") || name.ends_with('_');
        if !name.starts_with(letter) || !name.chars().all(plain) || reserved || name.len() > 64 {
            return Err(AtlasError::Asked(format!(
                "name '{name}': expected a letter, then letters, digits and single underscores"
            )));
        }
        coloring::check(tiling)?;
        if cells.as_formula().is_none() {
            CellTable::check(cells.kind().tiles(cells.colors()))?;
        }
        Ok(Self { language, tiling, cells, name })
    }

    /// The whole text: how to use it, constants, functions.
    pub fn text(&self) -> String {
        format!("{}\n{}", self.head(), self.functions())
    }

    /// The constants and functions alone.
    pub fn functions(&self) -> String {
        let mut text = String::new();
        if self.language == Language::GlslEs300 {
            text.push_str("precision highp int;\nprecision highp float;\n");
            text.push_str("precision highp sampler2D;\nprecision highp usampler2D;\n\n");
        }
        for (name, value) in self.constants() {
            text.push_str(&self.language.constant(&format!("NAME_{name}"), value));
        }
        for template in self.templates() {
            text.push('\n');
            text.push_str(&self.language.translate(template));
        }
        self.filled_in(&text)
    }

    /// [`Shader::functions`] with the seed left open: the keys of its hashes are uniforms, here with
    /// their names and the seeds that they stand for. (GLSL.)
    pub(in crate::atlas) fn open_functions(&self) -> (String, Vec<(String, u32)>) {
        let mut text = self.functions();
        let mut keys = Vec::new();
        for (name, seed) in coloring::seeds(self.tiling) {
            let name = format!("{}_{name}", self.name);
            let constant = self.language.constant(&name, hash::key(seed).into());
            text = text.replace(&constant, &format!("uniform uint {name};\n"));
            keys.push((name, seed));
        }
        (text, keys)
    }

    /// The parts of the template, in an order that lets every function use those before it.
    fn templates(&self) -> Vec<&'static str> {
        let mut parts = coloring::templates(self.tiling);
        parts.push(include_str!("template/number.wgsl"));
        match self.cells.as_formula() {
            None => parts.push(include_str!("template/table.wgsl")),
            Some(Formula::CornerEven) => parts.push(include_str!("template/cell_corner_even.wgsl")),
            Some(formula) => {
                parts.push(include_str!("template/ring.wgsl"));
                parts.push(match formula {
                    Formula::Wang => include_str!("template/cell_wang.wgsl"),
                    _ => include_str!("template/cell_corner_odd.wgsl"),
                });
            }
        }
        parts.push(include_str!("template/sample.wgsl"));
        parts
    }

    /// The constants that those parts name.
    fn constants(&self) -> Vec<(&'static str, u64)> {
        let colors = self.tiling.colors();
        let (h, v) = (colors.horizontal() as u64, colors.vertical() as u64);
        let shape = self.cells.shape();
        let mut constants = vec![
            ("CH", h),
            ("CV", v),
            ("WIDTH", shape.width() as u64),
            ("HEIGHT", shape.height() as u64),
        ];
        constants.extend(coloring::constants(self.tiling));
        match self.cells.as_formula() {
            None => {
                let (width, _) = CellTable::size(self.tiling.kind().tiles(colors));
                constants.push(("TABLE_W", width as u64));
            }
            Some(Formula::CornerEven) => {
                let packed = |windows: &[u8]| {
                    windows.iter().rev().fold(0, |packed, &cell| packed << 4 | u64::from(cell))
                };
                constants.push(("PLACES_LOW", packed(&WINDOWS[..8])));
                constants.push(("PLACES_HIGH", packed(&WINDOWS[8..])));
            }
            Some(_) => {}
        }
        constants
    }

    /// Puts in what differs between languages and tilings in more than words.
    fn filled_in(&self, text: &str) -> String {
        let map = self.map_channels();
        let table = self.cells.as_formula().is_none();
        let language = self.language;
        let whole = |name: &str| match language {
            Language::Wgsl => format!("{name}: texture_2d<u32>"),
            Language::Hlsl => {
                let texel = if name == "map" && map == Some(2) { "uint2" } else { "uint" };
                format!("Texture2D<{texel}> {name}")
            }
            _ => format!("usampler2D {name}"),
        };
        let fetch = |name: &str, part: &str| match language {
            Language::Wgsl => format!("textureLoad({name}, CELL, 0).{part}"),
            Language::Hlsl => format!("{name}.Load(int3(CELL, 0)).{part}"),
            _ => format!("texelFetch({name}, CELL, 0).{part}"),
        };
        let (parameter, argument, sample) = match language {
            Language::Wgsl => (
                "atlas: texture_2d<f32>, atlas_sampler: sampler",
                "atlas, atlas_sampler",
                "textureSampleGrad(atlas, atlas_sampler, ",
            ),
            Language::Hlsl => (
                "Texture2D<float4> atlas, SamplerState atlas_sampler",
                "atlas, atlas_sampler",
                "atlas.SampleGrad(atlas_sampler, ",
            ),
            _ => ("sampler2D atlas", "atlas", "textureGrad(atlas, "),
        };
        let (mut parameters, mut arguments) = (Vec::new(), Vec::new());
        for (there, name) in [(map.is_some(), "map"), (table, "table")] {
            if there {
                parameters.push(whole(name));
                arguments.push(name.to_owned());
            }
        }
        parameters.push(parameter.to_owned());
        arguments.push(argument.to_owned());
        let when = |there: bool, text: &str| if there { text.to_owned() } else { String::new() };
        // A corner has one color, an edge one of two.
        let map_texel = match (map, language) {
            (Some(2), _) => fetch("map", "xy"),
            (_, Language::Wgsl) => "vec2u(textureLoad(map, CELL, 0).x, 0u)".to_owned(),
            (_, Language::Hlsl) => "uint2(map.Load(int3(CELL, 0)).x, 0u)".to_owned(),
            _ => "uvec2(texelFetch(map, CELL, 0).x, 0u)".to_owned(),
        };
        let mut text = match map {
            Some(_) => text.to_owned(),
            None => text.replace(", MAP_PARAMETER", ""),
        };
        for (word, by) in [
            ("FETCH_MAP_XY(", map_texel),
            ("FETCH_MAP_X(", fetch("map", "x")),
            ("FETCH_TABLE(", fetch("table", "x")),
        ] {
            text = with_argument(&text, word, &by);
        }
        for (word, by) in [
            ("SAMPLE_PARAMETERS", parameters.join(", ")),
            ("SAMPLE_ARGUMENTS", arguments.join(", ")),
            ("MAP_PARAMETER", whole("map")),
            ("TABLE_PARAMETER", whole("table")),
            ("MAP_ARGUMENT", when(map.is_some(), ", map")),
            ("TABLE_ARGUMENT", when(table, ", table")),
            ("SAMPLE_GRAD(", sample.to_owned()),
            ("NAME_", format!("{}_", self.name)),
        ] {
            text = text.replace(word, &by);
        }
        text
    }

    /// What to hand over, and how to call it.
    fn head(&self) -> String {
        let (language, name, shape) = (self.language, self.name, self.cells.shape());
        let (kind, colors) = (self.tiling.kind(), self.tiling.colors());
        let mut lines = vec![
            format!(
                "{}: an endless tiling of {kind} tiles over {colors} colors,",
                language.title()
            ),
            coloring::words(self.tiling),
            format!("drawn from the atlas of a packing of {shape} tiles. Written by tilepack."),
            String::new(),
            format!("color = {name}_texture(position{})", self.calls()),
            String::new(),
            "position: in tiles, x to the east and y to the north; tile (0, 0) begins at (0, 0)."
                .into(),
            "atlas: the picture of the packing, its first row the northmost, with its mip levels;"
                .into(),
            "    filters linear, all coordinates wrap around (REPEAT).".into(),
        ];
        if let Some(map) = MapTexture::of(self.tiling) {
            lines.push(format!("map: {}x{} texels of {}.", map.width, map.height, map.words));
        }
        if self.cells.as_formula().is_none() {
            let (width, height) = CellTable::size(kind.tiles(colors));
            lines.push(format!(
                "table: {width}x{height} texels of one unsigned number; texel (t % {width}, t / {width}) \
                 is row * {} + column",
                shape.width()
            ));
            lines.push("    of tile t in the atlas, rows from the north.".to_owned());
        }
        lines.push("Whole numbers are exact for tiles from -2^30 to 2^30 - 2.".to_owned());
        lines.iter().map(|line| format!("// {line}").trim_end().to_owned() + "\n").collect()
    }

    /// Numbers of a texel of the map, if the coloring has one.
    fn map_channels(&self) -> Option<usize> {
        coloring::map_channels(self.tiling)
    }

    /// The textures of a call.
    fn calls(&self) -> String {
        let mut text = String::new();
        if self.map_channels().is_some() {
            text.push_str(", map");
        }
        if self.cells.as_formula().is_none() {
            text.push_str(", table");
        }
        text.push_str(", atlas");
        if matches!(self.language, Language::Hlsl | Language::Wgsl) {
            text.push_str(", atlas_sampler");
        }
        text
    }
}

/// Replaces `WORD(argument)` by a text in which `CELL` stands for the argument.
fn with_argument(text: &str, word: &str, by: &str) -> String {
    let Some((before, rest)) = text.split_once(word) else { return text.to_owned() };
    let mut depth = 1;
    let end = rest.find(|c| {
        depth += match c {
            '(' => 1,
            ')' => -1,
            _ => 0,
        };
        depth == 0
    });
    let (argument, after) = rest.split_at(end.unwrap_or(rest.len()));
    let after = after.strip_prefix(')').unwrap_or(after);
    format!("{before}{}{after}", by.replace("CELL", argument))
}

//! The tilings of the page: those that the packed set allows, the best first.
//!
//! A tiling by a rule needs the tiles that the rule lays; [`Shader`] says whether the packing has them.
//! Where no rule will do, it is a map of the packing, mixed ([`mixed`]). The seed of a rule
//! is left open in the shader's text, so that another seed is another number and no other program.

use super::Scene;
use crate::atlas::AtlasError;
use crate::atlas::shader::{Language, MapTexture, Shader};
use crate::tiles::Members;
use crate::tiling::{
    Cells, Coloring, Compact, Diagonal, Halton, Probabilities, Sums, Tiling, TilingError, mixed,
};
use crate::torus::Shape;
use serde_json::{Value, json};

/// Tiles along each side of the grid of Halton colors, which repeats: more than a screen shows.
const HALTON: u64 = 4096;

/// Cells of the map of probabilities, from west to east, and their points.
const FADE: (u64, u32) = (48, 2);

/// A tiling, and what the page calls it.
pub(super) struct Choice {
    /// In links and scripts.
    pub(super) name: &'static str,
    /// In the list.
    title: String,
    /// What it is.
    words: String,
    tiling: Tiling,
    seed: u32,
}

impl Choice {
    /// All tilings of a packing, at least one.
    ///
    /// # Errors
    /// A packing that nothing tiles with.
    pub(super) fn all(scene: &Scene<'_>, cells: &Cells) -> Result<Vec<Self>, AtlasError> {
        let (set, seed) = (&scene.packing.set, scene.seed);
        let mut all = Vec::new();
        for (name, title, words, coloring) in rules(scene) {
            // Not every tiling has a shader, either.
            if let Ok(tiling) = Tiling::new(set.kind(), set.colors(), coloring)
                && Shader::new(Language::GlslEs300, &tiling, cells, "tp").is_ok()
            {
                all.push(Self { name, title, words, tiling, seed });
            }
        }
        if all.is_empty() {
            all.push(Self::map(scene).map_err(|error| AtlasError::Asked(error.to_string()))?);
        }
        Ok(all)
    }

    /// The packing, repeated and mixed.
    fn map(scene: &Scene<'_>) -> Result<Self, TilingError> {
        let set = &scene.packing.set;
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
        let tiling = Tiling::new(set.kind(), set.colors(), Coloring::Map(mixed.map))?;
        Ok(Self { name: "map", title: "map".to_owned(), words, tiling, seed: scene.seed })
    }

    /// The functions of the shader, and what the script needs to know.
    ///
    /// # Errors
    /// What no shader can do.
    pub(super) fn texts(&self, cells: &Cells) -> Result<(String, Value), AtlasError> {
        let shader = Shader::new(Language::GlslEs300, &self.tiling, cells, "tp")?;
        let (functions, keys) = shader.open_functions();
        let keys: Vec<Value> =
            keys.iter().map(|(name, seed)| json!([name, seed.wrapping_sub(self.seed)])).collect();
        let map = match self.tiling.coloring() {
            // The script makes it: it is as long as many an atlas.
            Coloring::Compact(Compact::Block4(_)) => json!("patterns"),
            _ => MapTexture::of(&self.tiling).map_or(Value::Null, |map| {
                json!({
                    "width": map.width,
                    "height": map.height,
                    "channels": map.channels,
                    "data": map.data,
                })
            }),
        };
        let about = json!({
            "name": self.name,
            "title": self.title,
            "words": self.words,
            "keys": keys,
            "map": map,
        });
        Ok((functions, about))
    }
}

/// The rules that might do: name, title, what it is in words.
fn rules(scene: &Scene<'_>) -> Vec<(&'static str, String, String, Coloring)> {
    let (set, seed) = (&scene.packing.set, scene.seed);
    let (kind, colors) = (set.kind(), set.colors());
    let mut rules = Vec::new();
    let mut add = |name, title: &str, words: &str, coloring| {
        rules.push((name, title.to_owned(), words.to_owned(), coloring));
    };
    if *set.members() == Members::Complete {
        let words = "colors by hash: any tile anywhere, each as likely as any other";
        add("hash", "hash", words, Coloring::Hash { seed });
        if let Some(halton) =
            Shape::new(HALTON, HALTON).ok().and_then(|grid| Halton::of_tiles(kind, grid).ok())
        {
            let words = "colors along the Halton sequence, of which there is one: equal colors keep \
                         their distance, so tiles of many colors are frequent";
            add("halton", "Halton", words, Coloring::Halton(halton));
        }
        if let Some(map) = fade(colors.horizontal(), seed) {
            let words = "colors by hash, their probabilities by a map: from west to east one color \
                         fades into the next";
            add("fade", "probabilities", words, Coloring::Probabilities(map));
        }
        return rules;
    }
    let number = colors.horizontal();
    let compact = [Compact::of(number, seed), Diagonal::new(number, seed).map(Compact::Diagonal)];
    for compact in compact.into_iter().flatten() {
        let rule = compact.rule();
        let words =
            format!("the compact {} set, tile by tile by a formula: {}", rule.name(), rule.words());
        let title = format!("direct: {}", rule.name());
        add(rule.name(), &title, &words, Coloring::Compact(compact));
    }
    if let Ok(sums) = Sums::one_hash(colors, seed) {
        let words = "a compact set, tile by tile by a formula: an edge has the sum of the hashed colors \
                     of its ends";
        add("sums", "direct: sums", words, Coloring::Sums(sums));
    }
    rules
}

/// A map in which every color fades into the next one and the last into the first; of ten points
/// one has any color.
fn fade(colors: usize, seed: u32) -> Option<Probabilities> {
    let (cells, points) = FADE;
    let shape = Shape::new(cells, 1).ok()?;
    let mut weights = vec![0.1 / colors as f64; shape.cells() * colors];
    for cell in 0..shape.cells() {
        let at = cell * colors;
        let (first, part) = (at / shape.cells(), at % shape.cells());
        let share = 0.9 * part as f64 / shape.cells() as f64;
        weights[at + first] += 0.9 - share;
        weights[at + (first + 1) % colors] += share;
    }
    Probabilities::new(shape, [points, points], colors, &weights, seed).ok()
}

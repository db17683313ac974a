//! The tilings of the page: those that the packed set allows, the best first.
//!
//! A tiling by a rule needs the tiles that the rule lays; whether the packing has them is asked of
//! [`Cells`]. Where no rule will do, it is a map of the packing, mixed ([`mixed`]). The seed of a rule
//! is a constant of the shader's text; here it becomes a uniform, so that another seed is another
//! number and no other program.

use super::Scene;
use crate::atlas::AtlasError;
use crate::atlas::shader::{Language, Shader};
use crate::tiling::{Cells, Coloring, Halton, Tiling, hash, mixed};
use crate::torus::Shape;

/// Tiles along each side of the grid of Halton colors, which repeats: more than a screen shows.
const HALTON: u64 = 4096;

/// A tiling, and what the page calls it.
pub(super) struct Choice {
    /// In links and scripts.
    pub(super) name: &'static str,
    /// In the list.
    pub(super) title: &'static str,
    /// What it is.
    pub(super) words: String,
    /// The rule.
    pub(super) tiling: Tiling,
}

impl Choice {
    /// All tilings of a packing, at least one.
    ///
    /// # Errors
    /// A packing that nothing tiles with.
    pub(super) fn all(scene: &Scene<'_>, cells: &Cells) -> Result<Vec<Self>, AtlasError> {
        let asked = |error: crate::tiling::TilingError| AtlasError::Asked(error.to_string());
        let set = &scene.packing.set;
        let (kind, colors) = (set.kind(), set.colors());
        let mut all = Vec::new();
        let mut add = |name, title, words: &str, coloring| {
            if let Ok(tiling) = Tiling::new(kind, colors, coloring)
                && cells.check(&tiling).is_ok()
            {
                all.push(Self { name, title, words: words.to_owned(), tiling });
            }
        };
        add(
            "hash",
            "hash",
            "colors by hash: any tile anywhere, each as likely as any other",
            Coloring::Hash { seed: scene.seed },
        );
        let grid = Shape::new(HALTON, HALTON).map_err(|error| AtlasError::Asked(error.to_string()));
        if let Ok(halton) = Halton::of_tiles(kind, grid?) {
            add(
                "halton",
                "Halton",
                "colors along the Halton sequence, of which there is one: equal colors keep their \
                 distance, so tiles of many colors are frequent",
                    Coloring::Halton(halton),
            );
        }
        if all.is_empty() {
            all.push(Self::map(scene).map_err(asked)?);
        }
        Ok(all)
    }

    /// The packing, repeated and mixed.
    fn map(scene: &Scene<'_>) -> Result<Self, crate::tiling::TilingError> {
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
        Ok(Self { name: "map", title: "map", words, tiling })
    }

    /// Whether it has a seed of its own.
    pub(super) fn seeded(&self) -> bool {
        matches!(self.tiling.coloring(), Coloring::Hash { .. })
    }

    /// The functions of the shader; of a seeded tiling KEY is a uniform.
    pub(super) fn functions(&self, cells: &Cells) -> Result<String, AtlasError> {
        let text = Shader::new(Language::GlslEs300, &self.tiling, cells, "tp")?.functions();
        Ok(match self.tiling.coloring() {
            Coloring::Hash { seed } => {
                let constant = Language::GlslEs300.constant("tp_KEY", hash::key(*seed).into());
                text.replace(&constant, "uniform uint tp_KEY;\n")
            }
            _ => text,
        })
    }
}

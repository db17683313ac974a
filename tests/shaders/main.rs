//! Shaders: accepted by the compilers of every language, and equal to Rust bit for bit on a WebGL
//! context; the viewer, driven by a script.
//!
//! Where a compiler or the browser is not installed, a test says so and passes, but not where `CI`
//! is `true`: `.ci/textures` installs them all.

#![allow(clippy::unwrap_used, clippy::panic)]

mod tools;
mod validate;
mod viewer;
mod webgl;

use tilepack::construct::construct;
use tilepack::tiles::{Kind, Members, TileSet};
use tilepack::tiling::{Cells, ColorMap, Coloring, Halton, Tiling};
use tilepack::torus::{Packing, Shape};

/// A tiling and its packing.
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) tiling: Tiling,
    pub(crate) packing: Packing,
    pub(crate) cells: Cells,
}

/// The constructed packing of a complete set.
pub(crate) fn constructed(kind: Kind, colors: &str) -> Packing {
    let set = TileSet::new(kind, colors.parse().unwrap(), Members::Complete).unwrap();
    construct(&set, Shape::default_for(&set).unwrap(), None).unwrap().packing()
}

impl Case {
    /// `coloring` is hash, halton or map, `lookup` table or formula.
    pub(crate) fn new(kind: Kind, colors: &str, coloring: &str, lookup: &str) -> Self {
        let packing = constructed(kind, colors);
        let how = match coloring {
            "hash" => Coloring::Hash { seed: 0xdead_beef },
            "halton" => {
                let grid = Shape::new(100, 50).unwrap();
                Coloring::Halton(Halton::of_tiles(kind, grid).unwrap())
            }
            _ => Coloring::Map(ColorMap::of(&packing).unwrap()),
        };
        let tiling = Tiling::new(kind, packing.set.colors(), how).unwrap();
        let cells = match lookup {
            "table" => Cells::table(&packing),
            _ => Cells::formula(&packing).unwrap(),
        };
        let name = format!("{kind} {colors} {coloring} {lookup}");
        Self { name, tiling, packing, cells }
    }

    /// Kinds and numbers of colors, odd and even, equal and not, with every coloring and lookup.
    pub(crate) fn all() -> Vec<Self> {
        let corner = ["2", "3", "4", "5", "16"].map(|colors| (Kind::Corner, colors));
        let wang = ["3", "2,5", "4,1"].map(|colors| (Kind::Wang, colors));
        let mut cases = Vec::new();
        for (kind, colors) in corner.into_iter().chain(wang) {
            for coloring in ["hash", "halton", "map"] {
                for lookup in ["table", "formula"] {
                    cases.push(Self::new(kind, colors, coloring, lookup));
                }
            }
        }
        cases
    }
}

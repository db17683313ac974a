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
use tilepack::tiling::{
    Cells, ColorMap, Coloring, Compact, Diagonal, Halton, Permuted, Probabilities, Sums, Tiling,
};
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

    /// A coloring, over all tiles that it can show, which lie in the order of their numbers.
    pub(crate) fn of(kind: Kind, colors: &str, name: &str, coloring: Coloring) -> Self {
        let tiling = Tiling::new(kind, colors.parse().unwrap(), coloring).unwrap();
        let set = TileSet::new(kind, tiling.colors(), tiling.needs()).unwrap();
        let shape = Shape::near_square(set.size()).unwrap();
        let packing = Packing::new(set.clone(), shape, false, set.allowed().collect());
        let cells = Cells::table(&packing);
        Self { name: format!("{kind} {colors} {name}"), tiling, packing, cells }
    }

    /// The colorings that are not of all kinds and numbers of colors.
    fn particular() -> Vec<Self> {
        let mut cases = Vec::new();
        for colors in ["3", "4", "8"] {
            let compact = Compact::of(colors.parse().unwrap(), 0xffff_fffb).unwrap();
            cases.push(Self::of(Kind::Corner, colors, "compact", Coloring::Compact(compact)));
        }
        for colors in ["3", "6"] {
            let diagonal = Diagonal::new(colors.parse().unwrap(), 77).unwrap();
            let compact = Coloring::Compact(Compact::Diagonal(diagonal));
            cases.push(Self::of(Kind::Corner, colors, "diagonal", compact));
        }
        for colors in ["3", "5"] {
            let one = Sums::one_hash(colors.parse().unwrap(), u32::MAX).unwrap();
            cases.push(Self::of(Kind::Wang, colors, "one hash", Coloring::Sums(one)));
        }
        let two = Coloring::Sums(Sums::two_hashes(u32::MAX));
        cases.push(Self::of(Kind::Wang, "2,5", "two hashes", two));
        for (kind, colors) in [(Kind::Corner, "5"), (Kind::Wang, "2,3")] {
            let long = Coloring::Permuted(Permuted::long(5));
            cases.push(Self::of(kind, colors, "long period", long));
            let short = Coloring::Permuted(Permuted::short(5));
            cases.push(Self::of(kind, colors, "permutation", short));
        }
        // Colors that fade into each other, in cells of one and of some points.
        for (scale, colors) in [([1, 1], 3), ([7, 5], 3), ([4, 1], 5)] {
            let shape = Shape::new(11, 6).unwrap();
            let weights: Vec<f64> = (0..shape.cells())
                .flat_map(|cell| {
                    let first = cell % colors;
                    let share = (cell % 11) as f64 / 10.0;
                    (0..colors).map(move |color| match (color + colors - first) % colors {
                        0 => 1.0 - share,
                        1 => share,
                        _ => 0.0,
                    })
                })
                .collect();
            let map = Probabilities::new(shape, scale, colors, &weights, 9).unwrap();
            let name = format!("probabilities {scale:?}");
            let coloring = Coloring::Probabilities(map);
            cases.push(Self::of(Kind::Corner, &colors.to_string(), &name, coloring));
        }
        cases
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
        cases.extend(Self::particular());
        cases
    }
}

//! Endless tilings, evaluated anywhere: the tile at a place, without those before it.
//!
//! A [`Tiling`] gives every corner, or every edge, of an endless grid a color ([`Coloring`]); the
//! tile at a place is the one that shows the colors around it. [`Cells`] then say where that tile
//! lies in a packing, by a table or in closed form.
//!
//! **Where things are**, here and in the shaders: `x` grows to the east and `y` to the **north**.
//! The tile `(x, y)` has its south-west corner at the lattice point `(x, y)` and its north-east
//! corner at `(x + 1, y + 1)`. Its south edge is the point `(2x + 1, 2y)` of a lattice twice as
//! fine, its west edge `(2x, 2y + 1)`; north and east are the south and west edge of the tiles
//! beyond. Rows of packings and pictures still go from north to south: the cell at `row` and
//! `column` of a torus repeated as it is, is the tile `x = column`, `y = -1 - row`, so that the
//! south-west cell is the tile `(0, 0)`.
//!
//! **How far**: coordinates from `-2^62` to `2^62`. Hashes take their lower 32 bits, so a hashed
//! tiling repeats after `2^32` corner tiles or `2^31` Wang tiles; shaders count in 32 bits and give
//! the same there.
//!
//! Sources: Lagae 2007, chapter 4 (hashing lattice points); Schlömer 2012, 2.4 (Halton). A new
//! coloring is a variant of [`Coloring`], an arm of [`Tiling::sides`], and a template of
//! [`crate::atlas::shader`].

mod block4;
mod cells;
mod color_map;
mod compact;
mod diagonal;
mod dipole;
mod draws;
mod error;
mod fill;
mod frame;
mod halton;
pub mod hash;
mod mixed;
mod permuted;
mod probabilities;
mod rows;
mod rule;
mod scanline;
mod stats;
mod sums;
mod support;
mod xor;

pub use block4::{Block4, PATTERNS, Patterns};
pub use cells::{Cells, Formula};
pub use color_map::ColorMap;
pub use compact::Compact;
pub use diagonal::Diagonal;
pub use error::TilingError;
pub use fill::{Square, filled, least_side};
pub use frame::Frames;
pub use halton::Halton;
pub use mixed::{Mixed, mixed};
pub use permuted::Permuted;
pub use probabilities::{Column, Probabilities};
pub use rule::{Rule, alternating};
pub use scanline::{Laid, scanline};
pub use stats::{Stats, stats};
pub use sums::Sums;
pub use xor::Xor;

use crate::tiles::{Colors, Kind, Members, TileId};
use crate::torus::Shape;
use std::convert::Infallible;

/// What gives corners and edges their colors.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Coloring {
    /// Independent colors by a hash of the place: every tile is as likely as any other.
    Hash {
        /// Chooses the tiling.
        seed: u32,
    },
    /// Colors along the Halton sequence: equal colors keep their distance.
    Halton(Halton),
    /// A picture of colors, repeated in both directions.
    Map(ColorMap),
    /// Corner tiles of a compact set: half as many as colors to the fourth or fewer.
    Compact(Compact),
    /// Wang tiles whose edges are sums of random colors on corners.
    Sums(Sums),
    /// A hash by tables of permutations.
    Permuted(Permuted),
    /// Corner tiles of random colors, with probabilities that differ from place to place.
    Probabilities(Probabilities),
}

/// An endless tiling.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tiling {
    kind: Kind,
    colors: Colors,
    coloring: Coloring,
}

/// The largest coordinate, and less its sign the smallest.
pub const FARTHEST: i64 = 1 << 62;

impl Tiling {
    /// Tiles of a kind over these colors.
    ///
    /// # Errors
    /// Dominoes, and a map of another kind or of other colors.
    pub fn new(kind: Kind, colors: Colors, coloring: Coloring) -> Result<Self, TilingError> {
        if kind == Kind::Domino {
            return Err(TilingError::Dominoes);
        }
        let corner = |fits: bool| kind == Kind::Corner && fits;
        let (what, fits) = match &coloring {
            Coloring::Hash { .. } | Coloring::Halton(_) | Coloring::Permuted(_) => {
                return Ok(Self { kind, colors, coloring });
            }
            Coloring::Map(map) if map.kind() != kind || map.colors() != colors => {
                return Err(TilingError::OtherMap {
                    map: format!("{} tiles over {} colors", map.kind(), map.colors()),
                    asked: format!("{kind} tiles over {colors} colors"),
                });
            }
            Coloring::Map(_) => ("a map", true),
            Coloring::Compact(compact) => {
                ("this compact set", corner(compact.has_colors(colors.horizontal())))
            }
            Coloring::Sums(sums) => (
                "sums of colors on corners",
                kind == Kind::Wang && (sums.two || colors.single().is_some()),
            ),
            Coloring::Probabilities(map) => {
                ("this map of probabilities", corner(map.colors() == colors.horizontal()))
            }
        };
        match fits {
            true => Ok(Self { kind, colors, coloring }),
            false => Err(TilingError::Mismatch { what, kind, colors }),
        }
    }

    /// The kind of its tiles.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The numbers of colors.
    pub fn colors(&self) -> Colors {
        self.colors
    }

    /// What gives the colors.
    pub fn coloring(&self) -> &Coloring {
        &self.coloring
    }

    /// Which tiles can occur: all over the colors, or these. A packing has to have them.
    pub fn needs(&self) -> Members {
        match &self.coloring {
            Coloring::Hash { .. } | Coloring::Halton(_) | Coloring::Permuted(_) => {
                Members::Complete
            }
            Coloring::Map(map) => Members::Explicit(map.tiles()),
            Coloring::Compact(compact) => {
                Members::Explicit(compact.rule().tiles(self.colors.horizontal()))
            }
            Coloring::Sums(sums) if sums.two => Members::Complete,
            Coloring::Sums(_) => Members::Explicit(alternating(self.colors.horizontal())),
            Coloring::Probabilities(map) => Members::Explicit(map.tiles()),
        }
    }

    /// The same in words, for messages: what a packing must be of.
    pub fn needs_words(&self) -> String {
        let of_set = |count: usize, set: &str| {
            format!("this coloring needs the {count} tiles of {set}; tile --set-out writes them")
        };
        match &self.coloring {
            Coloring::Compact(compact) => {
                let (rule, colors) = (compact.rule(), self.colors.horizontal());
                let set = format!("the compact {} set ({})", rule.name(), rule.words());
                of_set(rule.tiles(colors).len(), &set)
            }
            Coloring::Sums(sums) if !sums.two => {
                let count = self.colors.horizontal().pow(3);
                of_set(count, "the compact Wang set with N - E + S - W = 0 mod C")
            }
            Coloring::Probabilities(map) => of_set(map.tiles().len(), "its map of probabilities"),
            Coloring::Map(_) => "this coloring needs the tiles of its map".to_owned(),
            _ => "this coloring needs the complete set; for other sets, take --coloring compact, \
                  scanline or map:FILE, with the tiles that it needs"
                .to_owned(),
        }
    }

    /// Bits of freedom of a tile, in a large window: 0 when only few things can be chosen. Of blocks a
    /// lower bound.
    pub fn entropy(&self) -> f64 {
        let (h, v) = (self.colors.horizontal() as f64, self.colors.vertical() as f64);
        match (&self.coloring, self.kind) {
            (Coloring::Hash { .. }, Kind::Corner) => h.log2(),
            (Coloring::Hash { .. }, _) => h.log2() + v.log2(),
            (Coloring::Sums(sums), _) if sums.two => h.log2() + v.log2(),
            (Coloring::Sums(_), _) => h.log2(),
            (Coloring::Compact(compact), _) => compact.entropy(),
            (Coloring::Probabilities(map), _) => map.entropy(),
            (Coloring::Halton(_) | Coloring::Map(_) | Coloring::Permuted(_), _) => 0.0,
        }
    }

    /// The colors of the tile at a place, in the order of [`Kind::sides`].
    pub fn sides(&self, x: i64, y: i64) -> [u8; 4] {
        match &self.coloring {
            Coloring::Map(map) => map.sides(x, y),
            Coloring::Compact(Compact::Frames(frames)) => frames.sides(x, y),
            Coloring::Sums(sums) => sums.sides(x, y, self.colors),
            _ => self.around(x, y, |x, y, colors| self.point(x, y, colors)),
        }
    }

    /// The tile at a place.
    pub fn tile(&self, x: i64, y: i64) -> TileId {
        let (h, v) = (self.colors.horizontal() as u32, self.colors.vertical() as u32);
        let [a, b, c, d] = self.sides(x, y).map(u32::from);
        // Of corner tiles both numbers of colors are the same.
        TileId(((a * v + b) * h + c) * v + d)
    }

    /// The tiles of a window, row by row from the north; `x` and `y` are of its south-west tile.
    pub fn window(&self, x: i64, y: i64, shape: Shape) -> Vec<TileId> {
        let mut window = Vec::with_capacity(shape.cells());
        let all: Result<(), Infallible> = self.try_for_each_row(x, y, shape, |_, row| {
            window.extend_from_slice(row);
            Ok(())
        });
        match all {
            Ok(()) => window,
        }
    }

    /// The colors around a tile, when each is known from its point and the number of colors.
    fn around(&self, x: i64, y: i64, color: impl Fn(i64, i64, usize) -> u8) -> [u8; 4] {
        let (h, v) = (self.colors.horizontal(), self.colors.vertical());
        let (east, north) = (x.wrapping_add(1), y.wrapping_add(1));
        match self.kind {
            Kind::Corner => {
                [color(east, north, h), color(east, y, h), color(x, y, h), color(x, north, h)]
            }
            _ => {
                let [x2, y2, east2, north2] = [x, y, east, north].map(|at| at.wrapping_mul(2));
                [
                    color(x2.wrapping_add(1), north2, h),
                    color(east2, y2.wrapping_add(1), v),
                    color(x2.wrapping_add(1), y2, h),
                    color(x2, y2.wrapping_add(1), v),
                ]
            }
        }
    }
}

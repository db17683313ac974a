//! All Wang cubes: a ring along each of the three axes.
//!
//! The west and east colors of a cube form a domino over `CV` colors, its north and south colors
//! one over `CH`, its bottom and top colors one over `CZ`. Lay a ring of all the first along every
//! row, of the second down every column, of the third up every pillar. *Why every cube occurs
//! once:* on a torus of `CV^2` columns, `CH^2` rows and `CZ^2` layers every three dominoes meet in
//! exactly one cell, and a cube is three dominoes. *Why neighbors fit:* the domino of an axis
//! depends on the place along that axis alone, and next to each other on a ring they fit. Where a
//! cube lies is three positions in rings, in closed form.
//!
//! Source: the product of Wei 2004, section 4, once more; Wang cubes: Culik and Kari 1995.

use super::{Ring, Seed};
use crate::torus::{CubeSet, Cubes, places};

/// The packing of all Wang cubes as a product of three rings.
#[derive(Debug, Clone)]
pub struct WangCubes {
    set: CubeSet,
    /// North colors down a column, west colors along a row, bottom colors up a pillar.
    rings: [Ring; 3],
}

impl WangCubes {
    /// The product of the three least rings, or of three rings chosen by a seed. The kind of the
    /// set is not looked at.
    pub fn new(set: CubeSet, mut seed: Option<Seed>) -> Self {
        let rings = set.colors.map(|colors| Ring::choose(colors.into(), seed.as_mut()));
        Self { set, rings }
    }

    /// Numbers of layers, rows and columns: `CZ^2`, `CH^2`, `CV^2`.
    pub fn sides(&self) -> [usize; 3] {
        let [down, along, up] = &self.rings;
        [up.length(), down.length(), along.length()]
    }

    /// The colors of the cube in a cell: north, east, south, west, bottom, top.
    pub fn colors(&self, layer: usize, row: usize, column: usize) -> [u8; 6] {
        let [down, along, up] = &self.rings;
        let domino =
            |ring: &Ring, at: usize| (ring.colors()[at], ring.colors()[(at + 1) % ring.length()]);
        let (north, south) = domino(down, row);
        let (west, east) = domino(along, column);
        let (bottom, top) = domino(up, layer);
        [north, east, south, west, bottom, top]
    }

    /// Layer, row and column of the cube with these colors, each within its palette.
    pub fn find(&self, colors: [u8; 6]) -> (usize, usize, usize) {
        let [north, east, south, west, bottom, top] = colors;
        let [down, along, up] = &self.rings;
        (up.place(bottom, top), down.place(north, south), along.place(west, east))
    }

    /// The whole packing, numbered: four bytes a cube.
    pub fn packing(&self) -> Cubes {
        let [h, v, z] = self.set.colors.map(u32::from);
        let number = |[layer, row, column]: [usize; 3]| {
            let colors = self.colors(layer, row, column);
            let digits = colors.into_iter().zip([h, v, h, v, z, z]);
            digits.fold(0, |number, (color, radix)| number * radix + u32::from(color))
        };
        Cubes {
            set: self.set,
            sides: self.sides(),
            cubes: places(self.sides()).map(number).collect(),
        }
    }
}

//! Direct tilings of Wang tiles: the color of an edge is the sum of the colors of its two ends.
//!
//! Every lattice point has a random color; an edge shows the sum of those at its ends, modulo `C`.
//! With one color a point, for all four edges, the sums of a tile are not independent:
//! `N - E + S - W = 0`, so just `C^3` tiles occur, a compact set, each as likely as any other. With
//! two colors a point, one for horizontal and one for vertical edges, all tiles occur. (Lagae 2007,
//! section 4.3, where one subscript of the second hash is a slip.)

use super::TilingError;
use super::hash::{hash3, uni};
use crate::tiles::Colors;

/// A tiling by sums of colors on points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sums {
    /// Chooses the tiling.
    pub seed: u32,
    /// Whether horizontal and vertical edges have hashes of their own.
    pub two: bool,
}

impl Sums {
    /// The tiling of the compact set of `C^3` tiles.
    ///
    /// # Errors
    /// Different numbers of colors for horizontal and vertical edges.
    pub fn one_hash(colors: Colors, seed: u32) -> Result<Self, TilingError> {
        match colors.single() {
            Some(_) => Ok(Self { seed, two: false }),
            None => Err(TilingError::TwoPalettes(colors)),
        }
    }

    /// The tiling of the complete set.
    pub fn two_hashes(seed: u32) -> Self {
        Self { seed, two: true }
    }

    /// The seeds of the hashes for horizontal and vertical edges.
    pub fn hash_seeds(self) -> [u32; 2] {
        [self.seed, self.seed.wrapping_add(u32::from(self.two))]
    }

    /// The colors of a point, as part of horizontal and of vertical edges.
    fn point(self, x: i64, y: i64, colors: Colors) -> [usize; 2] {
        let numbers = [colors.horizontal(), colors.vertical()];
        std::array::from_fn(|which| {
            let hash = hash3(self.hash_seeds()[which], x as u32, y as u32);
            uni(hash, numbers[which] as u32) as usize
        })
    }

    /// The colors of the tile at a place: N, E, S, W.
    pub fn sides(self, x: i64, y: i64, colors: Colors) -> [u8; 4] {
        let (h, v) = (colors.horizontal(), colors.vertical());
        let (east, north) = (x.wrapping_add(1), y.wrapping_add(1));
        let [ne, se, sw, nw] =
            [(east, north), (east, y), (x, y), (x, north)].map(|(x, y)| self.point(x, y, colors));
        let horizontal = |a: [usize; 2], b: [usize; 2]| ((a[0] + b[0]) % h) as u8;
        let vertical = |a: [usize; 2], b: [usize; 2]| ((a[1] + b[1]) % v) as u8;
        [horizontal(nw, ne), vertical(ne, se), horizontal(sw, se), vertical(nw, sw)]
    }
}

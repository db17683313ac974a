//! Compact sets with a tiling that is evaluated anywhere: which tiles they are.
//!
//! A compact set of corner tiles has two tiles for every (NW, SW, SE); a rule says which two colors
//! NE may have, both by one formula modulo the number of colors `C`. All of them are balanced: every
//! color is as frequent on every corner. A tiling in which every NE obeys the rule has at most one
//! bit of freedom a tile, so a rule is chosen for how even its tilings look:
//!
//! * [`Rule::Xor`], `C` a power of two: NE in `{2 (NW xor SE), + 1}`. Two points of a random tiling are
//!   always independent.
//! * [`Rule::Difference`], every `C`: NE - NW - SE + SW in `{0, 1}`. The same.
//! * [`Rule::Diagonal`], every `C`: NE in `{2 SW, + 1}`. The simplest tiling, but points on a diagonal
//!   depend on each other, which is seen.
//!
//! For `C = 2` all of them are the complete set.

use crate::tiles::{Colors, Kind, Members, TileError, TileId, TileSet};

/// Which NE a compact set of corner tiles has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rule {
    /// `{2 (NW xor SE), 2 (NW xor SE) + 1}`, for powers of two.
    Xor,
    /// `{NW + SE - SW, NW + SE - SW + 1}`.
    Difference,
    /// `{2 SW, 2 SW + 1}`.
    Diagonal,
}

impl Rule {
    /// The name of the set in files and messages.
    pub fn name(self) -> &'static str {
        match self {
            Rule::Xor => "xor",
            Rule::Difference => "difference",
            Rule::Diagonal => "diagonal",
        }
    }

    /// The rule in words.
    pub fn words(self) -> &'static str {
        match self {
            Rule::Xor => "NE is 2 (NW xor SE) mod C or one more",
            Rule::Difference => "NE - NW - SE + SW is 0 or 1 mod C",
            Rule::Diagonal => "NE is 2 SW mod C or one more",
        }
    }

    /// The smaller choice for NE, before the bit is added; colors are below `colors`.
    pub fn base(self, colors: usize, [se, sw, nw]: [u8; 3]) -> u8 {
        let [se, sw, nw] = [se, sw, nw].map(usize::from);
        let base = match self {
            Rule::Xor => 2 * (nw ^ se),
            Rule::Difference => nw + se + colors - sw,
            Rule::Diagonal => 2 * sw,
        };
        (base % colors) as u8
    }

    /// Whether the rule admits a tile, of sides NE, SE, SW, NW.
    pub fn admits(self, colors: usize, [ne, se, sw, nw]: [u8; 4]) -> bool {
        let base = usize::from(self.base(colors, [se, sw, nw]));
        (usize::from(ne) + colors - base) % colors < 2
    }

    /// The tiles over this many colors, in order.
    pub fn tiles(self, colors: usize) -> Vec<TileId> {
        let c = colors as u32;
        let mut tiles = Vec::with_capacity(2 * colors.pow(3));
        for rest in 0..c * c * c {
            let sides = [rest / c / c, rest / c % c, rest % c].map(|color| color as u8);
            let base = u32::from(self.base(colors, sides));
            // One color has one tile.
            for bit in 0..2.min(c) {
                tiles.push(TileId((base + bit) % c * c * c * c + rest));
            }
        }
        tiles.sort_unstable();
        tiles
    }

    /// The set as it is packed.
    ///
    /// # Errors
    /// None for colors that a coloring accepts.
    pub fn set(self, colors: Colors) -> Result<TileSet, TileError> {
        let tiles = self.tiles(colors.horizontal());
        TileSet::new(Kind::Corner, colors, Members::Explicit(tiles))
    }
}

/// The compact set of Wang tiles over one palette whose edges are sums of colors on corners:
/// `N - E + S - W = 0` modulo `C`, so any three edges say the fourth. In order.
pub fn alternating(colors: usize) -> Vec<TileId> {
    let c = colors as u32;
    (0..c * c * c)
        .map(|first| {
            let (n, e, s) = (first / c / c, first / c % c, first % c);
            TileId(first * c + (n + s + c - e) % c)
        })
        .collect()
}

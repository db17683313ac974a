//! Wang tiles: a color on each edge.
//!
//! The number of a tile is `((N*CV + E)*CH + S)*CV + W` for `CH` colors on north and south
//! edges and `CV` colors on east and west edges (Lagae 2007, equation 2.2, with the radix of
//! each digit that of its palette).

use super::{Color, Colors, TileId};

/// A Wang tile.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Wang {
    /// North edge, one of `CH` colors.
    pub n: Color,
    /// East edge, one of `CV` colors.
    pub e: Color,
    /// South edge, one of `CH` colors.
    pub s: Color,
    /// West edge, one of `CV` colors.
    pub w: Color,
}

impl Wang {
    /// The number of the tile; the colors must be below their palettes' sizes.
    pub fn id(self, colors: Colors) -> TileId {
        let (h, v) = (colors.horizontal() as u32, colors.vertical() as u32);
        let [n, e, s, w] = [self.n, self.e, self.s, self.w].map(|x| u32::from(x.0));
        TileId(((n * v + e) * h + s) * v + w)
    }

    /// The tile with this number.
    pub fn from_id(tile: TileId, colors: Colors) -> Self {
        let (h, v) = (colors.horizontal() as u32, colors.vertical() as u32);
        Wang {
            n: Color((tile.0 / (v * h * v) % h) as u8),
            e: Color((tile.0 / (h * v) % v) as u8),
            s: Color((tile.0 / v % h) as u8),
            w: Color((tile.0 % v) as u8),
        }
    }
}

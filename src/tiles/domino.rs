//! Dominoes: the one-dimensional tile, a color on each end.
//!
//! On a ring laid along a row the first end is west and the second east; along a column the
//! first is north and the second south. The number of a domino is `first*C + second`. A ring
//! of dominoes is an Eulerian circuit of the digraph with an arc `first -> second` for each.

use super::{Color, Colors, TileId};

/// A domino.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Domino {
    /// West end in a row, north end in a column.
    pub first: Color,
    /// East end in a row, south end in a column.
    pub second: Color,
}

impl Domino {
    /// The number of the domino; the colors must be below the palette's size.
    pub fn id(self, colors: Colors) -> TileId {
        TileId(u32::from(self.first.0) * colors.vertical() as u32 + u32::from(self.second.0))
    }

    /// The domino with this number.
    pub fn from_id(tile: TileId, colors: Colors) -> Self {
        let c = colors.vertical() as u32;
        Domino { first: Color((tile.0 / c % c) as u8), second: Color((tile.0 % c) as u8) }
    }
}

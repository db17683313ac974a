//! Corner tiles: a color on each corner.
//!
//! The tile at row `r`, column `c` of a torus of lattice colors `a` has `NW = a[r][c]`,
//! `NE = a[r][c+1]`, `SW = a[r+1][c]`, `SE = a[r+1][c+1]`. Its number is
//! `((NE*C + SE)*C + SW)*C + NW` (Lagae 2007, equation 2.5).

use super::{Color, Colors, TileId};

/// A corner tile.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Corner {
    /// North-east corner.
    pub ne: Color,
    /// South-east corner.
    pub se: Color,
    /// South-west corner.
    pub sw: Color,
    /// North-west corner.
    pub nw: Color,
}

impl Corner {
    /// The number of the tile; the colors must be below the palette's size.
    pub fn id(self, colors: Colors) -> TileId {
        let c = colors.horizontal() as u32;
        let [ne, se, sw, nw] = [self.ne, self.se, self.sw, self.nw].map(|x| u32::from(x.0));
        TileId(((ne * c + se) * c + sw) * c + nw)
    }

    /// The tile with this number.
    pub fn from_id(tile: TileId, colors: Colors) -> Self {
        let c = colors.horizontal() as u32;
        let digit = |power: u32| Color((tile.0 / power % c) as u8);
        Corner { ne: digit(c * c * c), se: digit(c * c), sw: digit(c), nw: digit(1) }
    }
}

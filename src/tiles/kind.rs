//! The three kinds of tile, and the number of a tile.
//!
//! A tile is a short list of *sides* in a fixed order: corner tiles NE, SE, SW, NW; Wang tiles
//! N, E, S, W; dominoes first, second (west, east in a row; north, south in a column). Its
//! [`TileId`] is the mixed-radix number with these digits, the first side most significant.

use super::{Colors, Corner, Domino, TileError, Wang};
use std::fmt;
use std::str::FromStr;

/// The number of a tile among all tiles of its kind and colors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TileId(pub u32);

impl TileId {
    /// The number as an array index.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl fmt::Display for TileId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}

/// What carries the colors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Squares with colored corners.
    Corner,
    /// Squares with colored edges.
    Wang,
    /// Segments with colored ends.
    Domino,
}

impl Kind {
    /// The name used in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Corner => "corner",
            Kind::Wang => "wang",
            Kind::Domino => "domino",
        }
    }

    /// The names of the sides, in the order of the digits of a tile number.
    pub fn sides(self) -> &'static [&'static str] {
        match self {
            Kind::Corner => &["NE", "SE", "SW", "NW"],
            Kind::Wang => &["N", "E", "S", "W"],
            Kind::Domino => &["first", "second"],
        }
    }

    /// The number of colors that each side can take, in the order of [`Kind::sides`].
    ///
    /// A ring of dominoes lies along one axis and has the one palette of that axis: a ring in a
    /// row joins vertical edges, a ring in a column horizontal ones. Both counts are then equal.
    pub fn radices(self, colors: Colors) -> Vec<usize> {
        let (h, v) = (colors.horizontal(), colors.vertical());
        match self {
            Kind::Corner => vec![h; 4],
            Kind::Wang => vec![h, v, h, v],
            Kind::Domino => vec![v, v],
        }
    }

    /// How many tiles there are in all: one more than the largest tile number.
    pub fn tiles(self, colors: Colors) -> u64 {
        self.radices(colors).iter().map(|&r| r as u64).product()
    }

    /// The colors of a tile in the order of [`Kind::sides`]; unused places are 0.
    pub fn unpack(self, tile: TileId, colors: Colors) -> [u8; 4] {
        match self {
            Kind::Corner => {
                let t = Corner::from_id(tile, colors);
                [t.ne.0, t.se.0, t.sw.0, t.nw.0]
            }
            Kind::Wang => {
                let t = Wang::from_id(tile, colors);
                [t.n.0, t.e.0, t.s.0, t.w.0]
            }
            Kind::Domino => {
                let t = Domino::from_id(tile, colors);
                [t.first.0, t.second.0, 0, 0]
            }
        }
    }

    /// The number of the tile whose sides, in the order of [`Kind::sides`], have these colors.
    ///
    /// # Errors
    /// When a color is outside its palette.
    pub fn pack(self, sides: &[u8], colors: Colors) -> Result<TileId, TileError> {
        let mut id = 0u64;
        for (&color, radix) in sides.iter().zip(self.radices(colors)) {
            if usize::from(color) >= radix {
                return Err(TileError::ColorRange { color: color.into(), max: radix as u64 - 1 });
            }
            id = id * radix as u64 + u64::from(color);
        }
        Ok(TileId(id as u32))
    }

    /// The colors of a tile with the names of its sides, for messages: `NE 1, SE 0, ...`.
    pub fn describe(self, tile: TileId, colors: Colors) -> String {
        let values = self.unpack(tile, colors);
        let named: Vec<String> =
            self.sides().iter().zip(values).map(|(side, c)| format!("{side} {c}")).collect();
        named.join(", ")
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Kind {
    type Err = TileError;

    fn from_str(text: &str) -> Result<Self, TileError> {
        [Kind::Corner, Kind::Wang, Kind::Domino]
            .into_iter()
            .find(|kind| kind.name() == text)
            .ok_or_else(|| TileError::KindSyntax(text.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pack_inverts_unpack() {
        let palettes = [Colors::one(1), Colors::one(3), Colors::pair(2, 3), Colors::pair(4, 1)];
        for colors in palettes.map(Result::unwrap) {
            for kind in [Kind::Corner, Kind::Wang, Kind::Domino] {
                for id in 0..kind.tiles(colors) as u32 {
                    let sides = kind.unpack(TileId(id), colors);
                    let used = &sides[..kind.sides().len()];
                    assert_eq!(kind.pack(used, colors), Ok(TileId(id)), "{kind} {colors}");
                }
            }
        }
    }

    #[test]
    fn largest_tile_fits() {
        let colors = Colors::one(255).unwrap();
        assert_eq!(Kind::Corner.tiles(colors), 4_228_250_625);
        let last = Kind::Corner.pack(&[254; 4], colors).unwrap();
        assert_eq!(u64::from(last.0), 4_228_250_624);
        assert_eq!(Kind::Corner.unpack(last, colors), [254; 4]);
    }
}

//! A symmetry that a packing is required to have: a translation joined with a permutation of
//! the colors.
//!
//! `DX,DY:PERM` asks for `a[row + DY][col + DX] = PERM(a[row][col])`. The cells then fall into
//! orbits of `m` cells, `m` the order of the translation, and one color decides a whole orbit:
//! a search over `1/m` of the cells. For this to be a packing of a fixed set, `PERM^m` must be
//! the identity and no power `PERM^k`, `0 < k < m`, may leave a tile of the set in place, or
//! that tile would be needed at two places; the set itself must be kept.

use super::ColorMap;
use crate::tiles::{Colors, Kind, Members, TileSet};
use crate::torus::Shape;
use std::fmt;

/// A translation joined with a permutation of the colors.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Automorphism {
    /// Columns to the east.
    pub dx: u32,
    /// Rows to the south.
    pub dy: u32,
    /// What it does to the colors.
    pub map: ColorMap,
}

/// Why an automorphism cannot be asked for.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum AutomorphismError {
    /// Not of the form `DX,DY:PERM`.
    #[error(
        "automorphism '{0}': expected DX,DY:PERM, where PERM is +N or a list of all colors such as 1,2,0 \
         (for two palettes: horizontal/vertical)"
    )]
    Syntax(String),
    /// The list is not a permutation.
    #[error("automorphism '{text}': {list} is not a permutation of the colors 0 to {max}")]
    NotPermutation {
        /// The whole text.
        text: String,
        /// The list.
        list: String,
        /// The largest color.
        max: usize,
    },
    /// Two permutations where the tiles have one palette.
    #[error(
        "automorphism: {kind} tiles have one palette, but two different permutations are given"
    )]
    TwoPalettes {
        /// The kind of the tiles.
        kind: Kind,
    },
    /// The translation returns to its start after a number of steps, the colors do not.
    #[error(
        "automorphism: the translation by {dx},{dy} has order {order} on a {shape} torus, \
         but {order} times the color permutation is not the identity"
    )]
    Order {
        /// Columns.
        dx: u32,
        /// Rows.
        dy: u32,
        /// The order of the translation.
        order: usize,
        /// The torus.
        shape: Shape,
    },
    /// A tile would be needed twice.
    #[error(
        "automorphism: {power} times the color permutation leaves tile {tile} ({sides}) in place, \
         but moves it to another cell: the tile would occur twice"
    )]
    Collision {
        /// How often the permutation is applied.
        power: usize,
        /// The tile.
        tile: u32,
        /// Its colors.
        sides: String,
    },
    /// The set is not kept.
    #[error("automorphism: the color permutation takes tile {tile} ({sides}) out of the set")]
    SetNotKept {
        /// The tile.
        tile: u32,
        /// Its colors.
        sides: String,
    },
}

impl Automorphism {
    /// Reads `DX,DY:PERM`; negative steps go west and north.
    ///
    /// # Errors
    /// When the text has another form or a list is not a permutation.
    pub fn parse(text: &str, colors: Colors, shape: Shape) -> Result<Self, AutomorphismError> {
        let wrong = || AutomorphismError::Syntax(text.to_owned());
        let (steps, permutation) = text.split_once(':').ok_or_else(wrong)?;
        let (dx, dy) = steps.split_once(',').ok_or_else(wrong)?;
        let step = |digits: &str, side: usize| {
            let steps: i64 = digits.trim().parse().map_err(|_| wrong())?;
            Ok(steps.rem_euclid(side as i64) as u32)
        };
        let (dx, dy) = (step(dx, shape.width())?, step(dy, shape.height())?);
        let map = parse_map(text, permutation, colors)?;
        Ok(Self { dx, dy, map })
    }

    /// The order of the translation on a torus of this shape.
    pub fn order(&self, shape: Shape) -> usize {
        let order = |step: u32, side: usize| side / gcd(step as usize, side);
        let (x, y) = (order(self.dx, shape.width()), order(self.dy, shape.height()));
        x / gcd(x, y) * y
    }

    /// Checks that packings (with `cover`, coverings) of `set` can have it; gives the number of
    /// cells in an orbit.
    ///
    /// # Errors
    /// When the order does not fit the torus, a tile would collide with itself, or the set is
    /// not kept.
    pub fn check(
        &self,
        set: &TileSet,
        shape: Shape,
        cover: bool,
    ) -> Result<usize, AutomorphismError> {
        let kind = set.kind();
        if kind != Kind::Wang && self.map.horizontal() != self.map.vertical() {
            return Err(AutomorphismError::TwoPalettes { kind });
        }
        let order = self.order(shape);
        let powers = self.powers(order, set.colors());
        if !powers[order - 1].then(&self.map).is_identity() {
            return Err(AutomorphismError::Order { dx: self.dx, dy: self.dy, order, shape });
        }
        let colors = set.colors();
        let sides = |tile| kind.describe(tile, colors);
        let symmetric = matches!(set.members(), Members::Complete | Members::Compact);
        for tile in set.allowed() {
            if !symmetric && !set.allows(self.map.tile(kind, colors, tile)) {
                return Err(AutomorphismError::SetNotKept { tile: tile.0, sides: sides(tile) });
            }
            // A compact set may do without any tile that would collide; see `packing::compact`.
            if cover || set.is_compact() {
                continue;
            }
            let fixes = |&power: &usize| powers[power].tile(kind, colors, tile) == tile;
            if let Some(power) = (1..order).find(fixes) {
                let sides = sides(tile);
                return Err(AutomorphismError::Collision { power, tile: tile.0, sides });
            }
        }
        Ok(order)
    }

    /// The color maps of the powers 0 to `order - 1`.
    pub fn powers(&self, order: usize, colors: Colors) -> Vec<ColorMap> {
        let first = ColorMap::identity(colors);
        std::iter::successors(Some(first), |map| Some(map.then(&self.map))).take(order).collect()
    }
}

fn parse_map(text: &str, permutation: &str, colors: Colors) -> Result<ColorMap, AutomorphismError> {
    let wrong = || AutomorphismError::Syntax(text.to_owned());
    if let Some(amount) = permutation.strip_prefix('+') {
        let amount: u32 = amount.parse().map_err(|_| wrong())?;
        return Ok(ColorMap::shift(colors, amount as usize));
    }
    let list = |list: &str, count: usize| {
        let images: Result<Vec<u8>, _> = list.split(',').map(|c| c.trim().parse()).collect();
        let images = images.map_err(|_| wrong())?;
        let one = Colors::one(count as u64).map_err(|_| wrong())?;
        match ColorMap::new(one, images.clone(), images.clone()) {
            Some(_) => Ok(images),
            None => Err(AutomorphismError::NotPermutation {
                text: text.to_owned(),
                list: list.to_owned(),
                max: count - 1,
            }),
        }
    };
    let (h, v) = permutation.split_once('/').unwrap_or((permutation, permutation));
    let (h, v) = (list(h, colors.horizontal())?, list(v, colors.vertical())?);
    ColorMap::new(colors, h, v).ok_or_else(wrong)
}

/// The form that [`Automorphism::parse`] reads, with the images of all colors written out.
impl fmt::Display for Automorphism {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = |images: &[u8]| images.iter().map(u8::to_string).collect::<Vec<_>>().join(",");
        let (horizontal, vertical) = (list(self.map.horizontal()), list(self.map.vertical()));
        write!(f, "{},{}:{horizontal}", self.dx, self.dy)?;
        if vertical == horizontal { Ok(()) } else { write!(f, "/{vertical}") }
    }
}

/// The greatest common divisor; `gcd(0, n) = n`.
pub fn gcd(a: usize, b: usize) -> usize {
    if a == 0 { b } else { gcd(b % a, a) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn complete(colors: u64) -> TileSet {
        TileSet::new(Kind::Corner, Colors::one(colors).unwrap(), Members::Complete).unwrap()
    }

    fn check(text: &str, colors: u64) -> Result<usize, AutomorphismError> {
        let set = complete(colors);
        let shape = Shape::default_for(&set).unwrap();
        Automorphism::parse(text, set.colors(), shape)?.check(&set, shape, false)
    }

    #[test]
    fn accepts_what_fits() {
        assert_eq!(check("3,0:+1", 3), Ok(3));
        assert_eq!(check("4,0:1,2,3,0", 4), Ok(4));
        assert_eq!(check("0,-4:1,2,3,0", 4), Ok(4));
        assert_eq!(check("0,0:+0", 3), Ok(1));
    }

    #[test]
    fn refuses_what_does_not() {
        use AutomorphismError as E;
        assert!(matches!(check("2,0:+1", 3), Err(E::Collision { power: 3, .. })));
        assert!(matches!(check("1,0:+1", 3), Err(E::Collision { power: 3, tile: 0, .. })));
        assert!(matches!(check("3,0:1,0,2", 3), Err(E::Order { .. })));
        assert!(matches!(check("8,0:1,0,2,3", 4), Err(E::Collision { power: 1, .. })));
        assert!(matches!(check("8,0:1,0/0,1", 2), Err(E::TwoPalettes { .. })));
        assert!(matches!(check("3,0:1,1,2", 3), Err(E::NotPermutation { .. })));
        assert!(matches!(check("3,0:0,1", 3), Err(E::NotPermutation { .. })));
        for text in ["", "3", "3,0", "3:+1", "3,0:", "3,0:+", "3,0:a", "x,0:+1", "3,0,0:+1"] {
            assert!(matches!(check(text, 3), Err(E::Syntax(_))), "{text}");
        }
    }
}

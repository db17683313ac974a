//! Tile numbers to colors, many times over: division by multiplication.
//!
//! A number of colors `d` is at most 255, so with `m = 2^40 / d`, rounded up, `n m / 2^40` rounded
//! down is `n / d` for every `n` below `2^32`: the error `n (m d - 2^40)` is below `2^40`. And
//! `n m` stays below `2^64` when `n` is below the product of four numbers of colors, `d` among
//! them. Source: Granlund and Montgomery, *Division by invariant integers using multiplication*,
//! 1994.

use super::{Colors, Kind, TileId};

/// The scale of the reciprocals.
const SHIFT: u32 = 40;

/// Takes the tile numbers of a kind over some colors apart.
#[derive(Debug, Clone)]
pub struct Unpacker {
    /// For each side the number of its colors and its reciprocal; 1 where there is no side, as
    /// of dominoes: their numbers are below `2^16`.
    radices: [(u32, u64); 4],
}

impl Unpacker {
    /// For tiles of this kind.
    pub fn new(kind: Kind, colors: Colors) -> Self {
        let mut radices = [(1, 1 << SHIFT); 4];
        for (place, d) in radices.iter_mut().zip(kind.radices(colors)) {
            *place = (d as u32, (1u64 << SHIFT).div_ceil(d as u64));
        }
        Self { radices }
    }

    /// The same as [`Kind::unpack`].
    #[inline]
    pub fn sides(&self, tile: TileId) -> [u8; 4] {
        let mut colors = [0; 4];
        let mut rest = tile.0;
        for side in (0..4).rev() {
            let (d, reciprocal) = self.radices[side];
            let quotient = ((u64::from(rest) * reciprocal) >> SHIFT) as u32;
            colors[side] = (rest - quotient * d) as u8;
            rest = quotient;
        }
        colors
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_by_division() {
        for kind in [Kind::Corner, Kind::Wang, Kind::Domino] {
            for (h, v) in (1..=255).map(|h| (h, if kind == Kind::Corner { h } else { 256 - h })) {
                let Ok(colors) = Colors::pair(h, v) else { continue };
                let unpacker = Unpacker::new(kind, colors);
                let tiles = kind.tiles(colors);
                let step = tiles / 997 + 1;
                for tile in (0..tiles).step_by(step as usize).chain([tiles - 1]) {
                    let tile = TileId(tile as u32);
                    assert_eq!(unpacker.sides(tile), kind.unpack(tile, colors), "{kind} {colors}");
                }
            }
        }
    }
}

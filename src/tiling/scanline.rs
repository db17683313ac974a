//! Scanline tilings: tile after tile, each drawn from those that fit the ones before.
//!
//! The oldest way to tile with Wang tiles (Cohen, Shade, Hiller and Deussen 2003): a tile is drawn,
//! each as likely as any other, among those whose known sides fit. Compact sets are made for it:
//! two tiles fit. **Wang tiles** are laid from the north to the south and from the west to the east, so
//! N and W are known, S and E free. **Corner tiles** are laid from the *south* to the north, and from the
//! west to the east: SW, SE and NW are known, and NE is free, as in the definition of a compact set.
//! The choice at a place is by a hash of the place, but depends on all tiles before: a window that
//! begins elsewhere is another tiling.
//!
//! Any set will do as long as some tile fits; there is no way back.

use super::TilingError;
use super::hash::{hash3, uni};
use crate::tiles::{Kind, TileId, TileSet};
use crate::torus::Shape;
use std::collections::HashMap;

/// A window that was laid.
#[derive(Debug, Clone, PartialEq)]
pub struct Laid {
    /// Its tiles, row by row from the north.
    pub tiles: Vec<TileId>,
    /// Bits of choice a tile: the mean of the logarithms of how many fitted.
    pub entropy: f64,
}

/// Stands for a side that is not known; no color is as large.
const FREE: u8 = u8::MAX;

/// Lays a window with the tiles of a set; `x` and `y` are of its south-west tile.
///
/// # Errors
/// Dominoes, a compact set (which does not say what its tiles are), a place where no tile fits.
pub fn scanline(
    set: &TileSet,
    x: i64,
    y: i64,
    shape: Shape,
    seed: u32,
) -> Result<Laid, TilingError> {
    let (kind, colors) = (set.kind(), set.colors());
    if kind == Kind::Domino {
        return Err(TilingError::Dominoes);
    }
    if set.is_compact() {
        return Err(TilingError::NoTiles);
    }
    let (width, height) = (shape.width(), shape.height());
    // Sides that a tile shares with the one to the west, and with that in the row before.
    let (west, before): (&[usize], &[usize]) =
        if kind == Kind::Corner { (&[2, 3], &[1, 2]) } else { (&[3], &[0]) };
    let known = |sides: [u8; 4], has_west: bool, has_before: bool| -> [u8; 4] {
        std::array::from_fn(|side| {
            let is = has_west && west.contains(&side) || has_before && before.contains(&side);
            if is { sides[side] } else { FREE }
        })
    };
    let mut fitting: HashMap<[u8; 4], Vec<TileId>> = HashMap::new();
    for tile in set.allowed() {
        let sides = kind.unpack(tile, colors);
        for (has_west, has_before) in [(false, false), (false, true), (true, false), (true, true)] {
            fitting.entry(known(sides, has_west, has_before)).or_default().push(tile);
        }
    }
    let mut tiles = vec![TileId(0); shape.cells()];
    let mut bits = 0.0;
    for step in 0..height {
        // Rows in the picture, the first in the north.
        let (row, before) = match kind {
            Kind::Corner => (height - 1 - step, (height - step) % height),
            _ => (step, (step + height - 1) % height),
        };
        for column in 0..width {
            let mut sides = [FREE; 4];
            if column > 0 {
                let [a, b, _, _] = kind.unpack(tiles[row * width + column - 1], colors);
                // The east of that tile: NE and SE, or E.
                match kind {
                    Kind::Corner => (sides[3], sides[2]) = (a, b),
                    _ => sides[3] = b,
                }
            }
            if step > 0 {
                let [ne, _, third, nw] = kind.unpack(tiles[before * width + column], colors);
                match kind {
                    Kind::Corner => (sides[1], sides[2]) = (ne, nw),
                    _ => sides[0] = third,
                }
            }
            let (at_x, at_y) =
                (x.wrapping_add(column as i64), y.wrapping_add((height - 1 - row) as i64));
            let Some(choices) = fitting.get(&sides) else {
                return Err(TilingError::NothingFits { x: at_x, y: at_y });
            };
            let hash = hash3(seed.wrapping_add(10), at_x as u32, at_y as u32);
            tiles[row * width + column] = choices[uni(hash, choices.len() as u32) as usize];
            bits += (choices.len() as f64).log2();
        }
    }
    Ok(Laid { tiles, entropy: bits / shape.cells() as f64 })
}

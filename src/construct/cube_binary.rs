//! The 256 corner cubes over two colors on a torus of 8 x 8 x 4, closer to a cube than the stack
//! of 4 x 4 x 16.
//!
//! Layers are the 8 x 8 array `a`, `a + D`, `a + 1` and `a + D + 1`, modulo 2, where `D` is the
//! 4 x 4 packing of the corner tiles repeated. From a layer to the next a window changes by a
//! window of `D` (from even layers) or of its complement (from odd ones), so a lower and an upper
//! face together leave two places in `D`, one for either sort of layer, and with it 32 cells;
//! `a`, found by search, tells these apart.
//!
//! Source: this project; every cube is counted in a test.

use super::corner_even::BASE;

/// Rows of the lowest layer, a bit a cell, the first cell the highest.
const LOWEST: [u8; 8] = [
    0b0101_1000,
    0b0110_0001,
    0b1111_1011,
    0b0101_1100,
    0b0111_0101,
    0b1000_0011,
    0b0111_0011,
    0b1010_1111,
];

/// Numbers of layers, rows and columns.
pub const SIDES: [usize; 3] = [4, 8, 8];

/// The color at a point, below [`SIDES`].
pub fn color(layer: usize, row: usize, column: usize) -> u8 {
    let base = if layer % 2 == 1 { BASE[row % 4][column % 4] } else { 0 };
    ((LOWEST[row] >> (7 - column) & 1) + base + (layer / 2) as u8) % 2
}

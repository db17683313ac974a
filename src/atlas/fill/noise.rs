//! Random texels: the hardest pictures to filter, for nothing agrees but what has to.

use super::{Canvas, hash};
use crate::atlas::{AtlasError, Format, Image, TileImages};
use crate::tiles::{Kind, TileId};

/// Independent random samples; a function of the seed, and of what a texel may depend on.
#[derive(Debug, Clone, Copy)]
pub struct Noise {
    /// What the pictures have in common.
    pub canvas: Canvas,
    /// Seed of the samples.
    pub seed: u64,
    /// Whether the corner squares of Wang tiles differ from tile to tile: the *corner problem*,
    /// for tests. Corner tiles do not have it.
    pub loose_corners: bool,
}

impl Noise {
    /// What a texel depends on: a name of the part of the tile it lies in.
    fn part(&self, tile: TileId, sides: [u8; 4], x: usize, y: usize) -> [u64; 2] {
        let Canvas { kind, side, strip, .. } = self.canvas;
        let (north, south) = (y < strip, y >= side - strip);
        let (west, east) = (x < strip, x >= side - strip);
        let [a, b, c, d] = sides.map(u64::from);
        let whole = [0, tile.0.into()];
        let pair = |name: u64, from: u64, to: u64| [name, from << 8 | to];
        match (kind, north, east, south, west) {
            (_, false, false, false, false) => whole,
            (Kind::Wang, true, false, false, false) => [1, a],
            (Kind::Wang, false, true, false, false) => [2, b],
            (Kind::Wang, false, false, true, false) => [3, c],
            (Kind::Wang, false, false, false, true) => [4, d],
            (Kind::Wang, ..) if self.loose_corners => whole,
            (Kind::Wang, ..) => [5, 0],
            (_, true, true, ..) => [6, a],
            (_, _, true, true, _) => [7, b],
            (_, _, _, true, true) => [8, c],
            (_, true, _, _, true) => [9, d],
            (_, true, ..) => pair(1, d, a),
            (_, _, true, ..) => pair(2, a, b),
            (_, _, _, true, _) => pair(3, c, b),
            _ => pair(4, d, c),
        }
    }
}

impl TileImages for Noise {
    fn side(&self) -> usize {
        self.canvas.side
    }

    fn format(&self) -> Format {
        self.canvas.format
    }

    fn draw(&self, tile: TileId) -> Result<Image, AtlasError> {
        let Canvas { side, format, .. } = self.canvas;
        let sides = self.canvas.sides(tile);
        let mut image = Image::new(side, side, format);
        let bytes = format.bytes();
        for y in 0..side {
            for x in 0..side {
                let [name, of] = self.part(tile, sides, x, y);
                let random = hash([self.seed, name, of, (y * side + x) as u64]);
                image.row_mut(y)[x * bytes..][..bytes]
                    .copy_from_slice(&random.to_le_bytes()[..bytes]);
            }
        }
        Ok(image)
    }
}

//! Brick Wang tiles with bricks and mortar, as pictures that fit on each other.
//!
//! Where a brick ends is known in each tile from the positions of its edges. Near a side only the
//! joint that crosses it is to be seen, straight; the rest is one clay with a grain that repeats from
//! tile to tile. So all tiles with a position on a side look alike there.

use super::super::picture::wall::{CLAYS, JOINT, MORTAR, ROUND};
use super::super::{AtlasError, Format, Image, TileImages};
use super::{Canvas, hash};
use crate::dappled::brick::place;
use crate::tiles::TileId;

/// Width of the edge of a brick that catches light or lies in shade, in tile sides.
const BEVEL: f64 = 0.05;

/// Draws brick Wang tiles.
#[derive(Debug, Clone, Copy)]
pub struct Bricks {
    /// The pictures: Wang tiles with one palette, a color for each position.
    pub canvas: Canvas,
    /// Of the grain.
    pub seed: u64,
}

impl Bricks {
    /// A number from -1 to 1 that is smooth between points of a grid that repeats with the tile.
    fn cloud(&self, x: f64, y: f64, cells: u64, salt: u64) -> f64 {
        let (x, y) = (x * cells as f64, y * cells as f64);
        let point = |dx: u64, dy: u64| {
            let (px, py) = ((x as u64 + dx) % cells, (y as u64 + dy) % cells);
            (hash([self.seed, salt, px, py]) >> 40) as f64 / (1_u64 << 23) as f64 - 1.0
        };
        let smooth = |t: f64| t * t * (3.0 - 2.0 * t);
        let (u, v) = (smooth(x.fract()), smooth(y.fract()));
        let mix = |a: f64, b: f64, t: f64| a + (b - a) * t;
        mix(mix(point(0, 0), point(1, 0), u), mix(point(0, 1), point(1, 1), u), v)
    }

    /// The look of a place in a tile; `texel` is its size.
    fn look(&self, tile: TileId, [n, e, s, w]: [f64; 4], x: f64, y: f64, texel: f64) -> [f64; 3] {
        // Which of the four bricks: its joints are at `jx` and `jy`.
        let (left, high) = match w == e {
            true if y < w => (x < n, true),
            true => (x < s, false),
            false if x < n => (true, y < w),
            false => (false, y < e),
        };
        let (jx, jy) = (if high { n } else { s }, if left { w } else { e });
        // From the face of the brick to its ends.
        let (dx, dy) = ((x - jx).abs() - JOINT / 2.0, (y - jy).abs() - JOINT / 2.0);
        let inside = match dx < ROUND && dy < ROUND {
            true => ROUND - (ROUND - dx).hypot(ROUND - dy),
            false => dx.min(dy),
        };
        let covered = (inside / texel + 0.5).clamp(0.0, 1.0);
        // Light from the north-west.
        let edge = |d: f64, far: bool| {
            let near = (1.0 - d.max(0.0) / BEVEL).max(0.0);
            if far { -near * near } else { near * near }
        };
        let light = 0.16 * edge(dy, high) + 0.08 * edge(dx, left);
        // Far from the sides blotches of the tile's own.
        let deep = x.min(y).min(1.0 - x).min(1.0 - y);
        let own = ((deep - 0.125) * 6.0).clamp(0.0, 1.0);
        let blotch = own * self.cloud(x, y, 5, 0x51 + u64::from(tile.0));
        let grain = 0.6 * self.cloud(x, y, 16, 1) + 0.4 * self.cloud(x, y, 32, 2);
        let face = 1.0 + light + 0.05 * grain + 0.05 * blotch;
        let shaded = if dx < 0.0 && !left || dy < 0.0 && !high { 0.0 } else { 0.12 };
        let ground = 1.0 + 0.03 * grain - shaded * f64::from(u8::from(inside < 0.0));
        std::array::from_fn(|i| {
            let brick = f64::from(CLAYS[0][i]) * face;
            let mortar = f64::from(MORTAR[i]) * ground;
            (brick * covered + mortar * (1.0 - covered)) / 255.0
        })
    }
}

impl TileImages for Bricks {
    fn side(&self) -> usize {
        self.canvas.side
    }

    fn format(&self) -> Format {
        self.canvas.format
    }

    fn draw(&self, tile: TileId) -> Result<Image, AtlasError> {
        let positions = self.canvas.colors.largest().min(255) as u8;
        let sides = self.canvas.sides(tile).map(|position| place(position, positions));
        let texel = 1.0 / self.canvas.side as f64;
        Ok(self.canvas.paint(|x, y| {
            let at = |texels: usize| (texels as f64 + 0.5) * texel;
            self.look(tile, sides, at(x), at(y), texel).map(|sample| sample as f32)
        }))
    }
}

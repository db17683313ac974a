//! The direct tiling of the difference set over any number of colors, by blocks.
//!
//! As in [`super::block4`], the points with a coordinate that the side `B` of a block divides are
//! colored at random, and nothing has to hold there: every tile lies in one block. The bits
//! `D = NE - NW - SE + SW` of the tiles of a block have sums along its rows and columns that follow
//! from the frame, and [`super::fill`] finds bits that have them. A point then has the color of the frame
//! in its south, plus that in its west, less that of the corner, plus the sum of the bits between.
//!
//! One tile costs a whole block, `B^2` steps; a window evaluates every block once.

use super::TilingError;
use super::fill::{filled, least_side};
use super::hash::{hash3, uni};

/// A tiling of the difference set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Frames {
    /// Colors, from 2 to 64.
    colors: usize,
    /// Tiles along a side of a block.
    side: usize,
    /// Chooses the tiling.
    seed: u32,
}

/// Colors at most: a block then has 252 tiles a side.
const MOST: usize = 64;

impl Frames {
    /// The tiling over this many colors, by blocks of 16 tiles a side, or of as many as are needed.
    ///
    /// # Errors
    /// Fewer than 2 or more than 64 colors.
    pub fn new(colors: usize, seed: u32) -> Result<Self, TilingError> {
        if !(2..=MOST).contains(&colors) {
            return Err(TilingError::FrameColors { colors, most: MOST });
        }
        Ok(Self { colors, side: least_side(colors).max(16), seed })
    }

    /// The number of colors.
    pub fn colors(self) -> usize {
        self.colors
    }

    /// Tiles along a side of a block.
    pub fn side(self) -> usize {
        self.side
    }

    /// What chooses the tiling.
    pub fn seed(self) -> u32 {
        self.seed
    }

    fn frame(self, x: i64, y: i64) -> usize {
        uni(hash3(self.seed.wrapping_add(2), x as u32, y as u32), self.colors as u32) as usize
    }

    /// The colors of all points of a block and around it, `B + 1` in a row, rows from the south.
    pub fn block(self, x: i64, y: i64) -> Vec<u8> {
        let (c, side) = (self.colors, self.side);
        let (x0, y0) = (x.wrapping_mul(side as i64), y.wrapping_mul(side as i64));
        let line = |dx: i64, dy: i64, from: (i64, i64)| -> Vec<usize> {
            let points = 0..=side as i64;
            points
                .map(|at| self.frame(from.0.wrapping_add(dx * at), from.1.wrapping_add(dy * at)))
                .collect()
        };
        let beyond = (x0.wrapping_add(side as i64), y0.wrapping_add(side as i64));
        let (south, north) = (line(1, 0, (x0, y0)), line(1, 0, (x0, beyond.1)));
        let (west, east) = (line(0, 1, (x0, y0)), line(0, 1, (beyond.0, y0)));
        let sums = |near: &[usize], far: &[usize]| -> Vec<usize> {
            let lines = near.windows(2).zip(far.windows(2));
            lines.map(|(n, f)| (f[1] + n[0] + 2 * c - f[0] - n[1]) % c).collect()
        };
        let (rows, columns) = (sums(&west, &east), sums(&south, &north));
        let hash = hash3(self.seed.wrapping_add(4), x as u32, y as u32);
        let bits = filled(c, &rows, &columns, hash).bits;
        let mut colors = Vec::with_capacity((side + 1) * (side + 1));
        // For every column the sum of the bits below the row.
        let mut below = vec![0; side];
        for v in 0..=side {
            let mut sum = 0;
            for u in 0..=side {
                colors.push(((south[u] + west[v] + c - south[0] + sum) % c) as u8);
                if u < side {
                    sum += below[u];
                }
            }
            if v < side {
                for (sum, bit) in below.iter_mut().zip(&bits[v * side..]) {
                    *sum += usize::from(*bit);
                }
            }
        }
        colors
    }

    /// The color of a point.
    pub fn color(self, x: i64, y: i64) -> u8 {
        let side = self.side as i64;
        let block = self.block(x.div_euclid(side), y.div_euclid(side));
        let (u, v) = (x.rem_euclid(side) as usize, y.rem_euclid(side) as usize);
        block[v * (self.side + 1) + u]
    }

    /// The colors of the tile at a place: NE, SE, SW, NW, all from one block.
    pub fn sides(self, x: i64, y: i64) -> [u8; 4] {
        let side = self.side as i64;
        let block = self.block(x.div_euclid(side), y.div_euclid(side));
        let (u, v) = (x.rem_euclid(side) as usize, y.rem_euclid(side) as usize);
        let at = |u: usize, v: usize| block[v * (self.side + 1) + u];
        [at(u + 1, v + 1), at(u + 1, v), at(u, v), at(u, v + 1)]
    }

    /// A lower bound of the bits of freedom of a tile: the frame, the random cells, and the choice of
    /// cells in the strips; the corners of blocks count nothing.
    pub fn entropy(self) -> f64 {
        let (c, b) = (self.colors as f64, self.side as f64);
        let (corner, units) = (2.0 * c, self.colors - 1);
        let beside = b - corner;
        let free = b * b - 2.0 * beside * units as f64 - corner * corner;
        let log_choose = |t: usize| -> f64 {
            (0..t).map(|at| ((units - at) as f64 / (at + 1) as f64).log2()).sum()
        };
        let choices: f64 = (0..self.colors).map(log_choose).sum::<f64>() / c;
        ((2.0 * b - 1.0) * c.log2() + free + 2.0 * beside * choices) / (b * b)
    }
}

/// Rows of colors: the blocks of a row of them are kept.
#[derive(Debug)]
pub(super) struct FrameRows {
    frames: Frames,
    x: i64,
    /// The row of blocks known, and their points, `B` rows from the south.
    known: Option<i64>,
    points: Vec<Vec<u8>>,
}

impl FrameRows {
    pub(super) fn new(frames: Frames, x: i64, count: usize) -> Self {
        Self { frames, x, known: None, points: vec![vec![0; count]; frames.side] }
    }

    /// The colors of the row `y`.
    pub(super) fn row(&mut self, y: i64, colors: &mut [u8]) {
        let side = self.frames.side as i64;
        let row = y.div_euclid(side);
        if self.known != Some(row) {
            self.known = Some(row);
            let count = self.points[0].len();
            let mut at = 0;
            while at < count {
                let x = self.x.wrapping_add(at as i64);
                let from = x.rem_euclid(side) as usize;
                let width = (self.frames.side - from).min(count - at);
                let block = self.frames.block(x.div_euclid(side), row);
                for (v, points) in self.points.iter_mut().enumerate() {
                    let begin = v * (self.frames.side + 1) + from;
                    points[at..at + width].copy_from_slice(&block[begin..begin + width]);
                }
                at += width;
            }
        }
        colors.copy_from_slice(&self.points[y.rem_euclid(side) as usize]);
    }
}

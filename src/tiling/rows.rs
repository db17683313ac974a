//! Windows of tilings, row by row from the north: what neighbors share is computed once.
//!
//! The colors of a row of points are those of the row of tiles above and of the one below, so every
//! point is colored once; what a hash mixes of the row, what the Halton sequence makes of a column,
//! the bits of an xor set, the blocks of a difference set are kept. A window takes memory for some
//! rows, however high it is. That a row is what [`Tiling::tile`] says, tile by tile, is tested.

use super::block4::Block4Rows;
use super::frame::FrameRows;
use super::halton::HaltonRows;
use super::hash::{hash3, key, mix, uni};
use super::xor::XorRows;
use super::{Coloring, Compact, Sums, Tiling};
use crate::tiles::{Kind, TileId};
use crate::torus::Shape;

/// The rows of a window from the north.
impl Tiling {
    /// Gives the tiles of a window row by row from the north, each with its `y`, until something goes
    /// wrong; `x` and `y` are of the south-west tile.
    ///
    /// # Errors
    /// What `each` reports.
    pub fn try_for_each_row<E>(
        &self,
        x: i64,
        y: i64,
        shape: Shape,
        mut each: impl FnMut(i64, &[TileId]) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut tiles = vec![TileId(0); shape.width()];
        let mut rows = (0..shape.height() as i64).rev().map(|row| y.wrapping_add(row));
        match (&self.coloring, self.kind) {
            (Coloring::Map(_), _) => rows.try_for_each(|y| {
                for (tile, at) in tiles.iter_mut().zip(0..) {
                    *tile = self.tile(x.wrapping_add(at), y);
                }
                each(y, &tiles)
            }),
            (Coloring::Sums(sums), _) => {
                let mut edges = SumRows::new(self, *sums, x, shape.width());
                rows.try_for_each(|y| {
                    edges.row(y, &mut tiles);
                    each(y, &tiles)
                })
            }
            (_, Kind::Corner) => {
                let mut points = Points::new(self, x, 1, shape.width() + 1, self.colors.largest());
                let mut north = vec![0; shape.width() + 1];
                let mut south = north.clone();
                points.row(y.wrapping_add(shape.height() as i64), &mut north);
                rows.try_for_each(|y| {
                    points.row(y, &mut south);
                    corner_tiles(self.colors.horizontal() as u32, &north, &south, &mut tiles);
                    std::mem::swap(&mut north, &mut south);
                    each(y, &tiles)
                })
            }
            _ => {
                let (h, v) = (self.colors.horizontal(), self.colors.vertical());
                let twice = x.wrapping_mul(2);
                let mut across = Points::new(self, twice.wrapping_add(1), 2, shape.width(), h);
                let mut along = Points::new(self, twice, 2, shape.width() + 1, v);
                let mut north = vec![0; shape.width()];
                let (mut south, mut sides) = (north.clone(), vec![0; shape.width() + 1]);
                let fine = |y: i64| y.wrapping_mul(2);
                across.row(fine(y.wrapping_add(shape.height() as i64)), &mut north);
                rows.try_for_each(|y| {
                    across.row(fine(y), &mut south);
                    along.row(fine(y).wrapping_add(1), &mut sides);
                    wang_tiles([h, v].map(|n| n as u32), &north, &south, &sides, &mut tiles);
                    std::mem::swap(&mut north, &mut south);
                    each(y, &tiles)
                })
            }
        }
    }
}

/// Tiles between two rows of corners.
fn corner_tiles(colors: u32, north: &[u8], south: &[u8], tiles: &mut [TileId]) {
    let pairs = north.windows(2).zip(south.windows(2));
    for (tile, (n, s)) in tiles.iter_mut().zip(pairs) {
        let [nw, ne, sw, se] = [n[0], n[1], s[0], s[1]].map(u32::from);
        *tile = TileId(((ne * colors + se) * colors + sw) * colors + nw);
    }
}

/// Tiles between two rows of horizontal edges, and the vertical edges between them.
fn wang_tiles([h, v]: [u32; 2], north: &[u8], south: &[u8], sides: &[u8], tiles: &mut [TileId]) {
    let edges = north.iter().zip(south).zip(sides.windows(2));
    for (tile, ((&n, &s), sides)) in tiles.iter_mut().zip(edges) {
        let [n, s, w, e] = [n, s, sides[0], sides[1]].map(u32::from);
        *tile = TileId(((n * v + e) * h + s) * v + w);
    }
}

/// Rows of points, from the north to the south, of a coloring whose points each have a color.
enum Points<'a> {
    Hash { key: u32, x: u32, step: u32, colors: u32 },
    Halton(HaltonRows),
    Xor(XorRows),
    Block4(Block4Rows),
    Frames(FrameRows),
    Each { tiling: &'a Tiling, x: i64, step: i64, colors: usize },
}

impl<'a> Points<'a> {
    /// `count` points from `x` on, `step` apart, with so many colors; steps are 1 for corners.
    fn new(tiling: &'a Tiling, x: i64, step: u32, count: usize, colors: usize) -> Self {
        match &tiling.coloring {
            Coloring::Hash { seed } => {
                Points::Hash { key: key(*seed), x: x as u32, step, colors: colors as u32 }
            }
            Coloring::Halton(halton) => {
                Points::Halton(HaltonRows::new(*halton, x, step, count, colors))
            }
            Coloring::Compact(Compact::Xor(xor)) => Points::Xor(XorRows::new(*xor, x, count)),
            Coloring::Compact(Compact::Block4(block)) => {
                Points::Block4(Block4Rows::new(*block, x, count))
            }
            Coloring::Compact(Compact::Frames(frames)) => {
                Points::Frames(FrameRows::new(*frames, x, count))
            }
            _ => Points::Each { tiling, x, step: step.into(), colors },
        }
    }

    /// The colors of the row `y`.
    fn row(&mut self, y: i64, row: &mut [u8]) {
        match self {
            Points::Hash { key, x, step, colors } => {
                let begun = begun(*key, y);
                let first = begun.wrapping_add(*x);
                for (color, at) in row.iter_mut().zip(0u32..) {
                    *color = uni(mix(first.wrapping_add(at.wrapping_mul(*step))), *colors) as u8;
                }
            }
            Points::Halton(rows) => rows.row(y, row),
            Points::Xor(rows) => rows.row(y, row),
            Points::Block4(rows) => rows.row(y, row),
            Points::Frames(rows) => rows.row(y, row),
            Points::Each { tiling, x, step, colors } => {
                for (color, at) in row.iter_mut().zip(0..) {
                    *color = tiling.point(x.wrapping_add(at * *step), y, *colors);
                }
            }
        }
    }
}

/// What a hash makes of a row before it takes the column.
pub(super) fn begun(key: u32, y: i64) -> u32 {
    mix((y as u32).wrapping_add(key))
}

impl Tiling {
    /// The color of a point, for colorings whose points each have one.
    pub(super) fn point(&self, x: i64, y: i64, colors: usize) -> u8 {
        match &self.coloring {
            // The lower 32 bits: what a shader counts in.
            Coloring::Hash { seed } => uni(hash3(*seed, x as u32, y as u32), colors as u32) as u8,
            Coloring::Halton(halton) => halton.color(x, y, colors),
            Coloring::Compact(compact) => compact.color(x, y),
            Coloring::Permuted(tables) => tables.color(x, y, colors),
            Coloring::Probabilities(map) => map.color(x, y),
            // Their edges have colors, not their points.
            Coloring::Map(_) | Coloring::Sums(_) => 0,
        }
    }
}

/// Rows of tiles whose edges are sums.
struct SumRows {
    numbers: [u32; 2],
    keys: [u32; 2],
    x: u32,
    /// Colors of the points in the north and in the south, of either hash.
    north: [Vec<u8>; 2],
    south: [Vec<u8>; 2],
    known: Option<i64>,
}

impl SumRows {
    fn new(tiling: &Tiling, sums: Sums, x: i64, width: usize) -> Self {
        let numbers = [tiling.colors.horizontal(), tiling.colors.vertical()].map(|n| n as u32);
        let row = || [vec![0; width + 1], vec![0; width + 1]];
        let (keys, x) = (sums.hash_seeds().map(key), x as u32);
        Self { numbers, keys, x, north: row(), south: row(), known: None }
    }

    /// Colors the southern row of points.
    fn points(&mut self, y: i64) {
        for (which, row) in self.south.iter_mut().enumerate() {
            let first = begun(self.keys[which], y).wrapping_add(self.x);
            for (color, at) in row.iter_mut().zip(0u32..) {
                *color = uni(mix(first.wrapping_add(at)), self.numbers[which]) as u8;
            }
        }
    }

    fn row(&mut self, y: i64, tiles: &mut [TileId]) {
        if self.known != Some(y.wrapping_add(1)) {
            self.points(y.wrapping_add(1));
            std::mem::swap(&mut self.north, &mut self.south);
        }
        self.points(y);
        let [h, v] = self.numbers;
        let sum = |a: u8, b: u8, n: u32| {
            let sum = u32::from(a) + u32::from(b);
            if sum >= n { sum - n } else { sum }
        };
        let across = self.north[0].windows(2).zip(self.south[0].windows(2));
        let along = self.north[1].windows(2).zip(self.south[1].windows(2));
        for (tile, ((north, south), (up, down))) in tiles.iter_mut().zip(across.zip(along)) {
            let (n, s) = (sum(north[0], north[1], h), sum(south[0], south[1], h));
            let (e, w) = (sum(up[1], down[1], v), sum(up[0], down[0], v));
            *tile = TileId(((n * v + e) * h + s) * v + w);
        }
        std::mem::swap(&mut self.north, &mut self.south);
        self.known = Some(y);
    }
}

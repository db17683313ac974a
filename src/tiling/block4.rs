//! The direct tiling of the difference set over three colors, by blocks of 4 x 4 tiles and a table.
//!
//! The points with a coordinate that 4 divides, the *frame*, are colored at random, each by itself:
//! no tile has its four corners on the frame, so nothing has to hold there. Every tile lies in one
//! block. What remains of a block is a pattern of 16 bits, `D = NE - NW - SE + SW` for each tile, whose
//! sums along rows and columns modulo 3 follow from the frame. All 3^7 classes of sums that can be
//! have patterns, 16 to 90 of them; a hash of the block chooses one, each as likely as any other. The
//! color of a point is then that of the frame to its west and south, and the sum of the pattern
//! between.
//!
//! The law does not change when random colors are added along rows and columns, so any three corners
//! of a tile are independent, and so are any two points; every tile has probability 1/54. Counted over
//! all classes, a tile has 0.99664 of the one bit of freedom that there can be.

use super::hash::{hash3, key, mix, uni};
use super::rows::begun;
use std::sync::LazyLock;

/// A tiling of the difference set over three colors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Block4 {
    /// Chooses the tiling.
    pub seed: u32,
}

/// Tiles along a side of a block.
const SIDE: i64 = 4;

/// Classes of sums: four rows and three columns, modulo 3; the last column follows.
const CLASSES: usize = 2187;

/// All patterns of a block by their class, in order.
#[derive(Debug)]
pub struct Patterns {
    /// Where the patterns of each class begin; and the end.
    pub begins: Vec<u32>,
    /// Bit `4 v + u` is the tile in column `u` from the west, row `v` from the south.
    pub patterns: Vec<u16>,
}

/// The table, made when it is first asked for.
pub static PATTERNS: LazyLock<Patterns> = LazyLock::new(|| {
    let mut by_class: Vec<(u32, u16)> =
        (0..=u16::MAX).map(|pattern| (class_of(pattern), pattern)).collect();
    by_class.sort_unstable();
    let begins = (0..=CLASSES as u32)
        .map(|class| by_class.partition_point(|(of, _)| *of < class) as u32)
        .collect();
    Patterns { begins, patterns: by_class.into_iter().map(|(_, pattern)| pattern).collect() }
});

/// The class of sums, first those of the four rows from the south, then of the columns from the west.
fn class(sums: impl Iterator<Item = u32>) -> u32 {
    let weights = (0..7).map(|place| 3u32.pow(place));
    sums.zip(weights).map(|(sum, weight)| sum % 3 * weight).sum()
}

fn class_of(pattern: u16) -> u32 {
    let rows = (0..4).map(|v| (pattern >> (4 * v) & 15).count_ones());
    let columns = (0..3).map(|u| (pattern >> u & 0x1111).count_ones());
    class(rows.chain(columns))
}

/// The tiles of a block to the west of its column `u` and to the south of its row `v`.
const fn below(u: usize, v: usize) -> u16 {
    let row = (1u32 << u) - 1;
    let mut mask = 0;
    let mut at = 0;
    while at < v {
        mask |= row << (4 * at);
        at += 1;
    }
    mask as u16
}

/// [`below`] for all places, rows of five.
const BELOW: [[u16; 5]; 5] = {
    let mut masks = [[0; 5]; 5];
    let mut v = 0;
    while v < 5 {
        let mut u = 0;
        while u < 5 {
            masks[v][u] = below(u, v);
            u += 1;
        }
        v += 1;
    }
    masks
};

impl Block4 {
    /// The seed of the hash that colors the frame.
    pub fn frame_seed(self) -> u32 {
        self.seed.wrapping_add(2)
    }

    /// The seed of the hash that chooses the patterns of blocks.
    pub fn block_seed(self) -> u32 {
        self.seed.wrapping_add(4)
    }

    fn frame(self, x: i64, y: i64) -> u32 {
        uni(hash3(self.frame_seed(), x as u32, y as u32), 3)
    }

    /// The pattern of a block, which is known by its column and row, from its frame.
    pub(super) fn pattern(self, block: (i64, i64), frame: &Frame4) -> u16 {
        let (begin, count) = frame.patterns();
        let hash = hash3(self.block_seed(), block.0 as u32, block.1 as u32);
        PATTERNS.patterns[(begin + uni(hash, count)) as usize]
    }

    /// The color of a point.
    pub fn color(self, x: i64, y: i64) -> u8 {
        let block = (x.div_euclid(SIDE), y.div_euclid(SIDE));
        let (x0, y0) = (block.0 * SIDE, block.1 * SIDE);
        let point = |along: usize| along as i64;
        let frame = Frame4 {
            south: std::array::from_fn(|at| self.frame(x0.wrapping_add(point(at)), y0) as u8),
            north: std::array::from_fn(|at| {
                self.frame(x0.wrapping_add(point(at)), y0.wrapping_add(SIDE)) as u8
            }),
            west: std::array::from_fn(|at| self.frame(x0, y0.wrapping_add(point(at))) as u8),
            east: std::array::from_fn(|at| {
                self.frame(x0.wrapping_add(SIDE), y0.wrapping_add(point(at))) as u8
            }),
        };
        let (u, v) = ((x - x0) as usize, (y - y0) as usize);
        frame.color(self.pattern(block, &frame), u, v)
    }
}

/// The colors around a block: five points each.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame4 {
    pub(super) south: [u8; 5],
    pub(super) north: [u8; 5],
    pub(super) west: [u8; 5],
    pub(super) east: [u8; 5],
}

impl Frame4 {
    /// The first pattern that fits, and how many do.
    fn patterns(&self) -> (u32, u32) {
        // Between two points of a line and the two across: 6 keeps it from being negative.
        let sum = |near: &[u8; 5], far: &[u8; 5], at: usize| {
            u32::from(far[at + 1] + 6 - far[at] - near[at + 1] + near[at])
        };
        let rows = (0..4).map(|v| sum(&self.west, &self.east, v));
        let columns = (0..3).map(|u| sum(&self.south, &self.north, u));
        let class = class(rows.chain(columns)) as usize;
        let [begin, end] = [PATTERNS.begins[class], PATTERNS.begins[class + 1]];
        (begin, end - begin)
    }

    /// The color of the point in column `u` and row `v` of the block, both 0 to 4.
    pub(super) fn color(&self, pattern: u16, u: usize, v: usize) -> u8 {
        let ones = (pattern & BELOW[v][u]).count_ones() as u8;
        (self.south[u] + self.west[v] + 3 - self.south[0] + ones) % 3
    }
}

/// Rows of colors: the patterns of a row of blocks are kept.
#[derive(Debug)]
pub(super) struct Block4Rows {
    block: Block4,
    /// The first block, and how many points of it are left out.
    first: i64,
    skipped: usize,
    /// The row of blocks known.
    known: Option<i64>,
    /// The frame along rows in the south and north, four points a block and one more.
    south: Vec<u8>,
    north: Vec<u8>,
    /// The frame along columns: of every block the points of rows 0 to 4, and of the last one's east.
    columns: Vec<[u8; 5]>,
    patterns: Vec<u16>,
    /// The colors of whole blocks, before they are reduced.
    sums: Vec<u8>,
}

/// For four bits of a row of a pattern the sums of those before each, a byte each.
const BEFORE: [[u8; 4]; 16] = {
    let mut sums = [[0; 4]; 16];
    let mut bits = 0;
    while bits < 16 {
        let mut at = 1;
        while at < 4 {
            sums[bits][at] = sums[bits][at - 1] + (bits >> (at - 1) & 1) as u8;
            at += 1;
        }
        bits += 1;
    }
    sums
};

impl Block4Rows {
    pub(super) fn new(block: Block4, x: i64, count: usize) -> Self {
        let skipped = x.rem_euclid(SIDE) as usize;
        let blocks = (skipped + count).div_ceil(4);
        Self {
            block,
            first: x.div_euclid(SIDE),
            skipped,
            known: None,
            south: vec![0; 4 * blocks + 1],
            north: vec![0; 4 * blocks + 1],
            columns: vec![[0; 5]; blocks + 1],
            patterns: vec![0; blocks],
            sums: vec![0; 4 * blocks],
        }
    }

    /// Colors the frame of a row of blocks, and chooses their patterns.
    fn prepare(&mut self, row: i64) {
        let frame_key = key(self.block.frame_seed());
        let color = |begun: u32, x: i64| uni(mix((x as u32).wrapping_add(begun)), 3) as u8;
        let (x0, y0) = (self.first.wrapping_mul(SIDE), row.wrapping_mul(SIDE));
        let line = |points: &mut [u8], y: i64| {
            let begun = begun(frame_key, y);
            for (point, at) in points.iter_mut().zip(0..) {
                *point = color(begun, x0.wrapping_add(at));
            }
        };
        match self.known.is_some_and(|known| known == row.wrapping_add(1)) {
            true => std::mem::swap(&mut self.north, &mut self.south),
            false => line(&mut self.north, y0.wrapping_add(SIDE)),
        }
        line(&mut self.south, y0);
        for (at, column) in self.columns.iter_mut().enumerate() {
            (column[0], column[4]) = (self.south[4 * at], self.north[4 * at]);
        }
        for v in 1..4 {
            let begun = begun(frame_key, y0.wrapping_add(v as i64));
            for (column, at) in self.columns.iter_mut().zip(0..) {
                column[v] = color(begun, x0.wrapping_add(SIDE * at));
            }
        }
        let block_begun = begun(key(self.block.block_seed()), row);
        for (at, pattern) in self.patterns.iter_mut().enumerate() {
            let five = |row: &[u8]| std::array::from_fn(|u| row[4 * at + u]);
            let frame = Frame4 {
                south: five(&self.south),
                north: five(&self.north),
                west: self.columns[at],
                east: self.columns[at + 1],
            };
            let (begin, count) = frame.patterns();
            let hash = mix((self.first.wrapping_add(at as i64) as u32).wrapping_add(block_begun));
            *pattern = PATTERNS.patterns[(begin + uni(hash, count)) as usize];
        }
        self.known = Some(row);
    }

    /// The colors of the row `y`.
    pub(super) fn row(&mut self, y: i64, colors: &mut [u8]) {
        let row = y.div_euclid(SIDE);
        if self.known != Some(row) {
            self.prepare(row);
        }
        let v = y.rem_euclid(SIDE) as usize;
        let blocks = self.sums.chunks_exact_mut(4).zip(self.south.chunks_exact(4));
        for (((sums, south), pattern), column) in blocks.zip(&self.patterns).zip(&self.columns) {
            let shift = column[v] + 3 - column[0];
            let mut bytes = [south[0], south[1], south[2], south[3]].map(|color| color + shift);
            for below in 0..v {
                let before = BEFORE[usize::from(pattern >> (4 * below) & 15)];
                for (byte, more) in bytes.iter_mut().zip(before) {
                    *byte += more;
                }
            }
            sums.copy_from_slice(&bytes);
        }
        for (color, sum) in colors.iter_mut().zip(&self.sums[self.skipped..]) {
            *color = sum % 3;
        }
    }
}

//! What a texture filter reads for a sample: texels of the mip levels, with weights.
//!
//! Positions are in half texels of level 0, so that all that matters is whole. Between two
//! centers of texels a bilinear filter is linear in x and in y; so is every sum of such filters
//! between two *breaks* of any of them. The largest difference of two pictures therefore lies
//! where breaks of x and breaks of y cross (or on the border of the tile): only there we look.

use std::collections::{BTreeMap, BTreeSet};

/// A filter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Footprint {
    /// Four texels of a level.
    Bilinear {
        /// The level.
        level: usize,
    },
    /// Half way between this level and the next.
    Trilinear {
        /// The finer level.
        level: usize,
    },
    /// The mean of `ratio` bilinear samples, a texel of the level apart.
    Anisotropic {
        /// The level.
        level: usize,
        /// How many samples: a power of two.
        ratio: usize,
        /// The line they lie on.
        direction: Direction,
    },
}

/// Lines of samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// West to east.
    East,
    /// North to south.
    South,
    /// North-west to south-east.
    SouthEast,
    /// South-west to north-east.
    NorthEast,
}

impl Direction {
    /// All of them.
    pub const ALL: [Direction; 4] =
        [Direction::East, Direction::South, Direction::SouthEast, Direction::NorthEast];

    fn step(self) -> (i64, i64) {
        match self {
            Direction::East => (1, 0),
            Direction::South => (0, 1),
            Direction::SouthEast => (1, 1),
            Direction::NorthEast => (1, -1),
        }
    }
}

/// A texel that is read: its place in the level, from the north-west corner of the tile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tap {
    /// The mip level.
    pub level: usize,
    /// Columns to the east; negative in the neighbor to the west.
    pub x: isize,
    /// Rows to the south.
    pub y: isize,
    /// Its part of the sample; all parts add up to 1.
    pub weight: f64,
}

/// The taps of a sample that lie in one tile.
#[derive(Debug, Clone)]
pub struct Part {
    /// The tile: columns to the east and rows to the south.
    pub tile: (isize, isize),
    /// What is read there.
    pub taps: Vec<Tap>,
}

impl Footprint {
    /// The coarsest level it reads.
    pub fn coarsest(self) -> usize {
        match self {
            Footprint::Bilinear { level } | Footprint::Anisotropic { level, .. } => level,
            Footprint::Trilinear { level } => level + 1,
        }
    }

    /// All samples with their center in a tile of this side that read other tiles, where the
    /// largest differences lie.
    pub fn samples(self, side: usize) -> Vec<Vec<Part>> {
        let (columns, rows) = (self.breaks(side, false), self.breaks(side, true));
        let at = rows.iter().flat_map(|&y| columns.iter().map(move |&x| (x, y)));
        let parts = at.map(|(x, y)| self.parts(side, x, y));
        parts.filter(|parts| parts.iter().any(|part| part.tile != (0, 0))).collect()
    }

    /// Bilinear samples that it is the mean of: level, offset in half texels, weight.
    fn bilinear(self) -> Vec<(usize, i64, i64, f64)> {
        match self {
            Footprint::Bilinear { level } => vec![(level, 0, 0, 1.0)],
            Footprint::Trilinear { level } => vec![(level, 0, 0, 0.5), (level + 1, 0, 0, 0.5)],
            Footprint::Anisotropic { level, ratio, direction } => {
                let (dx, dy) = direction.step();
                let ratio = ratio as i64;
                let offset = |i: i64| (2 * i - ratio + 1) << level;
                let one = |i| (level, dx * offset(i), dy * offset(i), 1.0 / ratio as f64);
                (0..ratio).map(one).collect()
            }
        }
    }

    /// Where it is not linear, from border to border of the tile.
    fn breaks(self, side: usize, down: bool) -> BTreeSet<i64> {
        let far = 2 * side as i64;
        let mut breaks = BTreeSet::from([0, far]);
        for (level, dx, dy, _) in self.bilinear() {
            let offset = if down { dy } else { dx };
            let texel = 2i64 << level;
            // The first center of a texel that a sample in the tile can have.
            let first = (texel / 2 - offset).rem_euclid(texel);
            breaks.extend((first..=far).step_by(texel as usize));
        }
        breaks
    }

    /// What a sample reads, tile by tile.
    fn parts(self, side: usize, x: i64, y: i64) -> Vec<Part> {
        let mut taps: BTreeMap<(usize, i64, i64), f64> = BTreeMap::new();
        for (level, dx, dy, weight) in self.bilinear() {
            let texel = 2i64 << level;
            let axis = |at: i64| {
                let from = at - texel / 2;
                let part = from.rem_euclid(texel) as f64 / texel as f64;
                let first = from.div_euclid(texel);
                [(first, 1.0 - part), (first + 1, part)]
            };
            for (column, across) in axis(x + dx) {
                for (row, down) in axis(y + dy) {
                    if across * down > 0.0 {
                        *taps.entry((level, row, column)).or_insert(0.0) += weight * across * down;
                    }
                }
            }
        }
        let mut parts: Vec<Part> = Vec::new();
        for ((level, y, x), weight) in taps {
            let texels = (side >> level) as i64;
            let tile = (x.div_euclid(texels) as isize, y.div_euclid(texels) as isize);
            let tap = Tap { level, x: x as isize, y: y as isize, weight };
            match parts.iter_mut().find(|part| part.tile == tile) {
                Some(part) => part.taps.push(tap),
                None => parts.push(Part { tile, taps: vec![tap] }),
            }
        }
        parts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_add_up() {
        for footprint in [
            Footprint::Bilinear { level: 1 },
            Footprint::Trilinear { level: 0 },
            Footprint::Anisotropic { level: 0, ratio: 4, direction: Direction::NorthEast },
        ] {
            let samples = footprint.samples(8);
            assert!(!samples.is_empty());
            for parts in samples {
                let sum: f64 = parts.iter().flat_map(|part| &part.taps).map(|tap| tap.weight).sum();
                assert!((sum - 1.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn a_sample_on_the_border_reads_both_tiles() {
        let parts = Footprint::Bilinear { level: 0 }.parts(4, 0, 3);
        let west = parts.iter().find(|part| part.tile == (-1, 0)).unwrap();
        assert_eq!(west.taps, [Tap { level: 0, x: -1, y: 1, weight: 0.5 }]);
    }
}

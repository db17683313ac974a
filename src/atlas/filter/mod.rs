//! Where filtering in an atlas equals filtering in the endless tiling, and how far off it is
//! elsewhere.
//!
//! A sample in a tile reads the tile and, near its border, what lies beside it: in the atlas that
//! is the neighbor there, in a tiling any tile whose sides match. Both read the same mip levels,
//! for no texel of a level crosses the border of a tile. So the difference is a sum over the
//! neighbors read, and its largest value over *all* tilings is the largest over the legal
//! neighbors: one for a sample at a side; for a sample near a corner two neighbors and the tile
//! that fits both. Nothing is sampled at random, and nothing is left out: see
//! [`Footprint`] for the places.
//!
//! Filters add up light (samples of sRGB pictures are decoded first). Differences are in 1/255 of
//! full light. Equal texels are added up in the same order on both sides, so exactly 0 means
//! equal.

mod footprint;
mod neighbors;

pub use footprint::{Direction, Footprint, Part, Tap};

use super::light::Decoder;
use super::{AtlasError, Image, Layout};
use crate::tiles::Side;
use neighbors::{Corner, Neighbors};
use rayon::prelude::*;

/// Bytes of decoded texels at most.
const LIMIT: u64 = 6 << 30;

/// Ratios of anisotropic filters that are looked at.
pub const RATIOS: [usize; 4] = [2, 4, 8, 16];

/// The largest differences between atlas and tilings, in 1/255 of full light.
#[derive(Debug, Clone, PartialEq)]
pub struct Exactness {
    /// Bilinear, for each level.
    pub bilinear: Vec<f64>,
    /// Half way between each level and the next.
    pub trilinear: Vec<f64>,
    /// At level 0, for each ratio that fits half a tile.
    pub anisotropic: Vec<(usize, f64)>,
}

impl Exactness {
    /// The level through which all filtering without anisotropy is exact.
    pub fn exact_to_lod(&self) -> Option<u32> {
        let exact = |level: usize| {
            self.bilinear[level] == 0.0 && (level == 0 || self.trilinear[level - 1] == 0.0)
        };
        let levels = (0..self.bilinear.len()).take_while(|&level| exact(level)).count();
        (levels as u32).checked_sub(1)
    }
}

/// Light of a texel, at most four channels.
type Texel = [f64; 4];

/// An atlas whose filtering is looked at.
pub struct Filter<'a> {
    layout: &'a Layout,
    channels: usize,
    /// The light of each level.
    light: Vec<Vec<f32>>,
    neighbors: Neighbors,
    /// Around the corners between east or west and north or south.
    corners: [[Corner; 2]; 2],
}

impl<'a> Filter<'a> {
    /// The atlas that these levels show.
    ///
    /// # Errors
    /// One that takes too much memory.
    pub fn new(layout: &'a Layout, levels: &[Image]) -> Result<Self, AtlasError> {
        let texels: usize = levels.iter().map(|level| level.width() * level.height()).sum();
        let channels = levels.first().map_or(1, |level| level.format().channels.count());
        let bytes = (texels * channels * size_of::<f32>()) as u64;
        if bytes > LIMIT {
            return Err(AtlasError::Asked(format!(
                "to check the filtering of this atlas takes {} MiB of memory, the limit is {}",
                bytes >> 20,
                LIMIT >> 20
            )));
        }
        let decode = |level: &Image| Decoder::new(level.format()).decode(level);
        let light = levels.par_iter().map(decode).collect();
        let neighbors = Neighbors::new(layout);
        let corners = [Side::East, Side::West].map(|across| {
            [Side::North, Side::South].map(|down| Corner::new(&neighbors, across, down))
        });
        Ok(Self { layout, channels, light, neighbors, corners })
    }

    /// All figures.
    pub fn exactness(&self) -> Exactness {
        let levels = self.light.len();
        let bilinear = (0..levels).map(|level| self.error(Footprint::Bilinear { level }));
        let trilinear =
            (1..levels).map(|level| self.error(Footprint::Trilinear { level: level - 1 }));
        let ratios = RATIOS.into_iter().filter(|ratio| 2 * ratio <= self.layout.side);
        let anisotropic = ratios.map(|ratio| {
            let directions = Direction::ALL.into_iter();
            let errors = directions
                .map(|direction| self.error(Footprint::Anisotropic { level: 0, ratio, direction }));
            (ratio, errors.fold(0.0, f64::max))
        });
        Exactness {
            bilinear: bilinear.collect(),
            trilinear: trilinear.collect(),
            anisotropic: anisotropic.collect(),
        }
    }

    /// The largest difference for a filter that reaches no further than half a tile, in 1/255.
    pub fn error(&self, footprint: Footprint) -> f64 {
        let samples = footprint.samples(self.layout.side);
        let errors = samples.par_iter().map(|parts| self.sample_error(parts));
        255.0 * errors.reduce(|| 0.0, f64::max)
    }

    /// The largest difference of one sample, over all cells and all that can lie around them.
    fn sample_error(&self, parts: &[Part]) -> f64 {
        let outside: Vec<&Part> = parts.iter().filter(|part| part.tile != (0, 0)).collect();
        let dx = outside.iter().find_map(|part| (part.tile.0 != 0).then_some(part.tile.0));
        let dy = outside.iter().find_map(|part| (part.tile.1 != 0).then_some(part.tile.1));
        let across = |dx: isize| if dx > 0 { Side::East } else { Side::West };
        let down = |dy: isize| if dy > 0 { Side::South } else { Side::North };
        match (dx, dy, &outside[..]) {
            (Some(dx), None, [part]) => self.side_error(part, across(dx)),
            (None, Some(dy), [part]) => self.side_error(part, down(dy)),
            (Some(dx), Some(dy), _) => self.corner_error(&outside, dx, dy),
            _ => 0.0,
        }
    }

    /// One neighbor is read.
    fn side_error(&self, part: &Part, side: Side) -> f64 {
        let inside = self.in_cells(part);
        let shown = self.shown(part, &inside);
        let mut largest: f64 = 0.0;
        for channel in 0..self.channels {
            let values = inside.iter().map(|texel| texel[channel]);
            let ranges = self.neighbors.range_at_side(side, values);
            for (cell, shown) in shown.iter().enumerate() {
                let range = ranges[self.neighbors.key(cell, side)];
                largest = largest.max(away(shown[channel], range));
            }
        }
        largest
    }

    /// Two neighbors and the one between them may be read.
    fn corner_error(&self, parts: &[&Part], dx: isize, dy: isize) -> f64 {
        let part = |tile: (isize, isize)| parts.iter().copied().find(|part| part.tile == tile);
        let parts = [part((dx, 0)), part((0, dy)), part((dx, dy))];
        let inside = parts.map(|part| part.map(|part| self.in_cells(part)));
        let shown: [Option<Vec<Texel>>; 3] = std::array::from_fn(|at| {
            let (part, inside) = (parts[at]?, inside[at].as_ref()?);
            Some(self.shown(part, inside))
        });
        let corner = &self.corners[usize::from(dx < 0)][usize::from(dy > 0)];
        let mut largest: f64 = 0.0;
        for channel in 0..self.channels {
            let values = inside.each_ref().map(|inside| {
                inside.as_ref().map(|inside| inside.iter().map(|texel| texel[channel]))
            });
            for (cell, range) in corner.ranges(values).into_iter().enumerate() {
                let [a, b, c] = shown
                    .each_ref()
                    .map(|shown| shown.as_ref().map_or(0.0, |shown| shown[cell][channel]));
                largest = largest.max(away((a + b) + c, range));
            }
        }
        largest
    }

    /// What each cell would contribute if it lay where the part reads.
    fn in_cells(&self, part: &Part) -> Vec<Texel> {
        let side = self.layout.side as isize;
        let taps: Vec<(usize, usize, f64)> = part
            .taps
            .iter()
            .map(|tap| {
                let (texels, width) =
                    (side >> tap.level, (self.layout.width() >> tap.level) as isize);
                let x = tap.x - part.tile.0 * texels;
                let y = tap.y - part.tile.1 * texels;
                (tap.level, (y * width + x) as usize * self.channels, tap.weight)
            })
            .collect();
        let (block, gutter) = (self.layout.block(), self.layout.gutter);
        let cell = |cell: usize| {
            let (column, row) = self.layout.position(cell);
            let (left, top) = (column * block + gutter, row * block + gutter);
            let mut sum = [0.0; 4];
            for &(level, offset, weight) in &taps {
                let width = self.layout.width() >> level;
                let start = ((top >> level) * width + (left >> level)) * self.channels;
                let texel = &self.light[level][start + offset..][..self.channels];
                for (sum, &light) in sum.iter_mut().zip(texel) {
                    *sum += weight * f64::from(light);
                }
            }
            sum
        };
        (0..self.layout.tiles.len()).map(cell).collect()
    }

    /// What the atlas shows each cell in the place of its neighbor. Without gutters that is the
    /// neighboring cell, whose contribution is known.
    fn shown(&self, part: &Part, inside: &[Texel]) -> Vec<Texel> {
        let (columns, rows) = (self.layout.columns as isize, self.layout.rows() as isize);
        let cell = |cell: usize| {
            if self.layout.gutter > 0 {
                return self.read(cell, part);
            }
            let (column, row) = self.layout.position(cell);
            let column = (column as isize + part.tile.0).rem_euclid(columns);
            let row = (row as isize + part.tile.1).rem_euclid(rows);
            inside[(row * columns + column) as usize]
        };
        (0..self.layout.tiles.len()).map(cell).collect()
    }

    /// The sum over the taps in the atlas, from a cell on.
    fn read(&self, cell: usize, part: &Part) -> Texel {
        let (column, row) = self.layout.position(cell);
        let (block, gutter) = (self.layout.block(), self.layout.gutter);
        let mut sum = [0.0; 4];
        for tap in &part.taps {
            let size = |texels: usize| (texels >> tap.level) as isize;
            let (width, height) = (size(self.layout.width()), size(self.layout.height()));
            let x = (size(column * block + gutter) + tap.x).rem_euclid(width);
            let y = (size(row * block + gutter) + tap.y).rem_euclid(height);
            let start = (y * width + x) as usize * self.channels;
            let texel = &self.light[tap.level][start..][..self.channels];
            for (sum, &light) in sum.iter_mut().zip(texel) {
                *sum += tap.weight * f64::from(light);
            }
        }
        sum
    }
}

/// How far the farthest value of a range is away; of an empty range nothing.
fn away(shown: f64, (low, high): (f64, f64)) -> f64 {
    if low > high { 0.0 } else { (high - shown).max(shown - low) }
}

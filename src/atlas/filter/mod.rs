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
use super::sides::Side;
use super::{AtlasError, Image, Layout};
use neighbors::{Groups, Neighbors};
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

/// An atlas whose filtering is looked at.
pub struct Filter<'a> {
    layout: &'a Layout,
    channels: usize,
    /// The light of each level.
    light: Vec<Vec<f32>>,
    /// Different tiles with their first cells.
    cells: Vec<usize>,
    neighbors: Neighbors,
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
        let (tiles, cells): (Vec<_>, Vec<_>) = layout.places().unzip();
        let neighbors = Neighbors::new(layout.kind, layout.colors, &tiles);
        Ok(Self { layout, channels, light, cells, neighbors })
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
        let toward = |horizontal: bool| {
            outside.iter().find_map(|part| match (part.tile, horizontal) {
                ((1, _), true) => Some(Side::East),
                ((-1, _), true) => Some(Side::West),
                ((_, 1), false) => Some(Side::South),
                ((_, -1), false) => Some(Side::North),
                _ => None,
            })
        };
        match (toward(true), toward(false)) {
            (Some(side), None) | (None, Some(side)) => self.side_error(&outside, side),
            (Some(across), Some(down)) => self.corner_error(&outside, across, down),
            (None, None) => 0.0,
        }
    }

    /// One neighbor is read.
    fn side_error(&self, parts: &[&Part], side: Side) -> f64 {
        let Some(part) = parts.first() else { return 0.0 };
        let inside = self.in_tiles(part);
        let mut largest: f64 = 0.0;
        for channel in 0..self.channels {
            let range = self.neighbors.range_at_side(side, &inside[channel]);
            for cell in 0..self.layout.tiles.len() {
                let Some((low, high)) = range[self.neighbors.key_of(self.layout.tiles[cell], side)]
                else {
                    continue;
                };
                let shown = self.read(cell, part, (0, 0), channel);
                largest = largest.max(high - shown).max(shown - low);
            }
        }
        largest
    }

    /// Two neighbors and the one between them may be read.
    fn corner_error(&self, parts: &[&Part], across: Side, down: Side) -> f64 {
        let (dx, dy) = (across.step().0, down.step().1);
        let part = |tile: (isize, isize)| parts.iter().copied().find(|part| part.tile == tile);
        let parts = [part((dx, 0)), part((0, dy)), part((dx, dy))];
        let inside = parts.map(|part| part.map(|part| self.in_tiles(part)));
        let groups = Groups::new(&self.neighbors, across, down);
        let mut largest: f64 = 0.0;
        for channel in 0..self.channels {
            let values = std::array::from_fn(|at| {
                inside[at].as_ref().map(|channels| channels[channel].as_slice())
            });
            let ranges = groups.ranges(values);
            for (cell, &tile) in self.layout.tiles.iter().enumerate() {
                let Some((low, high)) = ranges.around(tile, &self.neighbors) else { continue };
                let [a, b, c] = parts
                    .map(|part| part.map_or(0.0, |part| self.read(cell, part, (0, 0), channel)));
                let shown = (a + b) + c;
                largest = largest.max(high - shown).max(shown - low);
            }
        }
        largest
    }

    /// What a neighbor would contribute, for every tile, channel by channel.
    fn in_tiles(&self, part: &Part) -> Vec<Vec<f64>> {
        let read = |channel| {
            let cells = self.cells.iter();
            cells.map(|&cell| self.read(cell, part, part.tile, channel)).collect()
        };
        (0..self.channels).map(read).collect()
    }

    /// The sum over the taps in the atlas, from a cell on, less so many tiles.
    fn read(&self, cell: usize, part: &Part, less: (isize, isize), channel: usize) -> f64 {
        let (column, row) = self.layout.position(cell);
        let (block, gutter) = (self.layout.block(), self.layout.gutter);
        let mut sum = 0.0;
        for tap in &part.taps {
            let size = |texels: usize| (texels >> tap.level) as isize;
            let (width, height) = (size(self.layout.width()), size(self.layout.height()));
            let side = size(self.layout.side);
            let x = size(column * block + gutter) + tap.x - less.0 * side;
            let y = size(row * block + gutter) + tap.y - less.1 * side;
            let wrap = |at: isize, size: isize| match at {
                at if at < 0 => at + size,
                at if at >= size => at - size,
                at => at,
            };
            let texel = wrap(y, height) * width + wrap(x, width);
            let at = texel as usize * self.channels + channel;
            sum += tap.weight * f64::from(self.light[tap.level][at]);
        }
        sum
    }
}

//! Pictures for the tiles of any set, made up.
//!
//! * [`Marks`]: the colors drawn plainly, for looking;
//! * [`Noise`]: random texels inside, for tests: nothing but the common strip agrees;
//! * [`Truchet`]: curves and contours that go on from tile to tile;
//! * [`Bricks`]: bricks and mortar, for brick Wang tiles.
//!
//! All keep the *common strip*: within `strip` texels of a side the picture depends on the
//! colors of that side alone. In the squares where two strips cross it therefore depends on the
//! color of that corner alone (corner tiles), or on nothing (Wang tiles).

mod bricks;
mod marks;
mod noise;
mod truchet;

pub use bricks::Bricks;
pub use marks::Marks;
pub use noise::Noise;
pub use truchet::Truchet;

use super::{Channels, Depth, Format, Image, Light};
use crate::tiles::{Colors, Kind, TileId};

/// What made-up pictures have in common.
#[derive(Debug, Clone, Copy)]
pub struct Canvas {
    /// What carries the colors: corners or edges.
    pub kind: Kind,
    /// The palettes.
    pub colors: Colors,
    /// Texels of a side.
    pub side: usize,
    /// Texels of the common strip, at most half of `side`.
    pub strip: usize,
    /// How samples are written.
    pub format: Format,
}

impl Canvas {
    /// The colors of a tile: NE, SE, SW, NW, or N, E, S, W.
    fn sides(&self, tile: TileId) -> [u8; 4] {
        self.kind.unpack(tile, self.colors)
    }

    /// The color of the palette behind a side of a Wang tile: horizontal edges first.
    fn shown(&self, side: usize, color: u8) -> u8 {
        match (self.kind, side % 2, self.colors.single()) {
            (Kind::Wang, 1, None) => color.wrapping_add(self.colors.horizontal() as u8),
            _ => color,
        }
    }

    /// The looks of the sides of a tile.
    fn looks(&self, sides: [u8; 4]) -> [[f32; 3]; 4] {
        std::array::from_fn(|side| rgb(self.shown(side, sides[side])))
    }

    /// A picture of these texels, each by its column and row.
    fn paint(&self, texel: impl Fn(usize, usize) -> [f32; 3]) -> Image {
        let mut image = Image::new(self.side, self.side, self.format);
        for y in 0..self.side {
            for x in 0..self.side {
                self.put(&mut image, x, y, texel(x, y));
            }
        }
        image
    }

    /// Writes a texel whose red, green and blue go from 0 to 1, encoded for the eye.
    fn put(&self, image: &mut Image, x: usize, y: usize, rgb: [f32; 3]) {
        let Format { channels, depth, light } = self.format;
        let rgb = match light {
            Light::Srgb => rgb,
            Light::Linear => rgb.map(super::light::decode),
        };
        let gray = || 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
        let max = f32::from(self.format.max());
        let sample = |value: f32| (value.clamp(0.0, 1.0) * max + 0.5) as u16;
        let samples = match channels {
            Channels::Gray => [sample(gray()), 0, 0, 0],
            Channels::GrayAlpha => [sample(gray()), self.format.max(), 0, 0],
            Channels::Rgb | Channels::Rgba => {
                [sample(rgb[0]), sample(rgb[1]), sample(rgb[2]), self.format.max()]
            }
        };
        let bytes = self.format.bytes();
        let texel = &mut image.row_mut(y)[x * bytes..][..bytes];
        match depth {
            Depth::Eight => texel.iter_mut().zip(samples).for_each(|(to, s)| *to = s as u8),
            Depth::Sixteen => texel
                .chunks_exact_mut(2)
                .zip(samples)
                .for_each(|(to, s)| to.copy_from_slice(&s.to_be_bytes())),
        }
    }
}

/// Red, green and blue of a color from 0 to 1.
fn rgb(color: u8) -> [f32; 3] {
    super::palette::rgb(color).map(|sample| f32::from(sample) / 255.0)
}

/// Between two colors.
fn mix(from: [f32; 3], to: [f32; 3], part: f32) -> [f32; 3] {
    std::array::from_fn(|channel| from[channel] + (to[channel] - from[channel]) * part)
}

/// A random word of these, the same on every machine (splitmix64, Steele, Lea and Flood 2014).
fn hash(parts: [u64; 4]) -> u64 {
    parts.into_iter().fold(0x9e37_79b9_7f4a_7c15, |state: u64, part| {
        let z = (state ^ part).wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    })
}

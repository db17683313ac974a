//! Tiles from examples: cuts against slow oracles, the strip, the command, the pictures.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod command;
mod examples;
mod flow;
mod page;
mod strips;
mod weaving;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use tilepack::atlas::{Channels, Depth, Format, Image, Light};

/// Random samples, smoothed a little so that some cuts are better than others.
pub(crate) fn noise(width: usize, height: usize, format: Format, seed: u64) -> Image {
    let mut random = Pcg64::seed_from_u64(seed);
    let mut image = Image::new(width, height, format);
    for y in 0..height {
        for x in 0..width {
            for channel in 0..format.channels.count() {
                let new: u16 = random.random_range(0..=format.max());
                let left = if x > 0 { image.sample(x - 1, y, channel) } else { new };
                let above = if y > 0 { image.sample(x, y - 1, channel) } else { new };
                let mean = (u32::from(new) + u32::from(left) + 2 * u32::from(above)) / 4;
                image.set_sample(x, y, channel, mean as u16);
            }
        }
    }
    image
}

pub(crate) const GRAY: Format =
    Format { channels: Channels::Gray, depth: Depth::Eight, light: Light::Srgb };
pub(crate) const RGB: Format =
    Format { channels: Channels::Rgb, depth: Depth::Eight, light: Light::Srgb };

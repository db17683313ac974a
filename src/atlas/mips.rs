//! The mip chain of a square: each level is the mean of 2 x 2 texels of the one before, in light.
//!
//! Levels are made from the light of the finest one, not from each other's rounded samples, so
//! a texel of level n is the mean of its 4^n texels to the nearest sample. A level has no texel
//! that crosses the border of the square: an atlas is put together of the levels of its tiles.

use super::Image;
use super::light::Decoder;

/// Levels 0 to `levels - 1` of a square whose side is a multiple of 2^(levels - 1).
pub fn chain(image: Image, levels: usize, decoder: &Decoder) -> Vec<Image> {
    let mut all = Vec::with_capacity(levels);
    if levels > 1 {
        let (mut width, mut height) = (image.width(), image.height());
        let channels = image.format().channels.count();
        let mut light = decoder.decode(&image);
        all.push(image);
        for _ in 1..levels {
            light = halve(&light, width, channels);
            (width, height) = (width / 2, height / 2);
            all.push(decoder.encode(&light, width, height));
        }
    } else {
        all.push(image);
    }
    all
}

/// The means of 2 x 2 texels.
fn halve(light: &[f32], width: usize, channels: usize) -> Vec<f32> {
    let row = width * channels;
    let mut half = Vec::with_capacity(light.len() / 4);
    for rows in light.chunks_exact(2 * row) {
        let (upper, lower) = rows.split_at(row);
        let pairs = upper.chunks_exact(2 * channels).zip(lower.chunks_exact(2 * channels));
        for (a, b) in pairs {
            for channel in 0..channels {
                let above = a[channel] + a[channels + channel];
                let below = b[channel] + b[channels + channel];
                half.push((above + below) * 0.25);
            }
        }
    }
    half
}

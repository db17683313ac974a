//! Light: samples encoded for the eye, and back (IEC 61966-2-1).
//!
//! Filters add up light, not codes. Decoding goes through a table for 8 bits; encoding finds the
//! nearest code.

use super::{Depth, Format, Image, Light};

/// Light from 0 to 1 of a code from 0 to 1.
pub fn decode(code: f32) -> f32 {
    if code <= 0.04045 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}

/// Code from 0 to 1 of light from 0 to 1.
pub fn encode(light: f32) -> f32 {
    if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}

/// Steps of light that are told apart when it is encoded in 8 bits: the darkest codes are 20
/// steps wide.
const STEPS: usize = 65535;

/// Turns samples into light and back.
#[derive(Debug)]
pub struct Decoder {
    format: Format,
    /// The light of each 8-bit code.
    light: Vec<f32>,
    /// The 8-bit code of each step of light.
    codes: Vec<u8>,
}

impl Decoder {
    /// For samples of this format.
    pub fn new(format: Format) -> Self {
        let light = (0..256).map(|code| decode(code as f32 / 255.0)).collect();
        let code = |step: usize| (encode(step as f32 / STEPS as f32) * 255.0 + 0.5) as u8;
        Self { format, light, codes: (0..=STEPS).map(code).collect() }
    }

    /// The format of the samples.
    pub fn format(&self) -> Format {
        self.format
    }

    fn is_encoded(&self, channel: usize) -> bool {
        let Format { channels, light, .. } = self.format;
        let alpha = channels.has_alpha() && channel + 1 == channels.count();
        light == Light::Srgb && !alpha
    }

    /// The samples of a picture as light, in the same order.
    pub fn decode(&self, image: &Image) -> Vec<f32> {
        debug_assert_eq!(image.format(), self.format);
        let channels = self.format.channels.count();
        let encoded: Vec<bool> = (0..channels).map(|channel| self.is_encoded(channel)).collect();
        match self.format.depth {
            Depth::Eight => {
                let samples = image.data().chunks_exact(channels);
                let one = |(&code, &encoded): (&u8, &bool)| match encoded {
                    true => self.light[usize::from(code)],
                    false => f32::from(code) / 255.0,
                };
                samples.flat_map(|texel| texel.iter().zip(&encoded).map(one)).collect()
            }
            Depth::Sixteen => {
                let samples = image.data().chunks_exact(2);
                let code = |(at, bytes): (usize, &[u8])| {
                    let code = f32::from(u16::from_be_bytes([bytes[0], bytes[1]])) / 65535.0;
                    if encoded[at % channels] { decode(code) } else { code }
                };
                samples.enumerate().map(code).collect()
            }
        }
    }

    /// The picture whose light this is, to the nearest samples.
    pub fn encode(&self, light: &[f32], width: usize, height: usize) -> Image {
        let channels = self.format.channels.count();
        let encoded: Vec<bool> = (0..channels).map(|channel| self.is_encoded(channel)).collect();
        let mut image = Image::new(width, height, self.format);
        let row_samples = width * channels;
        for y in 0..height {
            let row = image.row_mut(y);
            for (at, &value) in light[y * row_samples..][..row_samples].iter().enumerate() {
                let value = value.clamp(0.0, 1.0);
                match (self.format.depth, encoded[at % channels]) {
                    (Depth::Eight, true) => {
                        row[at] = self.codes[(value * STEPS as f32 + 0.5) as usize];
                    }
                    (Depth::Eight, false) => row[at] = (value * 255.0 + 0.5) as u8,
                    (Depth::Sixteen, is_encoded) => {
                        let value = if is_encoded { encode(value) } else { value };
                        let code = (value * 65535.0 + 0.5) as u16;
                        row[2 * at..2 * at + 2].copy_from_slice(&code.to_be_bytes());
                    }
                }
            }
        }
        image
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::atlas::Channels;

    #[test]
    fn encoding_inverts_decoding() {
        for (depth, light) in [
            (Depth::Eight, Light::Srgb),
            (Depth::Eight, Light::Linear),
            (Depth::Sixteen, Light::Srgb),
            (Depth::Sixteen, Light::Linear),
        ] {
            let format = Format { channels: Channels::GrayAlpha, depth, light };
            let mut image = Image::new(256, 16, format);
            for at in 0..4096 {
                let code = if depth == Depth::Eight { at % 256 } else { at * 16 };
                image.set_sample(at % 256, at / 256, 0, code as u16);
                image.set_sample(at % 256, at / 256, 1, code as u16);
            }
            let decoder = Decoder::new(format);
            let light = decoder.decode(&image);
            assert_eq!(decoder.encode(&light, 256, 16), image, "{format:?}");
        }
    }

    #[test]
    fn known_values() {
        assert!((decode(0.5) - 0.214_041).abs() < 1e-6);
        assert!((encode(0.5) - 0.735_357).abs() < 1e-6);
        let format = Format { channels: Channels::Gray, depth: Depth::Eight, light: Light::Srgb };
        let half = Decoder::new(format).encode(&[0.5], 1, 1);
        assert_eq!(half.sample(0, 0, 0), 188);
    }
}

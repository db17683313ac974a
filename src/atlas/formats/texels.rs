//! Texels as graphics cards take them: red, green, blue and opacity, 8 or 16 bits each, and a
//! chain of pictures each half as wide and high as the one before.

use crate::atlas::{AtlasError, Channels, Depth, Image, Light};
use std::io::{self, Write};

/// The texel formats that are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Texels {
    /// 8 bits, encoded for the eye.
    Srgb8,
    /// 8 bits, proportional to light.
    Linear8,
    /// 16 bits, proportional to light: there is no such format for the eye.
    Linear16,
}

impl Texels {
    /// Bytes of a texel.
    pub(super) fn bytes(self) -> usize {
        if self == Texels::Linear16 { 8 } else { 4 }
    }

    /// The format of a chain of pictures.
    ///
    /// # Errors
    /// No picture, pictures of several formats, or one whose size does not suit its place.
    pub(super) fn of(levels: &[Image]) -> Result<Self, AtlasError> {
        let asked = |message: String| Err(AtlasError::Asked(message));
        let Some(first) = levels.first() else {
            return asked("no picture to write".to_owned());
        };
        if u32::try_from(first.width().max(first.height())).is_err() {
            let (w, h) = (first.width(), first.height());
            return asked(format!("{w}x{h} texels: expected sides below 2^32"));
        }
        for (number, level) in levels.iter().enumerate() {
            let half = |side: usize| side.checked_shr(number as u32).unwrap_or(0).max(1);
            let expected = (half(first.width()), half(first.height()));
            if (level.width(), level.height()) != expected {
                let (w, h) = (level.width(), level.height());
                let (ew, eh) = expected;
                return asked(format!("mip level {number} has {w}x{h} texels, expected {ew}x{eh}"));
            }
            if level.format() != first.format() {
                return asked(format!("mip level {number} has another format than level 0"));
            }
        }
        let most = usize::BITS - first.width().max(first.height()).leading_zeros();
        if levels.len() > most as usize {
            let message =
                format!("{} mip levels, but level {} is one texel", levels.len(), most - 1);
            return asked(message);
        }
        Ok(match (first.format().depth, first.format().light) {
            (Depth::Sixteen, _) => Texels::Linear16,
            (Depth::Eight, Light::Srgb) => Texels::Srgb8,
            (Depth::Eight, Light::Linear) => Texels::Linear8,
        })
    }

    /// Writes a picture in this format, low bytes first.
    pub(super) fn write(self, out: &mut dyn Write, image: &Image) -> io::Result<()> {
        let format = image.format();
        if self != Texels::Linear16 && format.channels == Channels::Rgba {
            return out.write_all(image.data());
        }
        let decode = self == Texels::Linear16 && format.light == Light::Srgb;
        let mut row = Vec::with_capacity(image.width() * self.bytes());
        for y in 0..image.height() {
            row.clear();
            for x in 0..image.width() {
                let sample = |channel| image.sample(x, y, channel);
                let (color, alpha) = match format.channels {
                    Channels::Gray => ([sample(0); 3], format.max()),
                    Channels::GrayAlpha => ([sample(0); 3], sample(1)),
                    Channels::Rgb => ([0, 1, 2].map(sample), format.max()),
                    Channels::Rgba => ([0, 1, 2].map(sample), sample(3)),
                };
                let color = if decode { color.map(linear) } else { color };
                for sample in color.into_iter().chain([alpha]) {
                    match self {
                        Texels::Linear16 => row.extend(sample.to_le_bytes()),
                        _ => row.push(sample as u8),
                    }
                }
            }
            out.write_all(&row)?;
        }
        Ok(())
    }
}

/// Light of a sample encoded for the eye (IEC 61966-2-1).
fn linear(sample: u16) -> u16 {
    let encoded = f64::from(sample) / 65535.0;
    let light = match encoded {
        low if low <= 0.04045 => low / 12.92,
        high => ((high + 0.055) / 1.055).powf(2.4),
    };
    (light * 65535.0).round() as u16
}

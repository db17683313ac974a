//! Pictures to begin with: stone, grass, bricks, leaves, drawn here and free to use.
//!
//! Each is a field of colors and heights. Light falls on it from the north-west; heights and
//! normals can be had as maps of their own. All arithmetic is that of whole numbers and of
//! addition, multiplication, division and square roots of `f64`, which IEEE 754 lays down to the
//! last bit: the same seed gives the same bytes on every machine.

mod bricks;
mod field;
mod grass;
mod leaves;
mod stone;

use super::TextureError;
use crate::atlas::{Channels, Depth, Format, Image, Light};
use field::Field;

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subject {
    /// Weathered rock.
    Stone,
    /// Blades of grass.
    Grass,
    /// A wall of bricks.
    Bricks,
    /// Fallen leaves.
    Leaves,
}

/// What of it a picture shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Aspect {
    /// Its color in the light.
    Color,
    /// Its height, from low to high.
    Height,
    /// The direction it faces: x to the east, y to the north, z up.
    Normal,
}

impl Subject {
    /// All of them.
    pub const ALL: [Subject; 4] =
        [Subject::Stone, Subject::Grass, Subject::Bricks, Subject::Leaves];

    /// Its name.
    pub fn name(self) -> &'static str {
        ["stone", "grass", "bricks", "leaves"][self as usize]
    }
}

/// The subject and aspect of a name, as in `stone`, `stone-height`, `stone-normal`.
pub fn named(name: &str) -> Option<(Subject, Aspect)> {
    let aspects = [("", Aspect::Color), ("-height", Aspect::Height), ("-normal", Aspect::Normal)];
    Subject::ALL.into_iter().find_map(|subject| {
        let rest = name.strip_prefix(subject.name())?;
        aspects.iter().find(|(end, _)| *end == rest).map(|&(_, aspect)| (subject, aspect))
    })
}

/// Texels of a picture's side.
const SIDES: std::ops::RangeInclusive<usize> = 16..=4096;

/// Draws a picture.
///
/// # Errors
/// A size that is out of range.
pub fn draw(
    subject: Subject,
    aspect: Aspect,
    (width, height): (usize, usize),
    seed: u32,
) -> Result<Image, TextureError> {
    if !SIDES.contains(&width) || !SIDES.contains(&height) {
        let (least, most) = (SIDES.start(), SIDES.end());
        return Err(TextureError::Asked(format!(
            "an example of {width} x {height} texels: expected {least} to {most} a side"
        )));
    }
    let field = match subject {
        Subject::Stone => stone::field(width, height, seed),
        Subject::Grass => grass::field(width, height, seed),
        Subject::Bricks => bricks::field(width, height, seed),
        Subject::Leaves => leaves::field(width, height, seed),
    };
    Ok(field.picture(aspect))
}

impl Field {
    fn picture(&self, aspect: Aspect) -> Image {
        let (channels, light) = match aspect {
            Aspect::Color => (Channels::Rgb, Light::Srgb),
            Aspect::Height => (Channels::Gray, Light::Linear),
            Aspect::Normal => (Channels::Rgb, Light::Linear),
        };
        let format = Format { channels, depth: Depth::Eight, light };
        let mut image = Image::new(self.width, self.height, format);
        for y in 0..self.height {
            for x in 0..self.width {
                let samples = match aspect {
                    Aspect::Color => self.color[y * self.width + x],
                    Aspect::Height => [255.0 * self.high[y * self.width + x]; 3],
                    Aspect::Normal => self.normal(x, y).map(|part| 127.5 + 127.5 * part),
                };
                for (channel, sample) in samples.iter().take(channels.count()).enumerate() {
                    // To the nearest, also of what is halfway.
                    let sample = (sample + 0.5).clamp(0.0, 255.0) as u16;
                    image.set_sample(x, y, channel, sample);
                }
            }
        }
        image
    }
}

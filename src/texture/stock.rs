//! The stock: all examples on one board, with what is compared when texels are put side by side.
//!
//! The examples lie one above the other, a row and a column of nothing between them, so a texel is
//! one number and its neighbors are that number plus or minus 1 or the stride. An example may
//! come with maps of the same size (normals, heights); they are cut along with it.
//!
//! Texels are compared in linear light, in whole numbers: a map's samples share 65535 between
//! them, so that every map counts as much as the picture. Colors count as far as they cover.

use super::TextureError;
use crate::atlas::light::Decoder;
use crate::atlas::{Format, Image};

/// A texel of the stock.
pub type Texel = u32;

/// How the colors of a picture with opacity are meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Alpha {
    /// Not yet multiplied by opacity.
    Straight,
    /// Already multiplied by opacity.
    Premultiplied,
}

/// Where an example lies on the board.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Place {
    /// Its first row; its first column is 0.
    pub top: usize,
    /// Texels of a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
}

/// Examples with their maps, ready to be cut.
#[derive(Debug, Clone)]
pub struct Stock {
    stride: usize,
    places: Vec<Place>,
    /// For each example the picture, then its maps.
    images: Vec<Vec<Image>>,
    features: usize,
    /// The features of every texel of the board.
    light: Vec<u16>,
    /// Whether a texel belongs to an example.
    inside: Vec<bool>,
    /// The mean difference of texels side by side, at least 1.
    gradient: u32,
}

/// The largest price of a step.
const DEAREST: u64 = 1 << 24;
/// The price of a step whose mismatch is as large as the gradients there.
const UNIT: u64 = 256;

impl Stock {
    /// Examples, each the picture and then its maps.
    ///
    /// # Errors
    /// No example, maps of another size or number, opacity without a word on what it means.
    pub fn new(images: Vec<Vec<Image>>, alpha: Option<Alpha>) -> Result<Self, TextureError> {
        let asked = |message: String| Err(TextureError::Asked(message));
        let Some(first) = images.first().filter(|all| !all.is_empty()) else {
            return asked("expected at least one example".into());
        };
        let formats: Vec<Format> = first.iter().map(Image::format).collect();
        let mut places = Vec::new();
        let (mut top, mut widest) = (1, 0);
        for (at, all) in images.iter().enumerate() {
            let words = formats.len();
            let Some(picture) = all.first().filter(|_| all.len() == words) else {
                return asked(format!(
                    "example {at} has {} pictures, the first {words}",
                    all.len()
                ));
            };
            let (width, height) = (picture.width(), picture.height());
            for (map, image) in all.iter().enumerate() {
                let is = (image.width(), image.height());
                if is != (width, height) {
                    return asked(format!(
                        "map {map} is {} x {} texels: expected {width} x {height}, as its example",
                        is.0, is.1
                    ));
                }
                if image.format() != formats[map] {
                    return asked(format!(
                        "example {}: {}, but the first is {}",
                        at + 1,
                        words_of(image.format()),
                        words_of(formats[map])
                    ));
                }
                if image.format().channels.has_alpha() && alpha.is_none() {
                    return asked(format!(
                        "{} has opacity: expected --alpha straight or --alpha premultiplied",
                        if map == 0 { "the example" } else { "a map" }
                    ));
                }
            }
            places.push(Place { top, width, height });
            top += height + 1;
            widest = widest.max(width);
        }
        let stride = widest + 1;
        if (stride as u64) * (top as u64) >= 1 << 30 {
            return asked(format!(
                "the examples take {stride} x {top} texels on one board: at most {}",
                1u32 << 30
            ));
        }
        let features = formats.iter().map(|format| format.channels.count()).sum();
        let mut stock = Self {
            stride,
            places,
            images,
            features,
            light: vec![0; stride * top * features],
            inside: vec![false; stride * top],
            gradient: 1,
        };
        stock.fill_in(alpha);
        stock.gradient = stock.mean_gradient().max(1.0) as u32;
        Ok(stock)
    }

    /// Decodes the samples.
    fn fill_in(&mut self, alpha: Option<Alpha>) {
        for (place, images) in self.places.iter().zip(&self.images) {
            let mut first = 0;
            for image in images {
                let channels = image.format().channels;
                let count = channels.count();
                let multiply = channels.has_alpha() && alpha == Some(Alpha::Straight);
                let share = 65535.0 / count as f32;
                let light = Decoder::new(image.format()).decode(image);
                for (at, samples) in light.chunks_exact(count).enumerate() {
                    let cover = if multiply { samples[count - 1] } else { 1.0 };
                    let (x, y) = (at % place.width, at / place.width);
                    let texel = (place.top + y) * self.stride + x;
                    self.inside[texel] = true;
                    for (channel, &sample) in samples.iter().enumerate() {
                        let is_alpha = multiply && channel + 1 == count;
                        let value = if is_alpha { sample } else { sample * cover };
                        self.light[texel * self.features + first + channel] =
                            (value.clamp(0.0, 1.0) * share + 0.5) as u16;
                    }
                }
                first += count;
            }
        }
    }

    /// The mean difference of texels side by side.
    pub fn mean_gradient(&self) -> f64 {
        let (mut sum, mut count) = (0u64, 0u64);
        for texel in 0..self.inside.len() as u32 {
            for step in [1, self.stride as u32] {
                if self.holds(texel) && self.holds(texel + step) {
                    sum += u64::from(self.difference(texel, texel + step));
                    count += 1;
                }
            }
        }
        sum as f64 / count.max(1) as f64
    }

    /// From a texel to the one below it.
    pub fn stride(&self) -> usize {
        self.stride
    }

    /// Where the examples lie.
    pub fn places(&self) -> &[Place] {
        &self.places
    }

    /// The pictures of an example: itself, then its maps.
    pub fn images(&self, example: usize) -> &[Image] {
        &self.images[example]
    }

    /// Features of a texel.
    pub fn features(&self) -> usize {
        self.features
    }

    /// Texels of all examples.
    pub fn texels(&self) -> usize {
        self.places.iter().map(|place| place.width * place.height).sum()
    }

    /// All texels of the examples.
    pub fn all(&self) -> impl Iterator<Item = Texel> + '_ {
        (0..self.inside.len() as Texel).filter(|&texel| self.holds(texel))
    }

    /// The texel in a column and row of the board.
    pub fn texel(&self, x: usize, y: usize) -> Texel {
        (y * self.stride + x) as Texel
    }

    /// Whether a number is that of a texel of an example.
    pub fn holds(&self, texel: Texel) -> bool {
        self.inside.get(texel as usize).is_some_and(|&inside| inside)
    }

    /// The example of a texel, and its column and row there.
    pub fn locate(&self, texel: Texel) -> (usize, usize, usize) {
        let (x, y) = (texel as usize % self.stride, texel as usize / self.stride);
        let example = self.places.partition_point(|place| place.top <= y).saturating_sub(1);
        (example, x, y - self.places[example].top)
    }

    /// What texels are compared by.
    #[inline]
    pub fn light(&self, texel: Texel) -> &[u16] {
        &self.light[texel as usize * self.features..][..self.features]
    }

    /// The difference of two texels.
    #[inline]
    pub fn difference(&self, a: Texel, b: Texel) -> u32 {
        let pairs = self.light(a).iter().zip(self.light(b));
        pairs.map(|(&a, &b)| u32::from(a.abs_diff(b))).sum()
    }

    /// How badly `b` goes on from `a` when it is put a step (1 or the stride) after it: the mean
    /// difference of each from what lies there in the other's example. 0 where it does lie there.
    pub fn mismatch(&self, a: Texel, b: Texel, step: usize) -> u32 {
        let step = step as Texel;
        if b == a + step {
            return 0;
        }
        let (on, back) = (a + step, b - step);
        match (self.holds(on), self.holds(back)) {
            (true, true) => (self.difference(a, back) + self.difference(on, b)).div_ceil(2),
            (true, false) => self.difference(on, b),
            (false, true) => self.difference(a, back),
            (false, false) => self.difference(a, b),
        }
    }

    /// The price of the same step in a cut (Kwatra et al. 2003): the mismatch by the gradients
    /// there, for the eye forgives more where much is going on.
    pub fn price(&self, a: Texel, b: Texel, step: usize) -> i32 {
        if b == a + step as Texel {
            return 0;
        }
        let (on, back) = (a + step as Texel, b - step as Texel);
        let here = if self.holds(on) { self.difference(a, on) } else { 0 };
        let there = if self.holds(back) { self.difference(back, b) } else { 0 };
        let mismatch = u64::from(self.mismatch(a, b, step));
        let around = u64::from(here + there) / 2 + u64::from(self.gradient / 2 + 1);
        // One for the length of the cut, where all is alike.
        (UNIT * mismatch / around + 1).min(DEAREST) as i32
    }
}

/// What the samples of a picture are.
fn words_of(format: Format) -> String {
    let (channels, bits) = (format.channels.count(), 8 * format.sample_bytes());
    format!("{channels} channels of {bits} bits, {:?}", format.light)
}

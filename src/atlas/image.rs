//! Pictures in memory, in the layout of PNG: rows from the top, samples of a texel side by side,
//! 16-bit samples with the high byte first.
//!
//! Invariant: `data` holds `width * height * format.bytes()` bytes.

/// The samples of a texel, as PNG has them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Channels {
    /// Brightness.
    Gray,
    /// Brightness and opacity.
    GrayAlpha,
    /// Red, green, blue.
    Rgb,
    /// Red, green, blue and opacity.
    Rgba,
}

impl Channels {
    /// How many there are.
    pub fn count(self) -> usize {
        match self {
            Channels::Gray => 1,
            Channels::GrayAlpha => 2,
            Channels::Rgb => 3,
            Channels::Rgba => 4,
        }
    }

    /// Whether the last of them is opacity.
    pub fn has_alpha(self) -> bool {
        matches!(self, Channels::GrayAlpha | Channels::Rgba)
    }
}

/// Bits of a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Depth {
    /// 0 to 255.
    Eight,
    /// 0 to 65535.
    Sixteen,
}

/// How brightness is meant. Opacity is always linear.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Light {
    /// Encoded for the eye (IEC 61966-2-1), as most pictures are; filters decode it first.
    Srgb,
    /// Proportional to light, or no light at all: normals, heights, masks.
    Linear,
}

/// How the samples of a picture are to be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Format {
    /// The samples of a texel.
    pub channels: Channels,
    /// Their size.
    pub depth: Depth,
    /// Their meaning.
    pub light: Light,
}

impl Format {
    /// Red, green, blue and opacity in 8 bits each, for the eye.
    pub const RGBA8: Format =
        Format { channels: Channels::Rgba, depth: Depth::Eight, light: Light::Srgb };

    /// Bytes of a texel.
    pub fn bytes(self) -> usize {
        self.channels.count() * self.sample_bytes()
    }

    /// Bytes of a sample.
    pub fn sample_bytes(self) -> usize {
        match self.depth {
            Depth::Eight => 1,
            Depth::Sixteen => 2,
        }
    }

    /// The largest sample.
    pub fn max(self) -> u16 {
        match self.depth {
            Depth::Eight => 255,
            Depth::Sixteen => u16::MAX,
        }
    }
}

/// A picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Image {
    width: usize,
    height: usize,
    format: Format,
    data: Vec<u8>,
}

impl Image {
    /// A picture with all samples 0.
    pub fn new(width: usize, height: usize, format: Format) -> Self {
        Self { width, height, format, data: vec![0; width * height * format.bytes()] }
    }

    /// A picture with these samples, or `None` when their number does not suit the size.
    pub fn from_data(width: usize, height: usize, format: Format, data: Vec<u8>) -> Option<Self> {
        (data.len() == width * height * format.bytes()).then_some(Self {
            width,
            height,
            format,
            data,
        })
    }

    /// Texels of a row.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// How the samples are to be read.
    pub fn format(&self) -> Format {
        self.format
    }

    /// All samples.
    pub fn data(&self) -> &[u8] {
        &self.data
    }

    /// The same samples, meant otherwise.
    pub fn with_light(self, light: Light) -> Self {
        Self { format: Format { light, ..self.format }, ..self }
    }

    /// The samples of a row.
    pub fn row(&self, y: usize) -> &[u8] {
        let bytes = self.width * self.format.bytes();
        &self.data[y * bytes..][..bytes]
    }

    /// The samples of a row, to be changed.
    pub fn row_mut(&mut self, y: usize) -> &mut [u8] {
        let bytes = self.width * self.format.bytes();
        &mut self.data[y * bytes..][..bytes]
    }

    /// A sample.
    pub fn sample(&self, x: usize, y: usize, channel: usize) -> u16 {
        let at = self.at(x, y, channel);
        match self.format.depth {
            Depth::Eight => self.data[at].into(),
            Depth::Sixteen => u16::from_be_bytes([self.data[at], self.data[at + 1]]),
        }
    }

    /// Changes a sample, which must not be above [`Format::max`].
    pub fn set_sample(&mut self, x: usize, y: usize, channel: usize, value: u16) {
        let at = self.at(x, y, channel);
        match self.format.depth {
            Depth::Eight => self.data[at] = value as u8,
            Depth::Sixteen => self.data[at..at + 2].copy_from_slice(&value.to_be_bytes()),
        }
    }

    /// Copies another picture of the same format to where its first texel is given.
    pub fn blit(&mut self, from: &Image, x: usize, y: usize) {
        debug_assert_eq!(self.format, from.format);
        let bytes = self.format.bytes();
        for row in 0..from.height {
            self.row_mut(y + row)[x * bytes..][..from.width * bytes].copy_from_slice(from.row(row));
        }
    }

    /// A part of the picture.
    pub fn part(&self, x: usize, y: usize, width: usize, height: usize) -> Image {
        let bytes = self.format.bytes();
        let rows = (y..y + height).flat_map(|y| &self.row(y)[x * bytes..][..width * bytes]);
        Image { width, height, format: self.format, data: rows.copied().collect() }
    }

    fn at(&self, x: usize, y: usize, channel: usize) -> usize {
        debug_assert!(x < self.width && y < self.height);
        (y * self.width + x) * self.format.bytes() + channel * self.format.sample_bytes()
    }
}

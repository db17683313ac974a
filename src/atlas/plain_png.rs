//! PNG files, plainly: what is in memory as it is, and back.

use super::{AtlasError, Channels, Depth, Format, Image, Light};
use std::io::{Cursor, Write};
use std::path::Path;

/// Writes a picture.
///
/// # Errors
/// What `out` reports; a picture larger than PNG allows.
pub fn write(out: &mut dyn Write, image: &Image) -> Result<(), AtlasError> {
    let format = image.format();
    let side = |side: usize| {
        u32::try_from(side).ok().filter(|&side| side > 0 && side < 1 << 31).ok_or_else(|| {
            AtlasError::Asked(format!("a side of {side} texels: PNG has 1 to 2147483647"))
        })
    };
    let mut encoder = png::Encoder::new(out, side(image.width())?, side(image.height())?);
    encoder.set_color(match format.channels {
        Channels::Gray => png::ColorType::Grayscale,
        Channels::GrayAlpha => png::ColorType::GrayscaleAlpha,
        Channels::Rgb => png::ColorType::Rgb,
        Channels::Rgba => png::ColorType::Rgba,
    });
    encoder.set_depth(match format.depth {
        Depth::Eight => png::BitDepth::Eight,
        Depth::Sixteen => png::BitDepth::Sixteen,
    });
    if format.light == Light::Srgb {
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    }
    let wrong = |error: png::EncodingError| match error {
        png::EncodingError::IoError(error) => AtlasError::Io(error),
        error => AtlasError::Asked(error.to_string()),
    };
    let mut writer = encoder.write_header().map_err(wrong)?;
    writer.write_image_data(image.data()).map_err(wrong)?;
    writer.finish().map_err(wrong)
}

/// Reads a picture; its samples are taken for such light.
///
/// # Errors
/// A file that cannot be read, or is no PNG.
pub fn read(file: &Path, light: Light) -> Result<Image, AtlasError> {
    let wrong = |message: String| AtlasError::File { file: file.into(), message };
    let bytes = std::fs::read(file).map_err(|error| wrong(error.to_string()))?;
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(|error| wrong(error.to_string()))?;
    let size = reader.output_buffer_size().ok_or_else(|| wrong("is too large".to_owned()))?;
    let mut data = vec![0; size];
    let info = reader.next_frame(&mut data).map_err(|error| wrong(error.to_string()))?;
    data.truncate(info.buffer_size());
    let channels = match info.color_type {
        png::ColorType::Grayscale => Channels::Gray,
        png::ColorType::GrayscaleAlpha => Channels::GrayAlpha,
        png::ColorType::Rgb | png::ColorType::Indexed => Channels::Rgb,
        png::ColorType::Rgba => Channels::Rgba,
    };
    let depth = match info.bit_depth {
        png::BitDepth::Sixteen => Depth::Sixteen,
        _ => Depth::Eight,
    };
    let format = Format { channels, depth, light };
    let (width, height) = (info.width as usize, info.height as usize);
    Image::from_data(width, height, format, data).ok_or_else(|| wrong("is damaged".to_owned()))
}

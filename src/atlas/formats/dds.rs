//! DirectDraw Surface with the header of Direct3D 10: a picture with its mip chain, uncompressed,
//! for Direct3D, and for most engines and image editors.
//!
//! Source: learn.microsoft.com, Programming Guide for DDS.

use super::texels::Texels;
use crate::atlas::{AtlasError, Image};
use std::io::Write;

/// The fields that are there: caps, height, width, pitch, pixel format, mip levels.
const FLAGS: u32 = 0x1 | 0x2 | 0x4 | 0x8 | 0x1000 | 0x2_0000;
/// A texture, with others that belong to it, the mip levels.
const CAPS: u32 = 0x1000 | 0x8 | 0x40_0000;
/// The format is a number of four letters.
const FOUR_LETTERS: u32 = 0x4;
/// Two dimensions.
const TEXTURE_2D: u32 = 3;
/// Straight opacity.
const STRAIGHT: u32 = 1;

/// Writes a mip chain, level 0 first; see [`super::ktx2::write_ktx2`], which takes the same.
///
/// # Errors
/// Levels that are no mip chain; what `out` reports.
pub fn write_dds(out: &mut dyn Write, levels: &[Image]) -> Result<(), AtlasError> {
    let texels = Texels::of(levels)?;
    let dxgi = match texels {
        Texels::Linear8 => 28,
        Texels::Srgb8 => 29,
        Texels::Linear16 => 11,
    };
    let (width, height) = (levels[0].width() as u32, levels[0].height() as u32);
    let pitch = width.saturating_mul(texels.bytes() as u32);
    let mut words = vec![124, FLAGS, height, width, pitch, 0, levels.len() as u32];
    words.extend([0; 11]);
    words.extend([32, FOUR_LETTERS, u32::from_le_bytes(*b"DX10"), 0, 0, 0, 0, 0]);
    words.extend([CAPS, 0, 0, 0, 0]);
    words.extend([dxgi, TEXTURE_2D, 0, 1, STRAIGHT]);
    out.write_all(b"DDS ")?;
    for word in words {
        out.write_all(&word.to_le_bytes())?;
    }
    for level in levels {
        texels.write(out, level)?;
    }
    Ok(())
}

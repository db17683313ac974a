//! KTX 2.0 (Khronos, 2020): a picture with its mip chain, uncompressed, for Vulkan, WebGPU and
//! OpenGL, and all that loads textures for them.
//!
//! A header, an index of the levels, a data format descriptor that says again what the format
//! is, keys and values, and the levels, the smallest first. Opacity is straight, rows run from the
//! top.

use super::texels::Texels;
use crate::atlas::{AtlasError, Image};
use std::io::Write;

const IDENTIFIER: [u8; 12] = *b"\xabKTX 20\xbb\r\n\x1a\n";
const HEADER: usize = 80;
/// Bytes of the index for every level.
const ENTRY: usize = 24;

/// Writes a mip chain, level 0 first; each level is half as wide and high as the one before,
/// rounded down.
///
/// 8-bit texels become `R8G8B8A8`, as sRGB or linear. There is no sRGB of 16 bits: such pictures
/// are decoded and written as linear `R16G16B16A16`.
///
/// # Errors
/// Levels that are no mip chain; what `out` reports.
pub fn write_ktx2(out: &mut dyn Write, levels: &[Image]) -> Result<(), AtlasError> {
    let texels = Texels::of(levels)?;
    let (vk_format, type_size) = match texels {
        Texels::Linear8 => (37, 1),
        Texels::Srgb8 => (43, 1),
        Texels::Linear16 => (91, 2),
    };
    let descriptor = descriptor(texels);
    let keys = keys();
    let descriptor_at = HEADER + ENTRY * levels.len();
    let keys_at = descriptor_at + descriptor.len();
    let aligned = |at: usize| at.next_multiple_of(texels.bytes());
    // The smallest level comes first.
    let mut places = vec![(0, 0); levels.len()];
    let mut end = keys_at + keys.len();
    for (place, level) in places.iter_mut().zip(levels).rev() {
        let length = level.width() * level.height() * texels.bytes();
        *place = (aligned(end), length);
        end = aligned(end) + length;
    }

    out.write_all(&IDENTIFIER)?;
    let (width, height) = (levels[0].width(), levels[0].height());
    // Format, size of a sample, width, height, no depth, no array, one face, levels, uncompressed.
    let header = [vk_format, type_size, width, height, 0, 0, 1, levels.len(), 0];
    let index = [descriptor_at, descriptor.len(), keys_at, keys.len()];
    for word in header.into_iter().chain(index) {
        out.write_all(&(word as u32).to_le_bytes())?;
    }
    // No data shared by the levels.
    out.write_all(&[0; 16])?;
    for &(offset, length) in &places {
        for word in [offset, length, length] {
            out.write_all(&(word as u64).to_le_bytes())?;
        }
    }
    out.write_all(&descriptor)?;
    out.write_all(&keys)?;
    let mut at = keys_at + keys.len();
    for (&(offset, length), level) in places.iter().zip(levels).rev() {
        out.write_all(&vec![0; offset - at])?;
        texels.write(out, level)?;
        at = offset + length;
    }
    Ok(())
}

/// The basic descriptor block (Khronos Data Format 1.3): RGB with straight opacity, BT.709.
fn descriptor(texels: Texels) -> Vec<u8> {
    let bits = texels.bytes() as u32 * 2;
    let transfer = if texels == Texels::Srgb8 { 2 } else { 1 };
    let mut words = vec![4 + 88, 0, 2 | 88 << 16, 1 | 1 << 8 | transfer << 16, 0];
    words.extend([texels.bytes() as u32, 0]);
    for (number, channel) in [0, 1, 2, 15].into_iter().enumerate() {
        // Opacity is linear even where the colors are not.
        let qualifier = if channel == 15 && texels == Texels::Srgb8 { 0x10 } else { 0 };
        words.push((number as u32 * bits) | ((bits - 1) << 16) | ((channel | qualifier) << 24));
        words.extend([0, 0, (1 << bits) - 1]);
    }
    words.into_iter().flat_map(u32::to_le_bytes).collect()
}

/// Keys in order, each padded to words.
fn keys() -> Vec<u8> {
    let mut bytes = Vec::new();
    let writer = concat!("tilepack ", env!("CARGO_PKG_VERSION"));
    for (key, value) in [("KTXorientation", "rd"), ("KTXwriter", writer)] {
        let text = format!("{key}\0{value}\0");
        bytes.extend((text.len() as u32).to_le_bytes());
        bytes.extend(text.bytes());
        bytes.resize(bytes.len().next_multiple_of(4), 0);
    }
    bytes
}

//! A picture of the sheet, pale, with all that is off in red, and the sides of tiles that make a
//! visible seam in orange.

use super::Findings;
use crate::atlas::{Channels, Depth, Format, Image, Light, Sheet};
use crate::tiles::Side;

const FORMAT: Format = Format { channels: Channels::Rgb, depth: Depth::Eight, light: Light::Srgb };

/// Draws the heat map; the same size as the sheet.
pub fn heat_map(sheet: &Sheet, findings: &Findings) -> Image {
    let (from, layout) = (sheet.image(), sheet.layout());
    let mut map = Image::new(from.width(), from.height(), FORMAT);
    let channels = from.format().channels;
    let colors = channels.count() - usize::from(channels.has_alpha());
    for y in 0..from.height() {
        for x in 0..from.width() {
            let sum: u32 = (0..colors).map(|channel| u32::from(from.sample(x, y, channel))).sum();
            let gray = sum * 255 / (colors as u32 * u32::from(from.format().max()));
            // Between half and full brightness, so that red stands out.
            let pale = (135 + gray * 110 / 255) as u16;
            (0..3).for_each(|channel| map.set_sample(x, y, channel, pale));
        }
    }
    let corner = |cell: usize| {
        let (column, row) = layout.position(cell);
        let (block, gutter) = (layout.block(), layout.gutter);
        (column * block + gutter, row * block + gutter)
    };
    let side = layout.side;
    for seam in findings.visible() {
        for (cell, of) in [(seam.first, seam.side), (seam.second, seam.side.opposite())] {
            let (left, top) = corner(cell);
            for along in 0..side {
                let (x, y) = match of {
                    Side::North => (along, 0),
                    Side::South => (along, side - 1),
                    Side::West => (0, along),
                    Side::East => (side - 1, along),
                };
                paint(&mut map, left + x, top + y, [245, 150, 30]);
            }
        }
    }
    let samples = channels.count();
    for (cell, (x, y, width, _), differences) in &findings.off {
        let (left, top) = corner(*cell);
        for (texel, texel_samples) in differences.chunks(samples).enumerate() {
            let worst = texel_samples.iter().copied().fold(0.0, f32::max);
            if worst > 0.0 {
                // Small differences are to be seen, too.
                let strength = (0.35 + worst / 64.0).min(1.0);
                let (x, y) = (left + x + texel % width, top + y + texel / width);
                let rest = (200.0 * (1.0 - strength)) as u8;
                paint(&mut map, x, y, [215, rest, rest]);
            }
        }
    }
    map
}

fn paint(map: &mut Image, x: usize, y: usize, rgb: [u8; 3]) {
    for (channel, sample) in rgb.into_iter().enumerate() {
        map.set_sample(x, y, channel, sample.into());
    }
}

//! Fields of tiles as pictures: every tile a level of gray, from black for tile 0 to white for the
//! last; a free cell is a hole in the picture (opacity 0).
//!
//! Read back, a texel is the nearest level of its brightness; so any black and white picture is a
//! field of two tiles. What is written with more than one texel to a cell is read with as many.

use super::{Channels, Depth, Format, Image, Light};
use crate::dappled::{FREE, Field, FieldError};

/// The picture of a field, `side` texels to a cell; each side of it below `2^16`.
pub fn field_image(field: &Field, tiles: usize, side: usize) -> Image {
    let holes = !field.is_complete();
    let channels = if holes { Channels::GrayAlpha } else { Channels::Gray };
    let format = Format { channels, depth: Depth::Eight, light: Light::Srgb };
    let level = |tile: u8| (usize::from(tile) * 255 / (tiles - 1).max(1)) as u8;
    let mut data = Vec::with_capacity(field.cells().len() * side * side * format.bytes());
    for row in field.rows() {
        let start = data.len();
        for &tile in row {
            for _ in 0..side {
                data.push(if tile == FREE { 0 } else { level(tile) });
                if holes {
                    data.push(if tile == FREE { 0 } else { 255 });
                }
            }
        }
        let end = data.len();
        for _ in 1..side {
            data.extend_from_within(start..end);
        }
    }
    let (width, height) = (field.width() * side, field.height() * side);
    Image::from_data(width, height, format, data)
        .unwrap_or_else(|| Image::new(width, height, format))
}

/// The field that a picture shows, a cell for every `side` x `side` texels (the middle one counts).
///
/// # Errors
/// A size that `side` does not divide.
pub fn image_field(image: &Image, tiles: usize, side: usize) -> Result<Field, String> {
    let (width, height) = (image.width(), image.height());
    if side == 0 || !width.is_multiple_of(side) || !height.is_multiple_of(side) {
        return Err(format!("{width}x{height} texels, expected a multiple of {side}"));
    }
    let format = image.format();
    let (max, count) = (u64::from(format.max()), format.channels.count());
    let cell = |x: usize, y: usize| {
        let sample = |channel| u64::from(image.sample(x, y, channel));
        let colors = if format.channels.has_alpha() { count - 1 } else { count };
        if colors < count && 2 * sample(colors) < max {
            return FREE;
        }
        // Brightness as the eye has it (ITU-R BT.709), in thousandths.
        let luma = match colors {
            1 => 1000 * sample(0),
            _ => 213 * sample(0) + 715 * sample(1) + 72 * sample(2),
        };
        ((luma * (tiles as u64 - 1) + 500 * max) / (1000 * max)) as u8
    };
    let (columns, rows) = (width / side, height / side);
    let at = |at: usize| at * side + side / 2;
    let cells = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
    let cells = cells.map(|(x, y)| cell(at(x), at(y))).collect();
    Field::new(columns, rows, cells).map_err(|error: FieldError| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_come_back() {
        for tiles in 1..=9_u8 {
            let cells = (0..12).map(|at| if at == 5 { FREE } else { at % tiles }).collect();
            let field = Field::new(4, 3, cells).unwrap();
            for side in [1, 3] {
                let image = field_image(&field, tiles.into(), side);
                assert_eq!(image.width(), 4 * side);
                assert_eq!(image_field(&image, tiles.into(), side).unwrap(), field, "{tiles}");
            }
            assert!(image_field(&field_image(&field, 2, 1), 2, 5).is_err());
        }
    }
}

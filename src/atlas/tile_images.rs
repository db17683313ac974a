//! What draws the tiles of a set, and pictures put together of them.

use super::{AtlasError, Format, Image};
use crate::tiles::TileId;

/// The pictures of the tiles of a set: squares of one size and format.
pub trait TileImages: Sync {
    /// Texels of a side.
    fn side(&self) -> usize;

    /// How their samples are to be read.
    fn format(&self) -> Format;

    /// The picture of a tile; the same tile always gives the same picture.
    ///
    /// # Errors
    /// A tile that has no picture, or one that cannot be read.
    fn draw(&self, tile: TileId) -> Result<Image, AtlasError>;
}

/// A picture of tiles, listed row by row, `width` of them in a row.
///
/// # Errors
/// As [`TileImages::draw`].
pub fn assemble(
    images: &dyn TileImages,
    tiles: &[TileId],
    width: usize,
) -> Result<Image, AtlasError> {
    let (side, height) = (images.side(), tiles.len() / width);
    let mut picture = Image::new(width * side, height * side, images.format());
    for (cell, &tile) in tiles.iter().enumerate() {
        picture.blit(&images.draw(tile)?, cell % width * side, cell / width * side);
    }
    Ok(picture)
}

//! The measures of a tile.

use super::{Stock, TextureError};

/// How large a tile is, and how its parts are divided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shape {
    /// Texels of a side; even.
    pub side: usize,
    /// Texels along a side in which a tile shows what its neighbors know.
    pub strip: usize,
    /// Moves of each patch when positions are chosen.
    pub moves: usize,
}

/// The smallest and the largest tile.
const SIDES: std::ops::RangeInclusive<usize> = 8..=1024;

impl Shape {
    /// A tile.
    ///
    /// # Errors
    /// Sides that are odd or out of range, strips that leave nothing.
    pub fn new(side: usize, strip: usize) -> Result<Self, TextureError> {
        if !SIDES.contains(&side) || !side.is_multiple_of(2) {
            let (least, most) = (SIDES.start(), SIDES.end());
            return Err(TextureError::Asked(format!(
                "tiles of {side} texels: expected an even number from {least} to {most}"
            )));
        }
        if strip < 1 || 4 * strip > side {
            return Err(TextureError::Asked(format!(
                "a strip of {strip} texels: expected 1 to {}, a quarter of the tile's side of {side}",
                side / 4
            )));
        }
        Ok(Self { side, strip, moves: 1500 })
    }

    /// Half the width of the bands in which patches overlap.
    pub fn overlap(self) -> usize {
        (self.side / 5).max(2)
    }

    /// The disk about the middle of a tile that keeps clear of the strip.
    pub fn radius(self) -> usize {
        self.side / 2 - self.strip
    }

    /// Twice the radius of the disk in which seams have to be covered.
    pub fn core(self) -> usize {
        (self.side * 3 / 5).min(2 * self.radius() - 2)
    }

    /// Whether the examples are large enough for patches that reach so far from their middle.
    ///
    /// # Errors
    /// The first that is not, counted from 1.
    pub fn suits(self, stock: &Stock, reach: usize) -> Result<(), TextureError> {
        let least = 2 * reach;
        for (at, place) in stock.places().iter().enumerate() {
            if place.width < least || place.height < least {
                return Err(TextureError::Asked(format!(
                    "example {} is {} x {} texels: expected at least {least} x {least}, for tiles \
                     of {} texels",
                    at + 1,
                    place.width,
                    place.height,
                    self.side
                )));
            }
        }
        Ok(())
    }
}

//! Do the pictures of tiles keep the common strip?
//!
//! Within `strip` texels of a side all tiles with the same colors on that side must show the
//! same texels; and the squares in the corners of Wang tiles must be the same in all tiles,
//! because tiles that meet in a corner only share nothing else (the *corner problem*, Cohen et
//! al. 2003). For corner tiles that follows from the sides: two strips cross there.

use super::sides::{key_in_words, keys, side_keys};
use super::{AtlasError, Image};
use crate::tiles::Side;
use crate::tiles::{Colors, Kind, TileId};

/// A rectangle of a tile: columns and rows of its first texel, width and height.
pub(super) type Area = (usize, usize, usize, usize);

/// The strip along a side of a tile.
pub(super) fn strip_area(side: Side, texels: usize, strip: usize) -> Area {
    match side {
        Side::North => (0, 0, texels, strip),
        Side::South => (0, texels - strip, texels, strip),
        Side::West => (0, 0, strip, texels),
        Side::East => (texels - strip, 0, strip, texels),
    }
}

/// The squares in the corners of a tile, clockwise from NE.
pub(super) fn corner_areas(texels: usize, strip: usize) -> [Area; 4] {
    let far = texels - strip;
    [(far, 0), (far, far), (0, far), (0, 0)].map(|(x, y)| (x, y, strip, strip))
}

/// Names of the corners, clockwise from NE.
pub(super) const CORNERS: [&str; 4] = ["NE", "SE", "SW", "NW"];

/// Pictures of tiles, checked one after the other against those before.
#[derive(Debug)]
pub struct StripCheck {
    kind: Kind,
    colors: Colors,
    strip: usize,
    /// For each side and key the first tile that has it, and its strip.
    strips: Vec<Option<(TileId, Image)>>,
    /// For each corner the first tile, and its square.
    corners: [Option<(TileId, Image)>; 4],
}

impl StripCheck {
    /// Begins with no tile. `strip` is at most half the side of the tiles.
    pub fn new(kind: Kind, colors: Colors, strip: usize) -> Self {
        let strips = vec![None; 4 * keys(kind, colors)];
        Self { kind, colors, strip, strips, corners: [None, None, None, None] }
    }

    /// Looks at the picture of one more tile.
    ///
    /// # Errors
    /// The first texel that differs from an earlier tile's, in words.
    pub fn add(&mut self, tile: TileId, image: &Image) -> Result<(), AtlasError> {
        let (kind, colors) = (self.kind, self.colors);
        let stride = keys(kind, colors);
        let side_of = side_keys(kind, tile, colors);
        for (at, side) in Side::ALL.into_iter().enumerate() {
            let area = strip_area(side, image.width(), self.strip);
            let known = &mut self.strips[at * stride + side_of[at] as usize];
            agree(known, tile, image, area, |other| {
                let key = key_in_words(kind, side_of[at], colors);
                let side = side.name();
                format!("tiles {other} and {tile} both have {key} in the {side}")
            })?;
        }
        if kind == Kind::Wang {
            for (at, area) in corner_areas(image.width(), self.strip).into_iter().enumerate() {
                agree(&mut self.corners[at], tile, image, area, |other| {
                    let corner = CORNERS[at];
                    format!("tiles {other} and {tile} must agree in their {corner} corners")
                })?;
            }
        }
        Ok(())
    }
}

/// Compares an area with that of the first tile, or remembers it.
fn agree(
    known: &mut Option<(TileId, Image)>,
    tile: TileId,
    image: &Image,
    (x, y, width, height): Area,
    what: impl Fn(TileId) -> String,
) -> Result<(), AtlasError> {
    let part = image.part(x, y, width, height);
    let Some((other, first)) = known else {
        *known = Some((tile, part));
        return Ok(());
    };
    let Some(at) = first.data().iter().zip(part.data()).position(|(a, b)| a != b) else {
        return Ok(());
    };
    let texel = at / part.format().bytes();
    let (right, down) = (x + texel % width, y + texel / width);
    Err(AtlasError::Asked(format!("{}, but differ at column {right}, row {down}", what(*other))))
}

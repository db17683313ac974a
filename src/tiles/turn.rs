//! Squares: Wang tiles that may be turned by quarter turns.
//!
//! A square that is turned shows another tile. Two squares that show the same tiles, whichever
//! way they are turned, are of one *class*: nobody can tell them apart on the table. The class
//! is named after its least tile. Turning carries vertical edges to horizontal ones, so squares
//! have one palette for both.

use super::{Colors, Kind, Members, TileError, TileId, TileSet};

/// The colors N, E, S, W of a tile after so many quarter turns clockwise.
pub fn turned(sides: [u8; 4], turns: u8) -> [u8; 4] {
    let mut after = sides;
    after.rotate_right(usize::from(turns % 4));
    after
}

/// The tiles that a square shows after 0, 1, 2 and 3 quarter turns clockwise.
///
/// # Errors
/// When the palettes differ.
pub fn turns(tile: TileId, colors: Colors) -> Result<[TileId; 4], TileError> {
    let sides = Kind::Wang.unpack(tile, colors);
    let mut tiles = [tile; 4];
    for (shown, turns) in tiles.iter_mut().zip(0..) {
        *shown = Kind::Wang.pack(&turned(sides, turns), colors)?;
    }
    Ok(tiles)
}

impl TileSet {
    /// A set of squares, to be turned: tiles that are listed again, or are turns of each other,
    /// are squares of their own.
    ///
    /// # Errors
    /// A kind other than Wang tiles, two palettes, a tile out of range, an empty list.
    pub fn squares(colors: Colors, mut tiles: Vec<TileId>) -> Result<Self, TileError> {
        if colors.single().is_none() {
            return Err(TileError::TurnedPalettes(colors.to_string()));
        }
        tiles.sort_unstable();
        let mut different = tiles.clone();
        different.dedup();
        Ok(Self::new(Kind::Wang, colors, Members::Explicit(different))?.with_repeated(tiles))
    }
}

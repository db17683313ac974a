//! What tiles share: the colors of a side, as a number to compare.
//!
//! Two tiles may lie side by side when the sides that meet have the same key. For Wang tiles the
//! key is the color of the edge; for corner tiles it is made of the two corner colors, from west
//! to east or from north to south.

use crate::tiles::{Colors, Kind, TileId};

/// The keys of a tile's sides, in the order of [`crate::tiles::Side::ALL`]; all are below [`keys`].
pub fn side_keys(kind: Kind, tile: TileId, colors: Colors) -> [u32; 4] {
    let sides = kind.unpack(tile, colors).map(u32::from);
    match kind {
        Kind::Wang => sides,
        _ => {
            let [ne, se, sw, nw] = sides;
            let count = colors.horizontal() as u32;
            [nw * count + ne, ne * count + se, sw * count + se, nw * count + sw]
        }
    }
}

/// How many keys there can be.
pub fn keys(kind: Kind, colors: Colors) -> usize {
    match kind {
        Kind::Wang => colors.largest(),
        _ => colors.horizontal() * colors.horizontal(),
    }
}

/// The colors behind a key, in words.
pub fn key_in_words(kind: Kind, key: u32, colors: Colors) -> String {
    match kind {
        Kind::Wang => format!("color {key}"),
        _ => {
            let count = colors.horizontal() as u32;
            format!("colors {} and {}", key / count, key % count)
        }
    }
}

/// The kind of a set whose tiles are squares in the plane.
pub fn is_square(kind: Kind) -> bool {
    kind != Kind::Domino
}

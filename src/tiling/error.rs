//! What can be wrong with a tiling, in one line.

use crate::tiles::{Colors, Kind};

/// A tiling that cannot be, or cannot be looked up.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TilingError {
    /// Dominoes do not fill the plane.
    #[error("dominoes have no endless tiling: expected corner or Wang tiles")]
    Dominoes,
    /// A map that is not about the tiles in question.
    #[error("the color map shows {map}, but the tiles are {asked}")]
    OtherMap {
        /// What the map shows.
        map: String,
        /// What was asked for.
        asked: String,
    },
    /// A grid of colors too large for exact arithmetic.
    #[error("halton {width}x{height}: at most 2^{limit} points are told apart")]
    HaltonTooLarge {
        /// Columns of tiles.
        width: usize,
        /// Rows of tiles.
        height: usize,
        /// Binary digits of the number of points.
        limit: u32,
    },
    /// Tiles of a map that do not fit.
    #[error("the color map does not close: row {row}, column {column} does not fit its neighbors")]
    MapDoesNotFit {
        /// Of the cell.
        row: usize,
        /// Of the cell.
        column: usize,
    },
    /// A coloring that is not one of these tiles.
    #[error("{what}: not a tiling of {kind} tiles over {colors} colors")]
    Mismatch {
        /// The coloring.
        what: &'static str,
        /// Of tiles.
        kind: Kind,
        /// Of the tiles.
        colors: Colors,
    },
    /// A number of colors that the xor set does not have.
    #[error("a compact xor set has 2, 4, 8, 16, 32, 64 or 128 colors, not {0}")]
    NotPowerOfTwo(usize),
    /// A number of colors without a direct tiling of a compact set.
    #[error("compact corner sets over {0} colors: expected 2 to 128 colors")]
    CompactColors(usize),
    /// A number of colors that blocks are not made for.
    #[error("blocks of the compact difference set over {colors} colors: expected 2 to {most}")]
    FrameColors {
        /// Asked for.
        colors: usize,
        /// At most.
        most: usize,
    },
    /// Different colors where one palette is needed.
    #[error("the compact set of Wang tiles has one palette for all edges, not {0} colors")]
    TwoPalettes(Colors),
    /// A list of another length.
    #[error("{found} probabilities, expected {expected}: one for each cell and color")]
    Weights {
        /// Cells times colors.
        expected: usize,
        /// Given.
        found: usize,
    },
    /// Cells of no points, or of too many.
    #[error("cells of {}x{} points: expected 1 to {most} each", .scale[0], .scale[1])]
    Scale {
        /// Points of a cell.
        scale: [u32; 2],
        /// At most.
        most: u32,
    },
    /// What is no probability.
    #[error("row {row}, column {column}: {weight} is no probability: expected 0 to 1")]
    Weight {
        /// Of the cell, from the north.
        row: usize,
        /// Of the cell.
        column: usize,
        /// As it was read.
        weight: String,
    },
    /// Probabilities that do not add up.
    #[error("row {row}, column {column}: the probabilities add up to {sum}, expected 1")]
    Sum {
        /// Of the cell, from the north.
        row: usize,
        /// Of the cell.
        column: usize,
        /// What they add up to.
        sum: String,
    },
    /// A packing that no formula describes.
    #[error(
        "the packing is not the constructed one, so no formula says where its tiles lie: {0}; \
         make it with find --method construct, or look tiles up in a table"
    )]
    NotTheFormula(String),
    /// A place where no tile fits.
    #[error(
        "no tile of the set fits at ({x}, {y}) to those laid before: a scanline goes no way back; \
         take another --seed, or a compact or complete set, where some tile always fits"
    )]
    NothingFits {
        /// To the east.
        x: i64,
        /// To the north.
        y: i64,
    },
    /// A compact set whose tiles are not said.
    #[error(
        "a compact set does not say which its tiles are: expected a packing of one, or a tile set \
         file (tile --coloring compact --set-out writes one)"
    )]
    NoTiles,
    /// A tile that the tiling needs and the packing lacks.
    #[error("tile {tile} ({sides}) of the tiling is not in the packing: {needs}")]
    MissingTile {
        /// The number of the tile.
        tile: u32,
        /// Its colors.
        sides: String,
        /// What the tiling needs.
        needs: String,
    },
    /// Another kind or other colors.
    #[error("the packing has {packing}, but the tiling {tiling}")]
    OtherPacking {
        /// What the packing has.
        packing: String,
        /// What the tiling has.
        tiling: String,
    },
}

//! What can be wrong with a tiling, in one line.

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
    /// A packing that no formula describes.
    #[error(
        "the packing is not the constructed one, so no formula says where its tiles lie: {0}; \
         make it with find --method construct, or look tiles up in a table"
    )]
    NotTheFormula(String),
    /// A tile that the tiling needs and the packing lacks.
    #[error(
        "tile {tile} of the tiling is not in the packing: a coloring by hash or Halton needs the \
         complete set; for other sets, give a color map of their tiles"
    )]
    MissingTile {
        /// The number of the tile.
        tile: u32,
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

//! What can be wrong with colors, tiles and tile sets, in words a user can act on.

/// An error in the description of colors, tiles or a tile set.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TileError {
    /// The number of colors is not in the range this program handles.
    #[error("{count} colors: expected 1 to {max}")]
    ColorCount {
        /// The number given.
        count: u64,
        /// The largest number accepted.
        max: u64,
    },
    /// Text that should be a number of colors is not.
    #[error("colors '{0}': expected C, or CH,CV for Wang tiles and dominoes")]
    ColorSyntax(String),
    /// Two numbers of colors were given for corner tiles, which have one.
    #[error("corner tiles have one number of colors, but {0},{1} was given")]
    TwoColorCounts(u16, u16),
    /// A color is outside the range of the set.
    #[error("color {color} is out of range: expected 0 to {max}")]
    ColorRange {
        /// The color given.
        color: u64,
        /// The largest color of the set.
        max: u64,
    },
    /// A tile number is outside the range of the kind and colors.
    #[error("tile {tile} is out of range: expected 0 to {max}")]
    TileRange {
        /// The tile given.
        tile: u64,
        /// The largest tile number.
        max: u64,
    },
    /// A tile occurs twice in an explicit set.
    #[error("tile {tile} ({sides}) is listed twice in the set")]
    DuplicateTile {
        /// The tile number.
        tile: u32,
        /// Its colors, for people.
        sides: String,
    },
    /// Squares to be turned have two palettes.
    #[error("colors {0}: squares that may be turned have one number of colors for all edges")]
    TurnedPalettes(String),
    /// An explicit set holds no tile.
    #[error("the set holds no tile")]
    EmptySet,
    /// An excluded pair names the same color twice.
    #[error("excluded pair {0}-{0}: expected two different colors")]
    PairOfOne(u8),
    /// Compact sets are not defined for this kind.
    #[error("compact sets are defined for corner and Wang tiles, not for dominoes")]
    CompactDomino,
    /// Text that should be a tile set is not.
    #[error("set '{0}': expected complete, compact, pruned:A-B,C-D,... or a tile set file")]
    SetSyntax(String),
    /// Text that should name a kind of tile does not.
    #[error("kind '{0}': expected corner, wang or domino")]
    KindSyntax(String),
}

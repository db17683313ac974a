//! What can be wrong with a packing, in words: which cell, which side, which tile.
//!
//! Rows and columns count from 0, rows from the north and columns from the west.

use crate::torus::Shape;
use std::fmt;

/// A cell, for messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// 0-based, from the north.
    pub row: usize,
    /// 0-based, from the west.
    pub column: usize,
}

impl Place {
    /// The place of the cell with this index, row by row.
    pub(super) fn of(index: usize, shape: Shape) -> Self {
        Self { row: index / shape.width(), column: index % shape.width() }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "row {}, column {}", self.row, self.column)
    }
}

/// A tile, for messages.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tile {
    /// Its number.
    pub number: u32,
    /// Its colors: `NE 0, SE 1, SW 2, NW 2`.
    pub colors: String,
}

impl fmt::Display for Tile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "tile {} ({})", self.number, self.colors)
    }
}

/// One side or corner of a tile where it touches a neighbor.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Touch {
    /// The cell.
    pub at: Place,
    /// The part of the tile: `east side`, `NE corner`, `second end`.
    pub part: &'static str,
    /// The color there.
    pub color: u8,
}

/// A reason why tiles are no packing.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Fault {
    /// The list of tiles does not fill the torus.
    #[error("size {shape} has {}, but there are {}", count(.shape.cells() as u64, "cell"),
        count(*.given as u64, "tile"))]
    Cells {
        /// The torus.
        shape: Shape,
        /// The length of the list.
        given: usize,
    },
    /// Dominoes are one-dimensional.
    #[error("size {shape}: dominoes lie on a ring, so the width or the height must be 1")]
    NotARing {
        /// The torus.
        shape: Shape,
    },
    /// The number of cells does not suit the number of tiles in the set.
    #[error("size {shape} has {}, but the set has {}{}", count(.shape.cells() as u64, "cell"),
        count(*.tiles, "tile"), if *.cover { " to cover" } else { "" })]
    Size {
        /// The torus.
        shape: Shape,
        /// The size of the set.
        tiles: u64,
        /// Whether every tile was to occur at least once rather than exactly once.
        cover: bool,
    },
    /// There is no tile with this number.
    #[error("{at}: tile {tile} is out of range: expected 0 to {max}")]
    Range {
        /// The cell.
        at: Place,
        /// The number.
        tile: u32,
        /// The largest number.
        max: u64,
    },
    /// A tile of a pruned set shows two colors that may not meet.
    #[error("{at}: {tile} shows both colors of the excluded pair {}-{}", .pair.0, .pair.1)]
    Excluded {
        /// The cell.
        at: Place,
        /// The tile.
        tile: Tile,
        /// The pair of colors.
        pair: (u8, u8),
    },
    /// A tile is not in the list of an explicit set.
    #[error("{at}: {tile} is not one of the tiles of the set")]
    Foreign {
        /// The cell.
        at: Place,
        /// The tile.
        tile: Tile,
    },
    /// Two neighbors disagree on the color they share.
    #[error("{}: {} has color {}, but the tile to the {direction} ({}) has color {} on its {}",
        .this.at, .this.part, .this.color, .neighbor.at, .neighbor.color, .neighbor.part)]
    Mismatch {
        /// Where the tile touches its neighbor.
        this: Touch,
        /// `east` or `south`.
        direction: &'static str,
        /// Where the neighbor touches the tile.
        neighbor: Touch,
    },
    /// What the board, its border or the turns are said to be makes no sense.
    #[error("{what}")]
    Board {
        /// What is to be said.
        what: &'static str,
    },
    /// More or fewer turns than tiles that may be turned.
    #[error("there are {}, expected {expected}", count(*.given as u64, "turn"))]
    Turns {
        /// The turns given.
        given: usize,
        /// The tiles that may be turned.
        expected: usize,
    },
    /// No number of quarter turns.
    #[error("{at}: {turns} quarter turns: expected 0 to 3")]
    Turn {
        /// The cell.
        at: Place,
        /// The turns.
        turns: u8,
    },
    /// An outer side does not have the color prescribed.
    #[error("{}: {} has color {}, but the border has color {asked} there", .this.at, .this.part,
        .this.color)]
    Border {
        /// The side.
        this: Touch,
        /// The color prescribed.
        asked: u8,
    },
    /// A tile occurs more or less often than the set lists it.
    #[error("{tile} occurs {}{}, but the set lists it {}", times_of(*.times),
        if .at.is_empty() { String::new() } else { format!(": at {}", places(.at, *.times)) },
        times_of(*.copies))]
    Copies {
        /// The tile.
        tile: Tile,
        /// How often it occurs.
        times: u64,
        /// How often it should.
        copies: u64,
        /// The first places where it does.
        at: Vec<Place>,
    },
    /// A tile that should occur once occurs again.
    #[error("{tile} occurs {times} times: at {}", places(.at, *.times))]
    Repeated {
        /// The tile.
        tile: Tile,
        /// How often it occurs.
        times: u64,
        /// The first places where it does.
        at: Vec<Place>,
    },
    /// A compact set has exactly two tiles for each choice of the fixed colors.
    #[error("compact set: {found} with {fixed}{}, expected 2",
        if .free.is_empty() { String::new() } else { format!(" ({})", .free.join("; ")) },
        found = match *.found { 0 => "no tile".to_owned(), 1 => "only 1 tile".to_owned(),
            n => format!("{n} different tiles") })]
    Class {
        /// The colors that the two tiles have in common: `NW 0, SW 1, SE 2`.
        fixed: String,
        /// How many different tiles were found.
        found: u64,
        /// Their other colors, of the first few: `NE 0`, or `E 1, S 0` for Wang tiles.
        free: Vec<String>,
    },
    /// A tile of the set does not occur.
    #[error("{tile} is missing")]
    Missing {
        /// The tile.
        tile: Tile,
    },
}

impl Fault {
    /// Whether the size of the torus is wrong for the set, whatever the tiles.
    pub fn is_size(&self) -> bool {
        matches!(self, Fault::Cells { .. } | Fault::NotARing { .. } | Fault::Size { .. })
    }
}

/// `1 tile`, `2 tiles`.
fn count(number: u64, what: &str) -> String {
    format!("{number} {what}{}", if number == 1 { "" } else { "s" })
}

/// `once`, `3 times`.
fn times_of(number: u64) -> String {
    if number == 1 { "once".to_owned() } else { format!("{number} times") }
}

/// `A and B`, `A, B and C`, `A, B, C, D and 5 more`.
fn places(at: &[Place], times: u64) -> String {
    let more = times.saturating_sub(at.len() as u64);
    let mut words: Vec<String> = at.iter().map(Place::to_string).collect();
    let last = if more > 0 { format!("{more} more") } else { words.pop().unwrap_or_default() };
    if words.is_empty() { last } else { format!("{} and {last}", words.join("; ")) }
}

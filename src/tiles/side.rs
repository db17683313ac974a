//! The four sides of a square tile, in the order in which Wang tiles list their colors.

/// A side of a tile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Above.
    North,
    /// Right.
    East,
    /// Below.
    South,
    /// Left.
    West,
}

impl Side {
    /// All sides, clockwise.
    pub const ALL: [Side; 4] = [Side::North, Side::East, Side::South, Side::West];

    /// The name used in messages.
    pub fn name(self) -> &'static str {
        ["north", "east", "south", "west"][self as usize]
    }

    /// The side of the neighbor that meets this one.
    pub fn opposite(self) -> Side {
        [Side::South, Side::West, Side::North, Side::East][self as usize]
    }

    /// Columns to the east and rows to the south of the neighbor.
    pub fn step(self) -> (isize, isize) {
        [(0, -1), (1, 0), (0, 1), (-1, 0)][self as usize]
    }
}

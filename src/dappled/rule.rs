//! What a dappled tiling keeps: conditions, the windows of cells that they speak of, and the check
//! of a field from the definition.
//!
//! A condition gives a set of tiles a direction and a limit `p`: no `p + 1` cells side by side hold
//! tiles of the set only. With a limit of its own for each cell, that of the last cell counts (the
//! eastern one in a row, the southern one in a column). Where the edges meet, a window goes on at
//! the other end, and one longer than the line is the line, once.

use super::{FREE, Field};

/// Tiles at most: sets of tiles are words.
pub const MOST_TILES: usize = 64;

/// Along a row or down a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Direction {
    /// Side by side in a row.
    Horizontal,
    /// One above the other in a column.
    Vertical,
}

/// Which edges of the rectangle meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edges {
    /// None.
    Free,
    /// East and west: rows are cyclic.
    Cylinder,
    /// All: rows and columns are cyclic.
    Torus,
}

impl Edges {
    /// Whether lines of this direction meet their own end.
    pub fn meet(self, direction: Direction) -> bool {
        match self {
            Edges::Free => false,
            Edges::Cylinder => direction == Direction::Horizontal,
            Edges::Torus => true,
        }
    }
}

/// How many may stand side by side.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Limit {
    /// Any number.
    None,
    /// So many, at least 1.
    Same(u32),
    /// So many for each cell in which a run ends, row by row; `u32::MAX` for any number.
    Map(Vec<u32>),
}

impl Limit {
    /// The limit of runs that end in a cell (its index, row by row).
    pub fn at(&self, cell: usize) -> Option<u32> {
        match self {
            Limit::None => None,
            Limit::Same(limit) => Some(*limit),
            Limit::Map(map) => Some(map[cell]).filter(|&limit| limit != u32::MAX),
        }
    }
}

/// Of these tiles, no more than so many side by side.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Condition {
    /// The tiles, a bit each.
    pub set: u64,
    /// Where runs go.
    pub direction: Direction,
    /// How long they may be.
    pub limit: Limit,
}

/// Cells that may not all hold tiles of a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Window {
    /// Which condition of the rule.
    pub condition: usize,
    /// Its tiles, a bit each.
    pub set: u64,
    /// The cells (indices, row by row), from west to east or north to south, across the seam if
    /// need be.
    pub cells: Vec<u32>,
}

/// A window whose cells all hold tiles of its set.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "row {row}, column {column}: {length} tiles of {set:?} in a {line}, expected at most {limit}"
)]
pub struct Fault {
    /// The row of its last cell.
    pub row: usize,
    /// The column of its last cell.
    pub column: usize,
    /// How many cells it has.
    pub length: usize,
    /// The tiles that may not repeat.
    pub set: Vec<u8>,
    /// "row" or "column".
    pub line: &'static str,
    /// How many of them may stand side by side there.
    pub limit: u32,
}

/// Conditions for a rectangle.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rule {
    width: usize,
    height: usize,
    tiles: usize,
    edges: Edges,
    conditions: Vec<Condition>,
}

/// What is no rule.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RuleError {
    /// Too few or too many tiles.
    #[error("{0} tiles: expected 1 to {MOST_TILES}")]
    Tiles(usize),
    /// A tile that there is not.
    #[error("tile {tile}: expected one below {tiles}")]
    Tile {
        /// Its number.
        tile: usize,
        /// How many there are.
        tiles: usize,
    },
    /// A set without tiles.
    #[error("a limit for no tile: expected at least one")]
    Nothing,
    /// A limit of 0.
    #[error("a limit of 0: expected 1 or more, or inf")]
    Zero,
    /// A map for another rectangle.
    #[error("a map of {found} limits, expected one for each of {expected} cells")]
    Map {
        /// Limits in the map.
        found: usize,
        /// Cells of the rectangle.
        expected: usize,
    },
}

impl Rule {
    /// Conditions for a rectangle of tiles `0..tiles`.
    ///
    /// # Errors
    /// Tiles or limits that make no sense.
    pub fn new(
        (width, height): (usize, usize),
        tiles: usize,
        edges: Edges,
        conditions: Vec<Condition>,
    ) -> Result<Self, RuleError> {
        if !(1..=MOST_TILES).contains(&tiles) {
            return Err(RuleError::Tiles(tiles));
        }
        for condition in &conditions {
            if condition.set == 0 {
                return Err(RuleError::Nothing);
            }
            let last = condition.set.ilog2() as usize;
            if last >= tiles {
                return Err(RuleError::Tile { tile: last, tiles });
            }
            match &condition.limit {
                Limit::Same(0) => return Err(RuleError::Zero),
                Limit::Map(map) if map.len() != width * height => {
                    return Err(RuleError::Map { found: map.len(), expected: width * height });
                }
                Limit::Map(map) if map.contains(&0) => return Err(RuleError::Zero),
                _ => {}
            }
        }
        Ok(Self { width, height, tiles, edges, conditions })
    }

    /// The same limits for every tile alone: `horizontal` in a row, `vertical` in a column.
    ///
    /// # Errors
    /// As [`Rule::new`].
    pub fn uniform(
        size: (usize, usize),
        tiles: usize,
        edges: Edges,
        horizontal: Option<u32>,
        vertical: Option<u32>,
    ) -> Result<Self, RuleError> {
        let mut conditions = Vec::new();
        for tile in 0..tiles.min(MOST_TILES) {
            for (direction, limit) in
                [(Direction::Horizontal, horizontal), (Direction::Vertical, vertical)]
            {
                if let Some(limit) = limit {
                    let limit = Limit::Same(limit);
                    conditions.push(Condition { set: 1 << tile, direction, limit });
                }
            }
        }
        Self::new(size, tiles, edges, conditions)
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// How many tiles there are.
    pub fn tiles(&self) -> usize {
        self.tiles
    }

    /// Which edges meet.
    pub fn edges(&self) -> Edges {
        self.edges
    }

    /// The conditions.
    pub fn conditions(&self) -> &[Condition] {
        &self.conditions
    }

    /// The window of a condition that ends in a cell, if there is one: with free edges it must
    /// fit, and a line that meets its end is one window only, of its first cell that asks for it.
    pub fn window(&self, condition: usize, cell: usize) -> Option<Window> {
        let Condition { set, direction, limit } = &self.conditions[condition];
        let limit = limit.at(cell)?;
        let (at, line, step) = match direction {
            Direction::Horizontal => (cell % self.width, self.width, 1),
            Direction::Vertical => (cell / self.width, self.height, self.width),
        };
        let first = cell - at * step;
        let length = limit as usize + 1;
        let index = |at: usize| (first + at * step) as u32;
        let cells = match self.edges.meet(*direction) {
            false if at < limit as usize => return None,
            true if length >= line => {
                let conditions = &self.conditions[condition].limit;
                let long = |at: usize| {
                    conditions.at(first + at * step).is_some_and(|p| p as usize + 1 >= line)
                };
                if (0..at).any(long) {
                    return None;
                }
                (0..line).map(index).collect()
            }
            // From `at + line - limit` on, in a circle.
            _ => {
                (0..length).map(|back| index((at + line + back - limit as usize) % line)).collect()
            }
        };
        Some(Window { condition, set: *set, cells })
    }

    /// All windows, by condition, then by cell.
    pub fn windows(&self) -> impl Iterator<Item = Window> {
        let cells = self.width * self.height;
        (0..self.conditions.len()).flat_map(move |condition| {
            (0..cells).filter_map(move |cell| self.window(condition, cell))
        })
    }

    /// The first window that a field breaks; free cells hold nothing. From the definition, with no
    /// thought of speed.
    pub fn first_fault(&self, field: &Field) -> Option<Fault> {
        let holds = |set: u64, cell: u32| match field.cells()[cell as usize] {
            FREE => false,
            tile => set >> tile & 1 == 1,
        };
        let broken = self.windows().find(|w| w.cells.iter().all(|&cell| holds(w.set, cell)))?;
        let last = *broken.cells.last()? as usize;
        let Condition { set, direction, limit } = &self.conditions[broken.condition];
        Some(Fault {
            row: last / self.width,
            column: last % self.width,
            length: broken.cells.len(),
            set: (0..self.tiles as u8).filter(|&tile| set >> tile & 1 == 1).collect(),
            line: match direction {
                Direction::Horizontal => "row",
                Direction::Vertical => "column",
            },
            // The limit of the cell, or of the line that is one window.
            limit: limit.at(last).unwrap_or(broken.cells.len() as u32),
        })
    }

    /// Whether a field is a dappled tiling.
    pub fn accepts(&self, field: &Field) -> bool {
        (field.width(), field.height()) == (self.width, self.height)
            && field.cells().iter().all(|&tile| usize::from(tile) < self.tiles)
            && self.first_fault(field).is_none()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn field(rows: &[&str]) -> Field {
        let text = rows.concat();
        let cells = text.bytes().map(|b| if b == b'?' { FREE } else { b - b'0' });
        Field::new(rows[0].len(), rows.len(), cells.collect()).unwrap()
    }

    #[test]
    fn runs_are_found_in_both_directions_and_across_seams() {
        let free = Rule::uniform((4, 3), 2, Edges::Free, Some(2), Some(2)).unwrap();
        assert!(free.accepts(&field(&["0110", "1001", "0110"])));
        let fault = free.first_fault(&field(&["0111", "1001", "0110"])).unwrap();
        assert_eq!((fault.row, fault.column, fault.length, fault.line), (0, 3, 3, "row"));
        let fault = free.first_fault(&field(&["0101", "1001", "0011"])).unwrap();
        assert_eq!((fault.row, fault.column, fault.line, fault.set), (2, 3, "column", vec![1]));
        let torus = Rule::uniform((5, 3), 2, Edges::Torus, Some(2), Some(2)).unwrap();
        let fault = torus.first_fault(&field(&["00110", "11001", "01101"])).unwrap();
        assert_eq!((fault.row, fault.column), (0, 1));
        assert!(free.first_fault(&field(&["0?11", "????", "0110"])).is_none());
    }

    #[test]
    fn a_line_without_end_of_one_tile_breaks_every_limit() {
        let rule = Rule::uniform((3, 1), 2, Edges::Cylinder, Some(9), None).unwrap();
        assert_eq!(rule.windows().count(), 2);
        assert!(!rule.accepts(&field(&["111"])));
        assert!(rule.accepts(&field(&["110"])));
        let free = Rule::uniform((3, 1), 2, Edges::Free, Some(9), None).unwrap();
        assert!(free.accepts(&field(&["111"])));
    }

    #[test]
    fn maps_count_where_a_run_ends() {
        let limit = Limit::Map(vec![1, 1, u32::MAX, 1]);
        let condition = Condition { set: 1, direction: Direction::Horizontal, limit };
        let rule = Rule::new((4, 1), 2, Edges::Free, vec![condition]).unwrap();
        assert!(rule.accepts(&field(&["1001"])));
        assert!(!rule.accepts(&field(&["0011"])));
        assert!(!rule.accepts(&field(&["1000"])));
    }
}

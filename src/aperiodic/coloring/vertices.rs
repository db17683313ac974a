//! What is colored: the vertices of a Wang tiling, by the pattern of tiles around them.
//!
//! Vertices with the same pattern are one *class*, and get one color. Every cell has four of
//! them, every side two; only different ones are kept. They are read off the windows with one row
//! and one column more than the pattern, which show a cell with all that its vertices see.

use std::collections::{BTreeMap, BTreeSet};

/// The classes of vertices, and where they meet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Vertices {
    /// Rows and columns of the pattern around a vertex.
    pub shape: [usize; 2],
    /// The patterns, sorted; their places are the numbers of the classes.
    pub patterns: Vec<Vec<usize>>,
    /// The Wang tiles [N, E, S, W].
    pub wang: Vec<[u32; 4]>,
    /// Cells: the classes NW, NE, SE, SW and the Wang tile.
    pub cells: Vec<([usize; 4], usize)>,
}

/// What cannot be colored.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum VerticesError {
    /// A vertex must see the four tiles that it belongs to.
    #[error("a window of {0}x{1} tiles: expected at least 2x2, for a vertex touches four tiles")]
    Small(usize, usize),
    /// There are no windows.
    #[error("there is no window of {0}x{1} tiles")]
    None(usize, usize),
}

/// Rows above a vertex and columns to its left, in a pattern of these rows and columns.
pub fn north_west([rows, columns]: [usize; 2]) -> [usize; 2] {
    [rows / 2, columns / 2]
}

/// The tiles around the vertex a step to the south and to the east within a window.
pub fn around(
    window: &[usize],
    [rows, columns]: [usize; 2],
    down: usize,
    right: usize,
) -> Vec<usize> {
    let width = columns + 1;
    let row = |row: usize| &window[row * width + right..row * width + right + columns];
    (down..down + rows).flat_map(row).copied().collect()
}

/// The vertices of a cell, NW, NE, SE, SW, as steps to the south and to the east.
pub const CORNERS: [(usize, usize); 4] = [(0, 0), (0, 1), (1, 1), (1, 0)];

impl Vertices {
    /// The vertices of tilings by `wang` whose windows of one row and one column more than
    /// `shape` are given.
    ///
    /// # Errors
    /// A pattern that is too small, no windows.
    pub fn new(
        wang: Vec<[u32; 4]>,
        shape: [usize; 2],
        windows: &BTreeSet<Vec<usize>>,
    ) -> Result<Self, VerticesError> {
        let [rows, columns] = shape;
        if rows < 2 || columns < 2 {
            return Err(VerticesError::Small(rows, columns));
        }
        if windows.is_empty() {
            return Err(VerticesError::None(rows + 1, columns + 1));
        }
        let [above, left] = north_west(shape);
        let middle = above * (columns + 1) + left;
        let seen =
            |window: &Vec<usize>| CORNERS.map(|(down, right)| around(window, shape, down, right));
        let patterns: BTreeSet<Vec<usize>> = windows.iter().flat_map(seen).collect();
        let patterns: Vec<Vec<usize>> = patterns.into_iter().collect();
        let number: BTreeMap<&Vec<usize>, usize> =
            patterns.iter().enumerate().map(|(class, pattern)| (pattern, class)).collect();
        let cells: BTreeSet<([usize; 4], usize)> = windows
            .iter()
            .map(|window| (seen(window).each_ref().map(|pattern| number[pattern]), window[middle]))
            .collect();
        let cells = cells.into_iter().collect();
        Ok(Self { shape, wang, cells, patterns })
    }

    /// The classes at the ends of a side N, E, S, W of a cell, from the west or the north on.
    pub fn ends([nw, ne, se, sw]: [usize; 4], side: usize) -> [usize; 2] {
        [[nw, ne], [ne, se], [sw, se], [nw, sw]][side % 4]
    }

    /// The sides of cells: whether one runs west to east, the classes at its ends, its label.
    pub fn sides(&self) -> BTreeSet<(bool, [usize; 2], u32)> {
        let of_cell = |&(classes, wang): &([usize; 4], usize)| {
            (0..4).map(move |side| (side % 2 == 0, Self::ends(classes, side), (wang, side)))
        };
        let sides = self.cells.iter().flat_map(of_cell);
        sides.map(|(flat, ends, (wang, side))| (flat, ends, self.wang[wang][side])).collect()
    }
}

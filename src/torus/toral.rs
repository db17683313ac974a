//! A set of corner tiles with its reasons: how the tilings by another set are coded on a torus,
//! and how their vertices are colored.
//!
//! Plain numbers as a file has them, nothing checked. A number `a + b phi` of the golden ratio
//! phi is `[a, b]`, a point of the plane `[a, b, c, d]`: `(a + b phi, c + d phi)`.
//!
//! The torus is the plane modulo a lattice. Step (x, y) of a tiling adds (x, y) to a point of it,
//! and the tile there is the label of the piece in which the point lies. A *window* is a pattern
//! of tiles, row by row from the north, and the points at its south-west cell that give it.
//!
//! Source of the coding: Labbé 2019, arXiv:1903.06137.

/// A point of the plane, with coordinates `a + b phi` and `c + d phi`.
pub type ToralPoint = [i64; 4];

/// A polygon of the partition and its label, the number of a Wang tile.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ToralPiece {
    /// The Wang tile.
    pub label: usize,
    /// The polygon, convex and counter-clockwise.
    pub polygon: Vec<ToralPoint>,
}

/// A rule that gives a vertex of a Wang tiling a color by the tiles around it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct VertexRule {
    /// Rows of tiles that it looks at to the north of the vertex.
    pub above: usize,
    /// Rows to the south.
    pub below: usize,
    /// Columns to the west.
    pub left: usize,
    /// Columns to the east.
    pub right: usize,
    /// Tiles, row by row from the north, and the color.
    pub table: Vec<(Vec<usize>, u32)>,
}

/// A pattern that occurs in the coded tilings.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ToralWindow {
    /// The Wang tiles, row by row from the north.
    pub labels: Vec<usize>,
    /// The points at its south-west cell.
    pub polygon: Vec<ToralPoint>,
    /// For each cell `[k, m, n]`: the polygon, moved to that cell, lies in piece `k` moved by
    /// `m` times the first vector of the lattice and `n` times the second.
    pub pieces: Vec<[i64; 3]>,
}

/// Everything that shows that a set of corner tiles fills the plane, and how each of its tilings
/// gives one by the Wang tiles.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ToralCertificate {
    /// What it is called. Says nothing.
    pub title: String,
    /// The two vectors of the lattice.
    pub lattice: [ToralPoint; 2],
    /// Width and height of the rectangle that the partition is of.
    pub domain: ToralPoint,
    /// The Wang tiles [N, E, S, W].
    pub wang: Vec<[u32; 4]>,
    /// The same before labels were merged; may be empty.
    pub wang_unmerged: Vec<[u32; 4]>,
    /// The partition.
    pub partition: Vec<ToralPiece>,
    /// The colors of vertices.
    pub rule: VertexRule,
    /// The corner tiles [NW, NE, SE, SW].
    pub tiles: Vec<[u32; 4]>,
    /// For each of them the Wang tiles whose vertices it has somewhere.
    pub image: Vec<Vec<usize>>,
    /// For each of them the Wang tiles whose labels all occur at its pairs of colors.
    pub options: Vec<Vec<usize>>,
    /// Rows and columns of the windows.
    pub window_shape: [usize; 2],
    /// The windows.
    pub windows: Vec<ToralWindow>,
}

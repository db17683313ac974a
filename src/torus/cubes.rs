//! Cubes that fill a torus in space.
//!
//! A *corner cube* has a color on each of its eight corners, a *Wang cube* one on each of its six
//! faces. Seen from above a cube is a tile, so its number begins with that of a tile:
//!
//! * corner cube: the number of the corner tile of its lower face, times `C^4`, plus that of its
//!   upper face;
//! * Wang cube: the number of the Wang tile of its four sides, times `CZ^2`, plus
//!   `bottom * CZ + top`. North and south have `CH` colors, east and west `CV`, bottom and top
//!   `CZ`.
//!
//! Layers count from the bottom, in each rows from the north and columns from the west.

use std::fmt;

/// The most cubes of a packing that is read or written: 256 MiB of numbers.
pub const MAX_CUBES: u64 = 1 << 26;

/// What carries the colors of a cube.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CubeKind {
    /// Its corners.
    Corner,
    /// Its faces.
    Wang,
}

impl CubeKind {
    /// `corner-cube` or `wang-cube`.
    pub fn name(self) -> &'static str {
        match self {
            CubeKind::Corner => "corner-cube",
            CubeKind::Wang => "wang-cube",
        }
    }
}

impl fmt::Display for CubeKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// All cubes of a kind over some colors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CubeSet {
    /// What carries the colors.
    pub kind: CubeKind,
    /// `CH`, `CV` and `CZ`; three times the same number for corner cubes.
    pub colors: [u8; 3],
}

impl CubeSet {
    /// All cubes over these colors, each number at least 1; `None` when there are more than
    /// [`MAX_CUBES`], or when corner cubes are to have several palettes.
    pub fn new(kind: CubeKind, colors: [u8; 3]) -> Option<Self> {
        let [h, v, z] = colors;
        let set = Self { kind, colors };
        let one = kind == CubeKind::Wang || (h == v && v == z);
        let size = set.size()?;
        (one && size > 0 && size <= MAX_CUBES).then_some(set)
    }

    /// The number of cubes, unless it is beyond all bounds.
    fn size(self) -> Option<u64> {
        let [h, v, z] = self.colors.map(u64::from);
        match self.kind {
            CubeKind::Corner => h.checked_pow(8),
            CubeKind::Wang => Some((h * v * z).pow(2)),
        }
    }

    /// The number of cubes.
    pub fn cubes(self) -> u64 {
        self.size().unwrap_or(u64::MAX)
    }

    /// The one number of colors; `None` when palettes differ.
    pub fn single(self) -> Option<u8> {
        let [h, v, z] = self.colors;
        (h == v && v == z).then_some(h)
    }
}

/// Cubes on a torus in space. Nothing says that they fit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cubes {
    /// What they are to be, each once.
    pub set: CubeSet,
    /// Numbers of layers, rows and columns.
    pub sides: [usize; 3],
    /// The numbers of the cubes, layer by layer, row by row.
    pub cubes: Vec<u32>,
}

impl Cubes {
    /// The packing of corner cubes that the colors of the points of the torus make: each point
    /// is the lower north-west corner of its cube.
    pub fn of_points(set: CubeSet, sides: [usize; 3], color: impl Fn([usize; 3]) -> u8) -> Self {
        let [layers, rows, columns] = sides;
        let radix = u32::from(set.colors[0]);
        let around = |[l, r, c]: [usize; 3]| [l % layers, r % rows, c % columns];
        let face = |[l, r, c]: [usize; 3]| {
            // NE, SE, SW, NW.
            [[l, r, c + 1], [l, r + 1, c + 1], [l, r + 1, c], [l, r, c]]
        };
        let cube = |[l, r, c]: [usize; 3]| {
            let corners = face([l, r, c]).into_iter().chain(face([l + 1, r, c]));
            corners.fold(0, |number, at| number * radix + u32::from(color(around(at))))
        };
        Self { set, sides, cubes: places(sides).map(cube).collect() }
    }

    /// The layers, each a list of rows one after the other.
    pub fn layers(&self) -> impl Iterator<Item = &[u32]> {
        self.cubes.chunks(self.sides[1] * self.sides[2])
    }
}

/// Layer, row and column of all cells, in order.
pub fn places([layers, rows, columns]: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
    (0..layers * rows * columns)
        .map(move |i| [i / (rows * columns), i / columns % rows, i % columns])
}

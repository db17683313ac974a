//! All corner cubes over `C` colors (a color on each of eight corners) on a torus in space.
//!
//! Let `A` be a square torus of all corner tiles, `n = C^2` a side. Layer `l` of `C^4` is `A`
//! shifted by `(X(l), Y(l))`, and from layer `l` to the next the shift changes by
//! `(l div n, l mod n)`. *Why every cube occurs once:* its lower and its upper face each say
//! where in `A` they are, the difference of the places says `l`, and then the lower face says
//! row and column. *Why the layers close:* each of `0 … n-1` is added `n` times to `X` and to
//! `Y`, and that is a multiple of `n`. The torus is `C^2 x C^2 x C^4`.

use super::Seed;
use super::corner::{CornerTorus, Plan, Window};

/// The stack of shifted copies of a square torus.
#[derive(Debug, Clone)]
pub struct CubeStack {
    torus: CornerTorus,
    /// The rows of the torus, one after the other.
    cells: Vec<u8>,
    side: usize,
}

impl CubeStack {
    /// The stack over the closed form, or over a member of its family; `None` without colors.
    /// It holds `colors^4` bytes.
    pub fn new(colors: usize, seed: Option<&mut Seed>) -> Option<Self> {
        let side = colors * colors;
        let torus = Plan::search(colors, side, side)?.build(seed);
        let mut cells = vec![0; side * side];
        for (row, colors) in cells.chunks_exact_mut(side).enumerate() {
            torus.row(row, colors);
        }
        Some(Self { torus, cells, side })
    }

    /// Rows and columns of a layer.
    pub fn side(&self) -> usize {
        self.side
    }

    /// The number of layers.
    pub fn layers(&self) -> usize {
        self.side * self.side
    }

    /// The color at a row and column of a layer.
    pub fn color(&self, layer: usize, row: usize, column: usize) -> u8 {
        let (down, right) = self.shift(layer);
        self.cells[(row + down) % self.side * self.side + (column + right) % self.side]
    }

    /// Layer, row and column of the cube with these colors on its lower face, which lies in
    /// that layer, and on its upper face, which lies in the next.
    pub fn find(&self, lower: Window, upper: Window) -> (usize, usize, usize) {
        let n = self.side;
        let ((i, j), (i_above, j_above)) = (self.torus.find(lower), self.torus.find(upper));
        let layer = (i_above + n - i) % n * n + (j_above + n - j) % n;
        let (down, right) = self.shift(layer);
        (layer, (i + n - down) % n, (j + n - right) % n)
    }

    /// How far a layer is shifted, modulo `n`: the sums of `l div n` and `l mod n` over the
    /// layers below it.
    fn shift(&self, layer: usize) -> (usize, usize) {
        let n = self.side;
        let (q, r) = (layer / n, layer % n);
        let triangle = |x: usize| x * x.saturating_sub(1) / 2;
        (q * r % n, (q * triangle(n) + triangle(r)) % n)
    }
}

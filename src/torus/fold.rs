//! A torus folded by a symmetry: what is left to choose, and where its neighbors are.
//!
//! When a translation by `(dx, dy)` replaces every color by its image under a permutation, a
//! rectangle of the torus decides all of it. East of the rectangle lies the rectangle again with
//! its colors replaced; south of it too, and shifted besides. So it is a smaller torus with
//! twisted seams: its height is `gcd(dy, h)`, and its width generates the steps that the
//! translation takes along a row.
//!
//! Without a symmetry the rectangle is the whole torus and nothing is twisted.

use super::Shape;

/// The largest number of steps after which the translation must be back.
const MOST: usize = 1 << 16;

/// A torus under a translation joined with a permutation of the colors.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fold {
    shape: Shape,
    step: (usize, usize),
    width: usize,
    height: usize,
    powers: Vec<Vec<u8>>,
    /// Steps of the translation that lead east by the width.
    east: usize,
    /// Steps that lead south by the height, and the columns they lead east besides.
    south: usize,
    shift: usize,
}

impl Fold {
    /// The torus as it is, over a number of colors.
    pub fn none(shape: Shape, colors: usize) -> Self {
        let powers = vec![(0..=u8::MAX).take(colors).collect()];
        let (width, height) = (shape.width(), shape.height());
        Self { shape, step: (0, 0), width, height, powers, east: 0, south: 0, shift: 0 }
    }

    /// Folded so that `a[row + dy][column + dx] = images[a[row][column]]`; `None` when the colors
    /// are not back when the translation is, or `images` is no permutation.
    pub fn new(shape: Shape, (dx, dy): (usize, usize), images: &[u8]) -> Option<Self> {
        let (w, h) = (shape.width(), shape.height());
        let (dx, dy) = (dx % w, dy % h);
        let mut sorted = images.to_vec();
        sorted.sort_unstable();
        if !sorted.iter().map(|&color| usize::from(color)).eq(0..images.len()) {
            return None;
        }
        let (mut x, mut y) = (dx, dy);
        let mut powers = vec![(0..=u8::MAX).take(images.len()).collect::<Vec<u8>>()];
        let next = |last: &Vec<u8>| last.iter().map(|&c| images[usize::from(c)]).collect();
        while (x, y) != (0, 0) && powers.len() < MOST {
            powers.push(next(&powers[powers.len() - 1]));
            (x, y) = ((x + dx) % w, (y + dy) % h);
        }
        if next(&powers[powers.len() - 1]) != powers[0] {
            return None;
        }
        let height = gcd(dy, h);
        // After so many steps it leads along the row.
        let level = h / height;
        let width = gcd(level * dx % w, w);
        let steps = |wanted: &dyn Fn(usize) -> bool| (0..powers.len()).find(|&steps| wanted(steps));
        let east = steps(&|k| k % level == 0 && (k * dx) % w == width % w)?;
        let south = steps(&|k| (k * dy) % h == height % h)?;
        let shift = south * dx % w;
        Some(Self { shape, step: (dx, dy), width, height, powers, east, south, shift })
    }

    /// The same seen in the mirror that is the SW-NE diagonal: rows are columns, and both are
    /// numbered from the other end.
    pub fn turned(&self) -> Option<Self> {
        let (w, h) = (self.shape.width(), self.shape.height());
        let shape = Shape::new(h as u64, w as u64).ok()?;
        if self.powers.len() == 1 {
            return Some(Self::none(shape, self.powers[0].len()));
        }
        let (dx, dy) = self.step;
        Self::new(shape, ((h - dy) % h, (w - dx) % w), &self.powers[1])
    }

    /// Steps of the symmetry that lead east by the width, those that lead south by the height, and
    /// the columns that the latter lead east besides.
    pub fn seams(&self) -> (usize, usize, usize) {
        (self.east, self.south, self.shift)
    }

    /// The whole torus.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// Columns left to choose.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows left to choose.
    pub fn height(&self) -> usize {
        self.height
    }

    /// Cells left to choose.
    pub fn cells(&self) -> usize {
        self.width * self.height
    }

    /// The images of the colors after 0, 1, ... steps; as many as an orbit has cells.
    pub fn powers(&self) -> &[Vec<u8>] {
        &self.powers
    }

    /// The symmetry as `DX,DY:` and the images of all colors; `None` without one.
    pub fn notation(&self) -> Option<String> {
        let images: Vec<String> = self.powers.get(1)?.iter().map(u8::to_string).collect();
        Some(format!("{},{}:{}", self.step.0, self.step.1, images.join(",")))
    }

    /// The cell of the rectangle that decides a cell of the plane, and the steps from it.
    pub fn locate(&self, row: usize, column: usize) -> (usize, usize) {
        let w = self.shape.width();
        let (down, row) = (row / self.height, row % self.height);
        let back = down * self.shift % w;
        let column = (column % w + w - back) % w;
        let (along, column) = (column / self.width, column % self.width);
        let steps = (down * self.south + along * self.east) % self.powers.len();
        (row * self.width + column, steps)
    }

    /// The color of a cell of the plane.
    pub fn color(&self, cells: &[u8], row: usize, column: usize) -> u8 {
        let (cell, steps) = self.locate(row, column);
        self.powers[steps][usize::from(cells[cell])]
    }

    /// All cells of the torus, row by row.
    pub fn unfold(&self, cells: &[u8]) -> Vec<u8> {
        let w = self.shape.width();
        (0..self.shape.cells()).map(|i| self.color(cells, i / w, i % w)).collect()
    }
}

/// The greatest common divisor; `gcd(0, n) = n`.
fn gcd(a: usize, b: usize) -> usize {
    if a == 0 { b } else { gcd(b % a, a) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every translation of small tori, with the cyclic shift of as many colors as it has order.
    #[test]
    fn folded_tori_have_the_symmetry() {
        let mut folds = 0;
        for (w, h) in [(6, 4), (4, 6), (5, 3), (8, 8), (1, 6), (9, 1), (12, 6)] {
            let shape = Shape::new(w as u64, h as u64).unwrap();
            for (dx, dy) in (0..w).flat_map(|dx| (0..h).map(move |dy| (dx, dy))) {
                let order = (1..).find(|k| k * dx % w == 0 && k * dy % h == 0).unwrap();
                let images: Vec<u8> = (0..order).map(|c| ((c + 1) % order) as u8).collect();
                let fold = Fold::new(shape, (dx, dy), &images).unwrap();
                assert_eq!(fold.cells() * order, w * h, "{fold:?}");
                let cells: Vec<u8> = (0..fold.cells()).map(|i| (i % order) as u8).collect();
                let all = fold.unfold(&cells);
                for (row, column) in (0..h).flat_map(|row| (0..w).map(move |c| (row, c))) {
                    let there = all[(row + dy) % h * w + (column + dx) % w];
                    assert_eq!(there, images[usize::from(all[row * w + column])], "{fold:?}");
                }
                assert_eq!(fold.turned().unwrap().turned().unwrap(), fold);
                folds += 1;
            }
        }
        assert!(folds > 200);
    }

    #[test]
    fn what_is_no_symmetry_is_refused() {
        let shape = Shape::new(6, 4).unwrap();
        assert_eq!(Fold::new(shape, (2, 0), &[1, 0]), None);
        assert_eq!(Fold::new(shape, (3, 0), &[0, 0]), None);
        assert!(Fold::new(shape, (3, 0), &[1, 0]).is_some());
        assert_eq!(Fold::new(shape, (0, 0), &[0, 1]), Some(Fold::none(shape, 2)));
    }
}

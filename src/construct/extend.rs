//! A larger torus of corner tiles from a smaller one: more colors, longer sides.
//!
//! `B` is a torus of `R x S` cells (rows, columns) with all windows over `C` colors. Its copies
//! fill `R k^m x S k^(4-m)` cells; copy `(u, v)`. A color is `C d + b`, where `b` is that of `B`
//! and `d` shows the `m` base-`k` digits of `u` and the `4-m` ones of `v`: there are four, as
//! there are classes of cells by the parities of row and column in a copy, and each class shows
//! one (`SLOTS`). An odd side would bring two cells of a class together at the seam, so its
//! last row (column) shows the sums of the digits of both classes instead.
//!
//! *Why every window occurs once:* its `b`s say where in a copy it begins; its `d`s are then an
//! invertible linear map of four digits modulo `k`. Where it reaches into the next copy, whose
//! digits are those of `u + 1`, the carry is one of at most four, and only one of them is right.
//!
//! Checked by brute force for all shapes up to 12 colors (`tests/construct`).

use super::corner::{CornerTorus, Window};

/// A digit of the number of a copy: of `u` or `v`, and which, from the lowest.
type Digit = (Axis, usize);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Axis {
    U,
    V,
}
use Axis::{U, V};

/// For every `m` the digit that cells of a class show: (even, even), (even, odd), (odd, even),
/// (odd, odd) row and column.
const SLOTS: [[Digit; 4]; 5] = [
    [(V, 0), (V, 2), (V, 1), (V, 3)],
    [(V, 0), (V, 2), (V, 1), (U, 0)],
    [(V, 0), (U, 0), (U, 1), (V, 1)],
    [(U, 0), (U, 1), (U, 2), (V, 0)],
    [(U, 0), (U, 1), (U, 2), (U, 3)],
];

/// An extended torus.
#[derive(Debug, Clone)]
pub struct Extended {
    base: Box<CornerTorus>,
    k: usize,
    m: usize,
}

impl Extended {
    /// `base` with `k` times as many colors, rows times `k^m` and columns times `k^(4-m)`; `m`
    /// must be at most 4.
    pub fn new(base: CornerTorus, k: usize, m: usize) -> Self {
        Self { base: Box::new(base), k, m }
    }

    /// The torus that is extended.
    pub fn base(&self) -> &CornerTorus {
        &self.base
    }

    /// The number of colors.
    pub fn colors(&self) -> usize {
        self.base.colors() * self.k
    }

    /// Rows and columns.
    pub fn sides(&self) -> (usize, usize) {
        let (height, width) = self.base.sides();
        (height * self.copies(U), width * self.copies(V))
    }

    /// How many copies of the base stand along an axis.
    fn copies(&self, axis: Axis) -> usize {
        let digits = if axis == U { self.m } else { 4 - self.m };
        (0..digits).fold(1, |copies, _| copies * self.k)
    }

    /// The digits of all four classes for a copy.
    fn slots(&self, u: usize, v: usize) -> [usize; 4] {
        SLOTS[self.m].map(|(axis, place)| {
            let number = if axis == U { u } else { v };
            (0..place).fold(number, |rest, _| rest / self.k) % self.k
        })
    }

    /// Writes the colors of a row.
    pub fn row(&self, row: usize, colors: &mut [u8]) {
        let (height, width) = self.base.sides();
        let (u, r) = (row / height, row % height);
        let mut below = vec![0; width];
        self.base.row(r, &mut below);
        let rows = classes(r, height);
        let factor = self.base.colors();
        for (v, copy) in colors.chunks_exact_mut(width).enumerate() {
            let slots = self.slots(u, v);
            let digit =
                |class: usize| rows.iter().map(|&row| slots[2 * row + class]).sum::<usize>();
            let (even, odd) = (digit(0), digit(1));
            let raise = |digits: usize| (digits % self.k * factor) as u8;
            let raises = [raise(even), raise(odd)];
            for (c, (color, &low)) in copy.iter_mut().zip(&below).enumerate() {
                *color = low + raises[c % 2];
            }
            if !width.is_multiple_of(2) {
                copy[width - 1] = below[width - 1] + raise(even + odd);
            }
        }
    }

    /// The row and column of a window.
    pub fn find(&self, window: Window) -> (usize, usize) {
        let factor = self.base.colors();
        let low = window.map(|pair| pair.map(|color| (usize::from(color) % factor) as u8));
        let high = window.map(|pair| pair.map(|color| usize::from(color) / factor));
        let (r, c) = self.base.find(low);
        let (height, width) = self.base.sides();
        let (rows, columns) = ([r, (r + 1) % height], [c, (c + 1) % width]);
        // How many of the digits change from one copy to the next, where the next shows.
        let carries =
            |wraps: bool, digits: usize| if wraps && digits > 0 { 1..=digits } else { 0..=0 };
        for down in carries(r + 1 == height, self.m) {
            for right in carries(c + 1 == width, 4 - self.m) {
                let (u, v) = self.solve(&high, rows, columns, down, right);
                let next_u = if rows[1] == 0 { (u + 1) % self.copies(U) } else { u };
                let next_v = if columns[1] == 0 { (v + 1) % self.copies(V) } else { v };
                let shown = |i: usize, j: usize| {
                    let slots = self.slots([u, next_u][i], [v, next_v][j]);
                    let parts = products(classes(rows[i], height), classes(columns[j], width));
                    parts.map(|class| slots[class]).sum::<usize>() % self.k
                };
                if (0..4).all(|at| shown(at / 2, at % 2) == high[at / 2][at % 2]) {
                    return (u * height + r, v * width + c);
                }
            }
        }
        // Not reached: one of the carries is right.
        (r, c)
    }

    /// The copy of the upper left cell, if `down` digits of `u` and `right` digits of `v` are
    /// one more in the next copy.
    fn solve(
        &self,
        high: &[[usize; 2]; 2],
        rows: [usize; 2],
        columns: [usize; 2],
        down: usize,
        right: usize,
    ) -> (usize, usize) {
        let (k, (height, width)) = (self.k, self.base.sides());
        let minus = |a: usize, b: usize| (a + k - b % k) % k;
        // The digits shown, less what the carry adds to them.
        let mut shown = *high;
        for (i, pair) in shown.iter_mut().enumerate() {
            for (j, digit) in pair.iter_mut().enumerate() {
                let parts = products(classes(rows[i], height), classes(columns[j], width));
                let more = parts.filter(|&class| match SLOTS[self.m][class] {
                    (U, place) => i == 1 && place < down,
                    (V, place) => j == 1 && place < right,
                });
                *digit = minus(*digit, more.count());
            }
        }
        // Rows first: from what the two rows of the window show to the two classes of rows.
        let [left, right] = [0, 1].map(|j| {
            separate(
                classes(rows[0], height),
                classes(rows[1], height),
                [shown[0][j], shown[1][j]],
                minus,
            )
        });
        let both = [0, 1].map(|class| {
            separate(
                classes(columns[0], width),
                classes(columns[1], width),
                [left[class], right[class]],
                minus,
            )
        });
        let (mut u, mut v) = (0, 0);
        for (class, (axis, place)) in SLOTS[self.m].into_iter().enumerate() {
            let value = (0..place).fold(both[class / 2][class % 2], |value, _| value * k);
            *(if axis == U { &mut u } else { &mut v }) += value;
        }
        (u, v)
    }
}

/// The classes of lines whose digits a line shows: its parity; both for the last of an odd number.
fn classes(line: usize, lines: usize) -> &'static [usize] {
    match line % 2 {
        0 if line + 1 == lines => &[0, 1],
        0 => &[0],
        _ => &[1],
    }
}

/// The classes of cells for classes of rows and columns.
fn products(rows: &'static [usize], columns: &'static [usize]) -> impl Iterator<Item = usize> {
    rows.iter().flat_map(move |row| columns.iter().map(move |column| 2 * row + column))
}

/// The digits of the even and the odd class, from those that two neighboring lines show.
fn separate(
    first: &[usize],
    second: &[usize],
    shown: [usize; 2],
    minus: impl Fn(usize, usize) -> usize,
) -> [usize; 2] {
    match (first, second) {
        ([0], [1]) => shown,
        ([1], [0]) => [shown[1], shown[0]],
        ([0, 1], [0]) => [shown[1], minus(shown[0], shown[1])],
        // The odd class before the last line, which shows both.
        _ => [minus(shown[1], shown[0]), shown[0]],
    }
}

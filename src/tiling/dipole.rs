//! The filling that is proved: a square of side `4K`, `K = C - 1`, has bits with any sums modulo `C`.
//!
//! Halve rows and columns, `a` and `b`. In the quadrants (a, a) and (b, b) dominoes stand upright:
//! in the first `K` columns of a quadrant they cover rows 0 and 1, 2 and 3, ..., in the others rows
//! 1 and 2, 3 and 4, .... A domino holds one 1, so it never changes the sum of its column; and `t` of
//! the `K` dominoes between two rows turned over move `t` units from the one to the other, any number
//! modulo `C`. In (a, b) and (b, a) dominoes lie, and do the same for columns. The `2K` cells of a
//! quadrant that no domino covers are free. Those of (a, b) make the total of the rows `a` right, those
//! of (b, a) that of the columns `a`, those of (b, b) that of the rows `b`; then that of the columns `b`
//! is right, too. Last, rows within `a` and within `b`, and columns likewise, exchange units along
//! the dominoes between them.

use super::draws::Draws;
use super::fill::Fill;

/// Fills the last square of side `4 (C - 1)`; the lines before have their sums.
pub(super) fn dipoles(fill: &mut Fill<'_>, draws: &mut Draws) {
    let units = fill.colors - 1;
    let half = 2 * units;
    let begin = fill.square.side - 2 * half;
    let quadrants =
        [[begin, begin], [begin, begin + half], [begin + half, begin], [begin + half; 2]];
    // Dominoes, and free cells at random.
    for (which, &origin) in quadrants.iter().enumerate() {
        let quadrant = Quadrant { origin, upright: which == 0 || which == 3, units };
        quadrant.lay(fill, draws);
    }
    let quadrant = |which: usize| Quadrant {
        origin: quadrants[which],
        upright: which == 0 || which == 3,
        units,
    };
    // Totals: rows a by (a, b), columns a by (b, a), rows b by (b, b).
    for (which, axis, from) in [(1, 0, begin), (2, 1, begin), (3, 0, begin + half)] {
        quadrant(which).clear(fill);
        let side = fill.square.side;
        let lacking: usize = (from..from + half).map(|line| fill.lacking(axis, line, side)).sum();
        quadrant(which).place(fill, lacking % fill.colors, draws);
    }
    // Lines: rows a and b by the upright dominoes, columns a and b by those that lie.
    for which in [0, 3, 2, 1] {
        quadrant(which).exchange(fill, draws);
    }
}

/// A quadrant, whose lines are rows where dominoes stand upright, else columns.
struct Quadrant {
    /// The first row and column.
    origin: [usize; 2],
    upright: bool,
    units: usize,
}

impl Quadrant {
    fn axis(&self) -> usize {
        usize::from(!self.upright)
    }

    /// A cell by its line, across the dominoes, and its place there.
    fn cell<'a>(&self, fill: &'a mut Fill<'_>, line: usize, place: usize) -> &'a mut u8 {
        let axis = self.axis();
        fill.at(axis, self.origin[axis] + line, self.origin[1 - axis] + place)
    }

    /// The places of the dominoes between a line and the next.
    fn places(&self, line: usize) -> std::ops::Range<usize> {
        if line.is_multiple_of(2) { 0..self.units } else { self.units..2 * self.units }
    }

    /// The cells without domino: line and place.
    fn free(&self) -> Vec<(usize, usize)> {
        let places = self.units..2 * self.units;
        places.flat_map(|place| [(0, place), (2 * self.units - 1, place)]).collect()
    }

    /// Dominoes whose 1 is in the first line, and random free cells.
    fn lay(&self, fill: &mut Fill<'_>, draws: &mut Draws) {
        for line in 0..2 * self.units - 1 {
            for place in self.places(line) {
                *self.cell(fill, line, place) = 1;
                *self.cell(fill, line + 1, place) = 0;
            }
        }
        for (line, place) in self.free() {
            *self.cell(fill, line, place) = (draws.bits() >> 31) as u8;
        }
    }

    fn clear(&self, fill: &mut Fill<'_>) {
        for (line, place) in self.free() {
            *self.cell(fill, line, place) = 0;
        }
    }

    /// Sets so many free cells.
    fn place(&self, fill: &mut Fill<'_>, count: usize, draws: &mut Draws) {
        let mut free = self.free();
        draws.shuffle(&mut free);
        for &(line, place) in &free[..count] {
            *self.cell(fill, line, place) = 1;
        }
    }

    /// Turns dominoes over until every line has its sum: the last one follows.
    fn exchange(&self, fill: &mut Fill<'_>, draws: &mut Draws) {
        let (axis, side, colors) = (self.axis(), fill.square.side, fill.colors);
        for line in 0..2 * self.units - 1 {
            let lacking = fill.lacking(axis, self.origin[axis] + line, side);
            let mut places: Vec<usize> = self.places(line).collect();
            draws.shuffle(&mut places);
            // One unit less here, one more in the next line, for each domino turned over.
            for &place in &places[..(colors - lacking) % colors] {
                *self.cell(fill, line, place) = 0;
                *self.cell(fill, line + 1, place) = 1;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tiling::fill::Square;

    /// Any sums with one total, for many numbers of colors, also with strips around.
    #[test]
    fn any_sums_are_filled() {
        for colors in 2..=12 {
            for (more, seed) in (0..40).flat_map(|seed| [(0, seed), (3, seed)]) {
                let side = 4 * (colors - 1) + more;
                let mut draws = Draws::new(seed);
                // Extreme sums as well as random ones.
                let mut line = |which: u32| -> Vec<usize> {
                    (0..side)
                        .map(|_| match (seed + which) % 4 {
                            0 => 0,
                            1 => colors - 1,
                            _ => draws.below(colors),
                        })
                        .collect()
                };
                let (rows, mut columns) = (line(0), line(seed / 4));
                let [a, b] = [&rows, &columns].map(|sums| sums.iter().sum::<usize>());
                columns[0] = (columns[0] + a + colors * side - b % colors) % colors;
                let bits = (0..side * side).map(|_| (draws.bits() >> 31) as u8).collect();
                let square = Square { side, bits };
                let mut fill = Fill { colors, square, sums: [&rows, &columns] };
                fill.strips(4 * (colors - 1), &mut draws);
                dipoles(&mut fill, &mut draws);
                for axis in [0, 1] {
                    for at in 0..side {
                        assert_eq!(fill.lacking(axis, at, side), 0, "{colors} colors, side {side}");
                    }
                }
            }
        }
    }
}

//! Squares of bits whose rows and columns have prescribed sums modulo `C`.
//!
//! What [`super::frame`] needs for every block: given the sums `r` of the rows and `c` of the columns of
//! a `B` x `B` square modulo `C`, with the same total, bits that have them; as random as may be.
//!
//! [`filled`]: all cells but a square of `M = 2C` in the last corner are random; in each row beside it
//! `C - 1` cells among the last `M`, and in each column above it likewise, are set so that the line
//! has its sum. For the square, whose sums then follow, real sums are chosen near half its side with
//! equal totals (*lifted*), and filled row by row, the largest demand first, which succeeds when
//! anything does (Gale 1957, Ryser 1957). The lift has been found for every input up to `C = 6`, by
//! exhaustion, and for all of millions of inputs above; what is proved for every `C` is [`dipoles`],
//! which steps in if none is found. Half of all squares, by a last coin, are the complement of a filling
//! of `B - r`, `B - c`: so each bit is fair.

use super::dipole::dipoles;
use super::draws::Draws;

/// A square of bits, row by row from the south.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Square {
    /// Cells of a side.
    pub side: usize,
    /// 0 or 1.
    pub bits: Vec<u8>,
}

/// Bits, and the sums modulo `C` that rows and columns must have.
#[derive(Debug)]
pub(super) struct Fill<'a> {
    pub(super) colors: usize,
    pub(super) square: Square,
    /// Of rows, then of columns.
    pub(super) sums: [&'a [usize]; 2],
}

impl Fill<'_> {
    /// A cell, by its line of an axis (0: rows, 1: columns) and its place there.
    pub(super) fn at(&mut self, axis: usize, line: usize, place: usize) -> &mut u8 {
        let side = self.square.side;
        &mut self.square.bits[if axis == 0 { line * side + place } else { place * side + line }]
    }

    /// What a line lacks, modulo the colors, when the cells in it from `from` on do not count.
    pub(super) fn lacking(&self, axis: usize, line: usize, from: usize) -> usize {
        let side = self.square.side;
        let bit = |place: usize| {
            self.square.bits[if axis == 0 { line * side + place } else { place * side + line }]
        };
        let there: usize = (0..from).map(|place| usize::from(bit(place))).sum();
        (self.sums[axis][line] + self.colors * side - there) % self.colors
    }

    /// Sets cells of the lines before the last `last` ones so that each has its sum: `C - 1` cells
    /// among the last `last` of the line.
    pub(super) fn strips(&mut self, last: usize, draws: &mut Draws) {
        let (side, free) = (self.square.side, self.colors - 1);
        let begin = side - last;
        for axis in [0, 1] {
            for line in 0..begin {
                let offset = draws.below(last);
                let mut places: Vec<usize> =
                    (0..free).map(|at| begin + (offset + at) % last).collect();
                for &place in &places {
                    *self.at(axis, line, place) = 0;
                }
                let lacking = self.lacking(axis, line, side);
                draws.shuffle(&mut places);
                for &place in &places[..lacking] {
                    *self.at(axis, line, place) = 1;
                }
            }
        }
    }
}

/// The least side of a square that [`filled`] fills whatever the sums are.
pub fn least_side(colors: usize) -> usize {
    (4 * (colors - 1)).max(2 * colors)
}

/// A square with these sums of rows and columns, both below `colors` with the same total modulo
/// `colors`; the side is at least [`least_side`].
pub fn filled(colors: usize, rows: &[usize], columns: &[usize], hash: u32) -> Square {
    let side = rows.len();
    let mut draws = Draws::new(hash);
    let complement = draws.bits() >> 31 == 1;
    let turned = |sums: &[usize]| -> Vec<usize> {
        let other = |sum: &usize| (side * colors + side - sum) % colors;
        if complement { sums.iter().map(other).collect() } else { sums.to_vec() }
    };
    let (rows, columns) = (turned(rows), turned(columns));
    let mut random = Vec::with_capacity(side * side);
    while random.len() < side * side {
        let (bits, left) = (draws.bits(), (side * side - random.len()).min(32));
        random.extend((0..left).map(|at| (bits >> at & 1) as u8));
    }
    let square = Square { side, bits: random };
    let mut fill = Fill { colors, square, sums: [&rows, &columns] };
    fill.strips(2 * colors, &mut draws);
    if !lifted(&mut fill, &mut draws) {
        fill.strips(4 * (colors - 1), &mut draws);
        dipoles(&mut fill, &mut draws);
    }
    if complement {
        fill.square.bits.iter_mut().for_each(|bit| *bit ^= 1);
    }
    fill.square
}

/// Fills the last square of side `2C`; whether real sums for it were found.
fn lifted(fill: &mut Fill<'_>, draws: &mut Draws) -> bool {
    let (colors, side) = (fill.colors, 2 * fill.colors);
    let begin = fill.square.side - side;
    let lacking = |fill: &Fill<'_>, axis: usize| -> Vec<usize> {
        (begin..fill.square.side).map(|line| fill.lacking(axis, line, begin)).collect()
    };
    let (rows, columns) = (lacking(fill, 0), lacking(fill, 1));
    let Some(bits) = lift(colors, &rows, &columns, draws) else { return false };
    for (at, bit) in bits.into_iter().enumerate() {
        *fill.at(0, begin + at / side, begin + at % side) = bit;
    }
    true
}

/// Bits of a square whose side is the number of sums, with these sums modulo `colors`, if the lift is
/// found; row by row.
pub(super) fn lift(
    colors: usize,
    rows: &[usize],
    columns: &[usize],
    draws: &mut Draws,
) -> Option<Vec<u8>> {
    let side = rows.len();
    let over = |sum: usize, base: usize| base + (sum + colors * side - base) % colors;
    let middle = (side + 1 - colors) / 2;
    let mut bases: Vec<usize> = (0..=side + 1 - colors).collect();
    bases.sort_by_key(|base| base.abs_diff(middle));
    for &base in &bases {
        let columns: Vec<usize> = columns.iter().map(|&sum| over(sum, base)).collect();
        let total: usize = columns.iter().sum();
        for &least in &bases {
            let mut lifted: Vec<usize> = rows.iter().map(|&sum| over(sum, least)).collect();
            let sum: usize = lifted.iter().sum();
            let mut raised: Vec<usize> = (0..side).filter(|&row| lifted[row] == least).collect();
            let Some(missing) = total.checked_sub(sum) else { continue };
            let count = missing / colors;
            if missing % colors != 0 || count > raised.len() {
                continue;
            }
            draws.shuffle(&mut raised);
            for &row in &raised[..count] {
                lifted[row] += colors;
            }
            if columns.iter().chain(&lifted).any(|&sum| sum > side) {
                continue;
            }
            if let Some(bits) = with_sums(&lifted, columns.clone(), draws) {
                return Some(bits);
            }
        }
    }
    None
}

/// Bits with exactly these sums of rows and columns, if there are any: row by row in random order,
/// ones where the largest demand is.
fn with_sums(rows: &[usize], mut demand: Vec<usize>, draws: &mut Draws) -> Option<Vec<u8>> {
    let side = rows.len();
    let mut bits = vec![0; side * side];
    let mut order: Vec<usize> = (0..side).collect();
    draws.shuffle(&mut order);
    for row in order {
        let mut places: Vec<usize> = (0..side).collect();
        draws.shuffle(&mut places);
        places.sort_by_key(|&place| std::cmp::Reverse(demand[place]));
        for &place in &places[..rows[row]] {
            demand[place] = demand[place].checked_sub(1)?;
            bits[row * side + place] = 1;
        }
    }
    demand.iter().all(|&left| left == 0).then_some(bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sums in order, for orders do not matter.
    fn multisets(colors: usize, length: usize) -> Vec<Vec<usize>> {
        let mut lists = vec![vec![]];
        for _ in 0..length {
            let longer = |list: &Vec<usize>| {
                let from = list.last().copied().unwrap_or(0);
                (from..colors).map(|next| [&list[..], &[next]].concat()).collect::<Vec<_>>()
            };
            lists = lists.iter().flat_map(longer).collect();
        }
        lists
    }

    /// The corner step never fails for few colors: every input, up to the order of its lines.
    #[test]
    fn every_small_corner_is_lifted() {
        for (colors, cases) in [(2, 13), (3, 262), (4, 6813)] {
            let lists = multisets(colors, 2 * colors);
            let mut tried = 0;
            for rows in &lists {
                let total: usize = rows.iter().sum();
                for columns in &lists {
                    if columns.iter().sum::<usize>() % colors != total % colors {
                        continue;
                    }
                    tried += 1;
                    let mut draws = Draws::new(tried);
                    let bits = lift(colors, rows, columns, &mut draws);
                    assert!(bits.is_some(), "{rows:?} {columns:?}");
                }
            }
            assert_eq!(tried, cases, "{colors} colors");
        }
    }
}

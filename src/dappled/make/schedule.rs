//! In which order cells are looked at.
//!
//! The paper goes from one anti-diagonal to the next: cell `(i, j)`, column and row, has weight
//! `i + j`. On its turn a cell may change itself, the cell before it in the row and the one above,
//! and the runs of the lines through them; it reads no more than that, and the cell between those
//! two. So what a cell does touches the columns `i - 1`, `i` and `i + 1` of three weights, and the
//! result depends only on the order of cells that touch the same.
//!
//! [`diagonal`] gives the result of increasing columns within a weight. A cell then needs, besides
//! lighter cells of its columns, `(i - 1, j + 1)` and `(i + 1, j - 2)`. In terms of `u = i + j` and
//! `v = 2i + j` all of these have no larger `u` and no larger `v`. So the plane may be cut along
//! both and taken block by block: a block fits into the cache, anti-diagonals do not.
//!
//! [`wavefront`] gives the result of even columns before odd ones within a weight. Two cells of one
//! step touch nothing in common, and a step reaches two columns further than the one before. So
//! blocks of columns that shrink by two columns a step are independent of each other; when they are
//! done, the gaps between them are.

use rayon::prelude::*;
use std::ops::Range;

/// What is done in a cell, given its column and row.
pub trait Step: Sync {
    /// Looks at a cell. `after` says whether the cells `(column - 1, row + 1)` and
    /// `(column + 1, row - 1)` of the same weight had their turn already.
    fn step(&self, column: usize, row: usize, after: (bool, bool));
}

/// Weights that are taken together.
const BAND: usize = 32;

/// Columns of a block of [`diagonal`].
const BLOCK: usize = 128;

/// Columns of a block of [`wavefront`]: more than twice what it shrinks by.
const FRONT: usize = 512;

/// The columns of the cells of a weight.
fn columns((width, height): (usize, usize), weight: usize) -> Range<usize> {
    (weight + 1).saturating_sub(height)..width.min(weight + 1)
}

/// By weight, columns in increasing order.
pub fn diagonal(size: (usize, usize), step: &impl Step) {
    let weights = size.0 + size.1 - 1;
    for band in (0..weights).step_by(BAND) {
        let band = band..(band + BAND).min(weights);
        let first = columns(size, band.start).start;
        let end = columns(size, band.end - 1).end + band.len();
        for block in (first..end).step_by(BLOCK) {
            for (shift, weight) in band.clone().enumerate() {
                let columns = columns(size, weight);
                // Cut along `2i + j`, which is the weight and `i`: a column less with each weight.
                let from = columns.start.max(block.saturating_sub(shift));
                let to = columns.end.min((block + BLOCK).saturating_sub(shift));
                for column in from..to {
                    step.step(column, weight - column, (true, false));
                }
            }
        }
    }
}

/// By weight, first all even columns, then all odd ones; on the threads of the current pool.
pub fn wavefront(size: (usize, usize), step: &impl Step) {
    let weights = size.0 + size.1 - 1;
    for band in (0..weights).step_by(BAND) {
        let band = band..(band + BAND).min(weights);
        let (first, end) = (columns(size, band.start).start, columns(size, band.end - 1).end);
        // The last block takes what is left over.
        let blocks = ((end - first) / FRONT).max(1);
        let border = |block: usize| first + block * FRONT;
        (0..blocks).into_par_iter().for_each(|block| {
            steps(size, &band, step, |shrunk| {
                let from = if block == 0 { 0 } else { border(block) + 1 + shrunk };
                let to = if block + 1 == blocks { end } else { border(block + 1) - 1 - shrunk };
                from..to
            });
        });
        (1..blocks).into_par_iter().for_each(|block| {
            steps(size, &band, step, |shrunk| {
                border(block) - 1 - shrunk..border(block) + 1 + shrunk
            });
        });
    }
}

/// All steps of a band, in the columns that `part` gives for what blocks have shrunk by.
fn steps(
    size: (usize, usize),
    band: &Range<usize>,
    step: &impl Step,
    part: impl Fn(usize) -> Range<usize>,
) {
    for weight in band.clone() {
        let columns = columns(size, weight);
        for odd in [0, 1] {
            let part = part(2 * (2 * (weight - band.start) + odd));
            let from = columns.start.max(part.start);
            let from = from + (from + odd) % 2;
            for column in (from..columns.end.min(part.end)).step_by(2) {
                step.step(column, weight - column, (odd == 1, odd == 1));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;

    /// The cells in the order in which they were looked at.
    struct Seen(Mutex<Vec<(usize, usize)>>);

    impl Step for Seen {
        fn step(&self, column: usize, row: usize, _: (bool, bool)) {
            self.0.lock().unwrap().push((column, row));
        }
    }

    /// All cells once, and those that touch the same columns of near weights in the order of `rank`.
    fn check<R: Ord>(size: (usize, usize), wave: bool, rank: impl Fn(usize, usize) -> R) {
        let seen = Seen(Mutex::new(Vec::new()));
        if wave {
            wavefront(size, &seen)
        } else {
            diagonal(size, &seen)
        }
        let seen = seen.0.into_inner().unwrap();
        let mut turn = vec![usize::MAX; size.0 * size.1];
        for (at, &(column, row)) in seen.iter().enumerate() {
            assert_eq!(turn[row * size.0 + column], usize::MAX, "twice: {column}, {row}");
            turn[row * size.0 + column] = at;
        }
        assert_eq!(seen.len(), size.0 * size.1);
        for &(i, j) in &seen {
            let near = if wave { 2 } else { 1 };
            for other in i.saturating_sub(near)..(i + near + 1).min(size.0) {
                for weight in (i + j).saturating_sub(2)..=i + j {
                    let Some(row) = weight.checked_sub(other).filter(|&row| row < size.1) else {
                        continue;
                    };
                    let before = turn[row * size.0 + other] < turn[j * size.0 + i];
                    let apart = weight == i + j && i.abs_diff(other) == 2 && wave;
                    assert!(
                        apart
                            || (other, row) == (i, j)
                            || before == (rank(other, row) < rank(i, j)),
                        "{other}, {row} and {i}, {j}"
                    );
                }
            }
        }
    }

    #[test]
    fn what_touches_the_same_keeps_its_order() {
        for size in [(1, 1), (1, 90), (90, 1), (7, 5), (300, 200), (50, 700), (1500, 70)] {
            check(size, false, |column, row| (column + row, column));
            check(size, true, |column, row| (column + row, column % 2, 0));
        }
    }
}

//! Many disjoint windows in a rectangle: each needs a tile of its own.
//!
//! Where every run of `a` cells in a row and of `b` cells in a column must hold some tile, a
//! rectangle holds at least as many of it as disjoint runs fit in. Rows of runs with columns in what
//! is left are one way to fit them in; four rectangles around a fifth, like the sails of a windmill,
//! another, and each of the five is filled in the better way.

/// A run of cells: where it begins, and whether it goes down a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Run {
    pub(super) column: usize,
    pub(super) row: usize,
    pub(super) down: bool,
}

/// How long runs are, in rows and in columns; none if there are none of them.
pub(super) type Lengths = [Option<usize>; 2];

/// Windmills within windmills at most, and larger rectangles do without.
const DEPTH: usize = 2;
const WINDMILL: usize = 64;

/// Disjoint runs in a rectangle, as many as are found.
pub(super) fn runs((width, height): (usize, usize), lengths: Lengths) -> Vec<Run> {
    let mut runs = Vec::new();
    place(&mut runs, (0, 0), (width, height), lengths, DEPTH);
    runs
}

/// The better of rows with columns in the rest, and columns with rows in the rest.
fn plain((width, height): (usize, usize), [a, b]: Lengths) -> (usize, bool) {
    let fit = |length: usize, run: Option<usize>| run.map_or(0, |run| length / run);
    let rest = |length: usize, run: Option<usize>| run.map_or(length, |run| length % run);
    let rows = height * fit(width, a) + rest(width, a) * fit(height, b);
    let columns = width * fit(height, b) + rest(height, b) * fit(width, a);
    (rows.max(columns), columns > rows)
}

/// The sails of a windmill and what is between them: corner and size of each.
fn windmill(
    (width, height): (usize, usize),
    (w, h): (usize, usize),
) -> [((usize, usize), (usize, usize)); 5] {
    let (v, g) = (width - w, height - h);
    [
        ((0, 0), (w, h)),
        ((w, 0), (v, g)),
        ((v, g), (w, h)),
        ((0, h), (v, g)),
        ((v, h), (w - v, g - h)),
    ]
}

/// The best number for a rectangle, and the windmill that gives it, if one does.
fn best(size: (usize, usize), lengths: Lengths, depth: usize) -> (usize, Option<(usize, usize)>) {
    let (width, height) = size;
    let (mut most, mut mill) = (plain(size, lengths).0, None);
    let shortest = lengths.into_iter().flatten().min().unwrap_or(usize::MAX);
    if depth == 0 || width.max(height) > WINDMILL {
        return (most, None);
    }
    for w in width.div_ceil(2)..width {
        for h in 1..=height / 2 {
            if most == width * height / shortest {
                return (most, mill);
            }
            let sails = windmill(size, (w, h));
            let number = sails.iter().map(|&(_, size)| best(size, lengths, depth - 1).0).sum();
            if number > most {
                (most, mill) = (number, Some((w, h)));
            }
        }
    }
    (most, mill)
}

fn place(
    runs: &mut Vec<Run>,
    (column, row): (usize, usize),
    size: (usize, usize),
    lengths: Lengths,
    depth: usize,
) {
    if let Some(sails) = best(size, lengths, depth).1.map(|at| windmill(size, at)) {
        for ((x, y), size) in sails {
            place(runs, (column + x, row + y), size, lengths, depth - 1);
        }
        return;
    }
    let (width, height) = size;
    let [a, b] = lengths;
    let columns_first = plain(size, lengths).1;
    let whole = |length: usize, run: Option<usize>| run.map_or(0, |run| length / run * run);
    // The columns that rows leave over, or all; the same for rows.
    let (from_column, from_row) = match columns_first {
        true => (0, whole(height, b)),
        false => (whole(width, a), 0),
    };
    for y in from_row..height {
        for x in (0..whole(width, a)).step_by(a.unwrap_or(1)) {
            runs.push(Run { column: column + x, row: row + y, down: false });
        }
    }
    for x in from_column..width {
        for y in (0..whole(height, b)).step_by(b.unwrap_or(1)) {
            runs.push(Run { column: column + x, row: row + y, down: true });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn runs_are_disjoint_and_many() {
        for (size, lengths, expected) in [
            ((8, 8), [Some(3), Some(3)], 21),
            ((16, 16), [Some(3), Some(3)], 85),
            ((32, 32), [Some(3), Some(3)], 341),
            ((5, 5), [Some(3), Some(3)], 8),
            ((4, 4), [Some(3), Some(3)], 5),
            ((2, 2), [Some(3), Some(3)], 0),
            ((7, 2), [Some(3), None], 4),
            ((7, 5), [Some(4), Some(2)], 15),
            ((1, 9), [None, None], 0),
        ] {
            let runs = runs(size, lengths);
            let mut cells = HashSet::new();
            for run in &runs {
                for i in 0..lengths[usize::from(run.down)].unwrap() {
                    let (x, y) = match run.down {
                        true => (run.column, run.row + i),
                        false => (run.column + i, run.row),
                    };
                    assert!(x < size.0 && y < size.1 && cells.insert((x, y)), "{size:?}");
                }
            }
            assert_eq!(runs.len(), expected, "{size:?} {lengths:?}");
        }
    }
}

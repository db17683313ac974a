//! The rows of a Latin square in ordered groups, each of whose products is a single cycle.
//!
//! The rows of a Latin square of order `C` are `C` permutations of the colors, no two of which
//! agree anywhere. They are to be divided into `l` groups of `m`, so that the permutations of a
//! group, one after the other, make a cycle through all colors.
//!
//! * Cyclic square, `x -> x + r`: the product of a group adds up its shifts, and is one cycle
//!   when the sum is coprime to `C`. The groups are repaired by swaps until all sums are.
//! * Random square: row by row a perfect matching of columns to the colors they have not had
//!   (there always is one: Hall 1935). Groups are drawn one by one; one draw in about `C` makes
//!   a cycle.
//!
//! Source: this project.

use rand::RngExt;
use rand::seq::SliceRandom;
use rand_pcg::Pcg64;

/// A permutation of the colors.
pub type Permutation = Vec<u8>;

/// Swaps tried on the cyclic square, for every row.
const SWAPS: usize = 200;
/// Random squares tried.
const SQUARES: usize = 60;
/// Draws tried for a group, for every color.
const DRAWS: usize = 20;

/// Divides the cyclic square into groups of `size`, or gives up.
pub fn cyclic(colors: usize, size: usize, rng: &mut Pcg64) -> Option<Vec<Vec<Permutation>>> {
    let mut rows: Vec<usize> = (0..colors).collect();
    rows.shuffle(rng);
    let fits = |rows: &[usize], group: usize| {
        let sum: usize = rows[group * size..(group + 1) * size].iter().sum();
        gcd(sum % colors, colors) == 1
    };
    for _ in 0..SWAPS * colors {
        let Some(bad) = (0..colors / size).find(|&group| !fits(&rows, group)) else {
            let shift = |&r: &usize| (0..colors).map(|x| ((x + r) % colors) as u8).collect();
            return Some(
                rows.chunks(size).map(|group| group.iter().map(shift).collect()).collect(),
            );
        };
        let (i, j) = (bad * size + rng.random_range(0..size), rng.random_range(0..colors));
        let before = [i, j].map(|k| fits(&rows, k / size));
        rows.swap(i, j);
        // Never spoil two to mend none; else wander.
        if before[1] && ![i, j].iter().any(|&k| fits(&rows, k / size)) {
            rows.swap(i, j);
        }
    }
    None
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// Divides random squares into groups of `size`, or gives up.
pub fn random(colors: usize, size: usize, rng: &mut Pcg64) -> Option<Vec<Vec<Permutation>>> {
    (0..SQUARES).find_map(|_| divided(latin_square(colors, rng)?, size, rng))
}

/// Draws the groups one by one from the rows that are left.
fn divided(
    mut rows: Vec<Permutation>,
    size: usize,
    rng: &mut Pcg64,
) -> Option<Vec<Vec<Permutation>>> {
    let colors = rows.len();
    let mut from = 0;
    let mut draws = 0;
    while from < colors {
        rows[from..].shuffle(rng);
        draws += 1;
        if is_cycle(&rows[from..from + size]) {
            (from, draws) = (from + size, 0);
        } else if draws > DRAWS * colors || colors - from == size && size < 3 {
            // The last rows may have no good order at all, two of them surely: begin again, and
            // now and then with another square.
            if rng.random_range(0..SQUARES) == 0 {
                return None;
            }
            (from, draws) = (0, 0);
        }
    }
    Some(rows.chunks(size).map(<[_]>::to_vec).collect())
}

/// Whether the permutations, one after the other, make a single cycle.
fn is_cycle(group: &[Permutation]) -> bool {
    let colors = group[0].len();
    let mut color = 0u8;
    for step in 1..=colors {
        color = group.iter().fold(color, |color, row| row[usize::from(color)]);
        if color == 0 {
            return step == colors;
        }
    }
    false
}

/// A random Latin square, row by row.
fn latin_square(colors: usize, rng: &mut Pcg64) -> Option<Vec<Permutation>> {
    let mut left: Vec<Vec<u8>> = vec![(0..colors as u8).collect(); colors];
    let mut rows = Vec::with_capacity(colors);
    for _ in 0..colors {
        let mut order: Vec<usize> = (0..colors).collect();
        order.shuffle(rng);
        left.iter_mut().for_each(|choices| choices.shuffle(rng));
        let mut column_of = vec![None; colors];
        for &column in &order {
            let mut seen = vec![false; colors];
            if !augment(column, &left, &mut column_of, &mut seen) {
                return None;
            }
        }
        let mut row = vec![0; colors];
        for (color, column) in column_of.into_iter().enumerate() {
            let column: usize = column?;
            row[column] = color as u8;
            left[column].retain(|&other| usize::from(other) != color);
        }
        rows.push(row);
    }
    Some(rows)
}

/// Gives a column a color, moving others (an augmenting path).
fn augment(
    column: usize,
    left: &[Vec<u8>],
    column_of: &mut [Option<usize>],
    seen: &mut [bool],
) -> bool {
    for &color in &left[column] {
        let color = usize::from(color);
        if std::mem::replace(&mut seen[color], true) {
            continue;
        }
        if column_of[color].is_none_or(|other| augment(other, left, column_of, seen)) {
            column_of[color] = Some(column);
            return true;
        }
    }
    false
}

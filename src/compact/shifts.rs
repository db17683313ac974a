//! Compact corner sets by shifted rows.
//!
//! The torus has `X = C m` columns and `2 C l` rows, `l = C / m`. Each of `l` groups of `m`
//! permutations (see [`groups`]) makes a sequence `s_t` of period `X`: every next
//! color is the image of the last under the permutation whose turn it is. All rows are such
//! sequences, those of `t` next to those of `t` and of `t + 1`, shifted by all multiples of `m`.
//!
//! Why: no two permutations agree anywhere, so (SW, SE) tells which one it is, and SW which of
//! its `C` turns, at place `p` of `s_t`. Above stand `s_t[p + m j]` and `s_{t+1}[p + m j]`, for
//! `j` from 0 to `C - 1`: every color once in either, for the product of a group is one cycle. So
//! (NW, SW, SE) occurs twice, and NE is the image of NW under two different permutations. With
//! one group the shifts are `C j + 1` and `C j - 1` instead.
//!
//! With the sides exchanged, the torus is reflected through its SW-NE diagonal, which keeps NE.
//! Source: this project.

use super::groups::{self, Permutation};
use super::{is_compact, reflected};
use rand::SeedableRng;
use rand_pcg::Pcg64;

/// Whether the rows of a torus can be such sequences.
pub fn suits(colors: usize, columns: usize, rows: usize) -> bool {
    // Not single rows: a column of a Latin square has every color, so some row keeps one.
    let size = columns / colors;
    columns.is_multiple_of(colors)
        && size > 1
        && colors.is_multiple_of(size)
        && rows == 2 * colors * (colors / size)
}

/// The colors of the lattice points, row by row from the north, or `None` when this does not
/// work for the shape.
pub fn corner(colors: usize, columns: usize, rows: usize, seed: u64) -> Option<Vec<u8>> {
    let mut rng = Pcg64::seed_from_u64(seed);
    // The near-square shape may work in one orientation only.
    for (w, h) in [(columns, rows), (rows, columns)] {
        if !suits(colors, w, h) {
            continue;
        }
        for divide in [groups::cyclic, groups::random] {
            let Some(groups) = divide(colors, w / colors, &mut rng) else { continue };
            let cells = shifted_rows(colors, &groups);
            let cells = if w == columns { cells } else { reflected(&cells, columns, rows) };
            if is_compact(colors, columns, &cells) {
                return Some(cells);
            }
        }
    }
    None
}

/// The rows of all shifts, from the north.
fn shifted_rows(colors: usize, groups: &[Vec<Permutation>]) -> Vec<u8> {
    let (l, m) = (groups.len(), groups[0].len());
    let columns = colors * m;
    let sequences: Vec<Vec<u8>> = groups
        .iter()
        .map(|group| {
            let next = |color: &u8, row: &Permutation| row[usize::from(*color)];
            let steps = group.iter().cycle().take(columns);
            steps.scan(0u8, |color, row| Some(std::mem::replace(color, next(color, row)))).collect()
        })
        .collect();
    // From the south: the sequence of every row, and the shift from it to the next.
    let mut plan: Vec<(usize, usize)> = Vec::with_capacity(2 * colors * l);
    for j in 0..colors {
        if l == 1 {
            plan.extend([(0, 1 + colors * j), (0, colors - 1 + colors * j)]);
        } else {
            plan.extend((0..l).flat_map(|t| [(t, m * j); 2]));
        }
    }
    let mut rows = Vec::with_capacity(plan.len());
    let mut shift = 0;
    for (t, step) in plan {
        let mut row = sequences[t].clone();
        row.rotate_left(shift % columns);
        rows.push(row);
        shift += step;
    }
    rows.reverse();
    rows.concat()
}

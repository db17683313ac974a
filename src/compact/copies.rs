//! Compact corner sets over more colors, from copies of a packing over fewer.
//!
//! Let `B` be a packing of the compact set over `c` colors, `R` rows high. Put `k^3` copies of it
//! on top of one another, number them `u = 0, 1, …` from the north and let `u0, u1, u2` be the
//! digits of `u` in base `k`, the lowest first. A color of copy `u` becomes `c d + (color in B)`,
//! where the digit `d` depends on the parities of row and column:
//!
//! | row | even column | odd column | last column of an odd number |
//! |---|---|---|---|
//! | even | `u0` | `u1` | `u0 + u1` |
//! | odd | `u2` | `u0 + u1 + u2` | `u1 + u2` |
//! | last row of an odd number | `u0 + u2` | `u1 + u2` | `u2` |
//!
//! modulo `k`. *Why:* (NW, SW, SE) without the digits occurs twice in `B`, with different NE; so
//! at either place the digits of the three must say which copy it is. Within a copy the three
//! sums of digits have determinant 1 or -1, whatever two rows and columns the window lies in: the
//! digits can be solved for. Across the lower edge of a copy SW and SE are of copy `u + 1`, but
//! show only its digits 0 and 1: they say `u` modulo `k^2`, and NW, where `u2` has the factor 1,
//! says the rest. The result has `c k` colors and the height `R k^3`; reflected through the SW-NE
//! diagonal, the width takes the factor. Source: this project.

/// The places of the digits `u0`, `u1`, `u2` that are added up, by type of row and column.
const SUMS: [[[bool; 3]; 3]; 3] = {
    const N: bool = false;
    const Y: bool = true;
    [
        [[Y, N, N], [N, Y, N], [Y, Y, N]],
        [[N, N, Y], [Y, Y, Y], [N, Y, Y]],
        [[Y, N, Y], [N, Y, Y], [N, N, Y]],
    ]
};

/// `k^3` numbered copies of a torus `columns` wide over `colors` colors, one below the other;
/// row by row from the north. Both sides must be at least 2, and `colors * k` at most 256.
pub fn stacked(cells: &[u8], columns: usize, colors: usize, k: usize) -> Vec<u8> {
    let rows = cells.len() / columns;
    let mut all = Vec::with_capacity(cells.len() * k.pow(3));
    for copy in 0..k.pow(3) {
        let digits = [copy % k, copy / k % k, copy / (k * k)];
        let digit = |sum: &[bool; 3]| {
            let chosen = digits.iter().zip(sum).filter(|(_, counts)| **counts);
            chosen.map(|(digit, _)| digit).sum::<usize>() % k
        };
        let table = SUMS.each_ref().map(|row| row.each_ref().map(digit));
        for (row, line) in cells.chunks_exact(columns).enumerate() {
            let digits = table[kind(row, rows)];
            let raised = |(column, &color): (usize, &u8)| {
                (colors * digits[kind(column, columns)]) as u8 + color
            };
            all.extend(line.iter().enumerate().map(raised));
        }
    }
    all
}

/// The type of a row or column: its parity, or 2 for the last of an odd number.
fn kind(at: usize, side: usize) -> usize {
    if side % 2 == 1 && at + 1 == side { 2 } else { at % 2 }
}

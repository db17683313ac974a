//! Sizes of tile sets in closed form.
//!
//! A pruned set consists of the tiles whose set of colors is independent in the graph of
//! excluded pairs, so its size is the sum over independent sets `S` of the number of tiles that
//! show exactly the colors of `S`. A tile has at most four colors, so only `|S| <= 4` counts,
//! and the inner number follows by inclusion and exclusion over the subsets of `S`.
//! For `k` disjoint pairs it is `C^4 - 2k(6C^2 - 12C - 6k + 13)` (Schlömer 2012, table 2.1).

use super::{Color, Colors, Kind};

/// Tiles in a compact set: `2 C^3` corner tiles, `2 CH CV` Wang tiles; dominoes have none.
pub fn compact(kind: Kind, colors: Colors) -> u64 {
    let (h, v) = (colors.horizontal() as u64, colors.vertical() as u64);
    match kind {
        Kind::Corner => 2 * h * h * h,
        Kind::Wang => 2 * h * v,
        Kind::Domino => 0,
    }
}

/// Tiles that show both colors of none of the `pairs`.
pub fn pruned(kind: Kind, colors: Colors, pairs: &[(Color, Color)]) -> u64 {
    let count = colors.largest();
    let mut excluded = vec![false; count * count];
    for (a, b) in pairs {
        let (a, b) = (usize::from(a.0), usize::from(b.0));
        excluded[a * count + b] = true;
        excluded[b * count + a] = true;
    }
    let radices = kind.radices(colors);
    let mut total = 0;
    let mut chosen = Vec::with_capacity(4);
    extend(&mut chosen, 0, count, &excluded, &radices, &mut total);
    total
}

/// Adds up the tiles of every independent set that extends `chosen` by colors from `from` on.
fn extend(
    chosen: &mut Vec<usize>,
    from: usize,
    count: usize,
    excluded: &[bool],
    radices: &[usize],
    total: &mut u64,
) {
    if !chosen.is_empty() {
        *total += showing_exactly(chosen, radices);
    }
    if chosen.len() == radices.len() {
        return;
    }
    for next in from..count {
        if chosen.iter().all(|&c| !excluded[c * count + next]) {
            chosen.push(next);
            extend(chosen, next + 1, count, excluded, radices, total);
            chosen.pop();
        }
    }
}

/// Tiles whose set of colors is exactly `shown`, by inclusion and exclusion.
fn showing_exactly(shown: &[usize], radices: &[usize]) -> u64 {
    let mut total = 0i64;
    for subset in 0..1u32 << shown.len() {
        let within: i64 = radices
            .iter()
            .map(|&radix| {
                let usable = |&(i, &c): &(usize, &usize)| subset >> i & 1 == 1 && c < radix;
                shown.iter().enumerate().filter(usable).count() as i64
            })
            .product();
        let missing = shown.len() as u32 - subset.count_ones();
        total += if missing.is_multiple_of(2) { within } else { -within };
    }
    total as u64
}

/// Corner tiles over `count` colors with `pairs` disjoint excluded pairs.
pub fn disjoint_pairs(count: u64, pairs: u64) -> u64 {
    let (c, k) = (count as i64, pairs as i64);
    (c.pow(4) - 2 * k * (6 * c * c - 12 * c - 6 * k + 13)) as u64
}

//! The middle of a tile covered by a patch with one cut in each quarter (Schlömer 2012).
//!
//! In a quarter the patch ends along a staircase from the middle of one edge to that of the
//! other, which steps toward the other edge or the corner or both at once, and is the cheapest by
//! dynamic programming; the price of a place is the square of the difference in brightness. All
//! staircases end at the same distance from the edges, so they join.

use super::Shape;
use super::quilt::Quilt;
use super::stock::{Stock, Texel};

/// A tile whose middle shows the patch at a position; what is paid for all seams then.
pub fn cover(stock: &Stock, shape: Shape, tile: &Quilt, at: Texel) -> (Quilt, u64) {
    let (side, half) = (shape.side, shape.side / 2);
    let patch = Quilt::new(side, side, |x, y| at + (y * stock.stride() + x) as Texel);
    let mut quilt = tile.clone();
    for (south, east) in [(false, false), (false, true), (true, false), (true, true)] {
        // Columns and rows from the middle of the tile, outward.
        let place = |u: usize, v: usize| {
            let line = |at: usize, far: bool| if far { half + at } else { half - 1 - at };
            line(v, south) * side + line(u, east)
        };
        let brightness =
            |texel: Texel| stock.light(texel).iter().map(|&sample| i64::from(sample)).sum::<i64>();
        let price = |u: usize, v: usize| {
            let at = place(u, v);
            let off = brightness(tile.texels[at]) - brightness(patch.texels[at]);
            (off * off) as u64 + 1
        };
        for (v, end) in staircase(shape.radius(), price).into_iter().enumerate() {
            for u in 0..end {
                quilt.texels[place(u, v)] = patch.texels[place(u, v)];
            }
        }
    }
    let price = quilt.price(stock);
    (quilt, price)
}

/// The cheapest staircase in a quarter of a disk, from (0, radius - 1) to (radius - 1, 0): for
/// each row how many columns, from the middle, lie within it.
pub fn staircase(radius: usize, price: impl Fn(usize, usize) -> u64) -> Vec<usize> {
    let end = radius - 1;
    let inside = |u: usize, v: usize| {
        let line = |at: usize| (2 * at + 1) * (2 * at + 1);
        u <= end && v <= end && (line(u) + line(v) < 4 * radius * radius || u + v == end)
    };
    // What the way from the first place costs, and the step that led here: columns, rows.
    let mut best = vec![(u64::MAX, (0, 0)); radius * radius];
    best[end * radius] = (price(0, end), (0, 0));
    for u in 0..radius {
        for v in (0..radius).rev() {
            if !inside(u, v) || (u, v) == (0, end) {
                continue;
            }
            let mut least = (u64::MAX, (0, 0));
            for (du, dv) in [(1, 1), (1, 0), (0, 1)] {
                if u >= du && inside(u - du, v + dv) {
                    least = least.min((best[(v + dv) * radius + u - du].0, (du, dv)));
                }
            }
            if least.0 < u64::MAX {
                best[v * radius + u] = (least.0.saturating_add(price(u, v)), least.1);
            }
        }
    }
    let mut columns = vec![0; radius];
    let (mut u, mut v) = (end, 0);
    loop {
        columns[v] = columns[v].max(u + 1);
        let (du, dv) = best[v * radius + u].1;
        if (du, dv) == (0, 0) {
            return columns;
        }
        (u, v) = (u - du, v + dv);
    }
}

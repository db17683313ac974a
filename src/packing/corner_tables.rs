//! What the search for corner packings begins with: tiles by row, dominoes left, colors that may
//! follow. See [`Rule`](super::rule::Rule) for what a row is.

use super::caps::Caps;
use super::{MAX_SEARCH_COLORS, Task};
use crate::tiles::{Kind, TileSet};

/// The index of a row, from its known corners; `shift` is the number of bits of a color.
#[inline(always)]
pub(super) fn row(shift: u32, known: [u8; 3]) -> usize {
    let [a, b, c] = known.map(usize::from);
    (a << shift | b) << shift | c
}

/// By the number of colors used, the colors that may follow: in a fixed order those used and
/// the next one, else all.
pub(super) fn follow(count: usize, ordered: bool) -> Vec<u64> {
    let below = |colors: usize| u64::MAX >> (MAX_SEARCH_COLORS - colors.min(count));
    (0..=count).map(|used| below(if ordered { used + 1 } else { count })).collect()
}

/// A tile as the colors of a window's known corners and free corner.
fn window_colors(set: &TileSet, sides: [u8; 4]) -> [u8; 4] {
    let [ne, se, sw, nw] = sides;
    if set.is_compact() { [sw, se, nw, ne] } else { [nw, ne, sw, se] }
}

/// For every row the tiles that may be placed: those of the set that an automorphism lets
/// occur. A tile takes its images along; in a packing they must be different tiles, and of a
/// row at most `limit` may be taken.
pub(super) fn allowed_rows(
    set: &TileSet,
    shift: u32,
    maps: &[Vec<u8>],
    packing: bool,
    limit: Option<usize>,
) -> Vec<u64> {
    let mut rows = vec![0; 1 << (3 * shift)];
    let mut images: Vec<(usize, u8)> = Vec::with_capacity(maps.len());
    for tile in set.allowed() {
        let sides = window_colors(set, Kind::Corner.unpack(tile, set.colors()));
        let image = |map: &Vec<u8>| {
            let [a, b, c, free] = sides.map(|color| map[usize::from(color)]);
            let [a, b, c] = [a, b, c].map(usize::from);
            ((a << shift | b) << shift | c, free)
        };
        images.clear();
        images.extend(maps.iter().map(image));
        let (row, free) = images[0];
        images.sort_unstable();
        let twice = images.windows(2).any(|pair| pair[0] == pair[1]);
        images.dedup();
        let crowded =
            limit.is_some_and(|limit| images.iter().filter(|image| image.0 == row).count() > limit);
        if !(crowded || packing && twice) {
            rows[row] |= 1 << free;
        }
    }
    rows
}

/// What the tiles of a task leave to its dominoes.
pub(super) fn caps<const W: usize, const C: usize>(task: &Task) -> Caps<W, C> {
    let (set, count) = (&task.set, task.set.colors().horizontal());
    let tiles =
        set.allowed().map(|tile| window_colors(set, Kind::Corner.unpack(tile, set.colors())));
    let share = if set.is_compact() { (2, count as u64) } else { (1, 1) };
    // Without caps as many as there are windows, with images.
    let spare = match task.prunings.caps {
        true => task.shape.cells() as u64 - set.size(),
        false => task.shape.cells() as u64,
    };
    Caps::new(count, tiles, share, spare)
}

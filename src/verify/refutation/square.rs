//! A square that cannot be filled, checked by breadth: all borders after each cell.

use super::{ClaimFault, sides};
use crate::tiles::Kind;
use std::collections::HashSet;

/// No tile.
const NONE: u32 = u32::MAX;

/// Fills the square cell by cell, row after row.
pub(super) fn check(
    kind: Kind,
    tiles: &[[u32; 4]],
    side: usize,
    most: usize,
) -> Result<(), ClaimFault> {
    let shown: Vec<_> = tiles.iter().map(|&tile| sides(kind, tile)).collect();
    // The first tile that shows the same on a side, or on two of them.
    let alike = |sides: &[usize]| -> Vec<u32> {
        let same = |a: usize, b: usize| sides.iter().all(|&side| shown[a][side] == shown[b][side]);
        let first = |tile: usize| (0..=tile).find(|&other| same(other, tile)).unwrap_or(tile);
        (0..shown.len()).map(|tile| first(tile) as u32).collect()
    };
    let (south, south_east) = (alike(&[2]), alike(&[1, 2]));
    let cells = side.checked_mul(side).ok_or(ClaimFault::TooLarge(most))?;
    // For each column the last tile, as far as the rest can tell it.
    let mut borders = HashSet::from([vec![NONE; side.min(most)]]);
    let mut steps = 0usize;
    for cell in 0..cells {
        let column = cell % side;
        let mut next = HashSet::new();
        for border in &borders {
            let north = border[column];
            let west = if column == 0 { NONE } else { border[column - 1] };
            for (tile, shows) in shown.iter().enumerate() {
                let fits_north = north == NONE || shown[north as usize][2] == shows[0];
                let fits_west = west == NONE || shown[west as usize][1] == shows[3];
                if !fits_north || !fits_west {
                    continue;
                }
                let mut border = border.clone();
                border[column] = south_east[tile];
                if column > 0 {
                    border[column - 1] = south[border[column - 1] as usize];
                }
                if column + 1 == side {
                    border[column] = south[tile];
                }
                next.insert(border);
            }
        }
        steps += next.len();
        if steps > most {
            return Err(ClaimFault::TooLarge(most));
        }
        if next.is_empty() {
            return Ok(());
        }
        borders = next;
    }
    Err(ClaimFault::Filled(side))
}

//! Rectangles of sets that compute (J. Kari 1996, K. Culik II 1996), of any size at once.
//!
//! The labels of N and S edges stand for numbers. A row of tiles turns the row of labels below it,
//! which are a number x on the mean, into one of q x, for one of the ratios q that the set knows;
//! E and W labels carry what is left over. The differences of the floors of 0, x, 2x, ... are
//! such a row of labels, and those of x/q one for the row below (Beatty; Kari 1996, section 3). So
//! a row is a walk among tiles whose N label is known and the number of whose S label is, and
//! there is one.

use super::super::decide::Tile;
use super::Random;

/// What the labels of a set compute.
#[derive(Debug, Clone, Copy)]
pub struct Machine {
    /// The number of each label of N and S.
    pub values: &'static [i64],
    /// By what the number of a row is multiplied from below to above: numerator and denominator.
    pub ratios: &'static [(f64, f64)],
    /// The numbers that rows have.
    pub range: (f64, f64),
}

/// Numbers tried for the first row.
const TRIES: usize = 200;

/// Fills a rectangle, or gives up: then the machine is not that of the set.
pub(super) fn fill(
    tiles: &[Tile],
    machine: &Machine,
    width: usize,
    height: usize,
    random: &mut Random,
) -> Option<Vec<usize>> {
    (0..TRIES).find_map(|_| {
        let (low, high) = machine.range;
        let mut x = low + (high - low) * random.next();
        let mut cells: Vec<usize> = Vec::with_capacity(width * height);
        for row in 0..height {
            let above = row.checked_sub(1).map(|above| &cells[above * width..][..width]);
            let (next, row) = machine.ratios.iter().find_map(|&(up, down)| {
                let next = x * down / up;
                let inside = (low..=high).contains(&next);
                let row = inside.then(|| walk(tiles, machine, above, (x, next), width))??;
                Some((next, row))
            })?;
            cells.extend(row);
            x = next;
        }
        Some(cells)
    })
}

/// The i-th difference of the floors of multiples of x.
fn label(x: f64, i: usize) -> i64 {
    ((i + 1) as f64 * x).floor() as i64 - (i as f64 * x).floor() as i64
}

/// A row between these numbers, below a row of tiles if there is one.
fn walk(
    tiles: &[Tile],
    machine: &Machine,
    above: Option<&[usize]>,
    (north, south): (f64, f64),
    width: usize,
) -> Option<Vec<usize>> {
    let fits = |column: usize, tile: &Tile| {
        let value = |label: u32| machine.values.get(label as usize).copied();
        let matches = match above {
            Some(above) => tiles[above[column]][2] == tile[0],
            None => value(tile[0]) == Some(label(north, column)),
        };
        matches && value(tile[2]) == Some(label(south, column))
    };
    let states = 1 + tiles.iter().flat_map(|tile| [tile[1], tile[3]]).max()? as usize;
    // From which W labels the end is reached.
    let mut reaches = vec![true; (width + 1) * states];
    for column in (0..width).rev() {
        let (here, there) = reaches[column * states..].split_at_mut(states);
        here.fill(false);
        for tile in tiles.iter().filter(|tile| fits(column, tile)) {
            here[tile[3] as usize] |= there[tile[1] as usize];
        }
    }
    let mut state: Option<u32> = None;
    let mut row = Vec::with_capacity(width);
    for column in 0..width {
        let there = &reaches[(column + 1) * states..][..states];
        let goes = |tile: &Tile| {
            state.is_none_or(|state| state == tile[3])
                && there[tile[1] as usize]
                && fits(column, tile)
        };
        let at = tiles.iter().position(goes)?;
        state = Some(tiles[at][1]);
        row.push(at);
    }
    Some(row)
}

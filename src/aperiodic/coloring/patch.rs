//! A legal rectangle of any Wang set, for the windows that occur in it.
//!
//! Every cell keeps the tiles that it may still have; a choice is followed up through its
//! neighbors until nothing changes. The cell with the fewest tiles left is next, and its tiles are
//! tried in random order. After too many failures it begins again with other random numbers, and
//! more patience.

use crate::search::Stop;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// The most Wang tiles: bits of a word.
pub const MOST_WANG: usize = 128;

/// Tiles left in every cell, row by row, and what was there before.
struct Rectangle<'a> {
    shape: [usize; 2],
    left: Vec<u128>,
    before: Vec<(usize, u128)>,
    fitting: &'a [Vec<u128>; 4],
}

/// The neighbors of a cell to the north, east, south and west.
fn neighbors(cell: usize, [rows, columns]: [usize; 2]) -> [Option<usize>; 4] {
    let (row, column) = (cell / columns, cell % columns);
    [
        (row > 0).then(|| cell - columns),
        (column + 1 < columns).then(|| cell + 1),
        (row + 1 < rows).then(|| cell + columns),
        (column > 0).then(|| cell - 1),
    ]
}

impl Rectangle<'_> {
    /// Leaves a cell only these tiles; `false` when some cell has none left.
    fn narrow(&mut self, cell: usize, tiles: u128) -> bool {
        let mut changed = Vec::new();
        if !self.set(cell, self.left[cell] & tiles, &mut changed) {
            return false;
        }
        while let Some(cell) = changed.pop() {
            for (direction, next) in neighbors(cell, self.shape).into_iter().enumerate() {
                let Some(next) = next else { continue };
                let mut fit = 0;
                let mut here = self.left[cell];
                while here != 0 {
                    fit |= self.fitting[direction][here.trailing_zeros() as usize];
                    here &= here - 1;
                }
                if !self.set(next, self.left[next] & fit, &mut changed) {
                    return false;
                }
            }
        }
        true
    }

    fn set(&mut self, cell: usize, tiles: u128, changed: &mut Vec<usize>) -> bool {
        if tiles != self.left[cell] {
            self.before.push((cell, self.left[cell]));
            self.left[cell] = tiles;
            changed.push(cell);
        }
        tiles != 0
    }

    fn undo(&mut self, to: usize) {
        for (cell, tiles) in self.before.drain(to..).rev() {
            self.left[cell] = tiles;
        }
    }

    /// The undecided cell with the fewest tiles left.
    fn next(&self) -> Option<usize> {
        let undecided = self.left.iter().enumerate().filter(|(_, left)| left.count_ones() > 1);
        undecided.min_by_key(|(_, left)| left.count_ones()).map(|(cell, _)| cell)
    }
}

/// A legal rectangle of so many rows and columns, or `None` when it is stopped or there is none.
/// At most [`MOST_WANG`] tiles.
pub fn patch(
    wang: &[[u32; 4]],
    shape: [usize; 2],
    seed: u64,
    stop: &dyn Stop,
) -> Option<Vec<Vec<usize>>> {
    let meet = |side: usize| {
        let of = |tile: &[u32; 4]| {
            let there =
                wang.iter().enumerate().filter(|(_, other)| tile[side] == other[(side + 2) % 4]);
            there.fold(0, |all, (i, _)| all | 1u128 << i)
        };
        wang.iter().map(of).collect()
    };
    let fitting = [0, 1, 2, 3].map(meet);
    let all = u128::MAX.checked_shr((MOST_WANG - wang.len().min(MOST_WANG)) as u32)?;
    let mut rng = Pcg64::new(u128::from(seed), 0);
    let mut patience = 1000u64;
    while !stop.should_stop() {
        let left = vec![all; shape[0] * shape[1]];
        let mut rectangle = Rectangle { shape, left, before: Vec::new(), fitting: &fitting };
        // What no neighbor fits is out from the start.
        if !(0..shape[0] * shape[1]).all(|cell| rectangle.follow(cell)) {
            return None;
        }
        match fill(&mut rectangle, &mut rng, patience, stop) {
            Some(true) => {
                let row =
                    |row: &[u128]| row.iter().map(|left| left.trailing_zeros() as usize).collect();
                return Some(rectangle.left.chunks(shape[1]).map(row).collect());
            }
            Some(false) => return None,
            None => patience *= 2,
        }
    }
    None
}

impl Rectangle<'_> {
    /// Follows up what a cell has now.
    fn follow(&mut self, cell: usize) -> bool {
        neighbors(cell, self.shape).into_iter().enumerate().all(|(direction, next)| {
            let Some(next) = next else { return true };
            let here = self.left[cell];
            let fits = |i: &usize| here >> i & 1 == 1;
            let tiles = (0..MOST_WANG).filter(fits);
            let fit = tiles.fold(0, |fit, i| fit | self.fitting[direction][i]);
            self.narrow(next, fit)
        })
    }
}

/// Fills a rectangle; whether that can be done, or `None` after too many failures.
fn fill(
    rectangle: &mut Rectangle<'_>,
    rng: &mut Pcg64,
    mut patience: u64,
    stop: &dyn Stop,
) -> Option<bool> {
    // Choices made: where `before` was, the cell, the tiles not yet tried.
    let mut choices: Vec<(usize, usize, u128)> = Vec::new();
    let mut going_on = true;
    loop {
        if going_on {
            let Some(cell) = rectangle.next() else { return Some(true) };
            choices.push((rectangle.before.len(), cell, rectangle.left[cell]));
        }
        let Some((mark, cell, untried)) = choices.last_mut() else { return Some(false) };
        rectangle.undo(*mark);
        if *untried == 0 {
            choices.pop();
            going_on = false;
            continue;
        }
        let mut pick = *untried;
        for _ in 0..rng.next_u64() % u64::from(untried.count_ones()) {
            pick &= pick - 1;
        }
        let tile = pick & pick.wrapping_neg();
        *untried &= !tile;
        let cell = *cell;
        going_on = rectangle.narrow(cell, tile);
        if !going_on {
            patience -= 1;
            if patience == 0 || stop.should_stop() {
                return None;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patches_are_legal() {
        // Any two tiles of a checkerboard and stripes.
        let wang = [[0, 0, 1, 1], [1, 1, 0, 0], [0, 1, 1, 0], [2, 0, 0, 0]];
        let patch = patch(&wang, [7, 9], 5, &()).unwrap();
        for (row, column) in (0..7).flat_map(|row| (0..9).map(move |column| (row, column))) {
            let tile = wang[patch[row][column]];
            assert!(column == 8 || tile[1] == wang[patch[row][column + 1]][3]);
            assert!(row == 6 || tile[2] == wang[patch[row + 1][column]][0]);
        }
        // South 1 meets no north: two rows there are none.
        assert_eq!(super::patch(&[[0, 0, 1, 0]], [2, 2], 0, &()), None);
        assert_eq!(super::patch(&[], [2, 2], 0, &()), None);
    }
}

//! Compact Wang sets by a few swaps.
//!
//! Every pair (N, W) is put down twice, anywhere on the torus; the cell below gives the tile
//! its S, the cell to the right its E. All that can be wrong is that the two tiles of a pair are
//! alike: in S and in E (*weak*), or in one of them (*strict*, as for the two tiles that a
//! stochastic tiling chooses from). Then cells are swapped with random others until none is.
//! Under 60 swaps suffice for 16 colors. Source: this project; the sets: Cohen, Shade, Hiller,
//! Deussen 2003; Lagae 2007, 3.2.1.

use crate::tiles::Colors;
use crate::torus::Shape;
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Swaps tried for every cell.
const SWAPS: usize = 200;

/// Labels where the two tiles of each (N, W) differ in S or in E.
pub fn weak(colors: Colors, shape: Shape, seed: u64) -> Option<Vec<u8>> {
    repaired(colors, shape, seed, |south, east| south || east)
}

/// Labels where they differ in both.
pub fn strict(colors: Colors, shape: Shape, seed: u64) -> Option<Vec<u8>> {
    repaired(colors, shape, seed, |south, east| south && east)
}

/// The torus while it is repaired: in every cell the number `N * CV + W` of a pair.
struct Torus {
    width: usize,
    vertical: usize,
    pairs: Vec<usize>,
    /// The two cells of every pair.
    cells: Vec<[usize; 2]>,
}

impl Torus {
    fn east(&self, cell: usize) -> usize {
        if (cell + 1).is_multiple_of(self.width) { cell + 1 - self.width } else { cell + 1 }
    }

    fn south(&self, cell: usize) -> usize {
        (cell + self.width) % self.pairs.len()
    }

    /// Whether the tiles of a pair differ in (S, E).
    fn differ(&self, pair: usize) -> (bool, bool) {
        let [a, b] = self.cells[pair];
        let south = |cell| self.pairs[self.south(cell)] / self.vertical;
        let east = |cell| self.pairs[self.east(cell)] % self.vertical;
        (south(a) != south(b), east(a) != east(b))
    }

    fn swap(&mut self, a: usize, b: usize) {
        let (p, q) = (self.pairs[a], self.pairs[b]);
        if p != q {
            self.cells[p] = self.cells[p].map(|cell| if cell == a { b } else { cell });
            self.cells[q] = self.cells[q].map(|cell| if cell == b { a } else { cell });
            self.pairs.swap(a, b);
        }
    }

    /// The pairs that may change when these two cells are swapped.
    fn around(&self, a: usize, b: usize) -> Vec<usize> {
        let (w, n) = (self.width, self.pairs.len());
        let west = |cell: usize| if cell.is_multiple_of(w) { cell + w - 1 } else { cell - 1 };
        let near = [a, b].map(|cell| [cell, west(cell), (cell + n - w) % n]);
        let mut pairs: Vec<usize> = near.as_flattened().iter().map(|&c| self.pairs[c]).collect();
        pairs.sort_unstable();
        pairs.dedup();
        pairs
    }
}

fn repaired(
    colors: Colors,
    shape: Shape,
    seed: u64,
    good: impl Fn(bool, bool) -> bool,
) -> Option<Vec<u8>> {
    let (pairs, cells) = (colors.horizontal() * colors.vertical(), shape.cells());
    if cells != 2 * pairs {
        return None;
    }
    let mut rng = Pcg64::seed_from_u64(seed);
    let mut order: Vec<usize> = (0..cells).map(|i| i / 2).collect();
    order.shuffle(&mut rng);
    let mut places = vec![Vec::with_capacity(2); pairs];
    for (cell, &pair) in order.iter().enumerate() {
        places[pair].push(cell);
    }
    let places = places.into_iter().map(|two| [two[0], two[1]]).collect();
    let mut torus =
        Torus { width: shape.width(), vertical: colors.vertical(), pairs: order, cells: places };
    let bad = |torus: &Torus, pair: usize| {
        let (south, east) = torus.differ(pair);
        !good(south, east)
    };
    let mut left = SWAPS * cells;
    loop {
        let wrong: Vec<usize> = (0..pairs).filter(|&pair| bad(&torus, pair)).collect();
        if wrong.is_empty() {
            let split =
                |&pair: &usize| [(pair / torus.vertical) as u8, (pair % torus.vertical) as u8];
            return Some(torus.pairs.iter().flat_map(split).collect());
        }
        for pair in wrong {
            // What is swapped is one of the tiles, or what gives it its S or E.
            let cell = torus.cells[pair][rng.random_range(0..2)];
            let a = [cell, torus.east(cell), torus.south(cell)][rng.random_range(0..3)];
            let b = rng.random_range(0..cells);
            let around = torus.around(a, b);
            let count = |torus: &Torus| around.iter().filter(|&&pair| bad(torus, pair)).count();
            let before = count(&torus);
            torus.swap(a, b);
            let after = torus.around(a, b);
            debug_assert!(after.iter().all(|pair| around.contains(pair)));
            if count(&torus) > before {
                torus.swap(a, b);
            }
            left = left.checked_sub(1)?;
        }
    }
}

//! Hashes by tables of permutations: no multiplication, but a period.
//!
//! A permutation `P` of `0 .. N` hashes a point to `P[(P[x mod N] + y) mod N]`, which repeats after `N`
//! points in both directions (Lagae 2007, equation 3.3). The sum of several such hashes, of tables
//! whose sizes have no common factor, modulo the first size, repeats in `x` and `y` after the product
//! of all sizes only (equation 3.6): 5,930,659,848 points for the seven sizes taken here, so that
//! coordinates need more than 32 bits to see it. The color of a point is its hash modulo `C`; where `C`
//! does not divide 24, the last colors are a little rarer.
//!
//! The tables are shuffled (Fisher and Yates): for `i` from `N - 1` down to 1, the entries `i` and
//! `uni(hash3(seed, i, N), i + 1)` change places.

use super::hash::{hash3, uni};

/// Sizes of the tables; the first alone is the short hash.
const SIZES: [u32; 7] = [24, 17, 19, 23, 29, 31, 37];

/// A hash by tables.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Permuted {
    /// Shuffled the tables.
    seed: u32,
    /// One permutation for each size in use.
    tables: Vec<Vec<u8>>,
}

impl Permuted {
    /// The hash by one table of 24.
    pub fn short(seed: u32) -> Self {
        Self { seed, tables: vec![shuffled(seed, SIZES[0])] }
    }

    /// The hash by all seven tables.
    pub fn long(seed: u32) -> Self {
        Self { seed, tables: SIZES.iter().map(|&size| shuffled(seed, size)).collect() }
    }

    /// What shuffled the tables.
    pub fn seed(&self) -> u32 {
        self.seed
    }

    /// The permutations.
    pub fn tables(&self) -> &[Vec<u8>] {
        &self.tables
    }

    /// After how many points, in both directions, it repeats; at the latest.
    pub fn period(&self) -> u64 {
        self.tables.iter().map(|table| table.len() as u64).product()
    }

    /// The hash of a point, below 24.
    pub fn hash(&self, x: i64, y: i64) -> u32 {
        let one = |table: &Vec<u8>| {
            let size = table.len() as i64;
            let first = i64::from(table[x.rem_euclid(size) as usize]);
            u32::from(table[((first + y.rem_euclid(size)) % size) as usize])
        };
        self.tables.iter().map(one).sum::<u32>() % SIZES[0]
    }

    /// The color of a point.
    pub fn color(&self, x: i64, y: i64, colors: usize) -> u8 {
        (self.hash(x, y) % colors as u32) as u8
    }
}

/// A permutation of this size.
fn shuffled(seed: u32, size: u32) -> Vec<u8> {
    let mut table: Vec<u8> = (0..size as u8).collect();
    for i in (1..size).rev() {
        table.swap(i as usize, uni(hash3(seed, i, size), i + 1) as usize);
    }
    table
}

//! What to begin with: random tiles, and random choices that depend on nothing but a seed.

use super::super::{FREE, Field};
use rand::{Rng, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// A number that looks random, from a seed and a place (the finalizer of SplitMix64, Steele and
/// others, 2014).
pub fn mixed(seed: u64, place: u64) -> u64 {
    let mut z = (place.wrapping_add(1)).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ seed.rotate_left(32);
    z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ z >> 31
}

/// Gives every free cell a random tile below `tiles`, all of them alike.
pub fn fill_randomly(field: &mut Field, tiles: usize, seed: u64) {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    // So many bits hold a tile, and a word so many tiles.
    let bits = usize::BITS - (tiles - 1).leading_zeros();
    let (mask, mut word, mut left) = ((1_u64 << bits) - 1, 0, 0);
    let mut next = || loop {
        if left < bits {
            (word, left) = (random.next_u64(), u64::BITS);
        }
        let tile = word & mask;
        word >>= bits;
        left -= bits;
        if tile < tiles as u64 {
            return tile as u8;
        }
    };
    for cell in field.cells_mut().iter_mut().filter(|cell| **cell == FREE) {
        *cell = next();
    }
}

/// Gives every free cell tile 0.
pub fn fill_with_nothing(field: &mut Field) {
    for cell in field.cells_mut().iter_mut().filter(|cell| **cell == FREE) {
        *cell = 0;
    }
}

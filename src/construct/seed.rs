//! Choices among the members of a construction, by a seed.
//!
//! Random numbers are those of SplitMix64 (Steele, Lea, Flood, *Fast splittable pseudorandom
//! number generators*, 2014), permutations are shuffled after Fisher and Yates. The same seed
//! gives the same choices for ever; that they be unpredictable is not asked of them.

/// A source of choices.
#[derive(Debug, Clone)]
pub struct Seed(u64);

impl Seed {
    /// The choices that belong to this number.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next number.
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    /// A number below `bound`, which must not be 0.
    pub fn below(&mut self, bound: usize) -> usize {
        ((u128::from(self.next()) * bound as u128) >> 64) as usize
    }

    /// Puts the items in random order.
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            let other = self.below(last + 1);
            items.swap(last, other);
        }
    }

    /// A permutation of the numbers below `count`, at most 256.
    pub fn permutation(&mut self, count: usize) -> Vec<u8> {
        let mut numbers: Vec<u8> = (0..count).map(|number| number as u8).collect();
        self.shuffle(&mut numbers);
        numbers
    }
}

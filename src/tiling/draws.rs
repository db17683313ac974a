//! A short stream of random numbers, all from one hash.

use super::hash::{mix, uni};

/// Numbers that follow from a hash.
#[derive(Debug, Clone)]
pub(super) struct Draws {
    state: u32,
    count: u32,
}

impl Draws {
    /// The stream of a hash.
    pub(super) fn new(hash: u32) -> Self {
        Self { state: hash, count: 0 }
    }

    /// 32 random bits.
    pub(super) fn bits(&mut self) -> u32 {
        self.count = self.count.wrapping_add(1);
        mix(self.state ^ mix(self.count.wrapping_mul(0x9e37_79b9)))
    }

    /// A number below `n`.
    pub(super) fn below(&mut self, n: usize) -> usize {
        uni(self.bits(), n as u32) as usize
    }

    /// Puts a list in random order.
    pub(super) fn shuffle<T>(&mut self, list: &mut [T]) {
        for i in (1..list.len()).rev() {
            list.swap(i, self.below(i + 1));
        }
    }
}

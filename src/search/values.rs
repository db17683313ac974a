//! Value orders: which alternative of a level is tried first.
//!
//! An order is a function of the level and the alternatives alone, without state, so that the
//! tree, the first solution in it and the number of nodes before that solution do not depend
//! on who walks which part of it.

use super::Alternatives;

/// An order on the alternatives of every level.
pub trait Values: Clone + Send + Sync {
    /// Removes and gives the first of the alternatives left at `level`, which are not empty.
    fn take<A: Alternatives>(&self, level: usize, left: &mut A) -> u32;

    /// Whether `a` comes before `b` at `level`.
    fn before(&self, level: usize, a: u32, b: u32) -> bool;
}

/// Smallest first.
#[derive(Debug, Clone, Copy, Default)]
pub struct Lexicographic;

impl Values for Lexicographic {
    #[inline(always)]
    fn take<A: Alternatives>(&self, _: usize, left: &mut A) -> u32 {
        left.take_first()
    }

    fn before(&self, _: usize, a: u32, b: u32) -> bool {
        a < b
    }
}

/// A random order of its own at every level, given by a seed.
#[derive(Debug, Clone, Copy)]
pub struct Random {
    /// Decides all the orders.
    pub seed: u64,
}

impl Random {
    #[inline]
    fn rank(&self, level: usize, choice: u32) -> u64 {
        scramble(self.seed ^ scramble((level as u64) << 32 | u64::from(choice)))
    }
}

impl Values for Random {
    #[inline]
    fn take<A: Alternatives>(&self, level: usize, left: &mut A) -> u32 {
        let mut rest = *left;
        let mut first = rest.take_first();
        let mut least = self.rank(level, first);
        while !rest.is_empty() {
            let choice = rest.take_first();
            let rank = self.rank(level, choice);
            if rank < least {
                (first, least) = (choice, rank);
            }
        }
        left.remove(first);
        first
    }

    fn before(&self, level: usize, a: u32, b: u32) -> bool {
        (self.rank(level, a), a) < (self.rank(level, b), b)
    }
}

/// A bijection of the 64-bit numbers that looks random (the finalizer of SplitMix64; Steele,
/// Lea, Flood 2014).
fn scramble(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

#[cfg(test)]
mod tests {
    use super::super::Words;
    use super::*;

    #[test]
    fn orders_are_total_and_agree_with_take() {
        let values = Random { seed: 7 };
        for level in 0..20 {
            let mut left = Words::<2>::below(100);
            let mut taken = Vec::new();
            while !left.is_empty() {
                taken.push(values.take(level, &mut left));
            }
            assert!(taken.windows(2).all(|w| values.before(level, w[0], w[1])));
            taken.sort_unstable();
            assert!(taken.into_iter().eq(0..100));
        }
    }
}

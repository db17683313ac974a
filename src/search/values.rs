//! Value orders: which alternative of a level is tried first.
//!
//! An order is a function of the level and the alternatives alone, without state, so that the
//! tree, the first solution in it and the number of nodes before that solution do not depend
//! on who walks which part of it.

use super::Alternatives;

/// An order on the alternatives of every level.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Values {
    /// Smallest first.
    Lexicographic,
    /// Largest first: where colors may come into use in order only, this uses new ones early.
    Highest,
    /// A random order of its own at every level, given by a seed.
    Random(u64),
}

impl Values {
    /// The first of the alternatives left at `level`, which are not empty.
    #[inline(always)]
    pub fn first<A: Alternatives>(self, level: usize, left: A) -> u32 {
        match self {
            Values::Lexicographic => left.first(),
            Values::Highest => left.last(),
            Values::Random(seed) => first_at_random(seed, level, left),
        }
    }

    /// Whether `a` comes before `b` at `level`.
    pub fn before(self, level: usize, a: u32, b: u32) -> bool {
        match self {
            Values::Lexicographic => a < b,
            Values::Highest => a > b,
            Values::Random(seed) => (rank(seed, level, a), a) < (rank(seed, level, b), b),
        }
    }
}

fn rank(seed: u64, level: usize, choice: u32) -> u64 {
    scramble(seed ^ scramble((level as u64) << 32 | u64::from(choice)))
}

#[inline(never)]
fn first_at_random<A: Alternatives>(seed: u64, level: usize, left: A) -> u32 {
    let ranked = left.numbers().map(|choice| (rank(seed, level, choice), choice));
    ranked.min().map_or(0, |(_, choice)| choice)
}

/// A bijection of the 64-bit numbers that looks random (the finalizer of SplitMix64; Steele,
/// Lea, Flood 2014).
pub(super) fn scramble(x: u64) -> u64 {
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
    fn orders_are_total_and_agree_with_first() {
        for (values, level) in
            (0..20).flat_map(|level| [(Values::Random(7), level), (Values::Highest, level)])
        {
            let mut left = Words::<2>::below(100);
            let mut taken = Vec::new();
            while !left.is_empty() {
                let first = values.first(level, left);
                left.remove(first);
                taken.push(first);
            }
            assert!(taken.windows(2).all(|w| values.before(level, w[0], w[1])));
            taken.sort_unstable();
            assert!(taken.into_iter().eq(0..100));
        }
    }
}

//! Random numbers that are the same on every machine: SplitMix64, and Gumbel noise from it.
//!
//! The largest of several scores with Gumbel noise added is each one with a probability in
//! proportion to `exp(score / tau)`, so a beam that keeps the largest draws without replacement
//! (Kool, van Hoof, Welling 2019). The noise is read from a table of its quantiles, in the
//! fixed-point numbers of [`super::score`].
//!
//! Source of the generator: Steele, Lea, Flood 2014.

use super::score::fixed;

/// Quantiles in the table: 2 to this power.
const BITS: u32 = 14;

/// A stream of random numbers.
#[derive(Debug, Clone)]
pub(super) struct Random(u64);

impl Random {
    /// The stream number `stream` of a seed.
    pub(super) fn new(seed: u64, stream: u64) -> Self {
        Self(scramble(scramble(seed).wrapping_add(stream)))
    }

    /// The next number.
    #[inline]
    pub(super) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        scramble(self.0)
    }

    /// A number below `end`, which is not 0 and small.
    pub(super) fn below(&mut self, end: usize) -> usize {
        ((u128::from(self.next()) * end as u128) >> 64) as usize
    }
}

/// The finalizer of SplitMix64.
#[inline]
fn scramble(x: u64) -> u64 {
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// Gumbel noise of one scale.
#[derive(Debug)]
pub(super) struct Gumbel(Vec<i64>);

impl Gumbel {
    /// The noise times `tau`.
    pub(super) fn new(tau: f64) -> Self {
        let steps = 1u32 << BITS;
        let quantile = |i: u32| -(-((f64::from(i) + 0.5) / f64::from(steps)).ln()).ln();
        Self((0..steps).map(|i| fixed(tau * quantile(i))).collect())
    }

    /// The next value.
    #[inline]
    pub(super) fn next(&self, random: &mut Random) -> i64 {
        self.0[(random.next() >> (64 - BITS)) as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_below_an_end_are_even() {
        let mut random = Random::new(1, 2);
        let mut counts = [0; 5];
        for _ in 0..10_000 {
            counts[random.below(5)] += 1;
        }
        assert!(counts.iter().all(|count| (1800..2200).contains(count)), "{counts:?}");
    }

    #[test]
    fn noise_has_the_mean_of_gumbel() {
        let (gumbel, mut random) = (Gumbel::new(2.0), Random::new(3, 4));
        let sum: i64 = (0..100_000).map(|_| gumbel.next(&mut random)).sum();
        let mean = sum as f64 / 100_000.0 / fixed(1.0) as f64;
        // Twice the Euler-Mascheroni constant.
        assert!((mean - 1.1544).abs() < 0.05, "{mean}");
    }
}

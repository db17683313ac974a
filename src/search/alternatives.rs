//! Sets of alternatives as machine words.
//!
//! The alternatives of a level are the bits of `N` words, so that the candidates of a cell are
//! the AND of a few masks and the next one is a count of trailing zeros. One implementation
//! serves every `N`; for `N = 1` the loops vanish.

use std::ops::{BitAnd, BitAndAssign, BitOr, BitOrAssign, Not};

/// A small set of numbers from 0, copied freely.
pub trait Alternatives: Copy + Send + PartialEq + std::fmt::Debug + 'static {
    /// The empty set.
    const EMPTY: Self;
    /// Whether no number is left.
    fn is_empty(&self) -> bool;
    /// How many numbers there are.
    fn count(&self) -> u32;
    /// The smallest number; the set must not be empty.
    fn first(&self) -> u32;
    /// The largest number; the set must not be empty.
    fn last(&self) -> u32;
    /// Adds a number.
    fn insert(&mut self, number: u32);
    /// Removes a number.
    fn remove(&mut self, number: u32);
    /// Whether it holds a number.
    fn contains(&self, number: u32) -> bool;

    /// The numbers in increasing order.
    fn numbers(mut self) -> impl Iterator<Item = u32> {
        std::iter::from_fn(move || {
            (!self.is_empty()).then(|| {
                let first = self.first();
                self.remove(first);
                first
            })
        })
    }
}

/// A set of numbers below `64 * N`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Words<const N: usize>(pub [u64; N]);

impl<const N: usize> Words<N> {
    /// The word of a number below `64 * N`; the remainder spares the check of the index.
    #[inline(always)]
    fn word(number: u32) -> usize {
        debug_assert!((number as usize) < 64 * N);
        (number / 64) as usize % N
    }

    /// Every number below `64 * N`.
    pub const ALL: Self = Self([u64::MAX; N]);

    /// The numbers below `count`.
    pub fn below(count: usize) -> Self {
        let mut set = Self::EMPTY;
        for number in 0..count {
            set.insert(number as u32);
        }
        set
    }
}

impl<const N: usize> Alternatives for Words<N> {
    const EMPTY: Self = Self([0; N]);

    #[inline(always)]
    fn is_empty(&self) -> bool {
        self.0.iter().fold(0, |all, &word| all | word) == 0
    }

    fn count(&self) -> u32 {
        self.0.iter().map(|word| word.count_ones()).sum()
    }

    #[inline(always)]
    fn first(&self) -> u32 {
        let (mut word, mut at) = (self.0[0], 0);
        for (i, &next) in self.0.iter().enumerate().skip(1) {
            if word != 0 {
                break;
            }
            (word, at) = (next, i);
        }
        64 * at as u32 + word.trailing_zeros()
    }

    fn last(&self) -> u32 {
        let at = self.0.iter().rposition(|&word| word != 0).unwrap_or(0);
        64 * at as u32 + 63 - self.0[at].leading_zeros().min(63)
    }

    #[inline(always)]
    fn insert(&mut self, number: u32) {
        self.0[Self::word(number)] |= 1 << (number % 64);
    }

    #[inline(always)]
    fn remove(&mut self, number: u32) {
        self.0[Self::word(number)] &= !(1 << (number % 64));
    }

    #[inline(always)]
    fn contains(&self, number: u32) -> bool {
        self.0[Self::word(number)] >> (number % 64) & 1 == 1
    }
}

impl<const N: usize> BitAnd for Words<N> {
    type Output = Self;

    #[inline(always)]
    fn bitand(mut self, other: Self) -> Self {
        self &= other;
        self
    }
}

impl<const N: usize> BitAndAssign for Words<N> {
    #[inline(always)]
    fn bitand_assign(&mut self, other: Self) {
        for (word, &mask) in self.0.iter_mut().zip(&other.0) {
            *word &= mask;
        }
    }
}

impl<const N: usize> BitOr for Words<N> {
    type Output = Self;

    #[inline(always)]
    fn bitor(mut self, other: Self) -> Self {
        self |= other;
        self
    }
}

impl<const N: usize> BitOrAssign for Words<N> {
    #[inline(always)]
    fn bitor_assign(&mut self, other: Self) {
        for (word, &mask) in self.0.iter_mut().zip(&other.0) {
            *word |= mask;
        }
    }
}

impl<const N: usize> Not for Words<N> {
    type Output = Self;

    #[inline(always)]
    fn not(mut self) -> Self {
        for word in &mut self.0 {
            *word = !*word;
        }
        self
    }
}

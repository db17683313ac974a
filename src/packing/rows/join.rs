//! Which walks of two groups go together.
//!
//! For every letter a bit set says which of up to 512 walks `x` have nothing against it; for a
//! walk `y` the sets of its letters are ANDed, and what is left goes together with it. So one
//! `y` meets all `x` in some twenty steps, whatever their number.

use super::law::Law;
use super::walks::{Group, Walk};

/// Walks `x` that are looked at together, at most.
const MOST: usize = 512;

/// Letters, with one that conflicts with nothing.
const LETTERS: usize = 256;

/// Goes through all pairs of a walk of `xs` and one of `ys` that go together, and whose sums do:
/// `fits` gives the sums of `xs`, as bits, that go with a sum of `ys`. `put` is also called for
/// what is no pair, and told so: that spares a branch. `before` is called before each `y`, with
/// the largest number of pairs to come.
pub fn join<S>(
    law: &Law,
    (xs, ys): (Group<'_>, Group<'_>),
    fits: impl Fn(u32) -> u128,
    state: &mut S,
    before: impl Fn(&mut S, usize),
    put: impl Fn(&mut S, &Walk, &Walk, bool),
) {
    if ys.walks.is_empty() {
        return;
    }
    let begins = (0..xs.walks.len()).step_by(MOST);
    for begin in begins {
        let xs = xs.part(begin, MOST);
        match xs.walks.len() {
            0..=128 => stretch::<2, S>(law, xs, ys, &fits, state, &before, &put),
            129..=256 => stretch::<4, S>(law, xs, ys, &fits, state, &before, &put),
            _ => stretch::<8, S>(law, xs, ys, &fits, state, &before, &put),
        }
    }
}

/// The same for as many `xs` as `B` words have bits.
fn stretch<const B: usize, S>(
    law: &Law,
    xs: Group<'_>,
    ys: Group<'_>,
    fits: &impl Fn(u32) -> u128,
    state: &mut S,
    before: &impl Fn(&mut S, usize),
    put: &impl Fn(&mut S, &Walk, &Walk, bool),
) {
    let sets = open::<B>(law, xs);
    // Which walks have which sum.
    let mut sums: Vec<(u32, [u64; B])> = Vec::new();
    for (x, walk) in xs.walks.iter().enumerate() {
        if sums.last().is_none_or(|&(sum, _)| sum != walk.sum) {
            sums.push((walk.sum, [0; B]));
        }
        if let Some((_, set)) = sums.last_mut() {
            set[x / 64] |= 1 << (x % 64);
        }
    }
    let mut at = 0;
    for same in ys.walks.chunk_by(|a, b| a.sum == b.sum) {
        let (fitting, from) = (fits(same[0].sum), at);
        at += same.len();
        let mut allowed = [0; B];
        for (_, set) in sums.iter().filter(|&&(sum, _)| fitting >> sum & 1 == 1) {
            for (allowed, set) in allowed.iter_mut().zip(set) {
                *allowed |= set;
            }
        }
        if allowed == [0; B] {
            continue;
        }
        let letters = ys.letters[from * ys.stride..at * ys.stride].chunks_exact(ys.stride);
        for (y, letters) in same.iter().zip(letters) {
            let mut left = allowed;
            for &letter in letters {
                let set = &sets[usize::from(letter)];
                for (left, set) in left.iter_mut().zip(set) {
                    *left &= set;
                }
            }
            before(state, 64 * B);
            for (word, mut bits) in left.into_iter().enumerate() {
                let mut next = || {
                    let x = 64 * word + bits.trailing_zeros() as usize % 64;
                    let real = bits != 0;
                    bits &= bits.wrapping_sub(1);
                    (&xs.walks[x.min(xs.walks.len() - 1)], real, bits != 0)
                };
                // Most words hold one or two: for these no branch has to be guessed.
                let (x, real, _) = next();
                put(state, x, y, real);
                let (x, real, mut more) = next();
                put(state, x, y, real);
                while more {
                    let (x, real, rest) = next();
                    put(state, x, y, real);
                    more = rest;
                }
            }
        }
    }
}

/// By letter: the walks that have nothing against it.
fn open<const B: usize>(law: &Law, xs: Group<'_>) -> Box<[[u64; B]; LETTERS]> {
    let mut all = [0; B];
    for x in 0..xs.walks.len() {
        all[x / 64] |= 1 << (x % 64);
    }
    let mut sets = Box::new([all; LETTERS]);
    for (x, letters) in xs.letters.chunks_exact(xs.stride.max(1)).enumerate() {
        for &letter in letters.iter().filter(|&&letter| usize::from(letter) < law.alphabet()) {
            for other in law.conflicts(letter) {
                sets[usize::from(other)][x / 64] &= !(1 << (x % 64));
            }
        }
    }
    sets
}

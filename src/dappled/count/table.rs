//! Numbers of fillings by state, sorted by state.
//!
//! A state is a word of 64 bits. A number is a row of limbs, least significant first; where tiles
//! are counted too there is such a number for each count. The table lies in several chunks, each
//! made by one thread; how it is cut has no meaning.
//!
//! Invariant: the states of all chunks, one after the other, increase; each chunk has
//! `limbs * counts` limbs for each of its states.

use num_bigint::BigUint;

/// A part of a table.
#[derive(Debug, Clone, Default)]
pub(super) struct Chunk {
    /// The states.
    pub(super) states: Vec<u64>,
    /// Their numbers.
    pub(super) numbers: Vec<u64>,
}

/// States and their numbers.
#[derive(Debug, Clone)]
pub(super) struct Table {
    /// The parts.
    pub(super) chunks: Vec<Chunk>,
    /// Limbs of a number.
    pub(super) limbs: usize,
    /// Numbers of a state: one for each count of the tile that is counted, from 0 on.
    pub(super) counts: usize,
    /// All most significant limbs, ORed.
    pub(super) highest: u64,
}

/// With a limb of this size on top, adding up might carry out of it.
const FULL: u64 = 1 << 40;

impl Table {
    /// One state, in one way.
    pub(super) fn one(state: u64) -> Self {
        let chunk = Chunk { states: vec![state], numbers: vec![1] };
        Self { chunks: vec![chunk], limbs: 1, counts: 1, highest: 1 }
    }

    /// Nothing.
    pub(super) fn none() -> Self {
        Self { chunks: Vec::new(), limbs: 1, counts: 1, highest: 0 }
    }

    /// Limbs of a state.
    pub(super) fn stride(&self) -> usize {
        self.limbs * self.counts
    }

    /// How many states there are.
    pub(super) fn len(&self) -> usize {
        self.chunks.iter().map(|chunk| chunk.states.len()).sum()
    }

    /// The memory it takes.
    pub(super) fn bytes(&self) -> usize {
        self.len() * 8 * (1 + self.stride())
    }

    /// The limbs of a state; none if there are no fillings.
    pub(super) fn get(&self, state: u64) -> Option<&[u64]> {
        let stride = self.stride();
        let after = |chunk: &Chunk| chunk.states.last().is_some_and(|&last| last < state);
        let chunk = self.chunks.get(self.chunks.partition_point(after))?;
        let at = chunk.states.binary_search(&state).ok()?;
        Some(&chunk.numbers[at * stride..(at + 1) * stride])
    }

    /// All states.
    pub(super) fn states(&self) -> impl Iterator<Item = u64> {
        self.chunks.iter().flat_map(|chunk| chunk.states.iter().copied())
    }

    /// All states and their limbs.
    pub(super) fn iter(&self) -> impl Iterator<Item = (u64, &[u64])> {
        let stride = self.stride();
        self.chunks
            .iter()
            .flat_map(move |chunk| chunk.states.iter().copied().zip(chunk.numbers.chunks(stride)))
    }

    /// Gives every number a limb more, if there is no room left for sums.
    pub(super) fn make_room(&mut self) {
        if self.highest < FULL {
            return;
        }
        let limbs = self.limbs;
        for chunk in &mut self.chunks {
            let mut wider = Vec::with_capacity(chunk.numbers.len() / limbs * (limbs + 1));
            for number in chunk.numbers.chunks(limbs) {
                wider.extend_from_slice(number);
                wider.push(0);
            }
            chunk.numbers = wider;
        }
        (self.limbs, self.highest) = (limbs + 1, 0);
    }

    /// The sums over all states, by count.
    pub(super) fn sums(&self) -> Vec<BigUint> {
        let mut sums = vec![BigUint::ZERO; self.counts];
        for (_, limbs) in self.iter() {
            for (sum, number) in sums.iter_mut().zip(limbs.chunks(self.limbs)) {
                *sum += number_of(number);
            }
        }
        sums
    }
}

/// A number from its limbs.
pub(super) fn number_of(limbs: &[u64]) -> BigUint {
    let halves = limbs.iter().flat_map(|&limb| [limb as u32, (limb >> 32) as u32]);
    BigUint::new(halves.collect())
}

/// Adds one number to another that has as many limbs or more; the sum must have room.
#[inline(always)]
pub(super) fn add(to: &mut [u64], what: &[u64]) {
    let mut carry = false;
    let (low, high) = to.split_at_mut(what.len());
    for (to, &what) in low.iter_mut().zip(what) {
        let (sum, first) = to.overflowing_add(what);
        let (sum, second) = sum.overflowing_add(u64::from(carry));
        (*to, carry) = (sum, first | second);
    }
    for to in high {
        if !carry {
            return;
        }
        (*to, carry) = to.overflowing_add(1);
    }
}

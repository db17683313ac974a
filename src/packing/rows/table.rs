//! The walks of the first half, to be looked up by key.
//!
//! Far most keys that are looked up are not there, so two bit maps come first: a small one that
//! stays in the cache of the core, and a large one with few false hits. What is left finds the
//! entries of its key side by side. Lookups are done in batches, a stage at a time and without
//! branches, so that the memory works on many of them at once.

use super::law::Mask;

/// Bits of the small map, as a power of two: one megabyte.
const SMALL: u32 = 23;
/// The bits of a key that the small map reads begin here: the large one reads the highest.
const SMALL_FROM: u32 = 18;
/// Bits of the large map to an entry, as a power of two.
const SPARSE: u32 = 4;
/// Lookups of a batch.
const BATCH: usize = 4096;

/// A walk of the first half.
#[derive(Debug, Clone, Copy, Default)]
pub struct Entry {
    /// The tiles it uses, lower half first: a wide word would take more room.
    mask: [u64; 2],
    /// The low bits of its key.
    tag: u32,
    /// How many of its lines are of the class in question.
    pub alike: u8,
}

impl Entry {
    /// An entry.
    pub fn new(mask: Mask, key: u64, alike: u8) -> Self {
        Self { mask: [mask as u64, (mask >> 64) as u64], tag: key as u32, alike }
    }

    /// The tiles it uses.
    #[inline(always)]
    pub fn mask(&self) -> Mask {
        Mask::from(self.mask[0]) | Mask::from(self.mask[1]) << 64
    }
}

/// A walk of the second half, to look up what goes with it.
#[derive(Debug, Clone, Copy, Default)]
pub struct Query {
    /// The key of what it leaves.
    pub key: u64,
    /// The tiles it uses.
    pub mask: Mask,
    /// How many of its lines are of the class in question.
    pub alike: u8,
}

/// The table.
#[derive(Debug)]
pub struct Table {
    small: Vec<u64>,
    large: Vec<u64>,
    large_shift: u32,
    /// By the highest bits of a key: where its entries begin; one more for the end.
    first: Vec<u32>,
    shift: u32,
    entries: Vec<Entry>,
}

/// Room for a batch of lookups on its way.
#[derive(Debug)]
pub struct Desk {
    queries: Vec<Query>,
    filled: usize,
    ranges: Vec<(u32, u32)>,
    /// Entries to compare, with their query.
    pairs: Vec<(u32, Query)>,
}

impl Default for Desk {
    fn default() -> Self {
        let queries = vec![Query::default(); BATCH];
        Self { queries, filled: 0, ranges: vec![(0, 0); BATCH], pairs: Vec::new() }
    }
}

fn bit(map: &[u64], at: u64) -> usize {
    // The length is a power of two.
    (map[(at >> 6) as usize & (map.len() - 1)] >> (at & 63) & 1) as usize
}

fn small_place(key: u64) -> u64 {
    key >> SMALL_FROM & ((1 << SMALL) - 1)
}

impl Table {
    /// A table of walks with their keys, fewer than 2^32.
    pub fn new(walks: &[(u64, Entry)]) -> Self {
        let bits = walks.len().max(64).next_power_of_two().ilog2();
        let (shift, large_shift) = (u64::BITS - bits, u64::BITS - bits - SPARSE);
        let mut small = vec![0u64; 1 << (SMALL - 6)];
        let mut large = vec![0u64; 1 << (bits + SPARSE - 6)];
        let mut first = vec![0u32; (1 << bits) + 1];
        for &(key, _) in walks {
            first[(key >> shift) as usize] += 1;
            for (map, at) in [(&mut small, small_place(key)), (&mut large, key >> large_shift)] {
                map[(at >> 6) as usize] |= 1 << (at & 63);
            }
        }
        let mut sum = 0;
        for first in &mut first {
            sum += *first;
            *first = sum;
        }
        let mut entries = vec![Entry::default(); walks.len()];
        for &(key, entry) in walks {
            let place = &mut first[(key >> shift) as usize];
            *place -= 1;
            entries[*place as usize] = entry;
        }
        Self { small, large, large_shift, first, shift, entries }
    }
}

impl Desk {
    /// Whether there may be no room for so many more and one that is not real.
    #[inline(always)]
    pub fn is_full(&self, more: usize) -> bool {
        self.filled + more >= BATCH
    }

    /// Puts down a query, or nothing if not `real`.
    #[inline(always)]
    pub fn put(&mut self, query: Query, real: bool) {
        self.queries[self.filled % BATCH] = query;
        self.filled += usize::from(real);
    }

    /// Looks up what lies here, and clears it; `found` is called for every entry with the key of a query, or
    /// with another one that agrees in most bits. Gives the number of lookups.
    pub fn look_up(&mut self, table: &Table, mut found: impl FnMut(&Query, &Entry)) -> u64 {
        let Self { queries, filled, ranges, pairs } = self;
        let count = std::mem::take(filled);
        let kept = retain(&mut queries[..count], |key| bit(&table.small, small_place(key)));
        let kept = retain(&mut queries[..kept], |key| bit(&table.large, key >> table.large_shift));
        let queries = &queries[..kept];
        for (query, range) in queries.iter().zip(ranges.iter_mut()) {
            let at = (query.key >> table.shift) as usize;
            *range = (table.first[at], table.first[at + 1]);
        }
        pairs.clear();
        for (query, &(begin, end)) in queries.iter().zip(ranges.iter()) {
            pairs.extend((begin..end).map(|entry| (entry, *query)));
        }
        let mut kept = 0;
        for at in 0..pairs.len() {
            let (entry, query) = pairs[at];
            pairs[kept] = (entry, query);
            kept += usize::from(table.entries[entry as usize].tag == query.key as u32);
        }
        for (entry, query) in &pairs[..kept] {
            found(query, &table.entries[*entry as usize]);
        }
        count as u64
    }
}

/// Moves the queries whose key gives 1 to the front, without a branch; how many there are.
#[inline(always)]
fn retain(queries: &mut [Query], keep: impl Fn(u64) -> usize) -> usize {
    let mut kept = 0;
    for at in 0..queries.len() {
        let query = queries[at];
        queries[kept] = query;
        kept += keep(query.key);
    }
    kept
}

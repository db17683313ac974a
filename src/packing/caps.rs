//! Counts of dominoes: the most valuable pruning.
//!
//! Every horizontal domino of lattice colors is the top of one window and every vertical domino
//! the left of one. So a packing shows each domino exactly as often as the tiles of the set do:
//! in a complete set `C^2` times, in a compact one `2C` times. What has been used up leaves the
//! candidates. A covering may exceed the counts by its spare cells. (Counting colors as well
//! saves next to nothing: their counts follow from those of the dominoes but for a row.)
//!
//! The caps follow from the law of the set; they only show contradictions earlier (compact
//! C = 3: the first packing comes after under a thousand nodes instead of half a million).
//!
//! The counts of the dominoes that begin with one color are lanes of 16 bits, `W` words of
//! four, each offset so that its top bit says whether there is any left: the candidates are
//! then an AND of two rows and a multiplication that gathers the top bits. Colors are taken
//! modulo `C`, a power of two, which spares the check of an index.

/// Bits of a lane.
const LANE: u32 = 16;
/// Lanes of a word.
const LANES: u32 = u64::BITS / LANE;
/// The top bit of every lane.
const TOP: u64 = 0x8000_8000_8000_8000;
/// Moves the lowest bit of lane `i` to bit `48 + i`.
const GATHER: u64 = 0x0001_0002_0004_0008;
/// What a lane holds when nothing is left.
const NONE: u64 = 0x7fff;
/// The largest count a lane holds.
const MOST: u64 = 0x8000;

/// How often dominoes over up to `C` colors may still occur; `C = 4 * W`, powers of two.
#[derive(Debug, Clone)]
pub struct Caps<const W: usize, const C: usize> {
    /// By west end: the counts for every east end.
    across: [[u64; W]; C],
    /// By the end visited first: the counts for every other end.
    along: [[u64; W]; C],
}

impl<const W: usize, const C: usize> Caps<W, C> {
    /// Counts the dominoes of `tiles`, given as the colors of a window's known corners and free
    /// corner; takes `share.0` of `share.1` of them (a compact set has the same share of the
    /// tiles with any domino), and allows `spare` more of each that occurs.
    pub fn new(
        colors: usize,
        tiles: impl Iterator<Item = [u8; 4]>,
        share: (u64, u64),
        spare: u64,
    ) -> Self {
        let mut counts = [vec![0u64; colors * colors], vec![0u64; colors * colors]];
        for [_, b, c, free] in tiles {
            counts[0][usize::from(c) * colors + usize::from(free)] += 1;
            counts[1][usize::from(b) * colors + usize::from(free)] += 1;
        }
        let rows = |counts: &[u64]| {
            let mut rows = [[0; W]; C];
            for (row, counts) in rows.iter_mut().zip(counts.chunks(colors)) {
                *row = pack(counts, share, spare);
            }
            rows
        };
        Self { across: rows(&counts[0]), along: rows(&counts[1]) }
    }

    /// The colors that may follow as free corner of a window with these known corners.
    #[inline(always)]
    pub fn open(&self, known: [u8; 3]) -> u64 {
        let across = &self.across[usize::from(known[2]) % C];
        let along = &self.along[usize::from(known[1]) % C];
        gather::<W>(|word| across[word] & along[word])
    }

    /// The east ends that horizontal dominoes with this west end may still have.
    pub fn open_across(&self, first: u8) -> u64 {
        gather::<W>(|word| self.across[usize::from(first) % C][word])
    }

    /// The second ends that vertical dominoes with this first end may still have.
    pub fn open_along(&self, first: u8) -> u64 {
        gather::<W>(|word| self.along[usize::from(first) % C][word])
    }

    /// How often a horizontal domino may still occur.
    pub fn left_across(&self, first: u8, second: u8) -> u64 {
        left(&self.across[usize::from(first) % C], second)
    }

    /// How often a vertical domino may still occur.
    pub fn left_along(&self, first: u8, second: u8) -> u64 {
        left(&self.along[usize::from(first) % C], second)
    }

    /// Whether a horizontal domino may occur once more.
    pub fn has_across(&self, first: u8, second: u8) -> bool {
        has(&self.across[usize::from(first) % C], second)
    }

    /// Whether a vertical domino may occur once more.
    pub fn has_along(&self, first: u8, second: u8) -> bool {
        has(&self.along[usize::from(first) % C], second)
    }

    /// Counts a horizontal domino; whether there was one left.
    #[inline(always)]
    pub fn take_across(&mut self, first: u8, second: u8) -> bool {
        take(&mut self.across[usize::from(first) % C], second)
    }

    /// Takes back a horizontal domino; true.
    #[inline(always)]
    pub fn release_across(&mut self, first: u8, second: u8) -> bool {
        release(&mut self.across[usize::from(first) % C], second)
    }

    /// Counts a vertical domino, the end visited first coming first; whether there was one left.
    #[inline(always)]
    pub fn take_along(&mut self, first: u8, second: u8) -> bool {
        take(&mut self.along[usize::from(first) % C], second)
    }

    /// Takes back a vertical domino; true.
    #[inline(always)]
    pub fn release_along(&mut self, first: u8, second: u8) -> bool {
        release(&mut self.along[usize::from(first) % C], second)
    }
}

/// The colors in whose lane the top bit is set.
#[inline(always)]
fn gather<const W: usize>(row: impl Fn(usize) -> u64) -> u64 {
    let mut colors = 0;
    for word in 0..W {
        let tops = (row(word) & TOP) >> (LANE - 1);
        let low = tops.wrapping_mul(GATHER) >> (u64::BITS - LANE) & 0xf;
        colors |= low << (LANES as usize * word);
    }
    colors
}

/// The word and the shift of the lane of a color.
#[inline(always)]
fn lane<const W: usize>(color: u8) -> (usize, u32) {
    let color = u32::from(color);
    ((color / LANES) as usize & (W - 1), LANE * (color % LANES))
}

#[inline(always)]
fn has<const W: usize>(row: &[u64; W], color: u8) -> bool {
    let (word, shift) = lane::<W>(color);
    row[word] >> shift & 1 << (LANE - 1) != 0
}

fn left<const W: usize>(row: &[u64; W], color: u8) -> u64 {
    let (word, shift) = lane::<W>(color);
    (row[word] >> shift & ((1 << LANE) - 1)).saturating_sub(NONE)
}

#[inline(always)]
fn take<const W: usize>(row: &mut [u64; W], color: u8) -> bool {
    let (word, shift) = lane::<W>(color);
    let left = has(row, color);
    row[word] = row[word].wrapping_sub(1 << shift);
    left
}

#[inline(always)]
fn release<const W: usize>(row: &mut [u64; W], color: u8) -> bool {
    let (word, shift) = lane::<W>(color);
    row[word] = row[word].wrapping_add(1 << shift);
    true
}

fn pack<const W: usize>(counts: &[u64], (share, of): (u64, u64), spare: u64) -> [u64; W] {
    let mut row = [0; W];
    for (color, &count) in counts.iter().enumerate() {
        let count = if count > 0 { count * share / of + spare } else { 0 };
        let (word, shift) = lane::<W>(color as u8);
        row[word] |= (NONE + count.min(MOST)) << shift;
    }
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_down_to_nothing_and_back() {
        let tiles = (0..5u8).flat_map(|free| (0..3).map(move |_| [0, 1, 2, free]));
        let mut caps = Caps::<2, 8>::new(5, tiles, (1, 1), 0);
        let known = [0, 1, 2];
        assert_eq!(caps.open(known), 0b11111);
        for round in 0..3 {
            assert!(caps.take_across(2, 4) && caps.take_along(1, 4), "{round}");
        }
        assert_eq!(caps.open(known), 0b01111);
        assert!(!caps.take_across(2, 4));
        caps.release_across(2, 4);
        caps.release_along(1, 4);
        caps.release_across(2, 4);
        assert_eq!(caps.open(known), 0b11111);
        assert_eq!(caps.open([0, 0, 2]), 0);
    }

    #[test]
    fn many_colors() {
        let tiles = (0..64u8).map(|free| [0, free, free, 63 - free]);
        let caps = Caps::<16, 64>::new(64, tiles, (1, 1), 0);
        for color in 0..64 {
            assert_eq!(caps.open([0, color, color]), 1 << (63 - color));
        }
    }
}

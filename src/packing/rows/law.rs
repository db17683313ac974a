//! What part of a packing uses, and when two parts go together.
//!
//! The tiles that may occur are numbered class by class, so a set of them is a mask in one wide
//! word. Of an exact set every tile is a class of its own and is needed once; of a compact set a
//! class is the `C` tiles that share (NW, SW, SE), and two are needed. Parts go together when
//! they share no tile and use no class more often than needed; they make up a packing when
//! besides every cell is filled.
//!
//! Each class has a random *weight*, and the weights of what a part uses add up to its *key*:
//! what it leaves has the key of everything less its own. Equal keys are only a hint; the masks
//! decide.

use crate::tiles::{Kind, TileId, TileSet};
use std::collections::HashMap;

/// A set of tiles, by their numbers.
pub type Mask = u128;

/// What a set demands.
#[derive(Debug, Clone)]
pub struct Law {
    numbers: HashMap<TileId, u32>,
    /// Tiles of a class: side by side in the mask.
    size: u32,
    /// How many of them are needed.
    need: u32,
    classes: u32,
    /// The lowest tile of every class.
    lowest: Mask,
    /// The letter of a pattern in a class, less one: only patterns that may occur have one.
    offset: Vec<u8>,
    /// The patterns that have a letter, in order.
    patterns: Vec<u32>,
}

impl Law {
    /// The law of a set of corner tiles, at most [`super::MOST_TILES`] of which may occur.
    pub fn new(set: &TileSet) -> Self {
        let colors = set.colors();
        let compact = set.is_compact();
        let mut tiles: Vec<TileId> = set.allowed().collect();
        let class = |&tile: &TileId| {
            let [ne, se, sw, nw] = Kind::Corner.unpack(tile, colors);
            (nw, sw, se, ne)
        };
        tiles.sort_by_key(class);
        let numbers = tiles.iter().enumerate().map(|(number, &tile)| (tile, number as u32));
        let (size, need) = if compact { (colors.horizontal() as u32, 2) } else { (1, 1) };
        let classes = tiles.len() as u32 / size.max(1);
        let lowest = (0..classes).fold(0, |mask, class| mask | 1 << (class * size));
        let may_occur = |pattern: &u32| (1..=need).contains(&pattern.count_ones());
        let patterns: Vec<u32> = (0..1u32 << size).filter(may_occur).collect();
        let mut offset = vec![u8::MAX; 1 << size];
        for (at, &pattern) in patterns.iter().enumerate() {
            offset[pattern as usize] = at as u8;
        }
        let numbers = numbers.collect();
        Self { numbers, size, need, classes, lowest, offset, patterns }
    }

    /// The mask of a tile; `None` when the set has no such tile.
    pub fn tile(&self, tile: TileId) -> Option<Mask> {
        self.numbers.get(&tile).map(|&number| 1 << number)
    }

    /// What two parts use together, if they go together.
    #[inline(always)]
    pub fn join(&self, one: Mask, other: Mask) -> Option<Mask> {
        let both = one | other;
        (one & other == 0 && !self.is_crowded(both)).then_some(both)
    }

    /// Whether more tiles of a class are used than needed, where they are at most one more.
    #[inline(always)]
    fn is_crowded(&self, mask: Mask) -> bool {
        // A class has at most one tile more than needed: see `super::MOST_TILES`.
        let whole = (0..self.size).fold(self.lowest, |all, tile| all & mask >> tile);
        self.size > self.need && whole != 0
    }

    /// How many tiles of every class are used.
    fn uses(&self, mask: Mask) -> impl Iterator<Item = (u32, u32)> {
        let bits = (1 << self.size) - 1;
        (0..self.classes).map(move |class| (class, (mask >> (class * self.size)) as u32 & bits))
    }

    /// The key of a part.
    pub fn key(&self, mask: Mask) -> u64 {
        let add = |sum: u64, (class, pattern): (u32, u32)| {
            sum.wrapping_add(weight(class).wrapping_mul(pattern.count_ones().into()))
        };
        self.uses(mask).fold(0, add)
    }

    /// The key of a packing.
    pub fn whole(&self) -> u64 {
        let add = |sum: u64, class| sum.wrapping_add(weight(class).wrapping_mul(self.need.into()));
        (0..self.classes).fold(0, add)
    }

    /// Number of letters.
    pub fn alphabet(&self) -> usize {
        self.classes as usize * self.patterns.len()
    }

    /// Writes the letters of a part: what it uses, class by class. A letter is a class together
    /// with a pattern, so parts go together if no two of their letters are in conflict.
    pub fn letters(&self, mask: Mask, letters: &mut [u8]) {
        let (bits, count) = ((1 << self.size) - 1, self.patterns.len() as u32);
        let mut left = mask;
        for letter in letters {
            if left == 0 {
                return;
            }
            let class = left.trailing_zeros() / self.size;
            let pattern = (left >> (class * self.size)) as u32 & bits;
            left &= !(Mask::from(bits) << (class * self.size));
            *letter = (class * count) as u8 + self.offset[pattern as usize];
        }
    }

    /// The letters in conflict with a letter, itself among them.
    pub fn conflicts(&self, letter: u8) -> impl Iterator<Item = u8> {
        let count = self.patterns.len();
        let (first, at) = (usize::from(letter) / count * count, usize::from(letter) % count);
        let pattern = self.patterns[at];
        let conflict =
            move |other: u32| pattern & other != 0 || (pattern | other).count_ones() > self.need;
        let others = self.patterns.iter().enumerate();
        others.filter(move |&(_, &other)| conflict(other)).map(move |(at, _)| (first + at) as u8)
    }
}

/// The weight of a class: fixed, and without order.
fn weight(class: u32) -> u64 {
    let mix = |x: u64, by: u32, times: u64| (x ^ x >> by).wrapping_mul(times);
    let x = (u64::from(class) + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let x = mix(x, 30, 0xbf58_476d_1ce4_e5b9);
    let x = mix(x, 27, 0x94d0_49bb_1331_11eb);
    x ^ x >> 31
}

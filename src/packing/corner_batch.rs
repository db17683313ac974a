//! Batches of partial corner packings, each in a few words.
//!
//! Lines (rows, or columns) are filled one after the other. What is still to come at a cell
//! depends on little: the tiles free, the dominoes left, the colors of the last two lines (for
//! the seams) and those of the first. That is a [`Node`]. Colors are pairs of bits. Around the
//! cell to be filled, called `c`:
//!
//! ```text
//!    f' ... d b        first colors of their lines f', f; the line behind is d b;
//!    f  ... a c        beside c is a
//! ```
//!
//! A window is the tile `dbac`, read as a number; what row and column order, or rows upward,
//! make of that is settled when a node is written down ([`Kernel::new`]). First come the colors
//! that the window, the domino `ac` and the domino `bc` allow, for all nodes of a handful, as a
//! list of parents and tiles; then all children in one loop. Neither has a branch that depends
//! on a node. At the end of a line and in the last line a cell closes more windows; there the
//! children that break a law are written and not counted.

use crate::search::batch::{self, HANDFUL};

/// Bits of a count of dominoes, which is offset so that the top bit says whether there is any.
const LANE: u32 = 5;
/// What a lane holds when nothing is left.
const NONE: u32 = 15;
/// The most a lane counts.
pub(super) const MOST_DOMINOES: u64 = 16;
/// The longest line: the colors of two lines are one word.
pub(super) const LONGEST_LINE: usize = 16;
/// The top bits of four lanes, and what moves that of lane `i` to bit `16 + i`.
const TOP: u32 = 1 << 4 | 1 << 9 | 1 << 14 | 1 << 19;
const GATHER: u64 = 1 << 12 | 1 << 8 | 1 << 4 | 1;
/// The tiles of a window whose third corner is `c`, and what moves that of color `i` from bit
/// `4 i` to bit `12 + i`; the same for the second corner, from bit `16 i` to bit `48 + i`.
const THIRD: (u64, u64) = (0x1111, 1 << 12 | 1 << 9 | 1 << 6 | 1 << 3);
const SECOND: (u64, u64) = (0x0001_0001_0001_0001, 1 << 48 | 1 << 33 | 1 << 18 | 1 << 3);
/// Room for the children of a handful, four each, and four more.
const LIST: usize = 4 * HANDFUL + 4;

/// The most colors; colors that do not occur have no tiles and no dominoes.
pub(super) const COLORS: usize = 4;

/// What is known at a node.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Node {
    /// By `d`: the tiles that may be placed.
    pub(super) free: [u64; COLORS],
    /// By `a`: counts of the dominoes `ac`.
    pub(super) beside: [u32; COLORS],
    /// By `b`: counts of the dominoes `bc`.
    pub(super) behind: [u32; COLORS],
    /// The colors chosen, the last one on top.
    pub(super) past: u64,
    /// The colors of the first line, from the lowest bits on.
    pub(super) first: u32,
}

impl Node {
    /// A lane that counts so many.
    pub(super) fn lane(color: usize, count: u64) -> u32 {
        (NONE + count.min(MOST_DOMINOES) as u32) << (LANE * color as u32)
    }

    #[inline(always)]
    fn take_beside(&mut self, a: usize, c: usize) -> bool {
        take_domino(&mut self.beside[a % COLORS], c)
    }

    #[inline(always)]
    fn take_behind(&mut self, b: usize, c: usize) -> bool {
        take_domino(&mut self.behind[b % COLORS], c)
    }
}

#[inline(always)]
fn take_domino(row: &mut u32, color: usize) -> bool {
    let shift = LANE * color as u32;
    let left = *row >> shift & (NONE + 1) != 0;
    *row = row.wrapping_sub(1 << shift);
    left
}

/// Where a level is.
#[derive(Debug, Clone, Copy)]
struct Place {
    /// Position in its line.
    position: usize,
    /// Whether the line is the last one.
    last: bool,
}

/// Makes the children of nodes.
#[derive(Debug, Clone)]
pub(super) struct Kernel {
    /// By level.
    places: Vec<Place>,
    /// Cells of a line.
    length: usize,
    law: Law,
    /// Whether two tiles of every `dba` are placed instead of each tile once.
    pairs: bool,
    /// Parents and tiles.
    list: Box<[u32; LIST]>,
}

/// By the colors of a cell: these, one after the other, and their number.
const CHOICES: [([u32; 4], u32); 16] = choices();

const fn choices() -> [([u32; 4], u32); 16] {
    let mut choices = [([0; 4], 0); 16];
    let mut set = 0;
    while set < 16 {
        let (mut color, mut count) = (0, 0);
        while color < 4 {
            if set >> color & 1 == 1 {
                choices[set].0[count as usize] = color;
                count += 1;
            }
            color += 1;
        }
        choices[set].1 = count;
        set += 1;
    }
    choices
}

impl Kernel {
    /// For lines of so many cells, of which all but the last `levels` of `cells` are chosen
    /// before level 0.
    pub(super) fn new(
        length: usize,
        cells: usize,
        levels: usize,
        allowed: [u64; COLORS],
        pairs: bool,
    ) -> Self {
        let place = |at: usize| Place { position: at % length, last: at + length >= cells };
        let places = (cells - levels..cells).map(place).collect();
        Self { places, length, law: Law(allowed), pairs, list: Box::new([0; LIST]) }
    }

    #[inline(always)]
    fn step<const START: bool, const END: bool, const LAST: bool, const PAIRS: bool>(
        &mut self,
        position: usize,
        nodes: &[Node],
        children: &mut [Node],
    ) -> usize {
        // The shift of `d` and `b` in the past.
        let behind = (62 - 2 * self.length) as u32;
        let list = &mut *self.list;
        let mut count = 0;
        for (parent, node) in nodes.iter().enumerate() {
            let db = (node.past >> behind) as usize % 16;
            let (d, b) = if START { (0, db >> 2) } else { (db % 4, db >> 2) };
            let a = if START { 0 } else { (node.past >> 62) as usize };
            let beside = if START { TOP } else { node.beside[a] };
            let dominoes = u64::from(node.behind[b] & beside & TOP);
            let mut colors = ((dominoes * GATHER) >> 16) as usize;
            if !START {
                colors &= (node.free[d] >> (b << 4 | a << 2)) as usize;
            }
            // Of the other windows those that are told by `c` alone make a sieve.
            let color = |back: usize| (node.past >> (64 - 2 * back)) as usize & 3;
            if END {
                let (f, before) = (color(self.length - 1), color(2 * self.length - 1));
                let tiles = node.free[b] >> (before << 4 | f) & THIRD.0;
                colors &= (tiles.wrapping_mul(THIRD.1) >> 12) as usize;
            }
            if LAST && !START {
                let tiles = node.free[a] >> ((node.first >> (2 * position - 2) & 3) * 4);
                let tiles = tiles >> (node.first >> (2 * position) & 3) & SECOND.0;
                colors &= (tiles.wrapping_mul(SECOND.1) >> 48) as usize;
            }
            let (quad, number) = &CHOICES[colors % 16];
            let base = (parent << 8 | d << 6 | b << 4 | a << 2) as u32;
            for (to, color) in list[count..count + 4].iter_mut().zip(quad) {
                *to = base + color;
            }
            count += *number as usize;
        }
        let (list, simple) = (&list[..count], !(END || LAST));
        if simple {
            for (child, &pair) in children.iter_mut().zip(list) {
                *child = nodes[pair as usize >> 8];
                self.law.fill::<START, PAIRS>(child, pair as usize);
            }
            return count;
        }
        let mut made = 0;
        for &pair in list {
            let parent = &nodes[pair as usize >> 8];
            let (past, first) = (parent.past, parent.first as usize);
            let child = &mut children[made];
            *child = *parent;
            self.law.fill::<START, PAIRS>(child, pair as usize);
            let (b, a, c) = (pair as usize >> 4 & 3, pair as usize >> 2 & 3, pair as usize & 3);
            let color = |back: usize| (past >> (64 - 2 * back)) as usize & 3;
            let mut fits = true;
            if END {
                let (f, before) = (color(self.length - 1), color(2 * self.length - 1));
                fits &= child.take_beside(c, f);
                fits &= self.law.take::<PAIRS>(child, b, before << 4 | c << 2 | f);
            }
            if LAST {
                let below = first >> (2 * position) & 3;
                fits &= child.take_behind(c, below);
                if !START {
                    let beside = first >> (2 * position - 2) & 3;
                    fits &= self.law.take::<PAIRS>(child, a, c << 4 | beside << 2 | below);
                }
                if END {
                    let f = color(self.length - 1);
                    let tile = f << 4 | below << 2 | first & 3;
                    fits &= self.law.take::<PAIRS>(child, c, tile);
                }
            }
            made += usize::from(fits);
        }
        made
    }

    #[inline(never)]
    fn inner<const PAIRS: bool>(
        &mut self,
        position: usize,
        nodes: &[Node],
        children: &mut [Node],
    ) -> usize {
        self.step::<false, false, false, PAIRS>(position, nodes, children)
    }

    #[inline(never)]
    fn seam<const PAIRS: bool>(
        &mut self,
        place: Place,
        nodes: &[Node],
        children: &mut [Node],
    ) -> usize {
        let at = place.position;
        match (at == 0, at + 1 == self.length, place.last) {
            (true, _, false) => self.step::<true, false, false, PAIRS>(at, nodes, children),
            (true, _, true) => self.step::<true, false, true, PAIRS>(at, nodes, children),
            (_, true, false) => self.step::<false, true, false, PAIRS>(at, nodes, children),
            (_, true, true) => self.step::<false, true, true, PAIRS>(at, nodes, children),
            (_, _, last) => {
                debug_assert!(last);
                self.step::<false, false, true, PAIRS>(at, nodes, children)
            }
        }
    }
}

/// By `d` the tiles of the set: the law.
#[derive(Debug, Clone, Copy)]
struct Law([u64; COLORS]);

impl Law {
    /// Fills the cell, but for what it closes at seams, with the last of the colors `dbac`.
    #[inline(always)]
    fn fill<const START: bool, const PAIRS: bool>(&self, child: &mut Node, dbac: usize) {
        let (d, b, a, c) = (dbac >> 6 & 3, dbac >> 4 & 3, dbac >> 2 & 3, dbac & 3);
        child.past = child.past >> 2 | (c as u64) << 62;
        child.take_behind(b, c);
        if !START {
            child.take_beside(a, c);
            self.take::<PAIRS>(child, d, dbac % 64);
        }
    }

    /// Places a tile, named by `d` and the rest; whether it could be.
    #[inline(always)]
    fn take<const PAIRS: bool>(&self, node: &mut Node, d: usize, tile: usize) -> bool {
        let free = &mut node.free[d % COLORS];
        let was_free = *free >> tile & 1 == 1;
        *free &= !(1 << tile);
        if PAIRS {
            // The second tile of a row closes it.
            let row = 15 << (tile & 60);
            let fresh = (*free | 1 << tile) & row == self.0[d % COLORS] & row;
            *free &= if fresh { u64::MAX } else { !row };
        }
        was_free
    }
}

impl batch::Kernel for Kernel {
    type Node = Node;

    fn most(&self) -> usize {
        COLORS
    }

    fn expand(&mut self, level: usize, nodes: &[Node], children: &mut [Node]) -> usize {
        let place = self.places[level];
        let inner = place.position > 0 && place.position + 1 < self.length && !place.last;
        match (inner, self.pairs) {
            (true, false) => self.inner::<false>(place.position, nodes, children),
            (true, true) => self.inner::<true>(place.position, nodes, children),
            (false, false) => self.seam::<false>(place, nodes, children),
            (false, true) => self.seam::<true>(place, nodes, children),
        }
    }
}

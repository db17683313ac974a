//! Batches of partial Wang packings over two colors, each in one word.
//!
//! Lines (columns, or rows) are filled one after the other. What is still to come at a cell
//! depends on little: the tiles free, and the colors shown to it. The sides of a tile are called
//! `p` and `r` (to the cell before and after in the line), `q` and `s` (to the line behind and
//! ahead). Tiles with the same `p` and `q` are a *group* of four; inside a line a cell takes
//! tiles of one group, told by its neighbors, less those that fail at the end of a line or of
//! the torus. By group and the set of tiles left there a table holds what tells each child from
//! its parent; so up to four children are written by adding, without a branch that depends on a
//! node, and the next parent writes over those that are none.

use crate::search::batch;

/// The longest line.
pub(super) const LONGEST_LINE: usize = 16;

/// What is known at a node. From the lowest bits on: by tile whether it may be placed; for the
/// last 16 cells their `s`, the last one on top; for the first line, from its first cell on, `q`;
/// `r` of the cell before; `p` of the cell that the line began with.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Node(u64);

/// Where the parts of a node begin, and where the past ends.
const PAST: u32 = 16;
const FIRST: u32 = 32;
const BEFORE: u32 = 48;
const BEGIN: u32 = 49;

/// The bit of a tile with sides `p`, `q`, `r`, `s`.
fn bit([p, q, r, s]: [u8; 4]) -> u32 {
    u32::from(p << 3 | q << 2 | r << 1 | s)
}

impl Node {
    /// The tiles open, and the sides of cells chosen: the last 16, the last one last; those of
    /// the first line; and that with which the line of the last began.
    pub(super) fn new(
        open: impl Iterator<Item = [u8; 4]>,
        past: impl DoubleEndedIterator<Item = [u8; 4]>,
        first: impl Iterator<Item = [u8; 4]>,
        begin: [u8; 4],
    ) -> Self {
        let mut node = open.fold(0, |free, sides| free | 1 << bit(sides));
        for (back, [_, _, r, s]) in past.rev().enumerate() {
            node |= u64::from(s) << (FIRST - 1 - back as u32);
            node |= if back == 0 { u64::from(r) << BEFORE } else { 0 };
        }
        for (at, [_, q, _, _]) in first.enumerate() {
            node |= u64::from(q) << (FIRST + at as u32);
        }
        Self(node | u64::from(begin[0]) << BEGIN)
    }
}

/// Where a level is.
#[derive(Debug, Clone, Copy)]
struct Place {
    /// Position in its line.
    position: usize,
    /// Whether the line is the last one.
    last: bool,
}

/// By tiles of a group: what is to be added to the node of a parent, one tile after the other,
/// and the number of tiles.
type Row = ([u64; 4], usize);

/// Makes the children of nodes.
#[derive(Debug, Clone)]
pub(super) struct Kernel {
    /// By level.
    places: Vec<Place>,
    length: usize,
    /// By `p` and `q`, and by the tiles of the group that fit.
    rows: Box<[[Row; 16]; 4]>,
}

/// Of the tiles of a group those that show color 0 as `r`, and as `s`.
const WITH_R: u64 = 0b0011;
const WITH_S: u64 = 0b0101;

impl Kernel {
    /// For lines of so many cells, of which all but the last `levels` of `cells` are chosen
    /// before level 0.
    pub(super) fn new(length: usize, cells: usize, levels: usize) -> Self {
        let place = |at: usize| Place { position: at % length, last: at + length >= cells };
        let mut rows = Box::new([[([0; 4], 0); 16]; 4]);
        for (group, rows) in rows.iter_mut().enumerate() {
            for (set, (list, count)) in rows.iter_mut().enumerate() {
                for tile in (0..4u64).filter(|tile| set >> tile & 1 == 1) {
                    let shown = tile >> 1 << BEFORE | (tile & 1) << (FIRST - 1);
                    list[*count] = shown.wrapping_sub(1 << (4 * group as u64 + tile));
                    *count += 1;
                }
            }
        }
        Self { places: (cells - levels..cells).map(place).collect(), length, rows }
    }

    #[inline(always)]
    fn step<const START: bool, const END: bool, const LAST: bool>(
        &self,
        position: usize,
        nodes: &[Node],
        children: &mut [Node],
    ) -> usize {
        let behind = FIRST - self.length as u32;
        let below = FIRST + position as u32;
        let mut made = 0;
        for &Node(node) in nodes {
            let q = node >> behind & 1;
            let mut fitting = 0b1111;
            if END {
                fitting &= WITH_R << ((node >> BEGIN & 1) * 2);
            }
            if LAST {
                fitting &= WITH_S << (node >> below & 1);
            }
            // The oldest of the past makes room for the newest, `before` is set anew.
            let past = node >> 1 & 0x7fff << PAST;
            let kept = node & !(0xffff << PAST | 1 << BEFORE) | past;
            let mut write = |p: u64, kept: u64| {
                let group = (p << 1 | q) as usize;
                let tiles = node >> (4 * group) & fitting;
                let (row, count) = &self.rows[group % 4][tiles as usize % 16];
                for (child, change) in children[made..made + 4].iter_mut().zip(row) {
                    *child = Node(kept.wrapping_add(*change));
                }
                made += count;
            };
            if START {
                write(0, kept & !(1 << BEGIN));
                write(1, kept | 1 << BEGIN);
            } else {
                write(node >> BEFORE & 1, kept);
            }
        }
        made
    }
}

impl batch::Kernel for Kernel {
    type Node = Node;

    fn most(&self) -> usize {
        8
    }

    fn expand(&mut self, level: usize, nodes: &[Node], children: &mut [Node]) -> usize {
        let Place { position, last } = self.places[level];
        match (position == 0, position + 1 == self.length, last) {
            (true, _, false) => self.step::<true, false, false>(position, nodes, children),
            (true, _, true) => self.step::<true, false, true>(position, nodes, children),
            (_, false, false) => self.step::<false, false, false>(position, nodes, children),
            (_, true, false) => self.step::<false, true, false>(position, nodes, children),
            (_, false, true) => self.step::<false, false, true>(position, nodes, children),
            (_, true, true) => self.step::<false, true, true>(position, nodes, children),
        }
    }
}

//! Sprints of the search for Wang packings, with everything at hand in registers.
//!
//! What a cell takes is known, but for the choice at the level before, as soon as that level is
//! reached: so the way from a tile chosen to the candidates after it is one load and one AND,
//! and a tile that leaves none is never placed. A tile placed writes what it asks of a later
//! neighbor straight into that cell's *inbox*, nearly always one word for the cell to the south;
//! nothing has to be taken back. The free tiles travel by value.
//!
//! Invariant: an inbox is read only after the neighbors it is for have written to it, or had
//! been placed before the sprint. In the end the choices are pushed the ordinary way, so that
//! [`Wang`] itself stands where the sprint ended.

use super::table::Table;
use super::wang::Wang;
use super::wang_plan::NEIGHBORS;
use super::wang_rule::WangRule;
use crate::search::{Alternatives, Problem, Sprint, Stretch, Words};

/// The relation of two cells one after the other that are not neighbors; others are the side,
/// in the order N, E, S, W, by which the later touches the earlier.
const APART: usize = 4;
/// Room for all relations, a power of two.
const RELATIONS: usize = 8;
/// Words of an inbox, a power of two.
const INBOX: usize = 4;
/// A tile writes no more letters than this.
const LETTERS: usize = 3;
/// Levels below which a sprint is not worth its while.
const FEWEST: usize = 3;

/// Where a tile writes what it asks, in one number: the level of the inbox, the place there
/// (what is written is also asked by all before it), and the side of the tile, N, E, S, W.
#[derive(Debug, Clone, Copy, Default)]
struct Letter(u32);

impl Letter {
    fn new(level: usize, at: u8, side: usize) -> Self {
        Self((level << 4 | usize::from(at) << 2 | side) as u32)
    }

    #[inline(always)]
    fn level(self) -> usize {
        (self.0 >> 4) as usize
    }

    #[inline(always)]
    fn at(self) -> usize {
        (self.0 >> 2) as usize % INBOX
    }

    #[inline(always)]
    fn side(self) -> usize {
        self.0 as usize % 4
    }
}

/// What is fixed about a level.
#[derive(Debug, Clone, Copy)]
struct Post {
    letters: [Letter; LETTERS],
    /// How many letters its tile writes.
    count: u8,
    /// Where the last letter to it stands in its inbox.
    last: u8,
    /// The relation of the next cell to this one.
    relation: u8,
}

/// What is kept of a level on the way down.
#[derive(Debug, Clone, Copy)]
struct Frame<const N: usize> {
    /// Candidates not yet tried.
    here: Words<N>,
    /// Tiles free.
    free: Words<N>,
    /// Of these those the next cell takes, whatever is chosen here.
    next: Words<N>,
    relation: usize,
}

/// The tables of sprints.
#[derive(Debug, Clone)]
pub(super) struct Track<const N: usize, const L: usize> {
    posts: Table<Post, L>,
    /// By level: first the tiles that may ever stand there, then of these those that neighbors
    /// placed before the last level ask as well, one after the other.
    inboxes: Table<[Words<N>; INBOX], L>,
    frames: Table<Frame<N>, L>,
    /// By tile and relation: the tiles left to the next cell.
    leaves: Table<[Words<N>; RELATIONS], L>,
}

impl<const N: usize, const L: usize> Track<N, L> {
    /// For by level the tiles that may ever stand there and the slots of the neighbors placed
    /// before; `None` where two cells one after the other touch on two sides.
    pub(super) fn new(partners: &[[Words<N>; 4]], steps: &[(Words<N>, [u32; 4])]) -> Option<Self> {
        let letters = [Letter::default(); LETTERS];
        let blank = Post { relation: APART as u8, count: 0, letters, last: 0 };
        let mut posts = vec![blank; steps.len()];
        for (level, (_, neighbors)) in steps.iter().enumerate() {
            let mut before: Vec<(usize, usize)> =
                neighbors.iter().map(|&from| from as usize).zip(0..).collect();
            before.retain(|&(from, _)| from < level);
            before.sort_unstable();
            for (from, side) in before {
                let post = &mut posts[from];
                if from + 1 == level {
                    if post.relation != APART as u8 {
                        return None;
                    }
                    post.relation = side as u8;
                    continue;
                }
                let at = posts[level].last + 1;
                let count = usize::from(posts[from].count);
                if usize::from(at) == INBOX || count == LETTERS {
                    return None;
                }
                posts[level].last = at;
                posts[from].letters[count] = Letter::new(level, at, NEIGHBORS[side].2);
                posts[from].count += 1;
            }
        }
        let inboxes = steps.iter().map(|&(ever, _)| [ever; INBOX]).collect();
        let row = |(tile, asked): (usize, &[Words<N>; 4])| {
            std::array::from_fn(|relation| {
                let asked = NEIGHBORS.get(relation).map(|&(_, _, touching)| asked[touching]);
                let mut leaves = asked.unwrap_or(Words::ALL);
                leaves.remove(tile as u32);
                leaves
            })
        };
        let leaves = partners.iter().enumerate().map(row).collect();
        Some(Self {
            posts: Table::new(posts, blank),
            inboxes: Table::new(inboxes, [Words::EMPTY; INBOX]),
            frames: Table::new(
                Vec::new(),
                Frame {
                    here: Words::EMPTY,
                    free: Words::EMPTY,
                    next: Words::EMPTY,
                    relation: APART,
                },
            ),
            leaves: Table::new(leaves, [Words::EMPTY; RELATIONS]),
        })
    }

    /// The tiles that the cell of a level takes, whatever is chosen at the level before.
    #[inline(always)]
    fn takes(&self, level: usize) -> Words<N> {
        self.inboxes[level][usize::from(self.posts[level].last) % INBOX]
    }

    /// Writes what the tile of a level asks of later neighbors.
    #[inline(always)]
    fn write(&mut self, level: usize, asked: &[Words<N>; 4]) {
        let Post { letters: [first, second, third], count, .. } = self.posts[level];
        if count > 0 {
            self.deliver(first, asked);
        }
        if count > 1 {
            self.deliver(second, asked);
        }
        if count > 2 {
            self.deliver(third, asked);
        }
    }

    #[inline(always)]
    fn deliver(&mut self, letter: Letter, asked: &[Words<N>; 4]) {
        let inbox = &mut self.inboxes[letter.level()];
        inbox[letter.at()] = inbox[(letter.at() + INBOX - 1) % INBOX] & asked[letter.side()];
    }
}

impl<const N: usize, const L: usize, R: WangRule<N>, const QUOTIENT: bool> Wang<N, L, R, QUOTIENT> {
    /// Walks a stretch; `None` when that is left to the walk.
    pub(super) fn run(&mut self, stretch: Stretch<'_, Words<N>>) -> Option<Sprint> {
        let Stretch { level: base, choices, left, budget, counts } = stretch;
        let levels = choices.len();
        // While the order of colors is open it takes part in every choice.
        let open = self.ordered && self.used[base] != self.all_used;
        if base + FEWEST > levels || open {
            return None;
        }
        let track = self.track.as_deref_mut()?;
        let partners = &self.partners;
        // What has been placed before.
        for level in 0..base {
            track.write(level, &self.slots[level].asked);
        }
        let (mut nodes, mut solutions) = (0, 0);
        let (mut level, mut deepest) = (base, base);
        let (mut here, mut free) = (left[base], self.rule.open(base));
        let mut next = free & track.takes(base + 1);
        let mut relation = usize::from(track.posts[base].relation);
        'arrived: while nodes < budget {
            deepest = deepest.max(level + 1);
            loop {
                nodes += 1;
                let tile = here.first();
                here.remove(tile);
                let after = next & track.leaves[tile as usize][relation % RELATIONS];
                if !after.is_empty() {
                    choices[level] = tile;
                    track.frames[level] = Frame { here, free, next, relation };
                    level += 1;
                    if level + 1 < levels {
                        track.write(level - 1, &partners[tile as usize]);
                        free.remove(tile);
                        (here, next) = (after, free & track.takes(level + 1));
                        relation = usize::from(track.posts[level].relation);
                        continue 'arrived;
                    }
                    let count = u64::from(after.count());
                    if !counts || nodes + count > budget {
                        here = after;
                        break 'arrived;
                    }
                    (nodes, solutions, deepest) = (nodes + count, solutions + count, levels);
                    level -= 1;
                }
                while here.is_empty() {
                    if level == base {
                        break 'arrived;
                    }
                    level -= 1;
                    Frame { here, free, next, relation } = track.frames[level];
                }
                if nodes == budget {
                    break 'arrived;
                }
            }
        }
        for (at, left) in left.iter_mut().enumerate().take(level).skip(base) {
            *left = track.frames[at].here;
        }
        left[level] = here;
        for (at, &choice) in choices.iter().enumerate().take(level).skip(base) {
            self.push(at, choice);
        }
        Some(Sprint { level, nodes, solutions, deepest })
    }
}

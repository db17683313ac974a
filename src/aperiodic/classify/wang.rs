//! All sets of n Wang tiles, each decided.
//!
//! **What is counted.** Sets of n different tiles of which no tile is useless at first sight:
//! with labels as vertices, every tile is an arc from W to E of one graph and from N to S of
//! another one, and every arc of both lies on a cycle. Sets that differ in the names of labels
//! only are the same (N and S have names of their own, E and W others); what else is the same,
//! [`UpTo`] says.
//!
//! **How.** Such a set is a matching of the arcs of two graphs, up to the automorphisms of both:
//! a double coset of permutations. For every pair of graphs the permutations are gone through; of
//! a double coset the first one is kept and the others are marked. So nothing is kept beyond a
//! pair of graphs, and pairs are independent: part R of M takes every M-th pair.
//!
//! A reflection reverses all arcs of one graph. So up to the symmetries of the square a graph and
//! its reverse count as one, and what maps a graph to its reverse is a symmetry of it like an
//! automorphism. Rows for columns exchanges the graphs; for two equal graphs that is the inverse
//! permutation.

use super::graphs::{Arcs, graphs, reversed};
use super::permutations::{MOST, Permutations};
use super::quick::Quick;
use crate::aperiodic::decide::{Bounds, Tile, Verdict, decide};
use crate::search::Stop;
use rayon::prelude::*;
use std::ops::AddAssign;
use std::sync::atomic::{AtomicU64, Ordering};

/// The largest number of tiles: beyond, permutations do not fit in the table.
pub const MOST_TILES: usize = MOST;

/// Which sets are the same, besides those that differ in the names of labels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UpTo {
    /// Rows are exchanged for columns only as far as the two graphs tell them apart: a set and its
    /// transpose are one, unless both graphs are the same; then they are two.
    Graphs,
    /// A set and its transpose are one.
    Transposition,
    /// Sets that differ by one of the eight symmetries of the square are one.
    Square,
}

/// How many sets there are, and of which sort.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tally {
    /// All of them.
    pub sets: u64,
    /// Those that fill the plane with two periods.
    pub periodic: u64,
    /// Those that do not fill it.
    pub no_tiling: u64,
    /// Those of which it is not known.
    pub undecided: u64,
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.sets += other.sets;
        self.periodic += other.periodic;
        self.no_tiling += other.no_tiling;
        self.undecided += other.undecided;
    }
}

impl Tally {
    /// Counts one set.
    pub fn count(&mut self, verdict: Option<bool>) {
        self.sets += 1;
        match verdict {
            Some(true) => self.periodic += 1,
            Some(false) => self.no_tiling += 1,
            None => self.undecided += 1,
        }
    }
}

/// What a run came to.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Classified {
    /// The sums.
    pub tally: Tally,
    /// The undecided sets, sorted.
    pub undecided: Vec<Vec<Tile>>,
    /// Whether all of the part was gone through.
    pub complete: bool,
}

/// Sets are gone through in this order, and deals of it are independent.
pub struct Sets {
    graphs: Vec<Graph>,
    permutations: Permutations,
    pairs: Vec<(u32, u32)>,
    up_to: UpTo,
}

struct Graph {
    arcs: Arcs,
    /// The permutations of the arcs that are symmetries.
    symmetries: Vec<u16>,
}

impl Sets {
    /// Of so many tiles, at most [`MOST_TILES`].
    pub fn new(tiles: usize, up_to: UpTo) -> Self {
        let permutations = Permutations::new(tiles);
        let square = up_to == UpTo::Square;
        let symmetries = |arcs: &Arcs| {
            let all = (0..).zip(&permutations.all);
            let is = |images| {
                is_symmetry(arcs, images, false) || square && is_symmetry(arcs, images, true)
            };
            all.filter(|(_, images)| is(images)).map(|(number, _)| number).collect()
        };
        let graphs: Vec<Graph> = graphs(tiles)
            .into_iter()
            .filter(|arcs| !square || *arcs <= reversed(arcs))
            .map(|arcs| Graph { symmetries: symmetries(&arcs), arcs })
            .collect();
        let count = graphs.len() as u32;
        let pairs = (0..count).flat_map(|one| (one..count).map(move |other| (one, other)));
        Self { pairs: pairs.collect(), permutations, graphs, up_to }
    }

    /// The number of pairs of graphs.
    pub fn pairs(&self) -> usize {
        self.pairs.len()
    }

    /// Shows the sets of a pair of graphs.
    pub fn visit(&self, pair: usize, mut visit: impl FnMut(&[Tile])) {
        let (one, other) = self.pairs[pair];
        let (rows, columns) = (&self.graphs[one as usize], &self.graphs[other as usize]);
        let all = &self.permutations.all;
        let mut marked = vec![false; all.len()];
        let mut tiles = vec![[0; 4]; rows.arcs.len()];
        for (number, images) in all.iter().enumerate() {
            if marked[number] {
                continue;
            }
            self.mark(&mut marked, images, rows, columns);
            if one == other && self.up_to != UpTo::Graphs {
                let mut inverse = vec![0; images.len()];
                (0..).zip(images).for_each(|(at, &image)| inverse[usize::from(image)] = at);
                self.mark(&mut marked, &inverse, rows, columns);
            }
            for (tile, (&(west, east), &image)) in
                tiles.iter_mut().zip(rows.arcs.iter().zip(images))
            {
                let (north, south) = columns.arcs[usize::from(image)];
                *tile = [north, east, south, west].map(u32::from);
            }
            let twice = (1..tiles.len()).any(|i| tiles[..i].contains(&tiles[i]));
            if !twice {
                visit(&tiles);
            }
        }
    }

    /// Marks the double coset of a matching.
    fn mark(&self, marked: &mut [bool], images: &[u8], rows: &Graph, columns: &Graph) {
        let all = &self.permutations.all;
        for &first in &rows.symmetries {
            for &then in &columns.symmetries {
                let first = all[usize::from(first)].iter();
                let then = &all[usize::from(then)];
                let image = first.map(|&at| then[usize::from(images[usize::from(at)])]);
                marked[self.permutations.number(image)] = true;
            }
        }
    }
}

/// Whether the arcs, so permuted (and reversed), are the same up to the names of vertices.
fn is_symmetry(arcs: &Arcs, images: &[u8], reversed: bool) -> bool {
    let mut names = [None; 2 * MOST];
    let mut taken = [None; 2 * MOST];
    arcs.iter().zip(images).all(|(&(from, to), &image)| {
        let (mut from_image, mut to_image) = arcs[usize::from(image)];
        if reversed {
            (from_image, to_image) = (to_image, from_image);
        }
        [(from, from_image), (to, to_image)].into_iter().all(|(vertex, image)| {
            *names[usize::from(vertex)].get_or_insert(image) == image
                && *taken[usize::from(image)].get_or_insert(vertex) == vertex
        })
    })
}

/// Decides the sets of part `part` of `parts`. The result does not depend on the number of
/// threads. `progress` is told pairs done, now and then.
pub fn classify(
    sets: &Sets,
    (part, parts): (usize, usize),
    bounds: &Bounds,
    stop: &dyn Stop,
    progress: &(dyn Fn(u64, u64) + Sync),
) -> Classified {
    let done = AtomicU64::new(0);
    let mine: Vec<usize> = (part..sets.pairs()).step_by(parts).collect();
    let total = mine.len() as u64;
    let one = |quick: &mut Quick, &pair: &usize| {
        let mut result = Classified { complete: !stop.should_stop(), ..Classified::default() };
        if result.complete {
            sets.visit(pair, |tiles| {
                let verdict = quick.decide(tiles).or_else(|| slowly(tiles, bounds, stop));
                result.tally.count(verdict);
                if verdict.is_none() {
                    result.undecided.push(tiles.to_vec());
                }
            });
            progress(done.fetch_add(1, Ordering::Relaxed) + 1, total);
        }
        result
    };
    let join = |mut a: Classified, mut b: Classified| {
        a.tally += b.tally;
        a.undecided.append(&mut b.undecided);
        a.complete &= b.complete;
        a
    };
    let none = || Classified { complete: true, ..Classified::default() };
    let mut result = mine.par_iter().map_init(Quick::default, one).reduce(none, join);
    result.complete &= !stop.should_stop();
    result.undecided.sort_unstable();
    result
}

/// Whether a set fills the plane, by powers.
pub(super) fn slowly(tiles: &[Tile], bounds: &Bounds, stop: &dyn Stop) -> Option<bool> {
    let bounds = Bounds { nodes: 0, strips: super::NO_STRIPS, ..*bounds };
    match decide(tiles, &bounds, stop) {
        Verdict::Periodic(_) | Verdict::Repeats(_) => Some(true),
        Verdict::NoSquare { .. } | Verdict::NoStrip(_) => Some(false),
        Verdict::Undecided(_) => None,
    }
}

//! The smallest covering that can be had with some effort.
//!
//! A round goes from the proven bound upward, in steps that grow, until a covering is found; the
//! next round goes through what lies below it, in smaller steps and with twice the effort. Of
//! so many cells the squarest torus comes first. On each the beam is tried, which knows which
//! tiles occur again, and annealing, which does not; both on the torus as it is and under the
//! symmetries that leave enough cells. It ends when the bound is reached.
//!
//! What is found follows from the seed and the number of rounds, not from the number of threads;
//! a limit on time ends it wherever it stands.

use super::bound::{Bound, Facts, NoBound, bound};
use super::folds::{Permutation, folds, permutations};
use crate::search::Limits;
use crate::tiles::TileSet;
use crate::torus::{Fold, Shape};
use crate::{anneal, beam};

/// Symmetries tried on one torus, in the first round a quarter of them.
const FOLDS: usize = 12;
/// Partial packings that the beam keeps in the first round, and at most.
const WIDTH: (usize, usize) = (500, 30_000);
/// Moves of annealing for each cell in the first round.
const MOVES: u64 = 500;

/// How to look.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Everything random follows from it.
    pub seed: u64,
    /// Threads, at least 1; the answer does not depend on them.
    pub threads: usize,
    /// The longest side is at most so many times the shortest.
    pub aspect: f64,
    /// Rounds at most.
    pub rounds: u32,
    /// Nodes of the search that proves one shape impossible, at most.
    pub nodes_for_bound: u64,
}

impl Default for Options {
    fn default() -> Self {
        Self { seed: 0, threads: 1, aspect: f64::INFINITY, rounds: 6, nodes_for_bound: 5_000_000 }
    }
}

/// A covering and where it came from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Covering {
    /// The torus.
    pub shape: Shape,
    /// The colors of its lattice points, row by row.
    pub labels: Vec<u8>,
    /// How it was found, in words.
    pub how: String,
}

/// What was found and what is proved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Smallest {
    /// The bound.
    pub bound: Bound,
    /// The smallest covering met.
    pub covering: Option<Covering>,
    /// Nodes of searches and beams, and moves.
    pub nodes: u64,
}

/// Looks for the smallest covering of a corner set. Nodes are limited only from one attempt to the
/// next.
///
/// # Errors
/// When the set has no covering of any size, or is none whose coverings are looked for.
pub fn smallest(
    set: &TileSet,
    options: &Options,
    limits: &Limits<'_>,
) -> Result<Smallest, NoBound> {
    let facts = Facts::new(set)?;
    let bound = bound(set, options.nodes_for_bound, limits)?;
    let mut hunt = Hunt { set, options, limits, nodes: bound.nodes };
    let permutations = permutations(set);
    let met = bound.found.clone().filter(|&(shape, _)| hunt.suits(shape));
    let mut best = met.map(|(shape, labels)| Covering { shape, labels, how: "search".into() });
    let cells = |best: &Option<Covering>| best.as_ref().map(|best| best.shape.cells() as u64);
    // A set that fits together at all has long been covered by then.
    let end = 4 * bound.cells + 64;
    for round in 0..options.rounds {
        // The sizes for which there is a torus, however long its sides may be.
        let below = cells(&best).unwrap_or(end);
        let sizes = (bound.cells..below).map(|size| {
            let mut shapes = facts.shapes(size);
            shapes.retain(|&shape| hunt.suits(shape));
            shapes
        });
        let sizes: Vec<Vec<Shape>> = sizes.filter(|shapes| !shapes.is_empty()).collect();
        let mut at = 0;
        while at < sizes.len() && !hunt.is_over() {
            let found = sizes[at].iter().find_map(|&shape| {
                let folds = all_folds(set, &permutations, shape, FOLDS >> (2 - round.min(2)));
                hunt.attempt(&folds, round)
            });
            if found.is_some() {
                best = found;
                break;
            }
            at += 1 + (at >> (round + 1).min(63));
        }
        if hunt.is_over() || sizes.is_empty() {
            break;
        }
    }
    Ok(Smallest { bound, covering: best, nodes: hunt.nodes })
}

/// Looks for a covering of one torus, under a symmetry if one is given, else under any or none.
///
/// # Errors
/// As [`smallest`].
pub fn on_torus(
    set: &TileSet,
    shape: Shape,
    fold: Option<Fold>,
    options: &Options,
    limits: &Limits<'_>,
) -> Result<Smallest, NoBound> {
    let bound = bound(set, options.nodes_for_bound, limits)?;
    let mut hunt = Hunt { set, options, limits, nodes: 0 };
    let folds = match fold {
        Some(fold) => vec![fold],
        None => all_folds(set, &permutations(set), shape, FOLDS),
    };
    let mut covering = None;
    for round in 0..options.rounds {
        covering = hunt.attempt(&folds, round);
        if covering.is_some() || hunt.is_over() {
            break;
        }
    }
    Ok(Smallest { bound, covering, nodes: hunt.nodes })
}

/// The symmetries to try on a torus, up to so many, and none.
fn all_folds(set: &TileSet, known: &[Permutation], shape: Shape, most: usize) -> Vec<Fold> {
    let mut all = folds(known, shape);
    all.truncate(most);
    all.push(Fold::none(shape, set.colors().largest()));
    all
}

/// What all attempts share.
struct Hunt<'a> {
    set: &'a TileSet,
    options: &'a Options,
    limits: &'a Limits<'a>,
    nodes: u64,
}

impl Hunt<'_> {
    fn suits(&self, shape: Shape) -> bool {
        let (w, h) = (shape.width(), shape.height());
        w.max(h) as f64 <= self.options.aspect * w.min(h) as f64
    }

    fn is_over(&self) -> bool {
        self.nodes >= self.limits.nodes || self.limits.stop.should_stop()
    }

    /// All ways to cover one torus, with the effort of a round.
    fn attempt(&mut self, folds: &[Fold], round: u32) -> Option<Covering> {
        for fold in folds {
            for way in [Self::beam, Self::anneal] {
                if self.is_over() {
                    return None;
                }
                if let Some(covering) = way(self, fold, round) {
                    return Some(covering);
                }
            }
        }
        None
    }

    fn beam(&mut self, fold: &Fold, round: u32) -> Option<Covering> {
        if fold.width().min(fold.height()) < 2 {
            return None;
        }
        let width = (WIDTH.0 << round.min(16)).min(WIDTH.1);
        let options = beam::Options {
            width,
            restarts: 2,
            seed: self.options.seed.wrapping_add(round.into()),
            threads: self.options.threads,
            ..beam::Options::for_set(self.set)
        };
        let limits = Limits { nodes: u64::MAX, ..*self.limits };
        let outcome = beam::cover(self.set, fold, &options, &limits).ok()?;
        self.nodes += outcome.nodes;
        let seed = options.seed;
        let how = format!("beam search (seed {seed}, width {width}, restart {})", outcome.restart);
        Some(covering(fold, outcome.labels?, how))
    }

    fn anneal(&mut self, fold: &Fold, round: u32) -> Option<Covering> {
        let most = (MOVES * fold.cells() as u64) << round.min(32);
        let left = self.limits.nodes - self.nodes.min(self.limits.nodes);
        let limits = Limits { nodes: most.min(left), ..*self.limits };
        let seed = self.options.seed.wrapping_add(round.into());
        let walk = anneal::cover(self.set, fold, seed, &limits);
        self.nodes += walk.moves;
        Some(covering(fold, walk.labels?, format!("annealing (seed {seed})")))
    }
}

fn covering(fold: &Fold, labels: Vec<u8>, how: String) -> Covering {
    let how = match fold.notation() {
        Some(symmetry) => format!("{how} under the symmetry {symmetry}"),
        None => how,
    };
    Covering { shape: fold.shape(), labels, how }
}

//! The symmetries under which a covering of a torus may be looked for.
//!
//! A translation of order `k` goes with a permutation of the colors of an order that divides
//! `k` and that keeps the set. The tiles then fall into orbits, and as each takes `k` cells, few
//! cells are lost only if nearly every orbit has `k` tiles. Permutations with the same order and
//! number of orbits mostly do the same, so few of them are taken, and one translation of every rectangle
//! that is left to choose.
//!
//! Source: this project.

use crate::tiles::TileSet;
use crate::torus::{Fold, Shape};
use std::collections::BTreeSet;

/// Over more colors there are too many permutations to look at all.
const MOST_COLORS: usize = 7;

/// A permutation of the colors that keeps a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Permutation {
    images: Vec<u8>,
    order: usize,
    /// Orbits of tiles.
    orbits: usize,
}

/// Permutations that keep a set, few of each order and number of orbits, the highest order first.
pub fn permutations(set: &TileSet) -> Vec<Permutation> {
    let colors = set.colors().largest();
    let mut found: Vec<Permutation> = Vec::new();
    if colors > MOST_COLORS {
        return found;
    }
    let code = |tile: [u8; 4]| tile.iter().fold(0, |i, &c| i * colors + usize::from(c));
    let tiles: Vec<[u8; 4]> =
        set.allowed().map(|tile| set.kind().unpack(tile, set.colors())).collect();
    let mut allowed = vec![false; colors.pow(4)];
    tiles.iter().for_each(|&tile| allowed[code(tile)] = true);
    let mut images: Vec<u8> = (0..colors as u8).collect();
    let mut seen = BTreeSet::new();
    while next(&mut images) {
        let image = |tile: [u8; 4]| tile.map(|color| images[usize::from(color)]);
        if !tiles.iter().all(|&tile| allowed[code(image(tile))]) {
            continue;
        }
        let period = |tile: [u8; 4]| {
            let images = std::iter::successors(Some(image(tile)), |&last| Some(image(last)));
            1 + images.take_while(|&other| other != tile).count()
        };
        let order = (0..colors as u8).map(|c| period([c; 4])).fold(1, lcm);
        // The sum of 1 / period over the tiles.
        let orbits = tiles.iter().map(|&tile| order / period(tile)).sum::<usize>() / order;
        // Whether a color may stand beside its image decides what the seams add up to.
        let beside =
            (0..colors as u8).filter(|&c| allowed[code([images[usize::from(c)], c, c, c])]);
        if seen.insert((order, orbits, beside.count())) {
            found.push(Permutation { images: images.clone(), order, orbits });
        }
    }
    found.sort_by_key(|permutation| (std::cmp::Reverse(permutation.order), permutation.orbits));
    found
}

/// The folds of a torus under the permutations that leave enough cells, those that spare most
/// first; never [`Fold::none`].
pub fn folds(permutations: &[Permutation], shape: Shape) -> Vec<Fold> {
    let mut folds = Vec::new();
    for permutation in permutations {
        let cells = shape.cells() / permutation.order;
        if !shape.cells().is_multiple_of(permutation.order) || cells < permutation.orbits {
            continue;
        }
        let mut seen = BTreeSet::new();
        let mut of_this: Vec<Fold> = Vec::new();
        for (dx, dy) in steps(shape, permutation.order) {
            let Some(fold) = Fold::new(shape, (dx, dy), &permutation.images) else { continue };
            let wide = fold.width().max(fold.height());
            let apart = fold.powers().len() == permutation.order && wide < fold.cells();
            if apart && seen.insert((fold.width(), fold.height())) {
                of_this.push(fold);
            }
        }
        // The beam likes short rows.
        of_this.sort_by_key(|fold| fold.width().min(fold.height()));
        folds.extend(of_this);
    }
    folds
}

/// The translations of a torus whose order may be `order`.
fn steps(shape: Shape, order: usize) -> impl Iterator<Item = (usize, usize)> {
    let (w, h) = (shape.width(), shape.height());
    let along =
        move |side: usize| (0..side).filter(move |step| (step * order).is_multiple_of(side));
    along(h).flat_map(move |dy| along(w).map(move |dx| (dx, dy)))
}

/// The next permutation in lexicographic order, if there is one.
fn next(images: &mut [u8]) -> bool {
    let Some(at) = (1..images.len()).rev().find(|&i| images[i - 1] < images[i]) else {
        return false;
    };
    let last = (at..images.len()).rev().find(|&i| images[i] > images[at - 1]).unwrap_or(at);
    images.swap(at - 1, last);
    images[at..].reverse();
    true
}

fn lcm(a: usize, b: usize) -> usize {
    (1..=b).map(|k| k * a).find(|multiple| multiple.is_multiple_of(b)).unwrap_or(a)
}

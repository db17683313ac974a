//! Packings of compact sets, constructed: milliseconds for sets of thousands of tiles.
//!
//! Corner sets of `2 C^3` tiles come from the rows of a Latin square ([`shifts`], [`groups`])
//! wherever a side of the torus is `C m` with `m` a divisor of `C`; that covers the near-square
//! shape for 4 to 32 colors but for 12, 20, 22, 26 and 30, where other shapes are covered
//! ([`shapes`]), and not for 3. Wang sets of `2 CH CV` tiles come in every shape by putting
//! pairs (N, W) down at random and swapping a few ([`wang`]).
//!
//! Whether there is a construction depends on the random choices in rare cases only, and what
//! is given is right: every construction is checked for what a compact set asks before it is
//! returned. Source: this project.

pub mod groups;
pub mod shifts;
pub mod wang;

use crate::tiles::{Kind, TileSet};
use crate::torus::Shape;

/// The labels of a packing of a compact set, as in [`crate::torus::Lattice`], or `None` when no
/// construction is known; another seed gives another packing.
pub fn construct(set: &TileSet, shape: Shape, seed: u64) -> Option<Vec<u8>> {
    if !set.is_compact() || set.size() != shape.cells() as u64 {
        return None;
    }
    match set.kind() {
        Kind::Corner => shifts::corner(set.colors().horizontal(), shape, seed),
        Kind::Wang => wang::strict(set.colors(), shape, seed)
            .or_else(|| wang::weak(set.colors(), shape, seed)),
        Kind::Domino => None,
    }
}

/// The shapes in which a compact corner set of at least four colors is constructed, from the
/// widest.
pub fn shapes(colors: usize) -> Vec<Shape> {
    let divisors = (2..=colors).filter(|&m| colors.is_multiple_of(m));
    let sides = divisors.map(|m| (colors * m, 2 * colors * colors / m));
    let both = sides.flat_map(|(a, b)| [(a, b), (b, a)]);
    let mut shapes: Vec<Shape> =
        both.filter_map(|(w, h)| Shape::new(w as u64, h as u64).ok()).collect();
    shapes.sort_by_key(|shape| std::cmp::Reverse(shape.width()));
    shapes.dedup();
    shapes
}

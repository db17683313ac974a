//! Symmetry removed before the search starts, and multiplied back.
//!
//! **Translations.** A packing that uses every tile exactly once shows a chosen tile at one
//! cell, so fixing it at the origin leaves one of the `W*H` translates of every packing. In a
//! compact set no tile is sure to occur, but exactly two have the fixed sides (0,0,0) or (0,0):
//! fixing one of them at the origin leaves two of the translates. Coverings have no such tile.
//!
//! **Order of colors.** In a complete or compact set the colors that the origin does not fix
//! are interchangeable and all occur, so asking for their first occurrences in increasing
//! order leaves one of `k!` (for Wang tiles, of `k! l!` for the two palettes).
//!
//! Labels given beforehand break both; a prescribed automorphism breaks the second.

use super::Task;
use crate::symmetry::Anchor;
use crate::tiles::{Kind, Members};
use crate::torus::Cell;
use num_bigint::BigUint;

/// What a search may assume, and how often it then meets each packing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reduction {
    /// What the origin shows.
    pub anchor: Anchor,
    /// The first interchangeable color of each palette, when their order is fixed.
    pub ordered_from: Option<usize>,
    /// Packings for each solution met, times `multiplicity`.
    factor: BigUint,
    /// How often each packing (up to the factor) is met.
    multiplicity: u32,
}

impl Reduction {
    /// No assumption.
    pub fn none() -> Self {
        let factor = BigUint::from(1u32);
        Self { anchor: Anchor::Everywhere, ordered_from: None, factor, multiplicity: 1 }
    }

    /// The tile or class at the origin, where the task allows it.
    pub fn anchored(task: &Task) -> Self {
        let mut reduction = Self::none();
        // Of a board, nothing is known that moves.
        if task.has_pins() || task.cover || !task.board.is_plain() {
            return reduction;
        }
        reduction.anchor = match task.set.members() {
            Members::Compact => Anchor::Class,
            _ => task.set.allowed().next().map_or(Anchor::Everywhere, Anchor::Tile),
        };
        if reduction.anchor == Anchor::Class {
            reduction.multiplicity = 2;
        }
        reduction.factor *= task.shape.cells();
        reduction
    }

    /// Everything that may be assumed: also the order of colors, where the task allows it.
    pub fn full(task: &Task) -> Self {
        let mut reduction = Self::anchored(task);
        let set = &task.set;
        let symmetric = matches!(set.members(), Members::Complete | Members::Compact);
        let fixed = task.has_pins() || task.automorphism.is_some() || !task.board.is_plain();
        if !symmetric || fixed {
            return reduction;
        }
        let from = usize::from(reduction.anchor != Anchor::Everywhere);
        reduction.ordered_from = Some(from);
        let palettes: &[usize] = match set.kind() {
            Kind::Wang => &[set.colors().horizontal(), set.colors().vertical()],
            Kind::Corner | Kind::Domino => &[set.colors().vertical()],
        };
        for colors in palettes {
            reduction.factor *= factorial(colors - from);
        }
        reduction
    }

    /// The number of packings, from the number of solutions met.
    pub fn packings(&self, met: u64) -> BigUint {
        &self.factor * met / self.multiplicity
    }

    /// The number of packings for each solution met, rounded.
    pub fn packings_per_solution(&self) -> f64 {
        // Digits are read correctly rounded; beyond the range of floating point it is infinite.
        let factor: f64 = self.factor.to_string().parse().unwrap_or(f64::INFINITY);
        factor / f64::from(self.multiplicity)
    }

    /// Whether anything is assumed.
    pub fn is_none(&self) -> bool {
        *self == Self::none()
    }

    /// The labels that the assumption about the origin fixes, as pairs of position and color.
    pub fn fixed_labels(&self, task: &Task) -> Vec<(usize, u8)> {
        let set = &task.set;
        let sides = task.lattice().sides(Cell(0));
        match self.anchor {
            Anchor::Everywhere => Vec::new(),
            Anchor::Tile(tile) => {
                sides.into_iter().zip(set.kind().unpack(tile, set.colors())).collect()
            }
            Anchor::Class => match sides[..] {
                // (NW, SW, SE) of a corner tile, (N, W) of a Wang tile.
                [_, se, sw, nw] if set.kind() == Kind::Corner => vec![(nw, 0), (sw, 0), (se, 0)],
                [n, _, _, w] => vec![(n, 0), (w, 0)],
                _ => Vec::new(),
            },
        }
    }
}

fn factorial(n: usize) -> BigUint {
    (1..=n).map(BigUint::from).product()
}

//! The labels that a Wang set uses, numbered from 0 in their order.

use crate::aperiodic::Set;
use std::collections::{BTreeSet, HashMap};
use std::hash::Hash;

/// Labels and their numbers.
#[derive(Debug)]
pub(super) struct Labels {
    /// Those of north and south.
    pub(super) horizontal: HashMap<u32, u32>,
    /// Those of east and west.
    pub(super) vertical: HashMap<u32, u32>,
}

impl Labels {
    /// Those of a Wang set.
    pub(super) fn of(set: &Set) -> Self {
        let tiles = set.tiles();
        Self {
            horizontal: Self::number(tiles.iter().flat_map(|&[n, _, s, _]| [n, s])),
            vertical: Self::number(tiles.iter().flat_map(|&[_, e, _, w]| [e, w])),
        }
    }

    /// Different things, numbered in their order.
    pub(super) fn number<T: Ord + Hash + Copy>(all: impl Iterator<Item = T>) -> HashMap<T, u32> {
        let sorted: BTreeSet<T> = all.collect();
        sorted.into_iter().zip(0..).collect()
    }
}

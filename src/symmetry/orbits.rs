//! The orbits of a whole list of packings, found in ways that check each other.
//!
//! * By canonical forms: as many orbits as different forms; their sizes add up to the list.
//! * By Burnside's lemma: the number of orbits is the mean, over the group, of the number of
//!   packings that an element leaves in place. It never looks at an image as a whole and shares
//!   no code with [`Canonizer`].
//! * By [`expand`]: all members of one orbit.
//!
//! All but the last expect a list that is closed under the group.

use super::{Anchor, Canonizer, Group};
use num_bigint::BigUint;
use std::collections::{BTreeMap, BTreeSet};

/// The canonical forms of the solutions, each with the size of its orbit.
pub fn by_canonical_form<'a>(
    group: &Group,
    anchor: Anchor,
    solutions: impl IntoIterator<Item = &'a [u8]>,
) -> BTreeMap<Vec<u8>, u64> {
    let mut canonizer = Canonizer::new(group, anchor);
    let forms: BTreeSet<_> =
        solutions.into_iter().map(|solution| canonizer.canonical(solution)).collect();
    let sized = forms.into_iter().filter_map(|form| {
        let size = canonizer.classify(&form)?;
        Some((form, size))
    });
    sized.collect()
}

/// The number of orbits of `solutions`, all different, by Burnside's lemma; `None` when the
/// mean is not a whole number, so that the list cannot be closed under the group.
pub fn burnside(group: &Group, solutions: &[Vec<u8>]) -> Option<BigUint> {
    let lattice = group.lattice();
    let mut fixed = BigUint::ZERO;
    for symmetry in group.elements() {
        let sources = symmetry.sources(lattice);
        let recolorings = [0, 1].map(|place| symmetry.point.recoloring(lattice.kind, place));
        let is_fixed = |labels: &&Vec<u8>| {
            sources.iter().zip(labels.iter()).enumerate().all(|(place, (&source, &label))| {
                recolorings[place % 2][usize::from(labels[source])] == label
            })
        };
        fixed += solutions.iter().filter(is_fixed).count();
    }
    let order = group.order();
    (&fixed % &order == BigUint::ZERO).then(|| fixed / order)
}

/// All images of `labels` under the group, sorted and different.
///
/// With the subgroup of translations and color permutations that a search left out, these are
/// the packings that one found representative stands for.
pub fn expand(group: &Group, labels: &[u8]) -> Vec<Vec<u8>> {
    let images: BTreeSet<_> = group.images(labels).collect();
    images.into_iter().collect()
}

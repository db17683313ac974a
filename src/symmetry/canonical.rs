//! One canonical representative for each orbit of packings.
//!
//! The canonical form of a packing is the lexicographically least array of labels among its
//! images that satisfy the [`Anchor`]. A packing is reported by a search exactly when it is its
//! own canonical form, and then stands for `|G| / |stabilizer|` packings (orbit-stabilizer).
//! Every element of the stabilizer leaves the anchor at the origin, so it is among the elements
//! tried and is counted on the way; most images differ from the packing after a few labels.
//!
//! With all color permutations in the group and the anchor tile 0 (or the class of zeros), the
//! colors of a canonical form first appear in increasing order, in the order of the labels (not
//! in the order a search visits cells): a search may then cut by that rule and miss no orbit.

use super::anchor::{Found, Locator, Preimage};
use super::{Anchor, Group, PointSymmetry};
use crate::torus::{Cell, Lattice};
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Tells canonical representatives from the other members of their orbits.
#[derive(Debug, Clone)]
pub struct Canonizer {
    lattice: Lattice,
    /// The order of the group: below `8 * 9! * 2^32`.
    order: u64,
    isometries: Vec<Moves>,
    candidates: Vec<Candidate>,
    /// For every candidate two permutations, for labels at even and at odd places of the image.
    recolorings: Vec<u8>,
    /// The length of one permutation in `recolorings`.
    stride: usize,
    locator: Locator,
    found: Found,
}

/// What an isometry moves where.
#[derive(Debug, Clone)]
struct Moves {
    /// For every place of the image the place its label comes from.
    sources: Vec<usize>,
    /// Row and column of the image of every cell.
    cells: Vec<(usize, usize)>,
}

/// An element of the group without its translation.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    /// Index into `isometries`.
    isometry: usize,
    /// What it turns into the anchor.
    preimage: Preimage,
    /// Where its permutations start.
    recoloring: usize,
}

impl Canonizer {
    /// For arrays of labels on the lattice of the group, all of which satisfy the anchor.
    pub fn new(group: &Group, anchor: Anchor) -> Self {
        let (lattice, colors) = (group.lattice(), group.colors());
        let (locator, preimages) = Locator::new(anchor, lattice, colors, group.points());
        let stride = colors.largest();
        let mut canonizer = Self {
            lattice,
            order: group.point_count() as u64 * lattice.shape.cells() as u64,
            isometries: Vec::new(),
            candidates: Vec::with_capacity(preimages.len()),
            recolorings: Vec::with_capacity(2 * stride * preimages.len()),
            stride,
            found: locator.room(),
            locator,
        };
        let mut numbers = BTreeMap::new();
        for (point, preimage) in group.points().zip(preimages) {
            let isometry = *numbers.entry(point.isometry).or_insert_with(|| {
                canonizer.isometries.push(Moves::of(&point, lattice));
                canonizer.isometries.len() - 1
            });
            let recoloring = canonizer.recolorings.len();
            for parity in 0..2 {
                let start = canonizer.recolorings.len();
                canonizer.recolorings.extend(point.recoloring(lattice.kind, parity));
                canonizer.recolorings.resize(start + stride, 0);
            }
            canonizer.candidates.push(Candidate { isometry, preimage, recoloring });
        }
        canonizer
    }

    /// The size of the orbit when `labels` is canonical, else `None`; also `None` when `labels`
    /// does not satisfy the anchor.
    pub fn classify(&mut self, labels: &[u8]) -> Option<u64> {
        self.locator.locate(labels, &mut self.found);
        let mut stabilizer = 0;
        for &candidate in &self.candidates {
            for cell in self.locator.cells(&self.found, candidate.preimage) {
                match self.compare(candidate, cell, labels, labels) {
                    Ordering::Less => return None,
                    Ordering::Equal => stabilizer += 1,
                    Ordering::Greater => {}
                }
            }
        }
        self.order.checked_div(stabilizer)
    }

    /// The canonical form of `labels`; `labels` itself when no image satisfies the anchor.
    pub fn canonical(&self, labels: &[u8]) -> Vec<u8> {
        let mut found = self.locator.room();
        self.locator.locate(labels, &mut found);
        let mut least: Option<Vec<u8>> = None;
        for &candidate in &self.candidates {
            for cell in self.locator.cells(&found, candidate.preimage) {
                match &mut least {
                    Some(least) => {
                        if self.compare(candidate, cell, labels, least).is_lt() {
                            least.clear();
                            least.extend(self.image(candidate, cell, labels));
                        }
                    }
                    None => least = Some(self.image(candidate, cell, labels).collect()),
                }
            }
        }
        least.unwrap_or_else(|| labels.to_vec())
    }

    /// How the image that has the image of `cell` at the origin compares with `other`.
    fn compare(&self, candidate: Candidate, cell: usize, labels: &[u8], other: &[u8]) -> Ordering {
        let odd = self.lattice.per_cell() - 1;
        let recoloring = &self.recolorings[candidate.recoloring..][..2 * self.stride];
        let mut rest = other;
        // Written out, because most comparisons end after one or two labels.
        for sources in self.runs(candidate, cell) {
            let (here, later) = rest.split_at(sources.len());
            rest = later;
            for (place, (&source, theirs)) in sources.iter().zip(here).enumerate() {
                let start = (place & odd) * self.stride;
                let ordering = recoloring[start + usize::from(labels[source])].cmp(theirs);
                if ordering.is_ne() {
                    return ordering;
                }
            }
        }
        Ordering::Equal
    }

    /// The labels of the image that has the image of `cell` at the origin, place by place.
    fn image<'a>(
        &'a self,
        candidate: Candidate,
        cell: usize,
        labels: &'a [u8],
    ) -> impl Iterator<Item = u8> + 'a {
        let odd = self.lattice.per_cell() - 1;
        let recoloring = &self.recolorings[candidate.recoloring..][..2 * self.stride];
        let stride = self.stride;
        self.runs(candidate, cell).flat_map(move |sources| {
            sources.iter().enumerate().map(move |(place, &source)| {
                recoloring[(place & odd) * stride + usize::from(labels[source])]
            })
        })
    }

    /// The places the labels of an image come from, in order, in runs that start at a cell: the
    /// rows from the one that comes to the north on, each from the column that comes to the
    /// west on.
    fn runs(&self, candidate: Candidate, cell: usize) -> impl Iterator<Item = &[usize]> + use<'_> {
        let moves = &self.isometries[candidate.isometry];
        let (row, column) = moves.cells[cell];
        let per_cell = self.lattice.per_cell();
        let width = per_cell * self.lattice.shape.width();
        let seam = per_cell * column;
        let (north, south) = moves.sources.split_at(width * row);
        south.chunks_exact(width).chain(north.chunks_exact(width)).flat_map(move |sources| {
            let (west, east) = sources.split_at(seam);
            [east, west]
        })
    }
}

impl Moves {
    fn of(point: &PointSymmetry, lattice: Lattice) -> Self {
        let cells = (0..lattice.shape.cells() as u32).map(Cell);
        let image = |cell| lattice.shape.position(point.isometry.cell(lattice, cell));
        Self { sources: point.isometry.sources(lattice), cells: cells.map(image).collect() }
    }
}

//! The walk: a random patch, and a random other filling of it.

use super::{Patch, Refusal};
use crate::search::Stop;
use crate::tiles::TileSet;
use crate::torus::{Cell, Lattice};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::ops::ControlFlow;

/// Nodes spent on one patch; then it is left as it is.
const MOST_NODES: u64 = 1 << 16;

/// A walk under way.
#[derive(Debug, Clone)]
pub struct Walk {
    patch: Patch,
    cells: u32,
    labels: Vec<u8>,
    rng: Pcg64,
    walked: Walked,
}

/// What a walk has done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Walked {
    /// Patches tried.
    pub steps: u64,
    /// Patches that had another filling: so often the packing has changed.
    pub moves: u64,
    /// Patches left as they were because the search for their fillings became too long.
    pub skipped: u64,
    /// Fillings met, in all.
    pub fillings: u64,
    /// Nodes visited.
    pub nodes: u64,
}

impl Walk {
    /// A walk from a packing, with patches of `width` columns and `height` rows of cells.
    ///
    /// # Errors
    /// When the patches do not suit the torus, or there are too many tiles.
    pub fn new(
        set: &TileSet,
        lattice: Lattice,
        labels: Vec<u8>,
        (width, height): (usize, usize),
        seed: u64,
    ) -> Result<Self, Refusal> {
        let patch = Patch::new(set, lattice, width, height)?;
        let cells = lattice.shape.cells() as u32;
        let (rng, walked) = (Pcg64::seed_from_u64(seed), Walked::default());
        Ok(Self { patch, cells, labels, rng, walked })
    }

    /// The labels of the packing it stands on.
    pub fn labels(&self) -> &[u8] {
        &self.labels
    }

    /// What it has done.
    pub fn walked(&self) -> Walked {
        self.walked
    }

    /// Tries so many patches, unless asked to stop before.
    pub fn run(&mut self, steps: u64, stop: &dyn Stop) {
        for _ in 0..steps {
            if stop.should_stop() {
                return;
            }
            self.step();
        }
    }

    /// Tries one patch: goes on to each other filling with the same probability.
    fn step(&mut self) {
        let Self { patch, cells, labels, rng, walked } = self;
        let corner = Cell(rng.random_range(0..*cells));
        let (mut others, mut chosen) = (0u64, Vec::new());
        let (nodes, all) = patch.fillings(labels, corner, MOST_NODES, |filling, is_present| {
            walked.fillings += 1;
            // Of the others so far, each is the one kept with the same probability.
            others += u64::from(!is_present);
            if !is_present && rng.random_range(0..others) == 0 {
                chosen.clear();
                chosen.extend_from_slice(filling);
            }
            ControlFlow::Continue(())
        });
        walked.steps += 1;
        walked.nodes += nodes;
        walked.skipped += u64::from(!all);
        if all && others > 0 {
            walked.moves += 1;
            for (&label, &color) in patch.free().iter().zip(&chosen) {
                labels[label as usize] = color;
            }
        }
    }
}

//! What to do with the packings a search meets: count them, keep the first, keep all, or keep
//! one of each orbit.

use super::Labeled;
use crate::search::Sink;
use crate::symmetry::{BoardCanonizer, Canonizer};
use num_bigint::BigUint;
use std::ops::ControlFlow;

/// What is done with each packing.
#[derive(Clone)]
pub enum Purpose {
    /// Nothing: the search counts.
    Count,
    /// Leaves stand for many packings each, which are added up.
    Met,
    /// The first ends the search.
    First,
    /// All are kept.
    Keep,
    /// The canonical ones of their orbits are counted and, if wanted, kept.
    Orbits {
        /// Tells the canonical ones.
        canonizer: Box<Forms>,
        /// Whether to keep them.
        keep: bool,
    },
}

/// Tells canonical packings.
#[derive(Clone)]
pub enum Forms {
    /// On a torus.
    Torus(Canonizer),
    /// On a board.
    Board(BoardCanonizer),
}

impl Forms {
    /// The size of the orbit of a canonical packing; `None` for any other.
    fn classify(&mut self, labels: &[u8]) -> Option<u64> {
        match self {
            Self::Torus(canonizer) => canonizer.classify(labels),
            Self::Board(canonizer) => canonizer.classify(labels),
        }
    }
}

/// Takes packings for a purpose.
pub struct Leaves {
    purpose: Purpose,
    labels: Vec<u8>,
    /// The packings kept, as labels, in no order.
    pub kept: Vec<Vec<u8>>,
    /// Canonical packings met; where leaves stand for many, the steps it took to count them.
    pub orbits: u64,
    /// The sum of the sizes of their orbits; or what the leaves stand for.
    pub orbit_sizes: BigUint,
}

impl Leaves {
    /// Nothing taken yet.
    pub fn new(purpose: Purpose) -> Self {
        let orbit_sizes = BigUint::ZERO;
        Self { purpose, labels: Vec::new(), kept: Vec::new(), orbits: 0, orbit_sizes }
    }
}

impl<P: Labeled> Sink<P> for Leaves {
    type Found = Vec<u8>;

    fn breaks(&self) -> bool {
        matches!(self.purpose, Purpose::First)
    }

    fn counts(&self) -> bool {
        matches!(self.purpose, Purpose::Count)
    }

    fn solution(&mut self, problem: &P, _: &[u32]) -> ControlFlow<Vec<u8>> {
        if matches!(self.purpose, Purpose::Count) {
            return ControlFlow::Continue(());
        }
        if matches!(self.purpose, Purpose::Met) {
            if let Some((steps, packings)) = problem.met() {
                self.orbits += steps;
                self.orbit_sizes += packings;
            }
            return ControlFlow::Continue(());
        }
        problem.write_labels(&mut self.labels);
        match &mut self.purpose {
            Purpose::Count | Purpose::Met => {}
            Purpose::First => return ControlFlow::Break(self.labels.clone()),
            Purpose::Keep => self.kept.push(self.labels.clone()),
            Purpose::Orbits { canonizer, keep } => {
                if let Some(size) = canonizer.classify(&self.labels) {
                    self.orbits += 1;
                    self.orbit_sizes += size;
                    if *keep {
                        self.kept.push(self.labels.clone());
                    }
                }
            }
        }
        ControlFlow::Continue(())
    }

    fn join(&mut self, mut other: Self) {
        self.kept.append(&mut other.kept);
        self.orbits += other.orbits;
        self.orbit_sizes += other.orbit_sizes;
    }
}

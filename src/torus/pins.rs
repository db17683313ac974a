//! Labels given beforehand.

use super::Lattice;

/// For every label of a lattice its color, or `None` where it is free.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pins(Vec<Option<u8>>);

impl Pins {
    /// Nothing given.
    pub fn free(lattice: Lattice) -> Self {
        Self(vec![None; lattice.labels()])
    }

    /// These labels, in the order of [`Lattice`].
    pub fn new(labels: Vec<Option<u8>>) -> Self {
        Self(labels)
    }

    /// The labels.
    pub fn labels(&self) -> &[Option<u8>] {
        &self.0
    }
}

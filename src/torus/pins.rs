//! Pins: labels given beforehand.
//!
//! A search fills the labels of a [`Lattice`] that are free and keeps those that are pinned.

use super::Lattice;

/// For every label of a lattice, the color it must have, or `None` when it is free.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pins(Vec<Option<u8>>);

impl Pins {
    /// Every label free.
    pub fn free(lattice: Lattice) -> Self {
        Self::free_labels(lattice.labels())
    }

    /// Every one of so many labels free.
    pub fn free_labels(labels: usize) -> Self {
        Self(vec![None; labels])
    }

    /// Pins the label at this position, numbered as in [`Lattice::sides`].
    ///
    /// # Errors
    /// The color that is already there, when it is another one.
    pub fn pin(&mut self, label: usize, color: u8) -> Result<(), u8> {
        match self.0[label].replace(color) {
            Some(known) if known != color => {
                self.0[label] = Some(known);
                Err(known)
            }
            _ => Ok(()),
        }
    }

    /// The color of a label, or `None` when it is free.
    pub fn get(&self, label: usize) -> Option<u8> {
        self.0[label]
    }

    /// All labels in order, as many as [`Lattice::labels`].
    pub fn labels(&self) -> &[Option<u8>] {
        &self.0
    }

    /// The number of labels that are pinned.
    pub fn pinned(&self) -> usize {
        self.0.iter().flatten().count()
    }
}

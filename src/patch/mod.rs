//! A walk from packing to packing: patches taken out and filled again.
//!
//! Take the tiles of a small rectangle of cells out of a packing. What stays around it says the
//! colors on its border, and the same tiles can go back in every way that fits: a [`Patch`] finds
//! all of them by search, and a [`Walk`] goes on to another one. Whatever the walk does, what it
//! stands on is a packing of the same set, with the same tiles.
//!
//! Rows of a packing found by beam search differ: some colors are used up early. A walk mixes this
//! away ([`drift`]) as far as its patches reach.
//!
//! What is claimed. The place of the patch is uniform. Its fillings, and so their number `n`, depend
//! on the border and on the tiles taken out alone, so from each of the `n` packings that differ in
//! the patch only, the walk goes to each other one with the same probability `1 / (n - 1)` (and
//! stays where `n` is 1, or where the search was cut short, which is the same for all `n` of them).
//! The walk is therefore symmetric, and the uniform law on every class of packings that it connects
//! is stationary: in the long run every packing of the class is visited equally often. What is not
//! claimed: that all packings of a set are in one class, or how long "in the long run" is.
//!
//! Source: this project (search.md 6).

pub mod drift;
mod fillings;
mod walk;

pub use drift::Drift;
pub use fillings::{MAX_TILES, Patch};
pub use walk::{Walk, Walked};

/// Why a walk cannot be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Refusal {
    /// The tables hold a number for every tile over the colors.
    #[error("there are {0} tiles over these colors; a walk handles up to {MAX_TILES}")]
    TooManyTiles(u64),
    /// Such a patch does not lie on the torus.
    #[error("a patch of {width}x{height} cells is larger than the torus of {shape}")]
    TooLarge {
        /// Columns of the patch.
        width: usize,
        /// Rows of the patch.
        height: usize,
        /// The torus.
        shape: crate::torus::Shape,
    },
    /// No color lies inside the patch.
    #[error("a patch of {0}x{1} cells has no color inside that could be changed")]
    Nothing(usize, usize),
}

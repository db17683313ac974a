//! All sets of tiles of a size, each decided.
//!
//! * [`wang`]: sets of n Wang tiles, up to the names of labels and transposition.
//! * [`two_colors`]: all sets of corner tiles over two colors.
//! * [`exhaust`]: there is no aperiodic set of at most n corner tiles over so many colors.

pub mod exhaust;
mod graphs;
mod permutations;
mod quick;
pub mod two_colors;
pub mod wang;

pub use quick::Quick;
pub use wang::{Classified, Sets, Tally, UpTo, classify};

use super::decide::torus;

/// No torus is asked for, only whether there is one.
const NO_STRIPS: torus::Bounds = torus::Bounds { columns: 0, steps: 0 };

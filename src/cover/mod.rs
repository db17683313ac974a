//! Coverings of corner sets: every tile at least once, on as small a torus as can be had.
//!
//! Some sets have no packing: their size is a prime, or no arrangement exists. Others have none
//! that is nearly square. With a few cells to spare there is one again, in which a few tiles
//! occur twice. [`bound`](mod@bound) proves how many cells it takes at least, [`folds`] lists the
//! symmetries that a torus and a set allow, and [`smallest`](mod@smallest) looks for coverings
//! from the bound upward, by beam search and by annealing.
//!
//! Source: this project; the sets: Schlömer 2012, 2.4.

pub mod bound;
pub mod folds;
pub mod smallest;

pub use bound::{Bound, NoBound, bound};
pub use smallest::{Covering, Options, Smallest, on_torus, smallest};

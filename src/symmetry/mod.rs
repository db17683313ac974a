//! What leaves a set of packings as it is.
//!
//! Translations of the torus, permutations of the colors, and the rotations and reflections of
//! the square that keep the shape and the tile set turn packings into packings. A search uses
//! them before it starts (translations and the order of colors are removed exactly, see
//! [`crate::packing`]), while it runs (an [`Automorphism`] that the packing must have) and at
//! the end (one canonical representative of each orbit).

pub mod automorphism;
pub mod color_map;

pub use automorphism::{Automorphism, AutomorphismError};
pub use color_map::ColorMap;

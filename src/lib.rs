//! Tile packings and the search for them.
pub mod symmetry;
pub mod tiles;
pub mod torus;

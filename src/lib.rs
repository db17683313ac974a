//! Tile packings and the search for them.
pub mod cli;
pub mod packing;
pub mod search;
pub mod store;
pub mod symmetry;
pub mod tiles;
pub mod torus;
pub mod verify;

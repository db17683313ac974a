//! Where tiles go: a torus of `width` x `height` cells, or a [`Board`] with outer sides.
//!
//! Rows run north to south, columns west to east, both wrap around. A packing is an array of
//! tiles; what neighbors share is better said once, so a [`Lattice`] holds the *labels*: one
//! color per lattice point for corner tiles, the colors of the north and the west edge of every
//! cell for Wang tiles, the color of the first end for dominoes. Search and symmetry work on
//! labels, files and verification on tiles. [`Cubes`] fill a torus in space. A
//! [`toral`] certificate is about the other torus, the plane modulo a lattice, whose points code tilings.

pub mod board;
pub mod cubes;
pub mod fold;
pub mod lattice;
pub mod order;
pub mod packing;
pub mod pins;
pub mod shape;
pub mod toral;

pub use board::{Board, Border, BorderError, Edges, Topology};
pub use cubes::{CubeKind, CubeSet, Cubes, MAX_CUBES, places};
pub use fold::Fold;
pub use lattice::Lattice;
pub use order::Order;
pub use packing::Packing;
pub use pins::Pins;
pub use shape::{Cell, Shape, ShapeError};

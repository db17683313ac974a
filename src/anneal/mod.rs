//! Packings and coverings by annealing, mostly under a symmetry.
//!
//! A packing that a step aside takes to itself, with every color replaced by the next, is given
//! by a part of its cells. The fewer unknowns and the fewer things that can be wrong make local
//! search quick where nothing is constructed: the 54 tiles of the compact set over three colors
//! in the blink of an eye, those over eight in seconds. Coverings ([`cover`](mod@cover)) have cells to
//! spare, which helps still more. It proves nothing.
//!
//! Source: this project; annealing: Kirkpatrick, Gelatt, Vecchi 1983.

pub mod compact;
pub mod cover;
mod metropolis;

pub use compact::{Annealed, compact_corner};
pub use cover::{Walk, cover, orbits};

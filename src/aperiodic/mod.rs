//! Sets of tiles that fill the plane, but never periodically: converted, decided, classified,
//! found.
//!
//! * [`Set`] is a list of tiles with labels of any size.
//! * [`coloring`] finds small aperiodic sets of corner tiles, with certificates.

pub mod coloring;
mod set;

pub use set::{Set, SetError};

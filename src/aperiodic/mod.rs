//! Sets of tiles that fill the plane, but never periodically: converted, decided, classified,
//! found.
//!
//! * [`Set`] is a list of tiles with labels of any size.
//! * [`mod@decide`] says whether a set fills the plane, and how.
//! * [`classify`] does so for all sets of a size.

pub mod classify;
pub mod decide;
mod set;

pub use set::{Set, SetError};

//! Sets of tiles that fill the plane, but never periodically: converted, decided, classified,
//! found.
//!
//! * [`Set`] is a list of tiles with labels of any size.
//! * [`mod@convert`] makes corner sets of Wang sets, and back; [`sound`] says what that proves.
//! * [`mod@decide`] says whether a set fills the plane, and how.
//! * [`classify`] does so for all sets of a size.
//! * [`coloring`] finds small aperiodic sets of corner tiles, with certificates.
//! * [`patch`] fills rectangles.

pub mod classify;
pub mod coloring;
pub mod convert;
pub mod decide;
pub mod patch;
mod set;
pub mod sound;

pub use set::{Set, SetError};

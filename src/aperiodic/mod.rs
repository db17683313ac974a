//! Sets of tiles that fill the plane, but never periodically: converted, decided, classified,
//! found.
//!
//! * [`Set`] is a list of tiles with labels of any size.
//! * [`mod@convert`] makes corner sets of Wang sets, and back; [`sound`] says what that proves.

pub mod convert;
mod set;
pub mod sound;

pub use set::{Set, SetError};

//! Sets of tiles that fill the plane, but never periodically: converted, decided, classified,
//! found.
//!
//! * [`Set`] is a list of tiles with labels of any size.

mod set;

pub use set::{Set, SetError};

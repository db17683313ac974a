//! What a tile is.
//!
//! A **corner tile** is a square with a color on each corner, a **Wang tile** a square with a
//! color on each edge, a **domino** a unit segment with a color on each end. Tiles are neither
//! rotated nor reflected, but for *squares* ([`turn`]), which may be turned. Two tiles may be neighbors when the colors they share agree.
//!
//! Every tile has one number, its [`TileId`]: its colors read as the digits of a mixed-radix
//! number. A [`TileSet`] says which numbers are in play; [`formula`] gives its size without
//! enumerating it.
//!
//! Source: A. Lagae, *Tile-Based Methods in Computer Graphics*, 2007, equations 2.2 and 2.5.

pub mod color;
pub mod corner;
pub mod domino;
pub mod error;
pub mod formula;
pub mod kind;
pub mod notation;
pub mod set;
pub mod side;
pub mod turn;
pub mod unpack;
pub mod wang;

pub use color::{Color, Colors, MAX_COLORS};
pub use corner::Corner;
pub use domino::Domino;
pub use error::TileError;
pub use kind::{Kind, TileId};
pub use set::{Members, TileSet};
pub use side::Side;
pub use unpack::Unpacker;
pub use wang::Wang;

//! Tile images from examples.
//!
//! Given a picture of stone, tiles that show stone: a set of them that fits without visible
//! seams, wherever the colors of the tiles agree. Every texel of a tile is a texel of an example;
//! where two pieces meet, they are cut apart along the line where it shows least.
//!
//! * [`Stock`] holds the examples, [`Quilt`] is a picture put together of their texels;
//! * [`flow`] finds cheapest cuts, [`weave`] joins two quilts along one;
//! * [`settle`] chooses where patches come from; [`corner`] makes corner tiles of them, [`wang`]
//!   Wang tiles of diamonds; [`cover`] hides what seams are left, [`staircase`] in another way;
//! * [`make()`] does all that for a set of tiles, and checks that they keep the common strip;
//! * [`quality`] says how good they are, [`quilting`] what another method would have made;
//! * [`example`] draws pictures to begin with.
//!
//! The guarantee: within the strip of a side the texels depend on the colors of that side alone
//! ([`crate::atlas`] says what that is good for). It holds by construction, and is checked.
//!
//! Sources: Efros and Freeman 2001; Cohen, Shade, Hiller, Deussen 2003; Kwatra, Schödl, Essa,
//! Turk, Bobick 2003; Ng, Wen, Tan, Zhang, Kim 2005; Lagae 2007; Schlömer 2012.

pub mod corner;
pub mod cover;
mod error;
pub mod example;
pub mod flow;
mod make;
pub mod quality;
mod quilt;
pub mod quilting;
pub mod settle;
mod shape;
pub mod staircase;
mod stock;
pub mod wang;
pub mod weave;

pub use error::TextureError;
pub use make::{Drawn, Made, Method, Order, Progress, check_count, make};
pub use quilt::Quilt;
pub use shape::Shape;
pub use stock::{Alpha, Place, Stock, Texel};

//! From a packing to a texture.
//!
//! A texture mapper looks a tile up in the *atlas*, the picture of a whole packing, and filters
//! there. What lies across the border of the tile is then its neighbor in the packing, not its
//! neighbor in the tiling. The packing sees to it that both agree in the colors they share; the
//! pictures of the tiles see to it that within a *common strip* of a side the picture depends on
//! the colors of that side alone. Where both hold, filtering in the atlas is filtering in the
//! endless tiling.
//!
//! * [`Image`] is a picture in memory, [`Format`] how its samples are to be read;
//! * [`TileImages`] draws the tiles of a set; [`fill`] makes pictures up, [`Folder`] and [`Sheet`]
//!   are given, [`StripCheck`] sees whether they keep the strip;
//! * [`Layout`] says where tiles lie, [`Scene`] draws them, [`chain`] makes mip levels, [`tables`]
//!   are for mappers;
//! * [`filter`] says where filtering is exact, [`lint`] whether the tiles of a sheet fit;
//! * [`PngWriter`] writes PNG, [`light`] decodes it; [`levels`] are fields of tiles as pictures; [`palette`] gives colors their look;
//! * [`formats`] are those of other programs, [`picture`] draws for people, [`demo`] lays tiles;
//! * [`shader`] writes the endless tiling for graphics cards, [`viewer`] a page that draws it.

mod compose;
pub mod demo;
mod error;
pub mod fill;
pub mod filter;
pub mod formats;
mod given;
mod image;
mod layout;
pub mod levels;
pub mod light;
pub mod lint;
mod mips;
pub mod palette;
pub mod picture;
mod png;
pub mod shader;
pub mod sides;
mod strip;
pub mod tables;
mod tile_images;
pub mod viewer;

pub use compose::Scene;
pub use error::AtlasError;
pub use given::{Folder, PICTURE_LIMIT, Sheet, open_png};
pub use image::{Channels, Depth, Format, Image, Light};
pub use layout::{Arrangement, Gutter, Layout};
pub use mips::chain;
pub use png::{PngWriter, read_png, write_png};
pub use strip::StripCheck;
pub use tile_images::{TileImages, assemble};

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
//! * [`TileImages`] draws the tiles of a set, [`palette`] gives colors their look;
//! * [`shader`] writes the endless tiling for graphics cards, [`viewer`] a page that draws it.

mod error;
mod image;
pub mod palette;
pub mod shader;
mod tile_images;
pub mod viewer;

pub use error::AtlasError;
pub use image::{Channels, Depth, Format, Image, Light};
pub use tile_images::{TileImages, assemble};

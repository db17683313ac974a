//! What leaves a set of packings as it is.
//!
//! Translations of the torus, permutations of the colors, and the rotations and reflections of
//! the square that keep the shape and the tile set turn packings into packings. A search uses
//! them before it starts (translations and the order of colors are removed exactly, see
//! [`crate::packing`]), while it runs (an [`Automorphism`] that the packing must have) and at
//! the end (one canonical representative of each orbit).
//!
//! All of it happens on arrays of labels ([`crate::torus::Lattice`]), where neighbors fit by
//! construction:
//! * [`square`]: the eight rotations and reflections, on tiles and on places of labels;
//! * [`color_map`]: permutations of the palettes; [`keeping`]: those that keep a tile set;
//! * [`element`]: one symmetry, *recolor, then rotate or reflect, then translate*, and how two
//!   of them compose;
//! * [`group`]: all symmetries of the packings of a set on a torus;
//! * [`anchor`], [`canonical`]: is this packing the representative of its orbit, and how large
//!   is the orbit?
//! * [`board`]: the symmetries of boards and the canonical pictures on them;
//! * [`orbits`]: the orbits of a whole list, by canonical forms and by Burnside's lemma.
//!
//! ```
//! use tilepack::symmetry::{Anchor, Canonizer, Group};
//! use tilepack::tiles::{Colors, Kind, Members, TileId, TileSet};
//! use tilepack::torus::Shape;
//!
//! // All 32 packings of the 16 corner tiles over two colors are one packing in disguise.
//! let set = TileSet::new(Kind::Corner, Colors::one(2)?, Members::Complete)?;
//! let group = Group::of(&set, Shape::default_for(&set)?, None)?;
//! assert_eq!(group.order(), (16u32 * 2 * 8).into());
//! let mut canonizer = Canonizer::new(&group, Anchor::Tile(TileId(0)));
//! let packing = [0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 1, 1, 0, 1, 1, 1];
//! let canonical = canonizer.canonical(&packing);
//! assert_eq!(canonizer.classify(&canonical), Some(32));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod anchor;
pub mod automorphism;
pub mod board;
pub mod canonical;
pub mod color_map;
pub mod element;
pub mod group;
pub mod keeping;
pub mod orbits;
pub mod square;
pub mod suggest;

pub use anchor::Anchor;
pub use automorphism::{Automorphism, AutomorphismError};
pub use board::BoardCanonizer;
pub use canonical::Canonizer;
pub use color_map::ColorMap;
pub use element::{PointSymmetry, Symmetry};
pub use group::{Group, GroupError};
pub use orbits::{burnside, by_canonical_form, expand};
pub use square::Isometry;
pub use suggest::suggest;

//! Finds, counts, lists and verifies packings of square tiles.
//!
//! Square tiles with colored corners (*corner tiles*) or colored edges (*Wang tiles*) fill the
//! plane without visible repetition; textures and point sets are synthesized on them. To live
//! in one texture that can be filtered, a tile set must be *packed*: every tile exactly once on
//! a torus, neighbors matching. This crate answers which packings there are, and how many.
//!
//! # The book
//!
//! 1. [`tiles`]: what a tile is, its number, and the sets: complete, compact, pruned, explicit.
//! 2. [`torus`]: where tiles go, and the labels that neighbors share.
//! 3. [`construct`]: packings in closed form, and where in them a tile lies.
//! 4. [`compact`]: packings of compact sets, constructed.
//! 5. [`count`]: exact numbers of packings without a search.
//! 6. [`search`]: exhaustive search that knows no tiles: paths, slices, threads.
//! 7. [`symmetry`]: what leaves a set of packings as it is: canonical forms and orbits.
//! 8. [`packing`]: the problems, their pruning, and the answers to [`packing::Task`]s.
//! 9. [`export`]: the same problems for SAT solvers and programs for exact cover.
//! 10. [`beam`]: first packings of corner tiles by beam search.
//! 11. [`anneal`]: packings by annealing under a symmetry.
//! 12. [`portfolio`]: several ways to a first packing, in turns.
//! 13. [`patch`]: a walk from packing to packing.
//! 14. [`cover`]: coverings of pruned sets, and how small they can be.
//! 15. [`verify`]: packings checked from the definition, by code that shares nothing with the
//!     search.
//! 16. [`aperiodic`]: sets of tiles that fill the plane, but never periodically.
//! 17. [`dappled`]: tilings in which nothing repeats for too long.
//! 18. [`tiling`]: endless tilings, evaluated anywhere.
//! 19. [`atlas`]: from a packing to a texture.
//! 20. [`texture`]: tile images from examples.
//! 21. [`store`]: files, whole or not at all.
//! 22. [`cluster`]: one search in parts, on many machines.
//! 23. [`cli`]: the command line.
//!
//! Every layer uses only those before it (the search none), so each can be read, and trusted,
//! without the later ones.
//!
//! # An example
//!
//! The packings of all 16 corner tiles over two colors, and the first of them checked:
//!
//! ```
//! use tilepack::packing::{self, Settings, Task};
//! use tilepack::tiles::{Colors, Kind, Members, TileSet};
//! use tilepack::torus::Shape;
//! use tilepack::verify;
//!
//! let set = TileSet::new(Kind::Corner, Colors::one(2)?, Members::Complete)?;
//! let task = Task::new(set.clone(), Shape::new(4, 4)?);
//!
//! let counted = packing::count(&task, &Settings::PLAIN, true)?;
//! assert_eq!(counted.value.packings, 32u32.into());
//! assert_eq!(counted.value.fundamental, Some(1));
//!
//! let labels = packing::find(&task, &Settings::PLAIN)?.value.expect("there are 32");
//! let packing = task.lattice().packing(&labels, &set, false);
//! assert!(verify::check(&packing).is_valid());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod anneal;
pub mod aperiodic;
pub mod atlas;
pub mod beam;
pub mod cli;
pub mod cluster;
pub mod compact;
pub mod construct;
pub mod count;
pub mod cover;
pub mod dappled;
pub mod export;
pub mod packing;
pub mod patch;
pub mod portfolio;
pub mod search;
pub mod store;
pub mod symmetry;
pub mod texture;
pub mod tiles;
pub mod tiling;
pub mod torus;
pub mod verify;

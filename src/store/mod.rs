//! Everything on disk.
//!
//! Files come from anywhere, so reading trusts nothing: every error names the file and the line
//! and column (or the cell), and says what was expected. Files are written whole or not at all,
//! and the same content always gives the same bytes.
//!
//! * [`Input`] opens a file and refuses what cannot be text;
//! * [`solutions()`] reads packings from solution JSON, JSON lines and text grids;
//! * [`read_pins`] reads cells given beforehand, [`read_tile_set`] a set of tiles;
//! * [`write_solution`], [`write_grid`] and [`write_tile_set`] are their inverses;
//! * [`AtomicFile`] and [`check_writable`] see to it that a result is not lost.
//!
//! The formats are described, with examples, in `docs/formats.md`.

mod atomic;
mod claim;
mod error;
mod grid;
mod json;
mod pins;
mod read;
mod solution;
mod solutions;
mod tile_set;

pub use atomic::{AtomicFile, check_writable, write_file};
pub use claim::Claim;
pub use error::StoreError;
pub use grid::write_grid;
pub use pins::read_pins;
pub use read::{Input, MAX_BYTES};
pub use solution::{FORMAT, Layout, Solution, write_solution};
pub use solutions::{Solutions, read_solution, solutions};
pub use tile_set::{NamedSet, read_tile_set, write_tile_set};

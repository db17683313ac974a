//! Everything on disk.
//!
//! Files come from anywhere, so reading trusts nothing: every error names the file and the line
//! and column (or the cell), and says what was expected. Files are written whole or not at all,
//! and the same content always gives the same bytes.
//!
//! * [`Input`] opens a file and refuses what cannot be text;
//! * [`solutions()`] reads packings from solution JSON, JSON lines and text grids;
//! * [`read_pins`] reads cells given beforehand, [`read_tile_set`] a set of tiles;
//! * [`read_listed_tiles`] reads the tiles of a sheet;
//! * [`read_border`], [`read_squares`] and [`read_pins_on_board`] are for boards;
//! * [`read_probabilities`] reads what semi-stochastic tilings draw from;
//! * [`read_cubes`] and [`write_cubes`] do the same for packings of cubes;
//! * [`read_certificate`] and [`write_certificate`] are for proofs that sets are aperiodic;
//! * [`write_solution`], [`write_grid`] and [`write_tile_set`] are their inverses;
//! * [`AtomicFile`] and [`check_writable`] see to it that a result is not lost;
//! * [`Keeping`] saves a search while it runs, [`read_checkpoint`] finds it again, a [`Lock`]
//!   keeps others away meanwhile;
//! * [`write_long`] and [`read_long`] do so for counts whose tables should not be in memory twice;
//! * [`SearchPlan`] and [`PartResult`] are a search in parts;
//! * [`write_job`] puts a search in words, [`fingerprint`] identifies it.
//!
//! The formats are described, with examples, in `docs/formats.md`.

mod atomic;
mod border;
mod checkpoint;
mod claim;
mod codec;
mod cubes;
mod error;
mod frame;
mod grid;
mod job;
mod json;
mod keeping;
mod kept;
mod lock;
mod long;
mod pins;
mod pins_on_board;
mod plan;
mod probabilities;
mod read;
mod sealed;
mod solution;
mod solutions;
mod tile_set;
mod toral;

pub use atomic::{AtomicFile, check_writable, write_file};
pub use border::read_border;
pub use checkpoint::{Checkpoint, Opened, previous, read_checkpoint, set_aside, write_checkpoint};
pub use claim::Claim;
pub use cubes::{CubeSolution, cube_fields, holds_cubes, read_cubes, write_cubes};
pub use error::StoreError;
pub use grid::{write_grid, write_grid_head, write_grid_row};
pub use job::{fingerprint, read_job, write_job};
pub use keeping::{Keeping, Report, Writer, Written};
pub use kept::{Extent, Kept};
pub use lock::Lock;
pub use long::{OpenedLong, holds_long, read_long, write_long};
pub use pins::read_pins;
pub use pins_on_board::read_pins_on_board;
pub use plan::{MAX_PARTS, PartFiles, PartResult, SearchPlan};
pub use probabilities::{ProbabilityGrid, read_probabilities};
pub use read::{Input, MAX_BYTES};
pub use sealed::hexadecimal;
pub use solution::{FORMAT, Layout, Solution, TakeRow, write_solution, write_solution_rows};
pub use solutions::{Solutions, read_solution, solutions};
pub use tile_set::{
    ListedTiles, NamedSet, read_listed_tiles, read_squares, read_tile_set, write_tile_set,
};
pub use toral::{holds_certificate, read_certificate, write_certificate};

use std::path::{Path, PathBuf};

/// The name of a file that belongs to another: the same with something at its end.
pub fn beside(file: &Path, end: &str) -> PathBuf {
    let mut name = file.as_os_str().to_owned();
    name.push(end);
    name.into()
}

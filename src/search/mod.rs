//! Exhaustive search, generic: a walk over a tree that a [`Problem`] describes.
//!
//! Three roles are kept apart. A **problem** says what may go where; it knows no clock, thread
//! or file. The **search** walks; it knows no tiles. A **sink** says what to do with a
//! solution. One object carries a walk, its explicit [`Path`]: the choice made at every level
//! and the alternatives left there. It is what a thread steals from, what a stopped search
//! leaves behind to go on from, and what the honest measure of progress is read off.
//!
//! A *node* is one committed valid placement: one call of [`Problem::push`] by the walk, or one
//! child made where the walk leaves subtrees to a problem ([`sprint`], [`batch`]). The
//! number of nodes of a complete search is a property of the problem alone, the same for any
//! number of threads.
//!
//! This module imports nothing else of the crate.

pub mod alternatives;
pub mod batch;
mod bulk;
pub mod estimate;
pub mod naive;
pub mod part;
pub mod path;
pub mod pool;
pub mod problem;
pub mod progress;
pub mod race;
pub mod restarts;
pub mod sink;
pub mod sprint;
pub mod state;
pub mod stop;
pub mod trail;
pub mod values;
pub mod walk;

pub use alternatives::{Alternatives, Words};
pub use batch::{Bounds, Visited};
pub use part::{Frontier, Part, cut, frontier};
pub use path::Path;
pub use pool::{Plan, run};
pub use problem::Problem;
pub use progress::Progress;
pub use race::{Attempt, Race, Turn, race};
pub use restarts::{Restarts, restart};
pub use sink::{Count, First, Sink};
pub use sprint::{Sprint, Stretch};
pub use state::{Best, Effort, Record, State};
pub use stop::{Limits, Stop};
pub use trail::{Trail, TrailError};
pub use values::Values;
pub use walk::{Slice, Walk};

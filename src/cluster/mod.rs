//! One search on many machines.
//!
//! A [plan](crate::store::SearchPlan) deals a search out into parts that need nothing of each
//! other; what runs them is an existing scheduler. [`slurm()`], [`hyperqueue()`] and [`parallel()`]
//! write the [`Job`] for it. [`merge()`] puts the results together, and refuses what does not
//! belong together.

mod hyperqueue;
mod job;
mod merge;
mod parallel;
mod shell;
mod slurm;

pub use hyperqueue::hyperqueue;
pub use job::{ClusterError, Job};
pub use merge::{MergeError, Merged, merge, missing_words};
pub use parallel::parallel;
pub use shell::quote;
pub use slurm::{Slurm, slurm};

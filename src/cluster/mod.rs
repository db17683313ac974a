//! One search on many machines.
//!
//! A [plan](crate::store::SearchPlan) deals a search out into parts that need nothing of each
//! other; what runs them is an existing scheduler. [`merge()`] puts their results together, and
//! refuses what does not belong together.

mod merge;

pub use merge::{MergeError, Merged, merge, missing_words};

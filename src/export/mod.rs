//! The same problems in the languages of other solvers: a second opinion.
//!
//! * [`instance`]: a task as cells, tiles and labels of a fundamental domain, and how often each
//!   tile must lie, in words that both formats share.
//! * [`cnf`]: propositional logic, in DIMACS CNF; [`cardinality`] says "exactly so many" in it;
//!   [`model`] reads what a SAT solver found.
//! * [`xcc`]: exact cover with colors and multiplicities, in the format of Knuth's programs.
//!
//! What is written is the task itself, without the reductions of our search: a second opinion
//! should share as little with the first as it can.

pub mod cardinality;
pub mod cnf;
pub mod instance;
pub mod model;
pub mod xcc;

pub use cnf::Cnf;
pub use instance::{ExportError, Instance};
pub use model::{Model, ModelError};
pub use xcc::Xcc;

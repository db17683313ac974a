//! The options of the commands about aperiodic sets.

use clap::Subcommand;

/// What to do with sets of tiles.
#[derive(Debug, Clone, Subcommand)]
pub enum AperiodicCommand {}

//! The options of the commands that write a problem for other solvers.

use super::ProblemArgs;
use clap::Args;
use std::path::PathBuf;

/// A problem in propositional logic.
#[derive(Debug, Clone, Args)]
pub struct ExportCnfArgs {
    /// The packings in question.
    #[command(flatten)]
    pub problem: ProblemArgs,
    /// Instead of writing the problem, read what a SAT solver printed about it (- is standard
    /// input) and give the packing it found
    #[arg(long, value_name = "FILE", help_heading = "Result")]
    pub model: Option<PathBuf>,
    /// Where it goes.
    #[command(flatten)]
    pub out: ExportOut,
}

/// A problem of exact cover.
#[derive(Debug, Clone, Args)]
pub struct ExportXccArgs {
    /// The packings in question.
    #[command(flatten)]
    pub problem: ProblemArgs,
    /// Where it goes.
    #[command(flatten)]
    pub out: ExportOut,
}

/// Where a problem goes, and what is said about it.
#[derive(Debug, Clone, Args)]
pub struct ExportOut {
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// No remarks on standard error
    #[arg(long, help_heading = "Result")]
    pub quiet: bool,
    /// One JSON object on standard output; for a problem it needs -o
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

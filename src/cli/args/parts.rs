//! The options of searches in parts: `plan`, `run`, `merge` and `cluster`.

use super::super::{cluster, help};
use super::{ProblemArgs, RunArgs, orders};
use crate::store::MAX_PARTS;
use crate::torus::Order;
use clap::{Args, Subcommand};
use std::path::PathBuf;

/// A search in parts.
#[derive(Debug, Clone, Args)]
pub struct PlanArgs {
    /// The packings in question.
    #[command(flatten)]
    pub problem: ProblemArgs,
    /// The order in which cells are filled; it changes the time, not the packings
    #[arg(long, value_name = "ORDER", value_parser = orders(), help_heading = "Search")]
    pub order: Option<Order>,
    /// Search without removing symmetry first: slow, for checking; same answer
    #[arg(long, help_heading = "Search")]
    pub plain: bool,
    /// Count as --method meet does, by two halves that meet in the middle
    #[arg(long, conflicts_with_all = ["list", "up_to_symmetry", "plain"], help_heading = "Search")]
    pub meet: bool,
    /// A list of the packings instead of their number
    #[arg(long, help_heading = "Search")]
    pub list: bool,
    /// Also count up to symmetry, or list only one packing of each orbit
    #[arg(long, help_heading = "Search")]
    pub up_to_symmetry: bool,
    /// Number of parts
    #[arg(long, value_name = "M", value_parser = clap::value_parser!(u64).range(1..=MAX_PARTS), help_heading = "Parts")]
    pub parts: u64,
    /// Choices that lead to the nodes dealt out to the parts [default: the fewest that lead to
    /// enough of them, the same for any M up to 4096]
    #[arg(long, value_name = "D", value_parser = clap::value_parser!(u32).range(1..), help_heading = "Parts")]
    pub depth: Option<u32>,
    /// Write the plan to this file
    #[arg(short, long, value_name = "PLAN", help_heading = "Result")]
    pub output: PathBuf,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// A part of a plan.
#[derive(Debug, Clone, Args)]
pub struct PartArgs {
    /// The plan
    #[arg(value_name = "PLAN")]
    pub plan: PathBuf,
    /// Number of the part, from 0
    #[arg(long, value_name = "R")]
    pub part: u64,
    /// Folder for checkpoints and results of parts; made if it is not there [default: PLAN.parts]
    #[arg(long, value_name = "DIR")]
    pub dir: Option<PathBuf>,
    /// Limits, threads, what is shown.
    #[command(flatten)]
    pub run: RunArgs,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// The parts of a plan.
#[derive(Debug, Clone, Args)]
pub struct MergeArgs {
    /// The plan
    #[arg(value_name = "PLAN")]
    pub plan: PathBuf,
    /// Folder with the results of the parts [default: PLAN.parts]
    #[arg(long, value_name = "DIR")]
    pub dir: Option<PathBuf>,
    /// Write the list to this file instead of standard output (plans of lists only)
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
    /// No remarks on standard error, only errors and warnings
    #[arg(long, help_heading = "Result")]
    pub quiet: bool,
}

/// The schedulers.
#[derive(Debug, Clone, Subcommand)]
pub enum ClusterCommand {
    /// A script for Slurm: array jobs, a task for each part
    #[command(after_help = help::CLUSTER)]
    Slurm(SlurmArgs),
    /// A script for HyperQueue: a task for each part
    #[command(after_help = help::CLUSTER)]
    Hyperqueue(JobArgs),
    /// A script for GNU parallel: the parts on the cores of one machine
    #[command(after_help = help::CLUSTER)]
    Parallel(JobArgs),
}

/// The parts of a plan.
#[derive(Debug, Clone, Args)]
pub struct JobArgs {
    /// The plan, written by the command plan
    #[arg(value_name = "PLAN")]
    pub plan: PathBuf,
    /// Where the parts keep checkpoints, results and logs [default: PLAN.parts]
    #[arg(long, value_name = "DIR")]
    pub dir: Option<PathBuf>,
    /// Threads of each part
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: u16,
    /// Time from one checkpoint to the next: 500ms, 90s, 10m, 2h [default: that of run]
    #[arg(long, value_name = "TIME", value_parser = cluster::checkpoint_every)]
    pub checkpoint_every: Option<String>,
    /// The program as the nodes find it: a name on their path, or a file
    #[arg(long, value_name = "PROGRAM", default_value = "tilepack")]
    pub program: PathBuf,
    /// Write the script to this file instead of standard output
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
}

/// The parts of a plan, for Slurm.
#[derive(Debug, Clone, Args)]
pub struct SlurmArgs {
    /// The parts.
    #[command(flatten)]
    pub job: JobArgs,
    /// Time limit of a part's run; at the end it is stopped and put back in the queue [default:
    /// that of the site]
    #[arg(long, value_name = "HH:MM:SS", value_parser = cluster::time_limit)]
    pub time: Option<String>,
    /// Tasks of one array at most: MaxArraySize of the site
    #[arg(long, value_name = "N", default_value_t = 1001, value_parser = clap::value_parser!(u64).range(1..=4_000_001))]
    pub max_array: u64,
}

//! The options of `find`.

use super::super::ring::RingOrder;
use super::{ProblemArgs, SearchArgs};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

fn aspect(text: &str) -> Result<f64, String> {
    let ratio: f64 = text.parse().map_err(|_| "expected a number such as 1.5".to_owned())?;
    if ratio >= 1.0 { Ok(ratio) } else { Err("expected a number of at least 1".to_owned()) }
}

/// One packing.
#[derive(Debug, Clone, Args)]
pub struct FindArgs {
    /// The packings in question.
    #[command(flatten)]
    pub problem: ProblemArgs,
    /// How to search.
    #[command(flatten)]
    pub search: SearchArgs,
    /// How to find it
    #[arg(long, value_enum, default_value_t = Method::Auto)]
    pub method: Method,
    /// Partial packings that beam search keeps at every cell [default: 1000 for complete
    /// sets, 8000 with all colors in the first row; else 3000]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=200_000))]
    pub beam_width: Option<u32>,
    /// Colors that beam search draws the first row from (of a torus wider than high, the last
    /// column) [default: two]
    #[arg(long, value_enum)]
    pub first_row: Option<FirstRow>,
    /// The rings that dominoes and Wang tiles are constructed from
    #[arg(long, value_enum, default_value_t = RingOrder::Least)]
    pub ring: RingOrder,
    /// Corner tiles: a packing that holds packings over fewer and fewer colors in its
    /// south-west, built up from two colors by beam search
    #[arg(long)]
    pub recursive: bool,
    /// With --cover --method anneal and no --size: the longest side is at most R times the
    /// shortest
    #[arg(long, value_name = "R", value_parser = aspect)]
    pub aspect: Option<f64>,
    /// The order in which colors or tiles are tried
    #[arg(long, value_enum, default_value_t = ValueOrder::Lexicographic)]
    pub values: ValueOrder,
    /// Begin the search again and again, each time in another random order, after N nodes times
    /// 1, 1, 2, 1, 1, 2, 4, ... (Luby) [without N: 100000]
    #[arg(
        long,
        value_name = "N",
        num_args = 0..=1,
        default_missing_value = "100000",
        value_parser = clap::value_parser!(u64).range(1..)
    )]
    pub restarts: Option<u64>,
    /// With --method portfolio: a packing with an automorphism will do, too
    #[arg(long)]
    pub symmetric: bool,
    /// Write the packing to this file (JSON) instead of a grid to standard output
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// Ways to find a packing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// A construction where one is known, annealing or beam search where they are quick, else
    /// search; search also when an option asks for one. Says which, and why
    Auto,
    /// A packing known in closed form, or none; --seed other than 0 chooses a random member of
    /// its family
    Construct,
    /// Exhaustive search
    Search,
    /// Beam search: unrestricted packings of corner tiles in seconds; never says there is none
    Beam,
    /// Annealing: compact corner sets on tori with a side that is a multiple of the colors. With
    /// --cover: coverings of corner tiles on the torus of --size, or the smallest that is found
    /// in the time. Never says there is none
    Anneal,
    /// Search in order, searches in random order, beam search, in turns that become longer and
    /// longer, until one of them finds a packing; says which
    Portfolio,
}

/// Colors of the first row of a beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum FirstRow {
    /// Two of them, drawn at random. The last row must fit the first, and few colors leave it far
    /// more choice: some twenty times less work on all 256 tiles over four colors
    Two,
    /// All of them: less special packings
    All,
}

impl FirstRow {
    /// As on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Two => "two",
            Self::All => "all",
        }
    }
}

/// Orders of alternatives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ValueOrder {
    /// Smallest first
    Lexicographic,
    /// In random order, by --seed
    Random,
    /// Largest first
    Highest,
}

//! The command line as it is typed: commands, options and their help, nothing else.
//!
//! What depends on more than one option (colors on the kind, a size on the set) is kept as text
//! here and read in [`super::problem`], where errors can say more.

mod aperiodic;
mod atlas;
mod board;
mod brick;
mod cube;
mod dapple;
mod export;
mod fill;
mod find;
mod formats;
mod parts;
mod shader;
mod tile;
mod walk;

pub use aperiodic::{
    AperiodicCommand, AperiodicSetsArgs, ClassifyArgs, ColorArgs, ConditionArg, ConvertArgs,
    DecideArgs, PatchArgs, TablesArgs, UpToArg,
};
pub use atlas::{ArrangeArg, AtlasArgs, ChannelsArg, GutterArg, LintArgs, TilePictureArgs};
pub use board::BoardArgs;
pub use brick::BrickArgs;
pub use cube::{CubeArgs, CubeKindArg};
pub use dapple::{
    DappleCheckArgs, DappleClosestArgs, DappleCommand, DappleCountArgs, DappleDecideArgs,
    DappleDrawArgs, DappleFlowArgs, DappleMakeArgs, DappleSampleArgs, OrderArg, RuleArgs, StartArg,
};
pub use export::{ExportCnfArgs, ExportOut, ExportXccArgs};
pub use fill::{AlphaArg, FillArgs, FillMethod};
pub use find::{FindArgs, FirstRow, Method, ValueOrder};
pub use formats::{ExportArgs, ImportArgs, To};
pub use parts::{ClusterCommand, JobArgs, MergeArgs, PartArgs, PlanArgs, SlurmArgs};
pub use shader::{ColoringArg, Lookup, ShaderArgs};
pub use tile::TileArgs;
pub use walk::WalkArgs;

use super::ring::RingOrder;
use super::{duration, help};
use crate::packing::Prunings;
use crate::tiles::Kind;
use crate::torus::Order;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;
use std::time::Duration;

/// Finds, counts, lists, verifies and draws packings of corner tiles, Wang tiles and dominoes
/// on a torus.
#[derive(Debug, Parser)]
#[command(name = "tilepack", version, about, long_about = help::PROGRAM, after_help = help::EXAMPLES)]
#[command(disable_help_subcommand = true, max_term_width = 100)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Find one packing
    #[command(after_help = help::FIND)]
    Find(FindArgs),
    /// Say where a tile lies in the constructed packing
    #[command(after_help = help::LOCATE)]
    Locate(LocateArgs),
    /// Count all packings, exactly
    #[command(after_help = help::COUNT)]
    Count(CountArgs),
    /// List all packings, sorted, one JSON object a line
    #[command(after_help = help::LIST)]
    List(ListArgs),
    /// Go on with a search that was saved
    #[command(after_help = help::RESUME)]
    Resume(ResumeArgs),
    /// Divide a count or a list into parts for several machines
    #[command(after_help = help::PLAN)]
    Plan(PlanArgs),
    /// Search one part of a plan
    #[command(after_help = help::RUN)]
    Run(PartArgs),
    /// Put the parts of a plan together
    #[command(after_help = help::MERGE)]
    Merge(MergeArgs),
    /// Estimate the number of packings and the size of the search, by random probes
    #[command(after_help = help::ESTIMATE)]
    Estimate(EstimateArgs),
    /// Write the problem for a SAT solver, in DIMACS CNF, or read what one found
    #[command(after_help = help::EXPORT_CNF)]
    ExportCnf(ExportCnfArgs),
    /// Write the problem as exact cover with colors, for Knuth's DLX2 and DLX3
    #[command(after_help = help::EXPORT_XCC)]
    ExportXcc(ExportXccArgs),
    /// Make a texture of a packing: the atlas, its mip levels, tables, a viewer
    #[command(after_help = help::ATLAS)]
    Atlas(AtlasArgs),
    /// Find out whether the tiles of a sheet fit
    #[command(after_help = help::LINT)]
    Lint(LintArgs),
    /// Make the pictures of tiles from examples, so that they fit without seams
    #[command(after_help = help::FILL)]
    Fill(FillArgs),
    /// Say which tile lies at a place of an endless tiling
    #[command(after_help = help::TILE)]
    Tile(TileArgs),
    /// Write a packing for other programs: map editors, engines, shaders, pictures
    #[command(after_help = help::EXPORT)]
    Export(ExportArgs),
    /// Convert, decide, classify and find sets of tiles that fill the plane without a period
    #[command(after_help = help::APERIODIC, subcommand, disable_help_subcommand = true)]
    Aperiodic(AperiodicCommand),
    /// Make, count, complete and check tilings in which nothing repeats for too long
    #[command(after_help = help::DAPPLE, subcommand, disable_help_subcommand = true)]
    Dapple(DappleCommand),
    /// Build a brick wall of Wang tiles: joints meet, but never cross
    #[command(after_help = help::BRICK)]
    Brick(BrickArgs),
    /// Read a tile set of the map editor Tiled, so that it can be packed
    #[command(after_help = help::IMPORT)]
    Import(ImportArgs),
    /// Check packings from the definition
    #[command(after_help = help::VERIFY)]
    Verify(VerifyArgs),
    /// Draw packings in the terminal
    #[command(after_help = help::SHOW)]
    Show(ShowArgs),
    /// Give the size of a tile set, and its tiles
    #[command(after_help = help::SETS)]
    Sets(SetsArgs),
    /// Construct a packing of cubes on a torus in space
    #[command(after_help = help::CUBE)]
    Cube(CubeArgs),
    /// Go from a packing to another one, by filling patches of it again
    #[command(after_help = help::WALK)]
    Walk(WalkArgs),
    /// Write a job file that runs the parts of a plan with a scheduler
    #[command(after_help = help::CLUSTER, subcommand, disable_help_subcommand = true)]
    Cluster(ClusterCommand),
}

fn kinds() -> impl TypedValueParser<Value = Kind> {
    PossibleValuesParser::new(["corner", "wang", "domino"])
        .try_map(|text| text.parse::<Kind>().map_err(|error| error.to_string()))
}

fn orders() -> impl TypedValueParser<Value = Order> {
    PossibleValuesParser::new(Order::ALL.map(Order::name)).try_map(|text| text.parse::<Order>())
}

/// Which tiles.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Problem")]
pub struct SetArgs {
    /// What carries the colors
    #[arg(long, value_name = "KIND", value_parser = kinds())]
    pub kind: Option<Kind>,
    /// Number of colors C; for Wang tiles and dominoes also CH,CV: first that of the north and
    /// south edges, then that of the east and west edges
    #[arg(long, value_name = "C", allow_hyphen_values = true)]
    pub colors: Option<String>,
    /// The tile set: complete (the default), compact, pruned:0-1,2-3 (no tile shows both colors
    /// of a pair) or a tile set file
    #[arg(long, value_name = "SET")]
    pub set: Option<PathBuf>,
}

/// What is claimed about packings that do not say it themselves.
#[derive(Debug, Clone, Args)]
pub struct ClaimArgs {
    /// The tiles; needed for bare grids, otherwise the file must agree.
    #[command(flatten)]
    pub set: SetArgs,
    /// Every tile at least once instead of exactly once
    #[arg(long)]
    pub cover: bool,
}

/// The packings in question.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Problem")]
pub struct ProblemArgs {
    /// The tiles.
    #[command(flatten)]
    pub set: SetArgs,
    /// Width and height of the torus [default: C^2 x C^2 (CV^2 x CH^2) for complete corner and
    /// Wang sets, a row for dominoes, else as square as possible]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    pub size: Option<String>,
    /// What the packing lies on.
    #[command(flatten)]
    pub board: BoardArgs,
    /// Every tile at least once instead of exactly once
    #[arg(long)]
    pub cover: bool,
    /// A symmetry that the packing must have.
    #[arg(
        long,
        value_name = "DX,DY:PERM",
        allow_hyphen_values = true,
        help = "Only packings a with a[row+DY][column+DX] = PERM(a[row][column]); PERM is +1 (add \
                1 modulo C) or the list of the images of all colors, such as 1,2,3,0; auto \
                takes one that suits"
    )]
    pub automorphism: Option<String>,
    /// Cells given beforehand: a grid with . (or a solution with null) for free cells
    #[arg(long, value_name = "FILE")]
    pub pin: Option<PathBuf>,
}

/// How to search.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Search")]
pub struct SearchArgs {
    /// The order in which cells are filled; it changes the time, not the packings
    #[arg(long, value_name = "ORDER", value_parser = orders())]
    pub order: Option<Order>,
    /// Seed of random choices
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    /// Search without removing symmetry first: slow, for checking; same answer
    #[arg(long)]
    pub plain: bool,
    /// What cuts the tree of corner packings: caps (no domino more often than the set has it),
    /// last-rows (the open rows can be closed), caps,last-rows or none; it changes the nodes, not
    /// the packings
    #[arg(long, value_name = "LIST", default_value_t)]
    pub prunings: Prunings,
    /// Save the search to this file while it runs; if the file is there, go on from it. DIR/ is
    /// a file in that folder named after the search [without FILE: checkpoints/]
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "checkpoints/")]
    pub checkpoint: Option<PathBuf>,
    /// Limits, threads, what is shown.
    #[command(flatten)]
    pub run: RunArgs,
}

/// What may differ from one run of a search to the next.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Search")]
pub struct RunArgs {
    /// Stop after this time: 500ms, 90s, 10m, 2h, 1d; a number alone is in seconds
    #[arg(long, value_name = "TIME", value_parser = duration::parse)]
    pub time_limit: Option<Duration>,
    /// Stop after this many nodes (valid placements), over all threads
    #[arg(long, value_name = "N")]
    pub node_limit: Option<u64>,
    /// Time between two checkpoints, and two looks at --status
    #[arg(long, value_name = "TIME", value_parser = duration::parse, default_value = "60s")]
    pub checkpoint_every: Duration,
    /// Write how far the search is to this file (JSON) once a checkpoint
    #[arg(long, value_name = "FILE")]
    pub status: Option<PathBuf>,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// No progress and no remarks on standard error, only errors, warnings and early stops
    #[arg(long)]
    pub quiet: bool,
}

/// Tiles to look up.
#[derive(Debug, Clone, Args)]
pub struct LocateArgs {
    /// The tiles of the packing.
    #[command(flatten)]
    pub set: SetArgs,
    /// Width and height of the torus [default: as find]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, help_heading = "Problem")]
    pub size: Option<String>,
    /// Which member of the family; 0 is the closed form itself
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = "Problem")]
    pub seed: u64,
    /// The rings that dominoes and Wang tiles are constructed from
    #[arg(long, value_enum, default_value_t = RingOrder::Least, help_heading = "Problem")]
    pub ring: RingOrder,
    /// Tile numbers, or colors: NE,SE,SW,NW of a corner tile, N,E,S,W of a Wang tile,
    /// first,second of a domino
    #[arg(required = true, value_name = "TILE")]
    pub tiles: Vec<String>,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// The number of packings.
#[derive(Debug, Clone, Args)]
pub struct CountArgs {
    /// The packings in question.
    #[command(flatten)]
    pub problem: ProblemArgs,
    /// How to search.
    #[command(flatten)]
    pub search: SearchArgs,
    /// How to count
    #[arg(long, value_enum, default_value_t = CountMethod::Auto, help_heading = "Search")]
    pub method: CountMethod,
    /// Also count packings up to symmetry: translations, color permutations, and the rotations
    /// and reflections that keep the torus and the set
    #[arg(long, help_heading = "Result")]
    pub up_to_symmetry: bool,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// Ways to count packings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum CountMethod {
    /// The formula for more than 16 dominoes where no option asks for a search; else search
    Auto,
    /// Exhaustive search
    Search,
    /// The BEST theorem: rings of any set of dominoes
    Formula,
    /// Two halves that meet in the middle, counted without looking at any packing as a whole:
    /// corner tiles on a torus with short rows or columns; up to 64 Wang tiles, or squares that
    /// may be turned, on any board
    Meet,
}

/// All packings.
#[derive(Debug, Clone, Args)]
pub struct ListArgs {
    /// The packings in question.
    #[command(flatten)]
    pub problem: ProblemArgs,
    /// How to search.
    #[command(flatten)]
    pub search: SearchArgs,
    /// Only one packing of those that symmetry makes of each other, the canonical one
    #[arg(long, help_heading = "Result")]
    pub up_to_symmetry: bool,
    /// Write the list to this file instead of standard output
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// One JSON object about the list on standard output; needs -o
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// A search that was saved.
#[derive(Debug, Clone, Args)]
pub struct ResumeArgs {
    /// The checkpoint
    #[arg(value_name = "CHECKPOINT")]
    pub file: PathBuf,
    /// Limits, threads, what is shown.
    #[command(flatten)]
    pub run: RunArgs,
    /// Write the result to this file [default: as the command that began the search]
    #[arg(short, long, value_name = "FILE", help_heading = "Result")]
    pub output: Option<PathBuf>,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// How many packings there may be.
#[derive(Debug, Clone, Args)]
pub struct EstimateArgs {
    /// The packings in question.
    #[command(flatten)]
    pub problem: ProblemArgs,
    /// The order in which cells are filled; it changes the tree, not the packings
    #[arg(long, value_name = "ORDER", value_parser = orders(), help_heading = "Search")]
    pub order: Option<Order>,
    /// Seed of the probes
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = "Search")]
    pub seed: u64,
    /// Estimate the search that removes no symmetry first
    #[arg(long, help_heading = "Search")]
    pub plain: bool,
    /// Nodes to probe, about: ten times as many make the intervals a third as wide
    #[arg(long, value_name = "N", default_value_t = 250_000_000, help_heading = "Search")]
    pub node_limit: u64,
    /// Stop after this time: 500ms, 90s, 10m, 2h, 1d; a number alone is in seconds
    #[arg(long, value_name = "TIME", value_parser = duration::parse, help_heading = "Search")]
    pub time_limit: Option<Duration>,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024), help_heading = "Search")]
    pub threads: Option<u16>,
    /// No remarks on standard error, only errors, warnings and early stops
    #[arg(long, help_heading = "Search")]
    pub quiet: bool,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// Packings to check.
#[derive(Debug, Clone, Args)]
pub struct VerifyArgs {
    /// Solution files, lists or text grids; - is standard input
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// What the files are.
    #[command(flatten)]
    pub claim: ClaimArgs,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024), help_heading = "Result")]
    pub threads: Option<u16>,
    /// Ask for more than a packing: one that holds packings over fewer and fewer colors in its
    /// south-west
    #[arg(long, help_heading = "Result")]
    pub recursive: bool,
    /// Nothing about valid files; only what is wrong, and the exit code
    #[arg(long, help_heading = "Result")]
    pub quiet: bool,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

/// Packings to draw.
#[derive(Debug, Clone, Args)]
pub struct ShowArgs {
    /// Solution file, list or text grid; - is standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What the file is.
    #[command(flatten)]
    pub claim: ClaimArgs,
    /// Write the number of every tile into it
    #[arg(long, help_heading = "Result")]
    pub indices: bool,
    /// Whether to use colors; auto: on a terminal, unless NO_COLOR is set
    #[arg(long, value_enum, default_value_t = When::Auto, help_heading = "Result")]
    pub color: When,
}

/// When to do something that suits a terminal only.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum When {
    /// On a terminal
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

/// A tile set.
#[derive(Debug, Clone, Args)]
pub struct SetsArgs {
    /// The tiles.
    #[command(flatten)]
    pub set: SetArgs,
    /// List the tiles, too
    #[arg(long, help_heading = "Result")]
    pub list: bool,
    /// One JSON object on standard output
    #[arg(long, help_heading = "Result")]
    pub json: bool,
}

//! The command line: raw arguments to a library call, and its answer to people and programs.
//!
//! * [`args`] is the command line as typed, [`help`] its longer texts; [`set`] and [`problem`]
//!   turn it into what the library wants and refuse what makes no sense.
//! * One file a command: [`find`] (by [`construct`], [`anneal`], [`beam`], [`cover`], [`restarts`] or
//!   [`portfolio`], whichever it is told to or [`choose`]s), [`locate`], [`tile`] (of a [`tiling`]),
//!   [`count`] (also by [`formula`]), [`list`], [`estimate`], [`export`] (for other solvers),
//!   [`atlas`] and [`lint`] (textures, of [`tile_pictures`]), [`mod@fill`] (tiles from examples),
//!   [`formats`] (for other programs, of which [`export_shader`] writes shaders) and [`import`],
//!   [`mod@aperiodic`], [`mod@dapple`], [`brick`], [`resume`], [`plan`], [`part`] (the command
//!   `run`), [`merge`], [`cluster`] (job files), [`verify`] (with [`recursive`]), [`show`],
//!   [`sets`], [`cube`], [`walk`]; [`ring`] is the option `--ring` of two of them.
//! * [`session`] runs a search with limits, [`signal`]s, [`progress`], [`eta`] (the time that is
//!   left) and [`status`]; [`saving`] keeps it in a checkpoint, along with the [`request`] that
//!   the answer is for.
//! * [`output`] writes results to standard output and remarks to standard error; [`exit`] holds
//!   the exit codes. [`draw`] and its palette draw packings.
//!
//! Options, JSON fields and exit codes are a contract: other programs rely on them.

pub mod anneal;
pub mod aperiodic;
pub mod args;
pub mod atlas;
pub mod beam;
mod board;
pub mod brick;
pub mod choose;
pub mod cluster;
pub mod construct;
pub mod count;
pub mod cover;
pub mod cube;
pub mod dapple;
pub mod describe;
pub mod draw;
pub mod duration;
pub mod estimate;
pub mod eta;
pub mod exit;
pub mod export;
pub mod export_shader;
pub mod fill;
pub mod find;
pub mod formats;
pub mod formula;
pub mod found;
pub mod help;
pub mod import;
pub mod lint;
pub mod list;
pub mod locate;
pub mod memory;
pub mod merge;
pub mod output;
pub mod part;
pub mod plan;
pub mod portfolio;
pub mod problem;
pub mod progress;
pub mod recursive;
pub mod request;
pub mod restarts;
pub mod resume;
pub mod ring;
pub mod saving;
pub mod session;
pub mod set;
pub mod sets;
pub mod show;
pub mod signal;
pub mod source;
pub mod status;
pub mod tile;
pub mod tile_pictures;
pub mod tile_stats;
pub mod tiling;
pub mod verify;
pub mod walk;

use args::{Cli, Command};
use clap::Parser;
use exit::Exit;

/// Runs the program with the arguments of the process.
pub fn run() -> Exit {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => {
            // Help goes to standard output, a complaint to standard error; if nobody reads it,
            // so be it.
            let _ = error.print();
            return if error.use_stderr() { Exit::Bad } else { Exit::Yes };
        }
    };
    let exit = match &cli.command {
        Command::Find(args) => find::run(args),
        Command::Locate(args) => locate::run(args),
        Command::Tile(args) => tile::run(args),
        Command::Count(args) => count::run(args),
        Command::List(args) => list::run(args),
        Command::Estimate(args) => estimate::run(args),
        Command::Resume(args) => resume::run(args),
        Command::Plan(args) => plan::run(args),
        Command::Run(args) => part::run(args),
        Command::Merge(args) => merge::run(args),
        Command::ExportCnf(args) => export::run_cnf(args),
        Command::ExportXcc(args) => export::run_xcc(args),
        Command::Atlas(args) => atlas::run(args),
        Command::Lint(args) => lint::run(args),
        Command::Fill(args) => fill::run(args),
        Command::Export(args) => formats::run(args),
        Command::Aperiodic(command) => aperiodic::run(command),
        Command::Dapple(command) => dapple::run(command),
        Command::Brick(args) => brick::run(args),
        Command::Import(args) => import::run(args),
        Command::Verify(args) => verify::run(args),
        Command::Show(args) => show::run(args),
        Command::Sets(args) => sets::run(args),
        Command::Cube(args) => cube::run(args),
        Command::Walk(args) => walk::run(args),
        Command::Cluster(command) => cluster::run(command),
    };
    exit.unwrap_or_else(|error| {
        if error.is::<output::Closed>() {
            return Exit::Yes;
        }
        output::remark(&format!("{error:#}"));
        Exit::Bad
    })
}

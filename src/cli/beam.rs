//! `find --method beam`: a first packing of corner tiles by beam search.
//!
//! What the beam cannot be asked for is refused before anything runs: it knows no
//! automorphisms and no coverings. It never says that there is no packing, so without a limit it
//! goes on until it finds one or is told to stop.

use super::args::{FindArgs, FirstRow, Method, ValueOrder};
use super::exit::Exit;
use super::found::{Found, Heuristic};
use super::session::{Ended, Session};
use super::{board, describe, problem};
use crate::beam::{self, Options, Outcome};
use crate::packing::Task;
use crate::store::check_writable;
use crate::tiles::{Kind, Members};
use crate::torus::Shape;
use crate::verify;
use anyhow::{Context, bail};
use serde_json::json;

/// Runs the command; `why` it was chosen, if the program did.
///
/// # Errors
/// Options that the beam does not know, bad input, or a file that cannot be written.
pub fn run(args: &FindArgs, why: Option<String>) -> anyhow::Result<Exit> {
    refuse(args)?;
    let task = problem::task(&args.problem, None)?;
    if task.set.kind() != Kind::Corner {
        let asked = if args.recursive { "--recursive" } else { "--method beam" };
        bail!("{asked} is for corner tiles, not for {} tiles", task.set.kind());
    }
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    if args.recursive {
        let shape = Shape::default_for(&task.set)?;
        if *task.set.members() != Members::Complete || task.shape != shape || task.has_pins() {
            bail!("--recursive is for all corner tiles over C colors on C^2 x C^2, without --pin");
        }
    }
    let session = Session::new(&args.search.run)?;
    let best = match args.recursive {
        true => Options::for_recursion(&task.set),
        false => Options::for_set(&task.set),
    };
    let mut options = Options { seed: args.search.seed, ..best };
    if args.first_row == Some(FirstRow::All) {
        options = options.over_all_colors(&task.set);
    }
    options.width = args.beam_width.map_or(options.width, |width| width as usize);
    let (seed, width) = (json!(options.seed), json!(options.width));
    let first_row = json!(args.first_row.unwrap_or(FirstRow::Two).name());
    let mut fields = vec![("seed", seed), ("beam_width", width), ("why", json!(why))];
    if !args.recursive {
        fields.push(("first_row", first_row));
    }
    let heuristic = Heuristic { args, shape: Some(task.shape), fields };
    if let Some(reason) = task.impossible() {
        return heuristic.none(&reason);
    }
    let (outcome, ended) = session.bounded(|threads, limits| {
        let options = Options { threads, ..options };
        if args.recursive {
            return beam::find_recursive(task.set.colors().largest(), &options, limits);
        }
        beam::find_around(&task.set, task.shape, Some(&task.pins), &options, limits)
    });
    let outcome = outcome.context("--method beam")?;
    give(&heuristic, &session, &task, options, &outcome, &ended)
}

/// Refuses options that would be left out of account.
fn refuse(args: &FindArgs) -> anyhow::Result<()> {
    board::refuse(&args.problem, "--method beam")?;
    let (problem, search) = (&args.problem, &args.search);
    for (given, option, why) in [
        (problem.automorphism.is_some(), "--automorphism", "it knows no symmetry"),
        (problem.cover, "--cover", "it places every tile exactly once"),
        (search.order.is_some(), "--order", "it fills rows along the short side"),
        (args.values == ValueOrder::Random, "--values random", "it is random already"),
        (args.values == ValueOrder::Highest, "--values highest", "it is random"),
        (args.restarts.is_some(), "--restarts", "it has its own"),
        (search.plain, "--plain", "it removes no symmetry"),
        (search.checkpoint.is_some(), "--checkpoint", "there is nothing to go on from"),
        (search.run.status.is_some(), "--status", "nobody knows how far it is"),
    ] {
        if given {
            bail!("--method beam and {option} do not go together: {why}");
        }
    }
    Ok(())
}

/// Refuses what belongs to a beam for any other method.
///
/// # Errors
/// When it is given.
pub fn refuse_elsewhere(args: &FindArgs) -> anyhow::Result<()> {
    if args.recursive && !matches!(args.method, Method::Auto | Method::Beam) {
        bail!(
            "--recursive needs --method beam; of dominoes and Wang tiles --ring wei is recursive"
        );
    }
    if args.beam_width.is_some() && args.method != Method::Beam && !args.recursive {
        bail!("--beam-width needs --method beam");
    }
    if args.first_row.is_some() && args.recursive {
        bail!("--first-row and --recursive do not go together: the first row is given");
    }
    if args.first_row.is_some() && args.method != Method::Beam {
        bail!("--first-row needs --method beam");
    }
    Ok(())
}

/// Writes what the beam came to.
fn give(
    heuristic: &Heuristic<'_>,
    session: &Session<'_>,
    task: &Task,
    Options { seed, width, .. }: Options,
    outcome: &Outcome,
    ended: &Ended,
) -> anyhow::Result<Exit> {
    let nodes = outcome.nodes;
    let Some(labels) = &outcome.labels else {
        let (cells, depth) = (task.shape.cells(), outcome.depth);
        let restarts = describe::number(outcome.restart, "restart");
        let how_far = format!(
            "{nodes} nodes, {restarts}, most cells filled {depth} of {cells}; no packing found so \
             far"
        );
        let fields = vec![("restarts", json!(outcome.restart))];
        return heuristic.stopped("beam", ended, nodes, fields, &how_far);
    };
    let packing = task.lattice().packing(labels, &task.set, false);
    let mut how = "beam search".to_owned();
    if heuristic.args.recursive {
        if let Some(fault) = verify::check_recursion(&packing).fault {
            bail!("internal error: the packing is not recursive: {fault}; please report this");
        }
        how += " around a packing over one color less, and so on";
    }
    let all = match heuristic.args.first_row {
        Some(FirstRow::All) => ", all colors in the first row",
        _ => "",
    };
    how += &format!(" (seed {seed}, width {width}{all}, restart {})", outcome.restart);
    let first_row = heuristic.args.first_row.map(FirstRow::name);
    let mut provenance = vec![
        ("nodes", json!(nodes.to_string())),
        ("seed", json!(seed)),
        ("beam_width", json!(width)),
        ("restart", json!(outcome.restart)),
    ];
    provenance.extend(first_row.map(|name| ("first_row", json!(name))));
    let found = Found {
        packing: &packing,
        method: "beam",
        how: &how,
        remark: &format!("{nodes} nodes"),
        nodes,
        fields: vec![("restart", json!(outcome.restart))],
        provenance,
    };
    heuristic.found(session, found, ended)
}

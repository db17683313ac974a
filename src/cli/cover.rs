//! `find --cover --method anneal`: coverings of corner sets, as small as can be had in the time.
//!
//! With --size only that torus is looked at, under --automorphism if there is one. Without it the
//! smallest covering is looked for, both by annealing and by beam search, and the answer says what
//! is proved: that no covering has fewer cells than so many, and why. A set of which a tile fits
//! nowhere has none at all.

use super::args::{FindArgs, Method, ValueOrder};
use super::exit::Exit;
use super::found::{Found, Heuristic};
use super::session::{Ended, Session};
use super::{board, describe, problem, set};
use crate::anneal;
use crate::cover::bound::excluded;
use crate::cover::{Bound, NoBound, Options, Smallest, on_torus, smallest};
use crate::store::check_writable;
use crate::tiles::TileSet;
use crate::torus::{Fold, Lattice, Shape};
use anyhow::{Context, bail};
use serde_json::json;
use std::time::Duration;

/// How long the smallest covering is looked for when no limit is given.
const PATIENCE: Duration = Duration::from_secs(10);

/// Runs the command; `why` it was chosen, if the program did.
///
/// # Errors
/// Options that annealing does not know, bad input, or a file that cannot be written.
pub fn run(args: &FindArgs, why: Option<String>) -> anyhow::Result<Exit> {
    refuse(args)?;
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    match &args.problem.size {
        Some(_) => one_torus(args, why),
        None => every_size(args, why),
    }
}

/// Refuses options that would be left out of account.
fn refuse(args: &FindArgs) -> anyhow::Result<()> {
    board::refuse(&args.problem, "--method anneal")?;
    let (problem, search) = (&args.problem, &args.search);
    for (given, option, why) in [
        (problem.pin.is_some(), "--pin", "it chooses every cell itself"),
        (search.order.is_some(), "--order", "it fills cells in random order"),
        (args.values == ValueOrder::Random, "--values random", "it is random already"),
        (args.values == ValueOrder::Highest, "--values highest", "it is random"),
        (args.restarts.is_some(), "--restarts", "it has its own"),
        (search.plain, "--plain", "it removes no symmetry"),
        (search.checkpoint.is_some(), "--checkpoint", "there is nothing to go on from"),
        (search.run.status.is_some(), "--status", "nobody knows how far it is"),
    ] {
        if given {
            bail!("--method anneal and {option} do not go together: {why}");
        }
    }
    if problem.size.is_some() && args.aspect.is_some() {
        bail!("--aspect and --size do not go together: the size says how long the sides are");
    }
    if problem.size.is_none() && problem.automorphism.is_some() {
        bail!("--automorphism needs --size: it belongs to one torus");
    }
    Ok(())
}

/// Refuses an aspect ratio for any other method.
///
/// # Errors
/// When it is given.
pub fn refuse_aspect(args: &FindArgs) -> anyhow::Result<()> {
    let suits = matches!(args.method, Method::Anneal | Method::Auto) && args.problem.cover;
    if args.aspect.is_some() && !suits {
        bail!("--aspect needs --cover, and no method but anneal");
    }
    Ok(())
}

fn one_torus(args: &FindArgs, why: Option<String>) -> anyhow::Result<Exit> {
    let task = problem::task(&args.problem, None)?;
    let heuristic = heuristic(args, &task.set, Some(task.shape), &why);
    let session = Session::new(&args.search.run)?;
    let none = |reason: String| heuristic.none(&reason);
    match excluded(&task.set, task.shape) {
        Ok(None) => {}
        Ok(Some(reason)) => return none(format!("size {}: {reason}", task.shape)),
        Err(why @ NoBound::Lonely { .. }) => return none(why.to_string()),
        Err(why) => return Err(why).context("--method anneal"),
    }
    let fold = match &task.automorphism {
        None => Some(Fold::none(task.shape, task.set.colors().largest())),
        Some(symmetry) => {
            let step = (symmetry.dx as usize, symmetry.dy as usize);
            Fold::new(task.shape, step, symmetry.map.vertical())
        }
    };
    let fold = fold.context("--automorphism: the colors are not back when the translation is")?;
    let (orbits, each) = (anneal::orbits(&task.set, &fold).unwrap_or(0), fold.powers().len());
    if orbits > fold.cells() {
        return none(format!(
            "the automorphism makes {orbits} orbits of the tiles, and each takes {each} cells"
        ));
    }
    let fold = task.automorphism.is_some().then_some(fold);
    let (outcome, ended) = session.bounded(|threads, limits| {
        on_torus(&task.set, task.shape, fold, &options(args, threads), limits)
    });
    give(&heuristic, &task.set, &session, &outcome.context("--method anneal")?, &ended)
}

/// How to look; rounds end with the limits.
fn options(args: &FindArgs, threads: usize) -> Options {
    let aspect = args.aspect.unwrap_or(f64::INFINITY);
    Options { seed: args.search.seed, threads, aspect, rounds: u32::MAX, ..Options::default() }
}

fn every_size(args: &FindArgs, why: Option<String>) -> anyhow::Result<Exit> {
    let set = set::tile_set(&args.problem.set, None)?;
    let heuristic = heuristic(args, &set, None, &why);
    let mut run = args.search.run.clone();
    if run.time_limit.is_none() && run.node_limit.is_none() {
        run.time_limit = Some(PATIENCE);
    }
    let session = Session::new(&run)?;
    let (outcome, ended) =
        session.bounded(|threads, limits| smallest(&set, &options(args, threads), limits));
    match outcome {
        Ok(outcome) => give(&heuristic, &set, &session, &outcome, &ended),
        Err(why @ NoBound::Lonely { .. }) => heuristic.none(&why.to_string()),
        Err(why) => Err(why).context("--method anneal"),
    }
}

/// The method at work, for a torus if one was asked for.
fn heuristic<'a>(
    args: &'a FindArgs,
    set: &TileSet,
    shape: Option<Shape>,
    why: &Option<String>,
) -> Heuristic<'a> {
    let fields = vec![
        ("seed", json!(args.search.seed)),
        ("set_size", json!(set.size())),
        ("why", json!(why)),
    ];
    Heuristic { args, shape, fields }
}

/// Writes what was found.
fn give(
    heuristic: &Heuristic<'_>,
    set: &TileSet,
    session: &Session<'_>,
    found: &Smallest,
    ended: &Ended,
) -> anyhow::Result<Exit> {
    let (nodes, bound) = (found.nodes, &found.bound);
    let proved = vec![("lower_bound", json!(bound.cells)), ("bound_reason", json!(bound.reason))];
    let Some(covering) = &found.covering else {
        let how_far = format!("{nodes} nodes and moves; no covering found so far");
        return heuristic.stopped("anneal", ended, nodes, proved, &how_far);
    };
    let lattice = Lattice { kind: set.kind(), shape: covering.shape };
    let how = &covering.how;
    let found = Found {
        packing: &lattice.packing(&covering.labels, set, true),
        method: method(how),
        how,
        remark: &in_words(set, covering.shape, bound),
        nodes,
        fields: proved.iter().cloned().chain([("how", json!(how))]).collect(),
        provenance: proved
            .into_iter()
            .chain([("seed", json!(heuristic.args.search.seed))])
            .collect(),
    };
    heuristic.found(session, found, ended)
}

/// The word for a method of the contract that a way to find something belongs to.
fn method(how: &str) -> &'static str {
    match how.split(' ').next() {
        Some("beam") => "beam",
        Some("search") => "search",
        _ => "anneal",
    }
}

/// `11x3, 33 cells for 31 tiles; no covering has fewer: ...`.
fn in_words(set: &TileSet, shape: Shape, bound: &Bound) -> String {
    let cells = shape.cells() as u64;
    let fewer = match cells == bound.cells {
        true => "no covering has fewer".to_owned(),
        false => format!("no covering has fewer than {}", bound.cells),
    };
    let tiles = describe::number(set.size(), "tile");
    format!("{shape}, {cells} cells for {tiles}; {fewer}: {}", bound.reason)
}

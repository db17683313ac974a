//! `find --cover --method anneal`: coverings of corner sets, as small as can be had in the time.
//!
//! With --size only that torus is looked at, under --automorphism if there is one. Without it the
//! smallest covering is looked for, both by annealing and by beam search, and the answer says what is proved: that no covering has
//! fewer cells than so many, and why. A set of which a tile fits nowhere has none at all.

use super::args::{FindArgs, Method, ValueOrder};
use super::exit::Exit;
use super::session::{Ended, Session};
use super::{describe, output, problem, set};
use crate::anneal;
use crate::cover::bound::excluded;
use crate::cover::{Bound, NoBound, Options, Smallest, on_torus, smallest};
use crate::store::{Layout, check_writable, write_file, write_grid, write_solution};
use crate::tiles::TileSet;
use crate::torus::{Fold, Lattice, Packing, Shape};
use crate::verify;
use anyhow::{Context, bail};
use serde_json::{Value, json};
use std::time::Duration;

/// How long the smallest covering is looked for when no limit is given.
const PATIENCE: Duration = Duration::from_secs(10);

/// Runs the command.
///
/// # Errors
/// Options that annealing does not know, bad input, or a file that cannot be written.
pub fn run(args: &FindArgs) -> anyhow::Result<Exit> {
    refuse(args)?;
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    match &args.problem.size {
        Some(_) => one_torus(args),
        None => every_size(args),
    }
}

/// Refuses options that would be left out of account.
fn refuse(args: &FindArgs) -> anyhow::Result<()> {
    let (problem, search) = (&args.problem, &args.search);
    for (given, option, why) in [
        (problem.pin.is_some(), "--pin", "it chooses every cell itself"),
        (search.order.is_some(), "--order", "it fills cells in random order"),
        (args.values == ValueOrder::Random, "--values random", "it is random already"),
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
    if args.aspect.is_some() && !(args.method == Method::Anneal && args.problem.cover) {
        bail!("--aspect needs --cover --method anneal");
    }
    Ok(())
}

fn one_torus(args: &FindArgs) -> anyhow::Result<Exit> {
    let task = problem::task(&args.problem, None)?;
    let answer = Answer { args, set: &task.set, shape: Some(task.shape) };
    let session = Session::new(&args.search.run)?;
    let none = |reason: String| answer.none(&reason);
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
    answer.give(&session, &outcome.context("--method anneal")?, &ended)
}

/// How to look; rounds end with the limits.
fn options(args: &FindArgs, threads: usize) -> Options {
    let aspect = args.aspect.unwrap_or(f64::INFINITY);
    Options { seed: args.search.seed, threads, aspect, rounds: u32::MAX, ..Options::default() }
}

fn every_size(args: &FindArgs) -> anyhow::Result<Exit> {
    let set = set::tile_set(&args.problem.set, None)?;
    let answer = Answer { args, set: &set, shape: None };
    let mut run = args.search.run.clone();
    if run.time_limit.is_none() && run.node_limit.is_none() {
        run.time_limit = Some(PATIENCE);
    }
    let session = Session::new(&run)?;
    let (outcome, ended) =
        session.bounded(|threads, limits| smallest(&set, &options(args, threads), limits));
    match outcome {
        Ok(outcome) => answer.give(&session, &outcome, &ended),
        Err(why @ NoBound::Lonely { .. }) => answer.none(&why.to_string()),
        Err(why) => Err(why).context("--method anneal"),
    }
}

/// A search for a covering, and where its result goes.
struct Answer<'a> {
    args: &'a FindArgs,
    set: &'a TileSet,
    /// The torus asked for.
    shape: Option<Shape>,
}

impl Answer<'_> {
    fn none(&self, reason: &str) -> anyhow::Result<Exit> {
        if self.args.json {
            let mut fields = self.fields("none", "argument", self.shape, 0, &Ended::default());
            fields.push(("reason", json!(reason)));
            output::object(&fields)?;
        } else {
            output::line(&format!("none: {reason}"))?;
        }
        Ok(Exit::No)
    }

    fn give(&self, session: &Session<'_>, found: &Smallest, ended: &Ended) -> anyhow::Result<Exit> {
        let nodes = found.nodes;
        let Some(covering) = &found.covering else {
            if self.args.json {
                let mut fields = self.fields("stopped", "anneal", self.shape, nodes, ended);
                fields.extend(bound_fields(&found.bound));
                output::object(&fields)?;
            }
            ended.tell(&format!("{nodes} nodes and moves; no covering found so far"));
            return Ok(Exit::Stopped);
        };
        let (args, set, shape) = (self.args, self.set, covering.shape);
        let lattice = Lattice { kind: set.kind(), shape };
        let packing = lattice.packing(&covering.labels, set, true);
        let verdict = verify::check(&packing);
        if !verdict.is_valid() {
            bail!("internal error: what was found is no covering: {verdict}; please report this");
        }
        let how = &covering.how;
        let cells = in_words(set, shape, &found.bound);
        if let Some(file) = &args.output {
            let provenance = json!({
                "method": how,
                "program": "tilepack",
                "version": env!("CARGO_PKG_VERSION"),
                "seed": args.search.seed,
                "lower_bound": found.bound.cells,
                "bound_reason": found.bound.reason,
            });
            write_file(file, |out| write_solution(out, &packing, &provenance, Layout::Pretty))?;
        }
        match (args.json, &args.output) {
            (true, _) => self.print_json(found, how, &packing, ended)?,
            (false, Some(_)) => {}
            (false, None) => output::result(|out| {
                writeln!(out, "# found by {how}")?;
                writeln!(out, "# {cells}")?;
                write_grid(out, &packing)
            })?,
        }
        let written = match &args.output {
            Some(file) => format!("; written to {}", file.display()),
            None => String::new(),
        };
        session.remark(&format!("found by {how}: {cells}; {}{written}", ended.time()));
        Ok(Exit::Yes)
    }

    fn print_json(
        &self,
        found: &Smallest,
        how: &str,
        packing: &Packing,
        ended: &Ended,
    ) -> anyhow::Result<()> {
        let mut fields = self.fields("found", method(how), Some(packing.shape), found.nodes, ended);
        fields.extend(bound_fields(&found.bound));
        fields.push(("how", json!(how)));
        if self.args.output.is_none() {
            fields.extend(output::solution_fields(packing));
        }
        output::object(&fields)
    }

    fn fields(
        &self,
        result: &str,
        method: &str,
        shape: Option<Shape>,
        nodes: u64,
        ended: &Ended,
    ) -> Vec<(&'static str, Value)> {
        let file = self.args.output.as_deref().filter(|_| result == "found");
        vec![
            ("result", json!(result)),
            ("method", json!(method)),
            ("width", json!(shape.map(Shape::width))),
            ("height", json!(shape.map(Shape::height))),
            ("nodes", json!(nodes.to_string())),
            ("seconds", json!(ended.time.as_secs_f64())),
            ("stopped_by", json!((result == "stopped").then_some(ended.by))),
            ("file", json!(file.map(|file| file.to_string_lossy()))),
            ("seed", json!(self.args.search.seed)),
            ("set_size", json!(self.set.size())),
        ]
    }
}

/// The word for a method of the contract that a way to find something belongs to.
fn method(how: &str) -> &'static str {
    match how.split(' ').next() {
        Some("beam") => "beam",
        Some("search") => "search",
        _ => "anneal",
    }
}

fn bound_fields(bound: &Bound) -> [(&'static str, Value); 2] {
    [("lower_bound", json!(bound.cells)), ("bound_reason", json!(bound.reason))]
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

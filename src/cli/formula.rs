//! `count` by a formula: rings of dominoes, by the BEST theorem, in no time whatever their number.
//!
//! Counts agree with those of the search: packings are told apart by where they begin, so each
//! ring counts once for every domino. `--method auto` leaves small sets to the search, which says
//! how many nodes it took, and everything that only a search can do.

use super::args::{CountArgs, CountMethod};
use super::exit::Exit;
use super::{construct, describe, duration, output, problem};
use crate::construct::Digraph;
use crate::count::best;
use crate::tiles::{Kind, TileSet};
use anyhow::bail;
use num_bigint::BigUint;
use serde_json::json;
use std::time::Instant;

/// The search counts rings of so many dominoes at once: four colors take a third of a million.
const MOST_TO_SEARCH: u64 = 16;

/// How the answer is obtained, for people and programs.
const METHOD: &str = "formula (BEST theorem)";

/// Gives the number by the formula; `None` if the search is to count.
///
/// # Errors
/// Bad input, and a formula asked for where there is none.
pub fn answer(args: &CountArgs) -> anyhow::Result<Option<Exit>> {
    if matches!(args.method, CountMethod::Search | CountMethod::Meet) {
        return Ok(None);
    }
    let asked = args.method == CountMethod::Formula;
    if let Some(option) = asks_for_search(args) {
        if asked {
            bail!("--method formula: {option} is for a search");
        }
        return Ok(None);
    }
    let (set, shape) = problem::set_and_shape(&args.problem)?;
    if set.kind() != Kind::Domino {
        if asked {
            bail!("--method formula is for dominoes, not for {} tiles", set.kind());
        }
        return Ok(None);
    }
    if !asked && set.size() <= MOST_TO_SEARCH {
        return Ok(None);
    }
    construct::check_size(&set, shape)?;
    let begin = Instant::now();
    let graph = graph(&set);
    let why = graph.circuit(None).err().map(|why| why.to_string());
    let rings = best::rings(&graph);
    let packings = best::packings(&graph);
    if args.json {
        output::object(&[
            ("result", json!("complete")),
            ("solutions", json!(packings.to_string())),
            ("up_to_translation", json!(rings.to_string())),
            ("nodes", json!("0")),
            ("seconds", json!(begin.elapsed().as_secs_f64())),
            ("stopped_by", json!(null)),
            ("method", json!(METHOD)),
            ("reason", json!(why)),
        ])?;
    } else {
        let plural = if packings == BigUint::from(1u32) { "" } else { "s" };
        let (set, torus) = (describe::set(&set), describe::torus(Kind::Domino, shape));
        let how = why.as_ref().map_or_else(
            || format!("in {}", duration::words(begin.elapsed())),
            |why| format!("there is no ring: {why}"),
        );
        output::result(|out| {
            writeln!(out, "{packings} packing{plural}")?;
            writeln!(out, "{rings} up to translation (rings up to rotation)")?;
            writeln!(out, "{set}, {torus}; by {METHOD}: {how}")
        })?;
    }
    Ok(Some(Exit::of(why.is_none())))
}

/// The dominoes as arcs between their colors.
fn graph(set: &TileSet) -> Digraph {
    let arcs = set.allowed().map(|tile| {
        let [first, second, ..] = Kind::Domino.unpack(tile, set.colors());
        (first, second)
    });
    Digraph::new(set.colors().vertical(), arcs.collect())
}

/// The option that only a search can follow, if one was given.
fn asks_for_search(args: &CountArgs) -> Option<&'static str> {
    let (problem, search) = (&args.problem, &args.search);
    let options = [
        (args.up_to_symmetry, "--up-to-symmetry"),
        (problem.board.given().is_some(), problem.board.given().unwrap_or_default()),
        (problem.pin.is_some(), "--pin"),
        (problem.automorphism.is_some(), "--automorphism"),
        (problem.cover, "--cover"),
        (search.order.is_some(), "--order"),
        (search.plain, "--plain"),
        (search.checkpoint.is_some(), "--checkpoint"),
        (search.run.status.is_some(), "--status"),
        (search.run.time_limit.is_some(), "--time-limit"),
        (search.run.node_limit.is_some(), "--node-limit"),
    ];
    options.into_iter().find_map(|(given, option)| given.then_some(option))
}

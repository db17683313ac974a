//! `find --restarts`: search begun again and again, every time in another random order.
//!
//! Nothing of a run is kept but its number, so there are no checkpoints: with the same seed and a
//! larger limit the same runs come again, in the same order.

use super::args::{FindArgs, Method, ValueOrder};
use super::exit::Exit;
use super::found::{Found, Heuristic};
use super::session::Session;
use super::{describe, problem};
use crate::packing::{self, Job, Question};
use crate::search::Restarts;
use crate::store::check_writable;
use anyhow::bail;
use serde_json::json;

/// Runs the command, with runs of `unit` nodes and more.
///
/// # Errors
/// Options that do not go together, bad input, or a file that cannot be written.
pub fn run(args: &FindArgs, unit: u64, why: Option<String>) -> anyhow::Result<Exit> {
    refuse(args)?;
    let task = problem::search_task(&args.problem, &args.search)?;
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    let session = Session::new(&args.search.run)?;
    let seed = args.search.seed;
    let automorphism = task.automorphism.as_ref().map(ToString::to_string);
    let mut fields = vec![("seed", json!(seed)), ("unit", json!(unit)), ("why", json!(why))];
    fields.extend(automorphism.iter().map(|automorphism| ("automorphism", json!(automorphism))));
    let heuristic = Heuristic { args, shape: Some(task.shape), fields };
    if let Some(reason) = task.impossible() {
        return heuristic.none(&reason);
    }
    let job = Job { reduce: !args.search.plain, ..Job::new(task, Question::First) };
    let restarts = Restarts { unit, seed };
    let (restarted, ended) = session
        .bounded(|threads, limits| packing::find_restarting(&job, restarts, threads, limits));
    let (restarted, task) = (restarted?, &job.task);
    let packing::Restarted { run, nodes, .. } = restarted;
    if restarted.none {
        return heuristic.none_by_search(&session, &describe::nothing(task), nodes, &ended);
    }
    let Some(labels) = &restarted.labels else {
        let runs = describe::number(run, "run");
        let how_far = format!(
            "{nodes} nodes, {runs}, deepest level {} of {}; no {}{} found so far",
            restarted.deepest,
            restarted.levels,
            describe::sought(task),
            describe::conditions(task)
        );
        return heuristic.stopped("search", &ended, nodes, vec![("runs", json!(run))], &how_far);
    };
    let packing = task.lattice().packing(labels, &task.set, task.cover);
    let order = task.visiting_order();
    let how = format!(
        "search with restarts (run {run} in {order} order, values random, seed {seed}, unit {unit})"
    );
    let mut provenance =
        vec![("nodes", json!(nodes.to_string())), ("seed", json!(seed)), ("unit", json!(unit))];
    provenance.extend(automorphism.map(|automorphism| ("automorphism", json!(automorphism))));
    let found = Found {
        packing: &packing,
        method: "search",
        how: &how,
        remark: &format!("{nodes} nodes"),
        nodes,
        fields: vec![("run", json!(run))],
        provenance,
    };
    heuristic.found(&session, found, &ended)
}

/// Refuses options that would be left out of account.
fn refuse(args: &FindArgs) -> anyhow::Result<()> {
    let search = &args.search;
    if !matches!(args.method, Method::Auto | Method::Search) {
        bail!("--restarts needs --method search");
    }
    for (given, option, why) in [
        (search.checkpoint.is_some(), "--checkpoint", "a run begins anew; the seed repeats it"),
        (search.run.status.is_some(), "--status", "nobody knows how far it is"),
        (args.values == ValueOrder::Highest, "--values highest", "every run has a random order"),
    ] {
        if given {
            bail!("--restarts and {option} do not go together: {why}");
        }
    }
    Ok(())
}

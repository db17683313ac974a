//! `find --method portfolio`: several ways to a packing, in turns.

use super::args::{FindArgs, Method, ValueOrder};
use super::describe;
use super::exit::Exit;
use super::found::{Found, Heuristic};
use super::problem;
use super::session::Session;
use crate::portfolio::{self, Outcome, Way};
use crate::store::check_writable;
use anyhow::bail;
use serde_json::json;

/// Runs the command.
///
/// # Errors
/// Options that a portfolio does not know, bad input, or a file that cannot be written.
pub fn run(args: &FindArgs) -> anyhow::Result<Exit> {
    refuse(args)?;
    let task = problem::search_task(&args.problem, &args.search)?;
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    let session = Session::new(&args.search.run)?;
    let seed = args.search.seed;
    let fields = vec![("seed", json!(seed))];
    let heuristic = Heuristic { args, shape: Some(task.shape), fields };
    if let Some(reason) = task.impossible() {
        return heuristic.none(&reason);
    }
    let (outcome, ended) = session
        .bounded(|threads, limits| portfolio::run(&task, args.symmetric, seed, threads, limits));
    let Outcome { won, labels, turns, nodes } = outcome?;
    let (Some((way, round)), labels) = (won, labels) else {
        let sought = describe::sought(&task);
        let how_far = format!(
            "{nodes} nodes, {}; no {sought}{} found so far",
            describe::number(turns, "turn"),
            describe::conditions(&task)
        );
        let fields = vec![("turns", json!(turns))];
        return heuristic.stopped("portfolio", &ended, nodes, fields, &how_far);
    };
    let Some(labels) = labels else {
        return heuristic.none_by_search(&session, &describe::nothing(&task), nodes, &ended);
    };
    let name = name(&way);
    let packing = task.lattice().packing(&labels, &task.set, task.cover);
    let mut how = format!("portfolio: {name}, round {round} (seed {seed})");
    let mut provenance = vec![
        ("nodes", json!(nodes.to_string())),
        ("seed", json!(seed)),
        ("way", json!(name)),
        ("round", json!(round)),
    ];
    let mut fields = vec![("way", json!(name)), ("round", json!(round)), ("turns", json!(turns))];
    let automorphism = match &way {
        Way::Symmetric(automorphism) => Some(automorphism),
        _ => task.automorphism.as_ref(),
    };
    if let Some(automorphism) = automorphism {
        how += &format!("; it has the automorphism {automorphism}");
        provenance.push(("automorphism", json!(automorphism.to_string())));
        fields.push(("automorphism", json!(automorphism.to_string())));
    }
    let found = Found {
        packing: &packing,
        method: "portfolio",
        how: &how,
        remark: &format!("{nodes} nodes in {}", describe::number(turns, "turn")),
        nodes,
        fields,
        provenance,
    };
    heuristic.found(&session, found, &ended)
}

/// A way, in words.
fn name(way: &Way) -> &'static str {
    match way {
        Way::InOrder => "search in order",
        Way::AtRandom => "search in random order",
        Way::Beam => "beam search",
        Way::Symmetric(_) => "search under a symmetry",
    }
}

/// Refuses what belongs to a portfolio for any other method.
///
/// # Errors
/// When it is given.
pub fn refuse_elsewhere(args: &FindArgs) -> anyhow::Result<()> {
    if args.symmetric && args.method != Method::Portfolio {
        bail!("--symmetric needs --method portfolio; see also --automorphism");
    }
    Ok(())
}

/// Refuses options that would be left out of account.
fn refuse(args: &FindArgs) -> anyhow::Result<()> {
    let search = &args.search;
    for (given, option, why) in [
        (args.values != ValueOrder::Lexicographic, "--values", "it tries several orders"),
        (args.restarts.is_some(), "--restarts", "it has rounds of its own"),
        (search.plain, "--plain", "it removes what symmetry it can"),
        (search.checkpoint.is_some(), "--checkpoint", "there is nothing to go on from"),
        (search.run.status.is_some(), "--status", "nobody knows how far it is"),
        (
            args.symmetric && args.problem.automorphism.is_some(),
            "--symmetric with --automorphism",
            "one of them says which symmetry",
        ),
        (
            args.symmetric && args.problem.pin.is_some(),
            "--symmetric with --pin",
            "a symmetry would say more cells",
        ),
    ] {
        if given {
            bail!("--method portfolio and {option} do not go together: {why}");
        }
    }
    Ok(())
}

//! `find`: one packing, checked from the definition before anybody sees it.

use super::args::{FindArgs, Method, ValueOrder};
use super::exit::Exit;
use super::session::{Done, Session};
use super::{describe, output, problem};
use crate::packing::{self, Task};
use crate::search::Values;
use crate::store::{Layout, check_writable, write_file, write_grid, write_solution};
use crate::torus::Packing;
use crate::verify;
use anyhow::bail;
use serde_json::{Map, Value, json};
use std::path::Path;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &FindArgs) -> anyhow::Result<Exit> {
    let task = problem::task(&args.problem, args.search.order)?;
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    match args.method {
        // Search is the one method there is.
        Method::Auto | Method::Search => search(args, &task),
    }
}

fn search(args: &FindArgs, task: &Task) -> anyhow::Result<Exit> {
    let values = match args.values {
        ValueOrder::Lexicographic => Values::Lexicographic,
        ValueOrder::Random => Values::Random(args.search.seed),
    };
    let session = Session::new(&args.search, values)?;
    if let Some(reason) = task.impossible() {
        return none(args, task, "argument", &session.without_search(()), &reason);
    }
    let done = session.run(|settings| packing::find(task, settings))?;
    let Some(labels) = &done.value else {
        if done.stopped.is_some() {
            if args.json {
                print_json(args, task, "stopped", "search", &done, None, None)?;
            }
            let (sought, conditions) = (describe::sought(task), describe::conditions(task));
            done.tell_stop(&format!("no {sought}{conditions} found so far"));
            return Ok(Exit::Stopped);
        }
        return none(args, task, "search", &done, &describe::nothing(task));
    };
    let packing = task.lattice().packing(labels, &task.set, task.cover);
    let verdict = verify::check(&packing);
    if !verdict.is_valid() {
        bail!("internal error: the search found what is no packing: {verdict}; please report this");
    }
    let how = how(args, task, done.stopped.is_none());
    if let Some(file) = &args.output {
        let provenance = provenance(args, &how, &done);
        write_file(file, |out| write_solution(out, &packing, &provenance, Layout::Pretty))?;
    }
    match (args.json, &args.output) {
        (true, _) => print_json(args, task, "found", "search", &done, Some(&packing), None)?,
        (false, Some(_)) => {}
        (false, None) => output::result(|out| {
            writeln!(out, "# found by {how}, {} nodes", done.work.nodes)?;
            write_grid(out, &packing)
        })?,
    }
    session.remark(&format!("found by {how}: {}{}", done.effort(), written_to(args)));
    Ok(Exit::Yes)
}

/// The answer is no.
fn none<T>(
    args: &FindArgs,
    task: &Task,
    method: &str,
    done: &Done<T>,
    reason: &str,
) -> anyhow::Result<Exit> {
    if args.json {
        print_json(args, task, "none", method, done, None, Some(reason))?;
    } else {
        output::line(&format!("none: {reason}"))?;
    }
    Ok(Exit::No)
}

/// How a packing was found: `search (first in row order, values lexicographic)`.
fn how(args: &FindArgs, task: &Task, complete: bool) -> String {
    let order = task.visiting_order();
    let values = match args.values {
        ValueOrder::Lexicographic => "lexicographic".to_owned(),
        ValueOrder::Random => format!("random with seed {}", args.search.seed),
    };
    // A search that a limit ends may have met another packing before the first.
    let first = if complete { "first" } else { "one, not surely the first," };
    let symmetric = match &args.problem.automorphism {
        Some(text) => format!(", only among those with automorphism {text}"),
        None => String::new(),
    };
    format!("search ({first} in {order} order, values {values}{symmetric})")
}

fn provenance(args: &FindArgs, how: &str, done: &Done<impl Sized>) -> Value {
    let mut fields = Map::new();
    let mut put = |name: &str, value: Value| fields.insert(name.to_owned(), value);
    put("method", json!(how));
    put("program", json!("tilepack"));
    put("version", json!(env!("CARGO_PKG_VERSION")));
    put("nodes", json!(done.work.nodes.to_string()));
    if args.values == ValueOrder::Random {
        put("seed", json!(args.search.seed));
    }
    if let Some(automorphism) = &args.problem.automorphism {
        put("automorphism", json!(automorphism));
    }
    if let Some(pin) = &args.problem.pin {
        put("pins", json!(pin.to_string_lossy()));
    }
    if args.search.plain {
        put("plain", json!(true));
    }
    Value::Object(fields)
}

fn print_json<T>(
    args: &FindArgs,
    task: &Task,
    result: &str,
    method: &str,
    done: &Done<T>,
    packing: Option<&Packing>,
    reason: Option<&str>,
) -> anyhow::Result<()> {
    let file = args.output.as_deref().filter(|_| packing.is_some()).map(Path::to_string_lossy);
    let mut fields = vec![
        ("result", json!(result)),
        ("method", json!(method)),
        ("width", json!(task.shape.width())),
        ("height", json!(task.shape.height())),
    ];
    fields.extend(done.fields());
    fields.extend([("file", json!(file)), ("reason", json!(reason))]);
    if args.values == ValueOrder::Random {
        fields.push(("seed", json!(args.search.seed)));
    }
    if let Some(automorphism) = &args.problem.automorphism {
        fields.push(("automorphism", json!(automorphism)));
    }
    // With the rest of a solution's fields the object is a solution, too.
    if let Some(packing) = packing.filter(|_| args.output.is_none()) {
        let description = output::description(packing);
        for name in ["format", "kind", "colors", "set", "cover", "topology"] {
            if let Some(value) = description.get(name) {
                fields.push((name, value.clone()));
            }
        }
        let rows: Vec<Vec<u32>> =
            packing.rows().map(|row| row.iter().map(|tile| tile.0).collect()).collect();
        fields.push(("tiles", json!(rows)));
    }
    output::object(&fields)
}

fn written_to(args: &FindArgs) -> String {
    match &args.output {
        Some(file) => format!("; written to {}", file.display()),
        None => String::new(),
    }
}

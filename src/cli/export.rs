//! `export-cnf` and `export-xcc`: the same problem for a SAT solver, or a program for exact
//! cover; and back: what a SAT solver found as a packing, checked from the definition.

use super::args::{ExportCnfArgs, ExportOut, ExportXccArgs};
use super::exit::Exit;
use super::{board, describe, output, problem, source};
use crate::export::{Cnf, Model, Xcc};
use crate::packing::Task;
use crate::store::{Layout, check_writable, write_file, write_grid, write_solution};
use crate::torus::Packing;
use crate::verify;
use anyhow::{Context, bail};
use serde_json::{Value, json};
use std::io::{self, Write};
use std::path::Path;

/// Runs `export-cnf`.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run_cnf(args: &ExportCnfArgs) -> anyhow::Result<Exit> {
    board::refuse(&args.problem, "export-cnf")?;
    let task = problem::task(&args.problem, None)?;
    if let Some(file) = &args.out.output {
        check_writable(file)?;
    }
    let cnf = Cnf::new(&task)?;
    if let Some(file) = &args.model {
        return read_model(&args.out, &task, &cnf, file);
    }
    let sizes = [("variables", cnf.variables as u64), ("clauses", cnf.clauses)];
    write(&args.out, "cnf", &sizes, &|out| cnf.write(out, &about(&task)))
}

/// Runs `export-xcc`.
///
/// # Errors
/// Bad input, a problem that cannot be said, or a file that cannot be written.
pub fn run_xcc(args: &ExportXccArgs) -> anyhow::Result<Exit> {
    board::refuse(&args.problem, "export-xcc")?;
    let task = problem::task(&args.problem, None)?;
    if let Some(file) = &args.out.output {
        check_writable(file)?;
    }
    let xcc = Xcc::new(&task)?;
    let items = (xcc.primary() as u64, xcc.secondary() as u64);
    let sizes = [("items", items.0), ("secondary_items", items.1), ("options", xcc.options)];
    let format = if xcc.multiplicities { "xcc with multiplicities" } else { "xcc" };
    write(&args.out, format, &sizes, &|out| xcc.write(out, &about(&task)))
}

/// A task in a line.
fn about(task: &Task) -> String {
    let set = describe::set(&task.set);
    let torus = describe::torus(task.set.kind(), task.shape);
    let automorphism = match &task.automorphism {
        Some(automorphism) => format!(", automorphism {automorphism}"),
        None => String::new(),
    };
    let pins = match task.pins.pinned() {
        0 => String::new(),
        pinned => format!(", {} given", describe::number(pinned as u64, "color")),
    };
    let sought = describe::sought(task);
    format!("tilepack {}: {sought}s, {set}, {torus}{automorphism}{pins}", env!("CARGO_PKG_VERSION"))
}

/// Writes a problem of these sizes.
fn write(
    args: &ExportOut,
    format: &str,
    sizes: &[(&'static str, u64)],
    text: &dyn Fn(&mut dyn Write) -> io::Result<()>,
) -> anyhow::Result<Exit> {
    match &args.output {
        Some(file) => write_file(file, |out| text(out))?,
        None if args.json => {
            bail!("--json needs -o: without it, standard output is for the problem")
        }
        None => output::result(text)?,
    }
    if args.json {
        let mut fields = vec![("result", json!("written")), ("format", json!(format))];
        fields.extend(sizes.iter().map(|&(name, size)| (name, json!(size))));
        fields.push(("file", json!(args.output.as_ref().map(|file| file.to_string_lossy()))));
        output::object(&fields)?;
    }
    if !args.quiet {
        let sizes: Vec<String> =
            sizes.iter().map(|(name, size)| format!("{size} {}", name.replace('_', " "))).collect();
        output::remark(&format!("{}{}", sizes.join(", "), written_to(args)));
    }
    Ok(Exit::Yes)
}

fn written_to(args: &ExportOut) -> String {
    args.output.as_ref().map_or_else(String::new, |file| format!("; written to {}", file.display()))
}

/// The packing that a solver found.
fn read_model(args: &ExportOut, task: &Task, cnf: &Cnf<'_>, file: &Path) -> anyhow::Result<Exit> {
    let input = source::open(file)?;
    let model = Model::read(input.text(), cnf).with_context(|| file.display().to_string())?;
    let labels = match model {
        Model::Labels(labels) => labels,
        Model::None => {
            let reason = "the solver says that there is no model; nothing here checks it";
            return none(args, task, Exit::No, "none", reason);
        }
        Model::Unknown => {
            return none(args, task, Exit::Stopped, "stopped", "the solver gave no answer");
        }
    };
    let pinned = task.pins.labels().iter().zip(&labels);
    if let Some(label) = pinned.into_iter().position(|(pin, is)| pin.is_some_and(|pin| pin != *is))
    {
        let (row, column) = cnf.instance().position(label);
        bail!("{}: row {row}, column {column} is not as given beforehand", file.display());
    }
    let packing = task.lattice().packing(&labels, &task.set, task.cover);
    let verdict = verify::check(&packing);
    if !verdict.is_valid() {
        bail!("{}: not a {}: {verdict}", file.display(), describe::sought(task));
    }
    give(args, task, &packing)
}

fn fields(task: &Task, result: &str, reason: Option<&str>) -> Vec<(&'static str, Value)> {
    vec![
        ("result", json!(result)),
        ("method", json!("model")),
        ("width", json!(task.shape.width())),
        ("height", json!(task.shape.height())),
        ("reason", json!(reason)),
    ]
}

fn none(
    args: &ExportOut,
    task: &Task,
    exit: Exit,
    result: &str,
    reason: &str,
) -> anyhow::Result<Exit> {
    if args.json {
        output::object(&fields(task, result, Some(reason)))?;
    } else {
        output::line(&format!("{result}: {reason}"))?;
    }
    Ok(exit)
}

fn give(args: &ExportOut, task: &Task, packing: &Packing) -> anyhow::Result<Exit> {
    if let Some(file) = &args.output {
        let provenance = json!({
            "method": "model of a SAT solver",
            "program": "tilepack",
            "version": env!("CARGO_PKG_VERSION"),
        });
        write_file(file, |out| write_solution(out, packing, &provenance, Layout::Pretty))?;
    }
    match (args.json, &args.output) {
        (true, file) => {
            let mut fields = fields(task, "found", None);
            fields.push(("file", json!(file.as_ref().map(|file| file.to_string_lossy()))));
            if file.is_none() {
                fields.extend(output::solution_fields(packing));
            }
            output::object(&fields)?;
        }
        (false, Some(_)) => {}
        (false, None) => output::result(|out| {
            writeln!(out, "# model of a SAT solver")?;
            write_grid(out, packing)
        })?,
    }
    if !args.quiet {
        output::remark(&format!("a {}{}", describe::sought(task), written_to(args)));
    }
    Ok(Exit::Yes)
}

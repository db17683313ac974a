//! `list`: all packings, sorted, one JSON line each.

use super::args::ListArgs;
use super::exit::Exit;
use super::session::Session;
use super::{describe, output, problem};
use crate::packing::solve::SolveError;
use crate::packing::{self, Task};
use crate::search::Values;
use crate::store::{Layout, check_writable, write_file, write_solution};
use anyhow::bail;
use serde_json::{Value, json};
use std::io::{self, Write};

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &ListArgs) -> anyhow::Result<Exit> {
    let task = problem::task(&args.problem, args.search.order)?;
    if args.up_to_symmetry && task.has_pins() {
        return Err(SolveError::PinnedOrbits.into());
    }
    match &args.output {
        Some(file) => check_writable(file)?,
        None if args.json => bail!("--json needs -o: without it, standard output is for the list"),
        None => {}
    }
    let session = Session::new(&args.search, Values::Lexicographic)?;
    let reason = task.impossible();
    let done = match &reason {
        Some(_) => session.without_search(Vec::new()),
        None => session.run(|settings| packing::list(&task, settings, args.up_to_symmetry))?,
    };
    let packings = &done.value;
    let found = describe::number(packings.len() as u64, describe::sought(&task));
    match &args.output {
        Some(file) => write_file(file, |out| write(&task, packings, out))?,
        None => output::result(|out| write(&task, packings, out))?,
    }
    if args.json {
        let mut fields = vec![
            ("result", json!(done.state())),
            ("solutions", json!(packings.len().to_string())),
            ("file", json!(args.output.as_ref().map(|file| file.to_string_lossy()))),
        ];
        fields.extend(done.fields());
        fields.push(("reason", json!(reason)));
        output::object(&fields)?;
    }
    done.tell_stop(&format!("the list is incomplete, with {found}"));
    if done.stopped.is_some() {
        return Ok(Exit::Stopped);
    }
    if packings.is_empty() {
        let reason = reason.unwrap_or_else(|| describe::nothing(&task));
        session.remark(&format!("none: {reason}"));
    } else {
        let conditions = describe::conditions(&task);
        let what = if args.up_to_symmetry { " up to symmetry" } else { "" };
        session.remark(&format!("{found}{conditions}{what} listed: {}", done.effort()));
    }
    Ok(Exit::of(!packings.is_empty()))
}

fn write(task: &Task, packings: &[Vec<u8>], out: &mut dyn Write) -> io::Result<()> {
    let lattice = task.lattice();
    for labels in packings {
        let packing = lattice.packing(labels, &task.set, task.cover);
        write_solution(&mut *out, &packing, &Value::Null, Layout::Line)?;
    }
    Ok(())
}

//! `list`: all packings, sorted, one JSON line each.

use super::args::ListArgs;
use super::exit::Exit;
use super::request::Request;
use super::saving::Save;
use super::session::{Done, Session};
use super::{describe, output, problem};
use crate::packing::solve::listed;
use crate::packing::{Job, Question, Task};
use crate::store::{Layout, check_writable, write_file, write_solution};
use anyhow::bail;
use serde_json::{Value, json};
use std::io::{self, Write};

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &ListArgs) -> anyhow::Result<Exit> {
    let task = problem::search_task(&args.problem, &args.search)?;
    let question = Question::List { up_to_symmetry: args.up_to_symmetry };
    let job = Job { reduce: !args.search.plain, ..Job::new(task, question) };
    job.check()?;
    let request = Request { output: args.output.clone(), json: args.json, ..Request::default() };
    let save = Save::asked(args.search.checkpoint.as_deref(), &job)?;
    answer(&job, &request, &Session::new(&args.search.run)?, save)
}

/// Searches, also on from where the search was saved, and gives the answer.
///
/// # Errors
/// A file that cannot be read or written.
pub fn answer(
    job: &Job,
    request: &Request,
    session: &Session<'_>,
    save: Option<Save>,
) -> anyhow::Result<Exit> {
    check_output(request)?;
    let reason = job.task.impossible();
    let mut done = match &reason {
        Some(_) => session.without_search(),
        None => session.run(job, request, save)?,
    };
    let packings = listed(job, std::mem::take(&mut done.standing.kept));
    tell(job, request, &done, &packings, reason.as_deref(), &[])?;
    let number = describe::number(packings.len() as u64, describe::sought(&job.task));
    done.tell_stop(&format!("the list is incomplete, with {number}"));
    if done.stopped.is_some() {
        return Ok(done.stopped_exit());
    }
    session.remark(&found(job, &done, &packings, reason.as_deref()));
    Ok(Exit::of(!packings.is_empty()))
}

/// What to say about a list that is complete.
pub fn found(job: &Job, done: &Done, packings: &[Vec<u8>], reason: Option<&str>) -> String {
    let task = &job.task;
    if packings.is_empty() {
        let reason = reason.map_or_else(|| describe::nothing(task), str::to_owned);
        return format!("none: {reason}");
    }
    let number = describe::number(packings.len() as u64, describe::sought(task));
    let conditions = describe::conditions(task);
    let what = if job.up_to_symmetry() { " up to symmetry" } else { "" };
    format!("{number}{conditions}{what} listed: {}", done.effort())
}

/// Checks, before any work, that the list can go where it is asked for.
///
/// # Errors
/// When it cannot.
pub fn check_output(request: &Request) -> anyhow::Result<()> {
    match &request.output {
        Some(file) => Ok(check_writable(file)?),
        None if request.json => {
            bail!("--json needs -o: without it, standard output is for the list")
        }
        None => Ok(()),
    }
}

/// Writes a list, and what there is to say about it in JSON, with more fields at the end.
///
/// # Errors
/// When a file or standard output cannot be written to.
pub fn tell(
    job: &Job,
    request: &Request,
    done: &Done,
    packings: &[Vec<u8>],
    reason: Option<&str>,
    more: &[(&'static str, Value)],
) -> anyhow::Result<()> {
    match &request.output {
        Some(file) => write_file(file, |out| write(&job.task, packings, out))?,
        None => output::result(|out| write(&job.task, packings, out))?,
    }
    if request.json {
        let mut fields = vec![
            ("result", json!(done.state())),
            ("solutions", json!(packings.len().to_string())),
            ("file", json!(request.output.as_ref().map(|file| file.to_string_lossy()))),
        ];
        fields.extend(done.fields());
        fields.push(("reason", json!(reason)));
        fields.extend_from_slice(more);
        output::object(&fields)?;
    }
    Ok(())
}

fn write(task: &Task, packings: &[Vec<u8>], out: &mut dyn Write) -> io::Result<()> {
    for labels in packings {
        let packing = task.packing(labels);
        write_solution(&mut *out, &packing, &Value::Null, Layout::Line)?;
    }
    Ok(())
}

//! `count`: the exact number of packings, by search, or by [`super::formula`].

use super::args::{CountArgs, CountMethod};
use super::exit::Exit;
use super::request::Request;
use super::saving::Save;
use super::session::{Done, Session};
use super::{describe, formula, output, problem};
use crate::packing::solve::counted;
use crate::packing::{Counted, Job, Question};
use crate::tiles::Kind;
use num_bigint::BigUint;
use serde_json::{Value, json};

/// Runs the command.
///
/// # Errors
/// Bad input.
pub fn run(args: &CountArgs) -> anyhow::Result<Exit> {
    if let Some(exit) = formula::answer(args)? {
        return Ok(exit);
    }
    let task = problem::search_task(&args.problem, &args.search)?;
    let question = Question::Count { up_to_symmetry: args.up_to_symmetry };
    let by_lines = args.method == CountMethod::Meet;
    let job = Job { reduce: !args.search.plain, by_lines, ..Job::new(task, question) };
    job.check()?;
    let request = Request { json: args.json, ..Request::default() };
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
    let reason = job.task.impossible();
    let (done, counted) = match &reason {
        Some(_) => (session.without_search(), Counted::nothing(job)),
        None => {
            let done = session.run(job, request, save)?;
            let counted = counted(job, &done.standing)?;
            (done, counted)
        }
    };
    let nothing = counted.packings == BigUint::ZERO;
    tell(
        &Told { job, done: &done, counted, reason: reason.as_deref(), how: describe::method(job) },
        request.json,
    )?;
    done.tell_stop("the numbers are lower bounds");
    Ok(match done.stopped {
        Some(_) => done.stopped_exit(),
        None => Exit::of(!nothing),
    })
}

/// A number of packings, and how it was obtained.
#[derive(Debug)]
pub struct Told<'a> {
    /// What was counted.
    pub job: &'a Job,
    /// The search.
    pub done: &'a Done,
    /// What it came to.
    pub counted: Counted,
    /// Why there are none, when no search was needed.
    pub reason: Option<&'a str>,
    /// `search`, `search in 64 parts`.
    pub how: &'a str,
}

/// Writes the number to standard output.
///
/// # Errors
/// When that cannot be written to.
pub fn tell(told: &Told<'_>, as_json: bool) -> anyhow::Result<()> {
    if as_json { output::object(&told.fields()) } else { told.print() }
}

impl Told<'_> {
    fn print(&self) -> anyhow::Result<()> {
        let Self { job, done, counted, reason, .. } = self;
        let task = &job.task;
        let Counted { packings, fundamental, up_to_translation } = counted;
        let at_least = if done.stopped.is_some() { "at least " } else { "" };
        let (sought, conditions) = (describe::sought(task), describe::conditions(task));
        let plural = if *packings == BigUint::from(1u32) { "" } else { "s" };
        output::result(|out| {
            writeln!(out, "{at_least}{packings} {sought}{plural}{conditions}")?;
            if let Some(fundamental) = fundamental {
                writeln!(out, "{at_least}{fundamental} up to symmetry")?;
            }
            if let Some(number) = up_to_translation.as_ref().filter(|_| reason.is_none()) {
                let rings = match task.set.kind() {
                    Kind::Domino => " (rings up to rotation)",
                    _ => "",
                };
                writeln!(out, "{number} up to translation{rings}")?;
            }
            writeln!(out, "{}", self.how())
        })
    }

    /// What was counted and how.
    fn how(&self) -> String {
        let Self { job, done, reason, how, .. } = self;
        let task = &job.task;
        let set = describe::set(&task.set);
        let torus = describe::board(task.set.kind(), task.shape, &task.board);
        let how = match (reason, &done.stopped) {
            (Some(reason), _) => format!("by an argument: {reason}"),
            (None, Some(_)) => format!("by {how}, stopped early: {}", self.effort()),
            (None, None) => format!("by {how}, complete: {}", self.effort()),
        };
        let checked = match (reason, job.up_to_symmetry(), !job.reduce) {
            (Some(_), ..) => "",
            _ if job.by_lines && task.set.kind() == Kind::Wang => "",
            (None, true, _) if done.stopped.is_none() => ", the sizes of the orbits add up to it",
            (None, _, true) => ", no symmetry removed",
            _ if job.reduction().is_none() && !job.by_lines => ", no symmetry to remove",
            (None, ..) => ", symmetry removed and multiplied back exactly",
        };
        format!("{set}, {torus}; {how}{checked}")
    }

    /// The work in words.
    fn effort(&self) -> String {
        match self.job.by_lines {
            false => self.done.effort(),
            true => {
                let steps = describe::number(self.done.standing.orbits, "step");
                format!("{steps}, {}", self.done.effort())
            }
        }
    }

    /// The fields of the answer in JSON.
    pub fn fields(&self) -> Vec<(&'static str, Value)> {
        let Self { job, done, counted, reason, .. } = self;
        let Counted { packings, fundamental, up_to_translation } = counted;
        let mut fields =
            vec![("result", json!(done.state())), ("solutions", json!(packings.to_string()))];
        if job.up_to_symmetry() {
            fields.push(("fundamental", json!(fundamental.map(|number| number.to_string()))));
        }
        let up_to_translation = up_to_translation.as_ref().map(BigUint::to_string);
        fields.push(("up_to_translation", json!(up_to_translation)));
        fields.extend(done.fields());
        let method = match (reason, job.by_lines) {
            (Some(_), _) => "argument",
            (None, true) => "meet",
            (None, false) => "search",
        };
        if job.by_lines {
            fields.push(("steps", json!(done.standing.orbits.to_string())));
        }
        fields.extend([("method", json!(method)), ("reason", json!(reason))]);
        fields
    }
}

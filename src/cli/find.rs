//! `find`: one packing, checked from the definition before anybody sees it.

use super::args::{FindArgs, Method, ValueOrder};
use super::choose::{self, Way};
use super::exit::Exit;
use super::request::Request;
use super::ring::RingOrder;
use super::saving::Save;
use super::session::{Done, Session};
use super::{anneal, beam, construct, cover, describe, output, portfolio, problem, restarts, ring};
use crate::packing::{Job, Question};
use crate::search::Values;
use crate::store::{Layout, check_writable, write_file, write_grid, write_solution};
use crate::torus::Packing;
use crate::verify;
use anyhow::bail;
use serde_json::{Map, Value, json};
use std::path::Path;
use std::time::Instant;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &FindArgs) -> anyhow::Result<Exit> {
    beam::refuse_elsewhere(args)?;
    portfolio::refuse_elsewhere(args)?;
    ring::refuse(args)?;
    if args.recursive {
        return beam::run(args, None);
    }
    cover::refuse_aspect(args)?;
    if args.ring != RingOrder::Least {
        return construct::run(args);
    }
    match args.method {
        Method::Beam => beam::run(args, None),
        Method::Anneal if args.problem.cover => cover::run(args, None),
        Method::Anneal => anneal::run(args, None),
        Method::Construct => construct::run(args),
        Method::Search => search(args, None),
        Method::Portfolio => portfolio::run(args),
        Method::Auto => {
            let begin = Instant::now();
            let (way, why) = choose::choose(args)?;
            match way {
                Way::Constructed(constructed) => {
                    construct::give(args, &constructed, begin, Some(&why))
                }
                Way::Anneal => {
                    tell(args, "anneal", &why);
                    anneal::run(args, Some(why))
                }
                Way::Beam => {
                    tell(args, "beam", &why);
                    beam::run(args, Some(why))
                }
                Way::Cover => {
                    tell(args, "anneal", &why);
                    cover::run(args, Some(why))
                }
                Way::Search => search(args, Some(why)),
            }
        }
    }
}

/// Says which method was chosen, and why.
fn tell(args: &FindArgs, method: &str, why: &str) {
    if !args.search.run.quiet {
        output::remark(&format!("method {method}: {why}"));
    }
}

/// Exhaustive search; `why` it was chosen, if it was not asked for.
fn search(args: &FindArgs, why: Option<String>) -> anyhow::Result<Exit> {
    if let Some(unit) = args.restarts {
        return restarts::run(args, unit, why);
    }
    let task = problem::search_task(&args.problem, &args.search)?;
    let values = match args.values {
        ValueOrder::Lexicographic => Values::Lexicographic,
        ValueOrder::Highest => Values::Highest,
        ValueOrder::Random => Values::Random(args.search.seed),
    };
    let job = Job { values, reduce: !args.search.plain, ..Job::new(task, Question::First) };
    let request = Request {
        output: args.output.clone(),
        json: args.json,
        pins: args.problem.pin.as_ref().map(|pin| pin.to_string_lossy().into_owned()),
        automorphism: match args.problem.automorphism.as_deref() {
            Some("auto") => job.task.automorphism.as_ref().map(ToString::to_string),
            text => text.map(str::to_owned),
        },
        why,
    };
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
    let task = &job.task;
    if let Some(file) = &request.output {
        check_writable(file)?;
    }
    let find = Find { job, request };
    if let Some(reason) = task.impossible() {
        return find.none("argument", &session.without_search(), &reason);
    }
    let done = session.run(job, request, save)?;
    let Some(labels) = done.standing.first() else {
        if done.stopped.is_some() {
            if request.json {
                find.print_json("stopped", "search", &done, None, None)?;
            }
            let (sought, conditions) = (describe::sought(task), describe::conditions(task));
            done.tell_stop(&format!("no {sought}{conditions} found so far"));
            return Ok(done.stopped_exit());
        }
        return find.none("search", &done, &describe::nothing(task));
    };
    let packing = task.packing(labels);
    let verdict = verify::check(&packing);
    if !verdict.is_valid() {
        bail!("internal error: the search found what is no packing: {verdict}; please report this");
    }
    let how = find.how(done.stopped.is_none());
    if let Some(file) = &request.output {
        let provenance = find.provenance(&how, &done);
        write_file(file, |out| write_solution(out, &packing, &provenance, Layout::Pretty))?;
    }
    match (request.json, &request.output) {
        (true, _) => find.print_json("found", "search", &done, Some(&packing), None)?,
        (false, Some(_)) => {}
        (false, None) => output::result(|out| {
            writeln!(out, "# found by {how}, {} nodes", done.work.nodes)?;
            write_grid(out, &packing)
        })?,
    }
    let written = match &request.output {
        Some(file) => format!("; written to {}", file.display()),
        None => String::new(),
    };
    session.remark(&format!("found by {how}: {}{written}", done.effort()));
    Ok(Exit::Yes)
}

/// A search for a packing, and where it goes.
struct Find<'a> {
    job: &'a Job,
    request: &'a Request,
}

impl Find<'_> {
    /// The answer is no.
    fn none(&self, method: &str, done: &Done, reason: &str) -> anyhow::Result<Exit> {
        if self.request.json {
            self.print_json("none", method, done, None, Some(reason))?;
        } else {
            output::line(&format!("none: {reason}"))?;
        }
        Ok(Exit::No)
    }

    /// How a packing was found: `search (first in row order, values lexicographic)`.
    fn how(&self, complete: bool) -> String {
        let order = self.job.task.visiting_order();
        let values = match self.job.values {
            Values::Lexicographic => "lexicographic".to_owned(),
            Values::Highest => "highest first".to_owned(),
            Values::Random(seed) => format!("random with seed {seed}"),
        };
        // A search that a limit ends may have met another packing before the first.
        let first = if complete { "first" } else { "one, not surely the first," };
        let symmetric = match &self.request.automorphism {
            Some(text) => format!(", only among those with automorphism {text}"),
            None => String::new(),
        };
        format!("search ({first} in {order} order, values {values}{symmetric})")
    }

    fn provenance(&self, how: &str, done: &Done) -> Value {
        let mut fields = Map::new();
        let mut put = |name: &str, value: Value| fields.insert(name.to_owned(), value);
        put("method", json!(how));
        put("program", json!("tilepack"));
        put("version", json!(env!("CARGO_PKG_VERSION")));
        put("nodes", json!(done.work.nodes.to_string()));
        if let Values::Random(seed) = self.job.values {
            put("seed", json!(seed));
        }
        if let Some(automorphism) = &self.request.automorphism {
            put("automorphism", json!(automorphism));
        }
        if let Some(pins) = &self.request.pins {
            put("pins", json!(pins));
        }
        if !self.job.reduce {
            put("plain", json!(true));
        }
        Value::Object(fields)
    }

    fn print_json(
        &self,
        result: &str,
        method: &str,
        done: &Done,
        packing: Option<&Packing>,
        reason: Option<&str>,
    ) -> anyhow::Result<()> {
        let Self { job, request } = self;
        let file =
            request.output.as_deref().filter(|_| packing.is_some()).map(Path::to_string_lossy);
        let mut fields = vec![
            ("result", json!(result)),
            ("method", json!(method)),
            ("width", json!(job.task.shape.width())),
            ("height", json!(job.task.shape.height())),
        ];
        fields.extend(done.fields());
        fields.extend([("file", json!(file)), ("reason", json!(reason))]);
        fields.push(("why", json!(request.why)));
        if let Values::Random(seed) = job.values {
            fields.push(("seed", json!(seed)));
        }
        if let Some(automorphism) = &request.automorphism {
            fields.push(("automorphism", json!(automorphism)));
        }
        // With the rest of a solution's fields the object is a solution, too.
        if let Some(packing) = packing.filter(|_| request.output.is_none()) {
            fields.extend(output::solution_fields(packing));
        }
        output::object(&fields)
    }
}

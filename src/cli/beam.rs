//! `find --method beam`: a first packing of corner tiles by beam search.
//!
//! What the beam cannot be asked for is refused before anything runs: it knows no
//! automorphisms and no coverings. It never says that there is no packing, so without a limit it
//! goes on until it finds one or is told to stop.

use super::args::{FindArgs, Method, ValueOrder};
use super::exit::Exit;
use super::session::{Ended, Session};
use super::{describe, output, problem};
use crate::beam::{self, Options, Outcome};
use crate::packing::Task;
use crate::store::{Layout, check_writable, write_file, write_grid, write_solution};
use crate::tiles::{Kind, Members};
use crate::torus::{Packing, Shape};
use crate::verify;
use anyhow::{Context, bail};
use serde_json::{Value, json};

/// Runs the command.
///
/// # Errors
/// Options that the beam does not know, bad input, or a file that cannot be written.
pub fn run(args: &FindArgs) -> anyhow::Result<Exit> {
    refuse(args)?;
    let task = problem::task(&args.problem, None)?;
    if task.set.kind() != Kind::Corner {
        let asked = if args.recursive { "--recursive" } else { "--method beam" };
        bail!("{asked} is for corner tiles, not for {} tiles", task.set.kind());
    }
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    if args.recursive {
        let shape = Shape::default_for(&task.set)?;
        if *task.set.members() != Members::Complete || task.shape != shape || task.has_pins() {
            bail!("--recursive is for all corner tiles over C colors on C^2 x C^2, without --pin");
        }
    }
    let session = Session::new(&args.search.run)?;
    let mut options = Options { seed: args.search.seed, ..Options::for_set(&task.set) };
    options.width = args.beam_width.map_or(options.width, |width| width as usize);
    let answer = Answer { args, task: &task, options };
    if let Some(reason) = task.impossible() {
        return answer.none(&reason);
    }
    let (outcome, ended) = session.bounded(|threads, limits| {
        let options = Options { threads, ..options };
        if args.recursive {
            return beam::find_recursive(task.set.colors().largest(), &options, limits);
        }
        beam::find_around(&task.set, task.shape, Some(&task.pins), &options, limits)
    });
    let outcome = outcome.context("--method beam")?;
    answer.give(&session, &outcome, &ended)
}

/// Refuses options that would be left out of account.
fn refuse(args: &FindArgs) -> anyhow::Result<()> {
    let (problem, search) = (&args.problem, &args.search);
    for (given, option, why) in [
        (problem.automorphism.is_some(), "--automorphism", "it knows no symmetry"),
        (problem.cover, "--cover", "it places every tile exactly once"),
        (search.order.is_some(), "--order", "it fills rows along the short side"),
        (args.values == ValueOrder::Random, "--values random", "it is random already"),
        (search.plain, "--plain", "it removes no symmetry"),
        (search.checkpoint.is_some(), "--checkpoint", "there is nothing to go on from"),
        (search.run.status.is_some(), "--status", "nobody knows how far it is"),
    ] {
        if given {
            bail!("--method beam and {option} do not go together: {why}");
        }
    }
    Ok(())
}

/// Refuses what belongs to a beam for any other method.
///
/// # Errors
/// When it is given.
pub fn refuse_width(args: &FindArgs) -> anyhow::Result<()> {
    if args.recursive && !matches!(args.method, Method::Auto | Method::Beam) {
        bail!(
            "--recursive needs --method beam; of dominoes and Wang tiles --ring wei is recursive"
        );
    }
    if args.beam_width.is_some() && args.method != Method::Beam && !args.recursive {
        bail!("--beam-width needs --method beam");
    }
    Ok(())
}

/// A search by beam, and where its result goes.
struct Answer<'a> {
    args: &'a FindArgs,
    task: &'a Task,
    options: Options,
}

impl Answer<'_> {
    fn none(&self, reason: &str) -> anyhow::Result<Exit> {
        if self.args.json {
            let mut fields = self.fields("none", &Ended::default(), "0".to_owned());
            fields.push(("reason", json!(reason)));
            output::object(&fields)?;
        } else {
            output::line(&format!("none: {reason}"))?;
        }
        Ok(Exit::No)
    }

    fn give(
        &self,
        session: &Session<'_>,
        outcome: &Outcome,
        ended: &Ended,
    ) -> anyhow::Result<Exit> {
        let (task, nodes) = (self.task, outcome.nodes);
        let Some(labels) = &outcome.labels else {
            if self.args.json {
                let mut fields = self.fields("stopped", ended, nodes.to_string());
                fields.extend([("restarts", json!(outcome.restart)), ("reason", Value::Null)]);
                output::object(&fields)?;
            }
            let (cells, depth) = (task.shape.cells(), outcome.depth);
            let restarts = describe::number(outcome.restart, "restart");
            ended.tell(&format!(
                "{nodes} nodes, {restarts}, most cells filled {depth} of {cells}; no packing found \
                 so far"
            ));
            return Ok(Exit::Stopped);
        };
        let packing = task.lattice().packing(labels, &task.set, false);
        let verdict = verify::check(&packing);
        if !verdict.is_valid() {
            bail!("internal error: the beam found no packing: {verdict}; please report this");
        }
        let mut how = "beam search".to_owned();
        if self.args.recursive {
            if let Some(fault) = verify::check_recursion(&packing).fault {
                bail!("internal error: the packing is not recursive: {fault}; please report this");
            }
            how += " around a packing over one color less, and so on";
        }
        let Options { seed, width, .. } = self.options;
        how += &format!(" (seed {seed}, width {width}, restart {})", outcome.restart);
        if let Some(file) = &self.args.output {
            let provenance = self.provenance(&how, outcome);
            write_file(file, |out| write_solution(out, &packing, &provenance, Layout::Pretty))?;
        }
        match (self.args.json, &self.args.output) {
            (true, _) => self.print_json(outcome, ended, &packing)?,
            (false, Some(_)) => {}
            (false, None) => output::result(|out| {
                writeln!(out, "# found by {how}, {nodes} nodes")?;
                write_grid(out, &packing)
            })?,
        }
        let written = match &self.args.output {
            Some(file) => format!("; written to {}", file.display()),
            None => String::new(),
        };
        session.remark(&format!("found by {how}: {nodes} nodes in {}{written}", ended.time()));
        Ok(Exit::Yes)
    }

    fn provenance(&self, how: &str, outcome: &Outcome) -> Value {
        json!({
            "method": how,
            "program": "tilepack",
            "version": env!("CARGO_PKG_VERSION"),
            "nodes": outcome.nodes.to_string(),
            "seed": self.options.seed,
            "beam_width": self.options.width,
            "restart": outcome.restart,
        })
    }

    fn print_json(
        &self,
        outcome: &Outcome,
        ended: &Ended,
        packing: &Packing,
    ) -> anyhow::Result<()> {
        let mut fields = self.fields("found", ended, outcome.nodes.to_string());
        fields.extend([("restart", json!(outcome.restart)), ("reason", Value::Null)]);
        if self.args.output.is_none() {
            fields.extend(output::solution_fields(packing));
        }
        output::object(&fields)
    }

    fn fields(&self, result: &str, ended: &Ended, nodes: String) -> Vec<(&'static str, Value)> {
        let file = self.args.output.as_deref().filter(|_| result == "found");
        let shape = self.task.shape;
        vec![
            ("result", json!(result)),
            ("method", json!(if result == "none" { "argument" } else { "beam" })),
            ("width", json!(shape.width())),
            ("height", json!(shape.height())),
            ("nodes", json!(nodes)),
            ("seconds", json!(ended.time.as_secs_f64())),
            ("stopped_by", json!((result == "stopped").then_some(ended.by))),
            ("file", json!(file.map(|file| file.to_string_lossy()))),
            ("seed", json!(self.options.seed)),
            ("beam_width", json!(self.options.width)),
        ]
    }
}

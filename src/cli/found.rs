//! A packing that a heuristic came to: checked from the definition, then written where it is
//! wanted. Methods that are not exhaustive find packings or are stopped, nothing else.

use super::args::FindArgs;
use super::exit::Exit;
use super::output;
use super::session::{Ended, Session};
use crate::store::{Layout, write_file, write_grid, write_solution};
use crate::torus::{Packing, Shape};
use crate::verify;
use anyhow::bail;
use serde_json::{Map, Value, json};

/// A method at work: what it is asked and how it answers.
#[derive(Debug)]
pub struct Heuristic<'a> {
    /// What was asked.
    pub args: &'a FindArgs,
    /// The torus.
    pub shape: Shape,
    /// Its name on the command line.
    pub method: &'static str,
    /// What is specific to it, for JSON and for provenance.
    pub about: Vec<(&'static str, Value)>,
}

impl Heuristic<'_> {
    /// The answer is no, by an argument.
    ///
    /// # Errors
    /// A result that cannot be written.
    pub fn none(&self, reason: &str) -> anyhow::Result<Exit> {
        if self.args.json {
            let mut fields = self.fields("none", &Ended::default(), 0);
            fields.push(("reason", json!(reason)));
            output::object(&fields)?;
        } else {
            output::line(&format!("none: {reason}"))?;
        }
        Ok(Exit::No)
    }

    /// Nothing was found before something asked to stop.
    ///
    /// # Errors
    /// A result that cannot be written.
    pub fn stopped(&self, ended: &Ended, nodes: u64, how_far: &str) -> anyhow::Result<Exit> {
        if self.args.json {
            let mut fields = self.fields("stopped", ended, nodes);
            fields.push(("reason", Value::Null));
            output::object(&fields)?;
        }
        ended.tell(how_far);
        Ok(Exit::Stopped)
    }

    /// A packing was found; `how` says it in words, for people and for provenance, and `effort`
    /// what it took: `260 nodes`.
    ///
    /// # Errors
    /// When it is none, or cannot be written.
    pub fn found(
        &self,
        session: &Session<'_>,
        packing: &Packing,
        ended: &Ended,
        nodes: u64,
        (how, effort): (&str, &str),
    ) -> anyhow::Result<Exit> {
        let verdict = verify::check(packing);
        if !verdict.is_valid() {
            bail!("internal error: {how} found no packing: {verdict}; please report this");
        }
        if let Some(file) = &self.args.output {
            let mut provenance = Map::new();
            provenance.insert("method".into(), json!(how));
            provenance.insert("program".into(), json!("tilepack"));
            provenance.insert("version".into(), json!(env!("CARGO_PKG_VERSION")));
            provenance.insert("nodes".into(), json!(nodes.to_string()));
            provenance
                .extend(self.about.iter().map(|(name, value)| ((*name).into(), value.clone())));
            let provenance = Value::Object(provenance);
            write_file(file, |out| write_solution(out, packing, &provenance, Layout::Pretty))?;
        }
        match (self.args.json, &self.args.output) {
            (true, output) => {
                let mut fields = self.fields("found", ended, nodes);
                fields.push(("reason", Value::Null));
                if output.is_none() {
                    fields.extend(output::solution_fields(packing));
                }
                output::object(&fields)?;
            }
            (false, Some(_)) => {}
            (false, None) => output::result(|out| {
                writeln!(out, "# found by {how}, {effort}")?;
                write_grid(out, packing)
            })?,
        }
        let written = match &self.args.output {
            Some(file) => format!("; written to {}", file.display()),
            None => String::new(),
        };
        session.remark(&format!("found by {how}: {effort} in {}{written}", ended.time()));
        Ok(Exit::Yes)
    }

    fn fields(&self, result: &str, ended: &Ended, nodes: u64) -> Vec<(&'static str, Value)> {
        let file = self.args.output.as_deref().filter(|_| result == "found");
        let mut fields = vec![
            ("result", json!(result)),
            ("method", json!(if result == "none" { "argument" } else { self.method })),
            ("width", json!(self.shape.width())),
            ("height", json!(self.shape.height())),
            ("nodes", json!(nodes.to_string())),
            ("seconds", json!(ended.time.as_secs_f64())),
            ("stopped_by", json!((result == "stopped").then_some(ended.by))),
            ("file", json!(file.map(|file| file.to_string_lossy()))),
        ];
        fields.extend(self.about.iter().cloned());
        fields
    }
}

//! What a heuristic comes to: a packing, checked from the definition and written where it is
//! wanted, or an early end. Methods that are not exhaustive find packings or are stopped; that
//! there is none they know by an argument only.

use super::args::FindArgs;
use super::exit::Exit;
use super::output;
use super::session::{Ended, Session};
use crate::store::{Layout, write_file, write_grid, write_solution};
use crate::torus::{Packing, Shape};
use crate::verify;
use anyhow::bail;
use serde_json::{Map, Value, json};

/// Names and values: of a JSON object, or of the provenance of a file.
pub type Fields = Vec<(&'static str, Value)>;

/// A method at work, and where its answer goes.
#[derive(Debug)]
pub struct Heuristic<'a> {
    /// What was asked.
    pub args: &'a FindArgs,
    /// The torus, if it was asked for.
    pub shape: Option<Shape>,
    /// What every JSON object says, whatever the answer.
    pub fields: Fields,
}

/// A packing or covering that was found.
#[derive(Debug)]
pub struct Found<'a> {
    /// What was found.
    pub packing: &'a Packing,
    /// The name of the method on the command line.
    pub method: &'static str,
    /// How, in words, for people and files.
    pub how: &'a str,
    /// What is worth knowing besides: `4711 nodes`.
    pub remark: &'a str,
    /// Nodes or moves.
    pub nodes: u64,
    /// More for the JSON object.
    pub fields: Fields,
    /// More for the provenance of a file.
    pub provenance: Fields,
}

impl Heuristic<'_> {
    /// The answer is no, by an argument.
    ///
    /// # Errors
    /// A result that cannot be written.
    pub fn none(&self, reason: &str) -> anyhow::Result<Exit> {
        if self.args.json {
            let mut fields = self.common("none", "argument", self.shape, 0, &Ended::default());
            fields.push(("reason", json!(reason)));
            output::object(&fields)?;
        } else {
            output::line(&format!("none: {reason}"))?;
        }
        Ok(Exit::No)
    }

    /// The answer is no, by a complete search.
    ///
    /// # Errors
    /// A result that cannot be written.
    pub fn none_by_search(
        &self,
        session: &Session<'_>,
        reason: &str,
        nodes: u64,
        ended: &Ended,
    ) -> anyhow::Result<Exit> {
        if self.args.json {
            let mut fields = self.common("none", "search", self.shape, nodes, ended);
            fields.push(("reason", json!(reason)));
            output::object(&fields)?;
        } else {
            output::line(&format!("none: {reason}"))?;
        }
        session.remark(&format!("complete search: {nodes} nodes in {}", ended.time()));
        Ok(Exit::No)
    }

    /// Nothing was found before something asked to stop; `more` is for the JSON object.
    ///
    /// # Errors
    /// A result that cannot be written.
    pub fn stopped(
        &self,
        method: &str,
        ended: &Ended,
        nodes: u64,
        more: Fields,
        how_far: &str,
    ) -> anyhow::Result<Exit> {
        if self.args.json {
            let mut fields = self.common("stopped", method, self.shape, nodes, ended);
            fields.extend(more);
            fields.push(("reason", Value::Null));
            output::object(&fields)?;
        }
        ended.tell(how_far);
        Ok(Exit::Stopped)
    }

    /// Checks what was found and writes it where it is wanted.
    ///
    /// # Errors
    /// When it is no packing, or cannot be written.
    pub fn found(
        &self,
        session: &Session<'_>,
        found: Found<'_>,
        ended: &Ended,
    ) -> anyhow::Result<Exit> {
        let Found { packing, how, remark, .. } = found;
        let verdict = verify::check(packing);
        if !verdict.is_valid() {
            bail!("internal error: {how} found what is not valid: {verdict}; please report this");
        }
        if let Some(file) = &self.args.output {
            let mut provenance = Map::new();
            provenance.insert("method".into(), json!(how));
            provenance.insert("program".into(), json!("tilepack"));
            provenance.insert("version".into(), json!(env!("CARGO_PKG_VERSION")));
            provenance.extend(found.provenance.into_iter().map(|(name, v)| (name.into(), v)));
            let provenance = Value::Object(provenance);
            write_file(file, |out| write_solution(out, packing, &provenance, Layout::Pretty))?;
        }
        match (self.args.json, &self.args.output) {
            (true, output) => {
                let shape = Some(packing.shape);
                let mut fields = self.common("found", found.method, shape, found.nodes, ended);
                fields.extend(found.fields);
                fields.push(("reason", Value::Null));
                if output.is_none() {
                    fields.extend(output::solution_fields(packing));
                }
                output::object(&fields)?;
            }
            (false, Some(_)) => {}
            (false, None) => output::result(|out| {
                writeln!(out, "# found by {how}")?;
                writeln!(out, "# {remark}")?;
                write_grid(out, packing)
            })?,
        }
        let written = match &self.args.output {
            Some(file) => format!("; written to {}", file.display()),
            None => String::new(),
        };
        session.remark(&format!("found by {how}: {remark} in {}{written}", ended.time()));
        Ok(Exit::Yes)
    }

    fn common(
        &self,
        result: &str,
        method: &str,
        shape: Option<Shape>,
        nodes: u64,
        ended: &Ended,
    ) -> Fields {
        let file = self.args.output.as_deref().filter(|_| result == "found");
        let mut fields = vec![
            ("result", json!(result)),
            ("method", json!(method)),
            ("width", json!(shape.map(Shape::width))),
            ("height", json!(shape.map(Shape::height))),
            ("nodes", json!(nodes.to_string())),
            ("seconds", json!(ended.time.as_secs_f64())),
            ("stopped_by", json!((result == "stopped").then_some(ended.by))),
            ("file", json!(file.map(|file| file.to_string_lossy()))),
        ];
        fields.extend(self.fields.iter().cloned());
        fields
    }
}

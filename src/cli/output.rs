//! Writing for people and programs: results to standard output, remarks to standard error.
//!
//! When the reader of a pipe goes away (`| head -1`) there is nobody left to tell anything, so
//! that ends the program quietly: writing then gives [`Closed`], which [`super::run`] takes for
//! success. A full disk behind standard output is an error like any other.

use crate::store::{Layout, write_solution};
use crate::torus::Packing;
use serde_json::{Value, json};
use std::io::{self, BufWriter, Write};

/// The reader of standard output went away.
#[derive(Debug, thiserror::Error)]
#[error("standard output was closed")]
pub struct Closed;

/// Writes a result to standard output.
///
/// # Errors
/// [`Closed`] when nobody reads it, else what the system says.
pub fn result(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> anyhow::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    let written = write(&mut out).and_then(|()| out.flush());
    // What is left in the buffer cannot be written either.
    let _ = out.into_parts();
    written.map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => Closed.into(),
        _ => anyhow::anyhow!("standard output: cannot be written: {error}"),
    })
}

/// Writes one line to standard output.
///
/// # Errors
/// As [`result`].
pub fn line(text: &str) -> anyhow::Result<()> {
    result(|out| writeln!(out, "{text}"))
}

/// Writes one JSON object, its fields in this order, as one line to standard output.
///
/// # Errors
/// As [`result`].
pub fn object(fields: &[(&str, Value)]) -> anyhow::Result<()> {
    line(&object_text(fields))
}

/// A JSON object with its fields in this order.
pub fn object_text(fields: &[(&str, Value)]) -> String {
    let fields: Vec<String> =
        fields.iter().map(|(name, value)| format!("{}:{value}", json!(name))).collect();
    format!("{{{}}}", fields.join(","))
}

/// Tells the user something, in one line on standard error. If nobody listens, so be it.
pub fn remark(text: &str) {
    let _ = writeln!(io::stderr().lock(), "tilepack: {text}");
}

/// What a packing is, in the words of a solution file: the fields `format`, `kind`, `colors`,
/// `set`, `width`, `height` and `topology`.
pub fn description(packing: &Packing) -> Value {
    let empty = Packing {
        board: packing.board.clone(),
        ..Packing::new(packing.set.clone(), packing.shape, packing.cover, Vec::new())
    };
    let mut text = Vec::new();
    // Writing to memory does not fail, and what is written is JSON.
    let _ = write_solution(&mut text, &empty, &Value::Null, Layout::Line);
    serde_json::from_slice(&text).unwrap_or_default()
}

/// The fields that make an object a solution file: the description and the tiles.
pub fn solution_fields(packing: &Packing) -> Vec<(&'static str, Value)> {
    let description = description(packing);
    let mut fields: Vec<_> = ["format", "kind", "colors", "set", "cover", "topology", "border"]
        .into_iter()
        .filter_map(|name| Some((name, description.get(name)?.clone())))
        .collect();
    let rows: Vec<Vec<u32>> =
        packing.rows().map(|row| row.iter().map(|tile| tile.0).collect()).collect();
    fields.push(("tiles", json!(rows)));
    if packing.board.rotations {
        let turns: Vec<&[u8]> = packing.turns.chunks(packing.shape.width()).collect();
        fields.push(("rotations", json!(turns)));
    }
    fields
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn objects_keep_the_order_of_their_fields() {
        let text = object_text(&[("z", json!("a\"b")), ("a", json!(null)), ("m", json!([1, 2]))]);
        assert_eq!(text, r#"{"z":"a\"b","a":null,"m":[1,2]}"#);
    }
}

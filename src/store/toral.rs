//! Certificates of aperiodic sets of corner tiles: one JSON object.
//!
//! It is recognized by its `vertex_rule`. Fields may come in any order and unknown ones are
//! ignored; but where the file says by what convention it lists tiles, that must be ours. What
//! the numbers mean is for the verifier.

use super::json::{Field, json_error};
use super::{Input, StoreError};
use crate::torus::toral::{ToralCertificate, ToralPiece, ToralPoint, ToralWindow, VertexRule};
use serde::{Deserialize, Serialize};
use serde_json::json;
use serde_json::value::RawValue;
use std::io::{self, Write};
use std::marker::PhantomData;

#[derive(Debug, Deserialize)]
struct Document<'a> {
    #[serde(borrow)]
    title: Option<&'a RawValue>,
    #[serde(borrow)]
    lattice: Option<&'a RawValue>,
    #[serde(borrow)]
    domain: Option<&'a RawValue>,
    #[serde(borrow)]
    jr_tiles_5: Option<&'a RawValue>,
    #[serde(borrow)]
    jr_tiles_4: Option<&'a RawValue>,
    #[serde(borrow)]
    jr_convention: Option<&'a RawValue>,
    #[serde(borrow)]
    partition: Option<&'a RawValue>,
    #[serde(borrow)]
    vertex_rule: Option<&'a RawValue>,
    #[serde(borrow)]
    corner_tiles: Option<&'a RawValue>,
    #[serde(borrow)]
    corner_convention: Option<&'a RawValue>,
    #[serde(borrow)]
    image: Option<&'a RawValue>,
    #[serde(borrow)]
    window_shape: Option<&'a RawValue>,
    #[serde(borrow)]
    windows: Option<&'a RawValue>,
    #[serde(borrow)]
    options: Option<&'a RawValue>,
}

/// The rule as a file has it.
#[derive(Debug, Deserialize)]
struct Rule {
    rows_above: usize,
    rows_below: usize,
    cols_left: usize,
    cols_right: usize,
    table: Vec<(Vec<usize>, u32)>,
}

const WANG: &str = "[N,E,S,W]";
const CORNER: &str = "[NW,NE,SE,SW]";

/// Whether a file says that it holds a certificate; what else it says may be wrong.
pub fn holds_certificate(input: &Input) -> bool {
    if !input.is_json() || !input.text().contains("\"vertex_rule\"") {
        return false;
    }
    let text = &input.text()[input.start()..];
    match serde_json::Deserializer::from_str(text).into_iter::<Document<'_>>().next() {
        Some(Ok(document)) => document.vertex_rule.is_some(),
        // A broken certificate, by its looks.
        _ => true,
    }
}

/// The certificate of a file. Not verified.
///
/// # Errors
/// A malformed file.
pub fn read_certificate(input: &Input) -> Result<ToralCertificate, StoreError> {
    let start = input.start();
    let text = &input.text()[start..];
    let document: Document<'_> =
        serde_json::from_str(text).map_err(|error| json_error(input, start, text, &error))?;
    let field = |name: &str, raw| Field::required(input, start, name, raw);
    for (name, raw, ours) in [
        ("jr_convention", document.jr_convention, WANG),
        ("corner_convention", document.corner_convention, CORNER),
    ] {
        if let Some(field) = Field::optional(input, raw) {
            field.word(name, &[ours])?;
        }
    }
    let tiles = |name, raw| field(name, raw)?.read(PhantomData::<Vec<[u32; 4]>>);
    let lists = |name, raw| field(name, raw)?.read(PhantomData::<Vec<Vec<usize>>>);
    let rule = field("vertex_rule", document.vertex_rule)?.read(PhantomData::<Rule>)?;
    type Polygon = Vec<ToralPoint>;
    let pieces =
        field("partition", document.partition)?.read(PhantomData::<Vec<(usize, Polygon)>>)?;
    type Window = (Vec<usize>, Polygon, Vec<[i64; 3]>);
    let windows = field("windows", document.windows)?.read(PhantomData::<Vec<Window>>)?;
    Ok(ToralCertificate {
        title: match Field::optional(input, document.title) {
            Some(field) => field.string()?,
            None => String::new(),
        },
        lattice: field("lattice", document.lattice)?.read(PhantomData)?,
        domain: field("domain", document.domain)?.read(PhantomData)?,
        wang: tiles("jr_tiles_4", document.jr_tiles_4)?,
        wang_unmerged: match document.jr_tiles_5 {
            None => Vec::new(),
            given => tiles("jr_tiles_5", given)?,
        },
        partition: pieces
            .into_iter()
            .map(|(label, polygon)| ToralPiece { label, polygon })
            .collect(),
        rule: VertexRule {
            above: rule.rows_above,
            below: rule.rows_below,
            left: rule.cols_left,
            right: rule.cols_right,
            table: rule.table,
        },
        tiles: tiles("corner_tiles", document.corner_tiles)?,
        image: lists("image", document.image)?,
        options: lists("options", document.options)?,
        window_shape: field("window_shape", document.window_shape)?.read(PhantomData)?,
        windows: windows
            .into_iter()
            .map(|(labels, polygon, pieces)| ToralWindow { labels, polygon, pieces })
            .collect(),
    })
}

/// Writes a certificate, one entry of a list a line; equal arguments give equal bytes.
///
/// # Errors
/// What `out` reports.
pub fn write_certificate(mut out: impl Write, certificate: &ToralCertificate) -> io::Result<()> {
    let ToralCertificate { rule, .. } = certificate;
    writeln!(out, "{{\"title\":{},", json!(certificate.title))?;
    let numbers = "polygon vertex [a,b,c,d] = point (a+b*phi, c+d*phi), phi=(1+sqrt5)/2; all \
                   polygons convex, counter-clockwise";
    writeln!(out, "\"number_format\":{},", json!(numbers))?;
    writeln!(out, "\"lattice\":{},", json!(certificate.lattice))?;
    writeln!(out, "\"domain\":{},", json!(certificate.domain))?;
    if !certificate.wang_unmerged.is_empty() {
        writeln!(out, "\"jr_tiles_5\":{},", json!(certificate.wang_unmerged))?;
    }
    writeln!(out, "\"jr_tiles_4\":{},", json!(certificate.wang))?;
    writeln!(out, "\"jr_convention\":\"{WANG}\",")?;
    let pieces = certificate.partition.iter().map(|piece| (piece.label, &piece.polygon));
    list(&mut out, "partition", pieces, ",")?;
    writeln!(
        out,
        "\"vertex_rule\":{{\"rows_above\":{},\"rows_below\":{},\"cols_left\":{},\"cols_right\":{},",
        rule.above, rule.below, rule.left, rule.right
    )?;
    list(&mut out, "table", &rule.table, "},")?;
    list(&mut out, "corner_tiles", &certificate.tiles, ",")?;
    writeln!(out, "\"corner_convention\":\"{CORNER}\",")?;
    writeln!(out, "\"image\":{},", json!(certificate.image))?;
    writeln!(out, "\"window_shape\":{},", json!(certificate.window_shape))?;
    let windows =
        certificate.windows.iter().map(|window| (&window.labels, &window.polygon, &window.pieces));
    list(&mut out, "windows", windows, ",")?;
    let comment = "[labels row by row from the top row, polygon U, pieces]; pieces[i]=[k,m,n]: \
                   U+(dx,dy) lies in partition polygon k + m*lattice[0] + n*lattice[1], \
                   (dx,dy)=offset of window position i, bottom-left position has offset (0,0)";
    writeln!(out, "\"windows_comment\":{},", json!(comment))?;
    writeln!(out, "\"options\":{},", json!(certificate.options))?;
    let comment = "options[i]: all Wang tiles whose four labels occur at the four vertex pairs of \
                   corner tile i";
    writeln!(out, "\"options_comment\":{}}}", json!(comment))
}

/// A named list, one entry a line.
fn list(
    out: &mut impl Write,
    name: &str,
    entries: impl IntoIterator<Item = impl Serialize>,
    end: &str,
) -> io::Result<()> {
    write!(out, "\"{name}\":[")?;
    for (i, entry) in entries.into_iter().enumerate() {
        write!(out, "{}\n{}", if i > 0 { "," } else { "" }, json!(entry))?;
    }
    writeln!(out, "]{end}")
}

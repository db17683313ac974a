//! Certificates about whether a set of tiles fills the plane: written by `decide`, checked by
//! `verify` with code of its own.
//!
//! A certificate is a JSON object with the set (`kind`, `tiles`) and what `certificate` names:
//! `periodic` (`width`, `height`, `torus`), `no-tiling` (`square`, or `rows`, or `columns`), or
//! `published` (`name`, `sides`, `images`).

use super::published::published;
use crate::cli::exit::Exit;
use crate::cli::output;
use crate::store::Input;
use crate::tiles::Kind;
use crate::verify::{Claim, check_claim};
use anyhow::{Context, bail, ensure};
use serde::Deserialize;
use serde_json::{Value, json};

/// Partial fillings, or arcs, that a check keeps at most.
pub(super) const MOST: usize = 1 << 23;

/// What a certificate may say.
#[derive(Debug, Deserialize)]
struct Document {
    certificate: String,
    kind: String,
    tiles: Vec<[u32; 4]>,
    width: Option<usize>,
    height: Option<usize>,
    torus: Option<Vec<Vec<usize>>>,
    square: Option<usize>,
    rows: Option<usize>,
    columns: Option<usize>,
    name: Option<String>,
    sides: Option<[usize; 4]>,
    images: Option<Vec<usize>>,
}

/// Whether a file is such a certificate, right or wrong.
pub fn holds_claim(input: &Input) -> bool {
    #[derive(Deserialize)]
    struct Named {
        certificate: Value,
    }
    // Most files do not have the word at all, and need not be read twice.
    let text = input.text();
    text.contains("\"certificate\"")
        && serde_json::from_str::<Named>(text.trim_start())
            .is_ok_and(|named| named.certificate.is_string())
}

/// The fields of a certificate.
pub(super) fn fields(
    kind: Kind,
    tiles: &[[u32; 4]],
    claim: &Claim,
    name: Option<&str>,
) -> Vec<(&'static str, Value)> {
    let what = match claim {
        Claim::Torus { .. } => "periodic",
        Claim::NoSquare { .. } | Claim::NoStrip { .. } => "no-tiling",
        Claim::Like { .. } => "published",
    };
    let mut fields = vec![("certificate", json!(what)), ("kind", json!(kind.name()))];
    fields.push(("tiles", json!(tiles)));
    match claim {
        Claim::Torus { width, height, cells } => {
            let rows: Vec<&[usize]> = cells.chunks(*width).collect();
            fields.extend([("width", json!(width)), ("height", json!(height))]);
            fields.push(("torus", json!(rows)));
        }
        Claim::NoSquare { side } => fields.push(("square", json!(side))),
        Claim::NoStrip { rows: true, power } => fields.push(("rows", json!(power))),
        Claim::NoStrip { rows: false, power } => fields.push(("columns", json!(power))),
        Claim::Like { sides, images, .. } => {
            fields.push(("name", json!(name)));
            fields.extend([("sides", json!(sides)), ("images", json!(images))]);
        }
    }
    fields
}

/// What there is to say about a certificate.
pub struct ClaimReport {
    file: String,
    said: anyhow::Result<Said>,
}

/// A certificate that could be read.
struct Said {
    document: Document,
    kind: Kind,
    words: String,
    fault: Option<String>,
}

impl ClaimReport {
    /// Checks the certificate in a file.
    pub fn new(file: String, input: &Input) -> Self {
        Self { file, said: read(input) }
    }

    /// How it ends.
    pub fn exit(&self) -> Exit {
        match &self.said {
            Err(_) => Exit::Bad,
            Ok(said) => Exit::of(said.fault.is_none()),
        }
    }

    /// The verdict to standard output; what could not be read to standard error.
    ///
    /// # Errors
    /// When nobody reads it.
    pub fn print(&self, quiet: bool) -> anyhow::Result<()> {
        let file = if self.file == "-" { "standard input" } else { &self.file };
        match &self.said {
            Err(error) => output::remark(&format!("{file}: {error:#}")),
            Ok(Said { fault: Some(fault), .. }) => {
                output::line(&format!("{file}: not a certificate: {fault}"))?;
            }
            Ok(said) if !quiet => output::line(&format!("{file}: valid: {}", said.words))?,
            Ok(_) => {}
        }
        Ok(())
    }

    /// The JSON object of the file.
    pub fn object(&self) -> String {
        let said = self.said.as_ref().ok();
        let error = match &self.said {
            Err(error) => Some(format!("{error:#}")),
            Ok(said) => said.fault.clone(),
        };
        output::object_text(&[
            ("file", json!(self.file)),
            ("valid", json!(self.exit() == Exit::Yes)),
            ("kind", json!(said.map(|said| said.kind.name()))),
            ("certificate", json!(said.map(|said| &said.document.certificate))),
            ("width", json!(said.and_then(|said| said.document.width))),
            ("height", json!(said.and_then(|said| said.document.height))),
            ("error", json!(error)),
        ])
    }
}

fn read(input: &Input) -> anyhow::Result<Said> {
    let document: Document = serde_json::from_str(input.text().trim_start())?;
    let kind: Kind = document.kind.parse()?;
    let (claim, words) = claim(&document)?;
    let fault = check_claim(kind, &document.tiles, &claim, MOST).err();
    let words = format!("{} {kind} tiles {words}", document.tiles.len());
    Ok(Said { document, kind, words, fault: fault.map(|fault| fault.to_string()) })
}

/// What a certificate claims, and in words.
fn claim(document: &Document) -> anyhow::Result<(Claim, String)> {
    let missing = |field: &str| format!("{:?} is missing", field);
    match document.certificate.as_str() {
        "periodic" => {
            let width = document.width.with_context(|| missing("width"))?;
            let height = document.height.with_context(|| missing("height"))?;
            let rows = document.torus.as_ref().with_context(|| missing("torus"))?;
            for (row, cells) in rows.iter().enumerate() {
                let count = cells.len();
                ensure!(count == width, "torus, row {row}: {count} cells, expected {width}");
            }
            ensure!(rows.len() == height, "torus: {} rows, expected {height}", rows.len());
            let words = format!("fill the plane with two periods: a torus of {width} x {height}");
            Ok((Claim::Torus { width, height, cells: rows.concat() }, words))
        }
        "no-tiling" => match (document.square, document.rows, document.columns) {
            (Some(side), None, None) => Ok((
                Claim::NoSquare { side },
                format!("do not fill the plane: no square of {side} x {side}"),
            )),
            (None, Some(power), None) => Ok((
                Claim::NoStrip { rows: true, power },
                format!("do not fill the plane: the power of {power} rows is empty"),
            )),
            (None, None, Some(power)) => Ok((
                Claim::NoStrip { rows: false, power },
                format!("do not fill the plane: the power of {power} columns is empty"),
            )),
            _ => bail!("expected one of \"square\", \"rows\" and \"columns\""),
        },
        "published" => {
            let name = document.name.as_ref().with_context(|| missing("name"))?;
            let sides = document.sides.with_context(|| missing("sides"))?;
            let images = document.images.clone().with_context(|| missing("images"))?;
            let sets = published()?;
            let known = sets.iter().find(|set| set.name == *name);
            let known = known.with_context(|| format!("{name:?} is no set known here"))?;
            let other = known.set.tiles().to_vec();
            let words = format!("are the published aperiodic set {name:?} ({})", known.source);
            Ok((Claim::Like { other, sides, images }, words))
        }
        other => bail!("certificate {other:?}: expected periodic, no-tiling or published"),
    }
}

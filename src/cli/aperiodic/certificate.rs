//! What `verify` has to say about a certificate of an aperiodic set of corner tiles.

use super::super::exit::Exit;
use super::super::output;
use crate::store::{Input, StoreError, read_certificate};
use crate::verify::{CertificateFault, ProvedSet, check_certificate};
use serde_json::{Value, json};

/// What is taken on trust.
pub const ASSUMED: &str = "no tiling by the 11 Wang tiles of Jeandel and Rao is periodic (Jeandel \
                           and Rao 2021, Advances in Combinatorics 2021:1)";

/// What the steps of the check come to.
pub fn proved(set: &ProvedSet) -> [String; 3] {
    [
        format!(
            "the 11 Wang tiles fill the plane: {} polygons code their tilings on a torus, and the \
             {} windows that occur are legal",
            set.pieces, set.windows
        ),
        format!("the {} corner tiles fill the plane, as the colored vertices of these", set.tiles),
        format!(
            "every tiling by the corner tiles gives one by the Wang tiles, which has all its \
             periods: {} say each Wang tile",
            set.way_back
        ),
    ]
}

/// What became of a file.
pub struct CertificateReport {
    name: String,
    checked: Result<Result<ProvedSet, CertificateFault>, StoreError>,
}

impl CertificateReport {
    /// Reads and checks a file; refuses it when options say something about packings.
    pub fn new(name: String, input: &Input, about_packings: bool) -> Self {
        if about_packings {
            let message = "holds a certificate, but the options are about packings".to_owned();
            let checked = Err(StoreError::Content { file: input.file().into(), message });
            return Self { name, checked };
        }
        let checked = read_certificate(input).map(|certificate| check_certificate(&certificate));
        Self { name, checked }
    }

    /// The exit code for this file alone.
    pub fn exit(&self) -> Exit {
        match &self.checked {
            Err(_) => Exit::Bad,
            Ok(verdict) => Exit::of(verdict.is_ok()),
        }
    }

    /// The verdict to standard output; what could not be read to standard error.
    ///
    /// # Errors
    /// When standard output cannot be written to.
    pub fn print(&self, quiet: bool) -> anyhow::Result<()> {
        let name = if self.name == "-" { "standard input" } else { &self.name };
        match &self.checked {
            Err(error) => output::remark(&error.to_string()),
            Ok(Err(fault)) => output::line(&format!("{name}: proves nothing: {fault}"))?,
            Ok(Ok(_)) if quiet => {}
            Ok(Ok(set)) => output::result(|out| {
                let (tiles, colors) = (set.tiles, set.colors);
                writeln!(
                    out,
                    "{name}: valid: {tiles} corner tiles over {colors} colors, aperiodic given \
                     Jeandel and Rao 2021"
                )?;
                for step in proved(set) {
                    writeln!(out, "  proved: {step}")?;
                }
                writeln!(out, "  assumed: {ASSUMED}")
            })?,
        }
        Ok(())
    }

    /// The JSON object of the file, with the fields of packings, and its own.
    pub fn object(&self) -> String {
        let set = self.checked.as_ref().ok().and_then(|verdict| verdict.as_ref().ok());
        let error = match &self.checked {
            Err(error) => Some(error.to_string()),
            Ok(verdict) => verdict.as_ref().err().map(ToString::to_string),
        };
        output::object_text(&[
            ("file", json!(self.name)),
            ("valid", json!(set.is_some())),
            ("kind", json!(set.map(|_| "corner"))),
            ("colors", json!(set.map(|set| set.colors))),
            ("width", Value::Null),
            ("height", Value::Null),
            ("set", json!(set.map(|_| "certificate"))),
            ("topology", json!(set.map(|_| "plane"))),
            ("packings", json!(0)),
            ("error", json!(error)),
            ("tiles", json!(set.map(|set| set.tiles))),
            ("pieces", json!(set.map(|set| set.pieces))),
            ("windows", json!(set.map(|set| set.windows))),
            ("condition", json!(set.map(|set| set.way_back.name()))),
            ("ambiguous", json!(set.map(|set| set.ambiguous))),
            ("proved", json!(set.map(proved))),
            ("assumed", json!(set.map(|_| ASSUMED))),
        ])
    }
}

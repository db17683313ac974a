//! Reading packings from a file of either form.
//!
//! A file whose first character is `{` is JSON and may hold any number of solutions, one after
//! the other, as `list` writes them one a line; any other file is a text grid and holds one.
//! They are read one at a time, so a list takes no more memory than its text.

use super::solution::{Document, Object, Solution};
use super::{Claim, Input, StoreError, grid, json};

/// The packings of a file in order. Ends after the first error.
#[derive(Debug)]
pub struct Solutions<'a> {
    input: &'a Input,
    claim: &'a Claim,
    /// The byte offset of what is still to be read; `None` at the end.
    rest: Option<usize>,
    line: usize,
    found: bool,
}

/// The packings of a file. Where `claim` says something, the file must not say otherwise; a bare
/// grid needs a claim of at least kind and colors.
pub fn solutions<'a>(input: &'a Input, claim: &'a Claim) -> Solutions<'a> {
    Solutions { input, claim, rest: Some(0), line: 1, found: false }
}

/// The one packing of a file.
///
/// # Errors
/// A malformed file, a contradiction to `claim`, or more than one packing.
pub fn read_solution(input: &Input, claim: &Claim) -> Result<Solution, StoreError> {
    let mut all = solutions(input, claim);
    let first = all.next().ok_or_else(|| input.error("expected a solution"))??;
    match all.next() {
        None => Ok(first),
        Some(Err(error)) => Err(error),
        Some(Ok(second)) => {
            let message = format!("a second solution on line {}, expected one", second.line);
            Err(input.error(message))
        }
    }
}

impl Iterator for Solutions<'_> {
    type Item = Result<Solution, StoreError>;

    fn next(&mut self) -> Option<Self::Item> {
        let rest = self.rest.take()?;
        if !self.input.is_json() {
            return Some(grid::read(self.input, self.claim));
        }
        let begin = if self.found { rest } else { self.input.start() };
        let text = &self.input.text()[begin..];
        let start = begin + text.len() - text.trim_ascii_start().len();
        let passed = &self.input.text().as_bytes()[rest..start];
        self.line += passed.iter().filter(|&&byte| byte == b'\n').count();
        if start == self.input.text().len() {
            return None;
        }
        self.found = true;
        let line = self.line;
        match object(self.input, start) {
            Err(error) => Some(Err(error)),
            Ok((object, end)) => {
                let inside = &self.input.text().as_bytes()[start..end];
                self.line += inside.iter().filter(|&&byte| byte == b'\n').count();
                let packing = object.packing(self.claim);
                self.rest = packing.is_ok().then_some(end);
                let done = |(packing, provenance)| Solution { packing, provenance, line };
                Some(packing.map(done))
            }
        }
    }
}

/// The JSON object that begins at a byte offset, and where it ends.
pub(super) fn object(input: &Input, start: usize) -> Result<(Object<'_>, usize), StoreError> {
    let text = &input.text()[start..];
    if !text.starts_with('{') {
        return Err(input.error_at(start, "expected '{', the beginning of a solution"));
    }
    let mut objects = serde_json::Deserializer::from_str(text).into_iter::<Document<'_>>();
    match objects.next() {
        Some(Ok(fields)) => {
            let end = start + objects.byte_offset();
            Ok((Object { input, start, fields }, end))
        }
        Some(Err(error)) => Err(json::json_error(input, start, text, &error)),
        None => Err(input.error_at(start, "expected a solution")),
    }
}

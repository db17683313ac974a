//! JSON files that programs rely on: readable, and whole or refused.
//!
//! `{"format": ..., "checksum": ..., "content": {...}}`: the checksum is the BLAKE3 hash of the
//! text of the content as it stands in the file, so that a change of any byte is noticed, and
//! anybody can check it with common tools.

use super::{Input, StoreError, fingerprint, write_file};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use std::io::Write;
use std::path::Path;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Sealed<'a> {
    format: String,
    checksum: String,
    #[serde(borrow)]
    content: &'a RawValue,
}

/// A hash in hexadecimal digits.
pub fn hexadecimal(hash: &[u8; 32]) -> String {
    hash.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Writes a file of this format.
///
/// # Errors
/// When it cannot be written.
pub(super) fn write_sealed(
    file: &Path,
    format: &str,
    content: &impl Serialize,
) -> Result<(), StoreError> {
    // Numbers, words and lists of them have a JSON form.
    let content = serde_json::to_string(content).unwrap_or_default();
    let checksum = hexadecimal(&fingerprint(&content));
    write_file(file, |out| {
        writeln!(out, "{{\"format\":\"{format}\",\"checksum\":\"{checksum}\",")?;
        writeln!(out, "\"content\":{content}}}")
    })
}

/// Reads a file of this format: its content, and the checksum that identifies it.
///
/// # Errors
/// A file that cannot be read, has another format, or was changed.
pub(super) fn read_sealed<T: DeserializeOwned>(
    file: &Path,
    format: &str,
) -> Result<(T, String), StoreError> {
    let input = Input::open(file)?;
    let wrong = |message: String| StoreError::Content { file: file.into(), message };
    let damaged = |error: serde_json::Error| wrong(format!("is damaged, or no {format}: {error}"));
    let sealed: Sealed<'_> = serde_json::from_str(input.text()).map_err(damaged)?;
    if sealed.format != format {
        return Err(wrong(format!("has the format {:?}, expected {format:?}", sealed.format)));
    }
    if sealed.checksum != hexadecimal(&fingerprint(sealed.content.get())) {
        return Err(wrong("was changed or is damaged: its checksum does not match".into()));
    }
    let content = serde_json::from_str(sealed.content.get()).map_err(damaged)?;
    Ok((content, sealed.checksum))
}

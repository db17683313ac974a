//! Opening what a user names: a file, or `-` for standard input.

use crate::store::{Input, MAX_BYTES, StoreError};
use std::io::{self, Read};
use std::path::Path;

/// The text of a file, or of standard input.
///
/// # Errors
/// As [`Input::open`].
pub fn open(file: &Path) -> Result<Input, StoreError> {
    if file != Path::new("-") {
        return Input::open(file);
    }
    let mut bytes = Vec::new();
    let name = Path::new("standard input");
    io::stdin()
        .lock()
        .take(MAX_BYTES + 1)
        .read_to_end(&mut bytes)
        .map_err(|source| StoreError::Unreadable { file: name.into(), source })?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(StoreError::TooLarge { file: name.into(), limit: MAX_BYTES });
    }
    Input::from_bytes(name, bytes)
}

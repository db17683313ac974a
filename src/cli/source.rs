//! Opening what a user names: a file, or `-` for standard input.

use super::args::ClaimArgs;
use super::set;
use crate::store::{Input, MAX_BYTES, StoreError, read_solution};
use crate::torus::Packing;
use crate::verify;
use anyhow::bail;
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

/// The one packing of a file; it is checked from the definition.
///
/// # Errors
/// A file that cannot be read, or that holds no packing.
pub fn packing(file: &Path, claim: &ClaimArgs) -> anyhow::Result<Packing> {
    let claim = set::packing_claim(claim)?;
    let packing = read_solution(&open(file)?, &claim)?.packing;
    let verdict = verify::check(&packing);
    if !verdict.is_valid() {
        let what = if packing.cover { "covering" } else { "packing" };
        bail!("{}: not a {what}: {verdict}", file.display());
    }
    Ok(packing)
}

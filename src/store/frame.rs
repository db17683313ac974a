//! The frame around binary files: what it is, whose it is, and whether it is whole.
//!
//! | bytes | what |
//! |---|---|
//! | 8 | `TILEPACK` |
//! | 2 | version of the format |
//! | 2 | kind: 1 is a checkpoint, 2 the checkpoint of a count with large tables |
//! | 8 | length of the payload |
//! | 32 | fingerprint of the search |
//! | … | payload |
//! | 32 | BLAKE3 hash of all bytes before |
//!
//! Numbers are little-endian. The hash finds any damage, so a file is either read as it was
//! written or refused with its name.

use super::StoreError;
use std::path::Path;

pub(super) const MAGIC: &[u8; 8] = b"TILEPACK";
/// The newest version of the format, which is written.
pub(super) const VERSION: u16 = 1;
pub(super) const HEAD: usize = 52;
pub(super) const HASH: usize = 32;

/// What a file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FrameKind {
    /// A search under way.
    Checkpoint = 1,
    /// A count with large tables, read and written piece by piece: see [`super::long`].
    Long = 2,
}

/// A frame that is whole.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Frame<'a> {
    /// The version of the format of the payload.
    pub(super) version: u16,
    /// Identifies the search.
    pub(super) fingerprint: [u8; 32],
    /// The content.
    pub(super) payload: &'a [u8],
}

/// The bytes before the payload.
pub(super) fn head(kind: FrameKind, fingerprint: &[u8; 32], length: u64) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(HEAD);
    bytes.extend(MAGIC);
    bytes.extend(VERSION.to_le_bytes());
    bytes.extend((kind as u16).to_le_bytes());
    bytes.extend(length.to_le_bytes());
    bytes.extend(fingerprint);
    bytes
}

/// The bytes of a file.
pub(super) fn write(kind: FrameKind, fingerprint: &[u8; 32], payload: &[u8]) -> Vec<u8> {
    let mut bytes = head(kind, fingerprint, payload.len() as u64);
    bytes.reserve_exact(payload.len() + HASH);
    bytes.extend(payload);
    let hash = blake3::hash(&bytes);
    bytes.extend(hash.as_bytes());
    bytes
}

/// Checks the bytes of a file.
///
/// # Errors
/// Another kind of file, a version that is not known, a file cut short or damaged.
pub(super) fn read<'a>(
    file: &Path,
    kind: FrameKind,
    bytes: &'a [u8],
) -> Result<Frame<'a>, StoreError> {
    let wrong = |message: String| StoreError::Content { file: file.into(), message };
    if !bytes.starts_with(MAGIC) {
        return Err(wrong("is not a checkpoint: expected a file that begins with TILEPACK".into()));
    }
    let number = |at: usize, bytes_of: usize| {
        let digits = bytes.get(at..at + bytes_of)?;
        Some(digits.iter().rev().fold(0u64, |number, &byte| number << 8 | u64::from(byte)))
    };
    let short = || wrong(format!("is cut short: {} bytes are not even a frame", bytes.len()));
    let version = number(8, 2).ok_or_else(short)?;
    let length = number(12, 8).ok_or_else(short)?;
    let expected = length.saturating_add((HEAD + HASH) as u64);
    if bytes.len() as u64 != expected {
        let bytes = bytes.len();
        return Err(wrong(format!("is cut short or damaged: {bytes} bytes, expected {expected}")));
    }
    let (content, hash) = bytes.split_at(bytes.len() - HASH);
    if blake3::hash(content).as_bytes() != hash {
        return Err(wrong("is damaged: its checksum does not match its content".into()));
    }
    // Now that it is known not to be damage.
    if version > u64::from(VERSION) {
        return Err(StoreError::Newer { file: file.into(), version, known: VERSION });
    }
    if number(10, 2) != Some(kind as u64) {
        return Err(wrong("is not a checkpoint, but another file of this program".into()));
    }
    let mut fingerprint = [0; 32];
    fingerprint.copy_from_slice(&content[20..HEAD]);
    Ok(Frame { version: version as u16, fingerprint, payload: &content[HEAD..] })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_flipped_bit_and_any_missing_byte_is_found() {
        let file = Path::new("some.checkpoint");
        let read = |bytes: &[u8]| read(file, FrameKind::Checkpoint, bytes).map(|f| f.version);
        let whole = write(FrameKind::Checkpoint, &[7; 32], b"what a search stands at");
        assert_eq!(read(&whole).unwrap(), VERSION);
        for bit in 0..8 * whole.len() {
            let mut bytes = whole.clone();
            bytes[bit / 8] ^= 1 << (bit % 8);
            let error = read(&bytes).unwrap_err().to_string();
            assert!(error.starts_with("some.checkpoint: "), "{error}");
        }
        for length in 0..whole.len() {
            assert!(read(&whole[..length]).is_err(), "{length}");
        }
        let longer: Vec<u8> = whole.iter().copied().chain([0]).collect();
        assert!(read(&longer).is_err());
    }
}

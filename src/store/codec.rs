//! Values to bytes and back.
//!
//! The only file that names `bincode`. Its bytes are small (numbers take as many bytes as they
//! need) but it notices damage only by chance, so nothing it wrote is read without the checksum
//! of a [frame](super::frame). Reading is bounded by the bytes there are, whatever lengths they
//! claim, and nothing may be left over.

use bincode::{DefaultOptions, Options};
use serde::Serialize;
use serde::de::DeserializeOwned;

fn options() -> impl Options {
    DefaultOptions::new()
}

/// The bytes of a value.
///
/// # Errors
/// When the value has no such form.
pub(super) fn encode(value: &impl Serialize) -> Result<Vec<u8>, String> {
    options().serialize(value).map_err(|error| error.to_string())
}

/// The value of bytes, all of them.
///
/// # Errors
/// When they are not the bytes of such a value.
pub(super) fn decode<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, String> {
    let options = options().with_limit(bytes.len() as u64);
    options.deserialize(bytes).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_not_believed() {
        let bytes = encode(&vec![1u32, 2, 300]).unwrap();
        assert_eq!(decode::<Vec<u32>>(&bytes), Ok(vec![1, 2, 300]));
        let longer: Vec<u8> = bytes.iter().copied().chain([0]).collect();
        assert!(decode::<Vec<u32>>(&longer).is_err());
        assert!(decode::<Vec<u32>>(&bytes[..bytes.len() - 1]).is_err());
        let endless = encode(&u64::MAX).unwrap();
        assert!(decode::<Vec<u8>>(&endless).is_err());
    }
}

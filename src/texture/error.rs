//! What can go wrong on the way from an example to tiles, in one line.

use crate::atlas::AtlasError;

/// Tiles that cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum TextureError {
    /// What was asked for makes no sense, or is too large; the message says what was expected.
    #[error("{0}")]
    Asked(String),
    /// A picture or a set of pictures is not what it should be.
    #[error(transparent)]
    Atlas(#[from] AtlasError),
    /// A signal asked to stop.
    #[error("stopped")]
    Stopped,
}

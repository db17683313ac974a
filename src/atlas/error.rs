//! What can go wrong on the way from a packing to a texture, in one line.

use std::io;
use std::path::PathBuf;

/// A texture that cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum AtlasError {
    /// What was asked for makes no sense, or is too large; the message says what was expected.
    #[error("{0}")]
    Asked(String),
    /// A file of pictures or tables is not what it should be.
    #[error("{}: {message}", .file.display())]
    File {
        /// The path.
        file: PathBuf,
        /// What is wrong and what was expected.
        message: String,
    },
    /// Writing failed.
    #[error("{0}")]
    Io(#[from] io::Error),
}

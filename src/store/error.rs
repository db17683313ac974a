//! What can go wrong with a file, in one line that names it.

use std::io;
use std::path::PathBuf;

/// A file that cannot be read, understood or written.
#[derive(Debug, thiserror::Error)]
pub enum StoreError {
    /// The path names a directory.
    #[error("{}: is a directory, expected a file", .file.display())]
    Directory {
        /// The path.
        file: PathBuf,
    },
    /// There is no such file.
    #[error("{}: no such file", .file.display())]
    Missing {
        /// The path.
        file: PathBuf,
    },
    /// The system refuses to read the file.
    #[error("{}: cannot be read: {source}", .file.display())]
    Unreadable {
        /// The path.
        file: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The file is larger than any we accept.
    #[error("{}: is larger than {} MiB, the limit", .file.display(), .limit >> 20)]
    TooLarge {
        /// The path.
        file: PathBuf,
        /// The largest number of bytes accepted.
        limit: u64,
    },
    /// The file is not text.
    #[error("{}: is a binary file: the byte at offset {offset} is not UTF-8 text", .file.display())]
    Binary {
        /// The path.
        file: PathBuf,
        /// The 0-based position of the first byte that is not text.
        offset: usize,
    },
    /// The text breaks the rules of its format.
    #[error("{}:{line}:{column}: {message}", .file.display())]
    Syntax {
        /// The path.
        file: PathBuf,
        /// 1-based line.
        line: usize,
        /// 1-based column, in characters.
        column: usize,
        /// What is wrong and what was expected.
        message: String,
    },
    /// A cell is at fault. Rows and columns count from 0.
    #[error("{}: row {row}, column {column}: {message}", .file.display())]
    Cell {
        /// The path.
        file: PathBuf,
        /// 0-based, from the north.
        row: usize,
        /// 0-based, from the west.
        column: usize,
        /// What is wrong with it.
        message: String,
    },
    /// The file as a whole is not what was asked for.
    #[error("{}: {message}", .file.display())]
    Content {
        /// The path.
        file: PathBuf,
        /// What is wrong and what was expected.
        message: String,
    },
    /// A later version of the program wrote it.
    #[error("{}: has version {version} of the format; this program reads up to version {known}", .file.display())]
    Newer {
        /// The path.
        file: PathBuf,
        /// Its version.
        version: u64,
        /// The newest version known.
        known: u16,
    },
    /// Another process works on it.
    #[error("{}: another process is at work on it (it has locked {})", .file.display(), .lock.display())]
    Locked {
        /// The path.
        file: PathBuf,
        /// The file that is locked.
        lock: PathBuf,
    },
    /// The file cannot be written.
    #[error("{}: cannot be written: {message}", .file.display())]
    Unwritable {
        /// The path.
        file: PathBuf,
        /// Why.
        message: String,
    },
}

impl StoreError {
    /// The file at fault.
    pub fn file(&self) -> &std::path::Path {
        match self {
            StoreError::Directory { file }
            | StoreError::Missing { file }
            | StoreError::Unreadable { file, .. }
            | StoreError::TooLarge { file, .. }
            | StoreError::Binary { file, .. }
            | StoreError::Syntax { file, .. }
            | StoreError::Cell { file, .. }
            | StoreError::Content { file, .. }
            | StoreError::Newer { file, .. }
            | StoreError::Locked { file, .. }
            | StoreError::Unwritable { file, .. } => file,
        }
    }
}

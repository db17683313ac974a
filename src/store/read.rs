//! Opening input files.
//!
//! A file is read whole, after a look at its length, and must be UTF-8 text. Positions are kept
//! as byte offsets and turned into lines and columns only when an error needs them.

use super::StoreError;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// The largest file that is read, in bytes.
pub const MAX_BYTES: u64 = 1 << 30;

/// The text of a file, and the name that errors give it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Input {
    file: PathBuf,
    text: String,
}

impl Input {
    /// Reads a file.
    ///
    /// # Errors
    /// A directory, no such file, a file that may not be read, more than [`MAX_BYTES`], or a
    /// file that is not UTF-8 text.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, StoreError> {
        let path = path.as_ref();
        let unreadable = |source: io::Error| match source.kind() {
            io::ErrorKind::NotFound => StoreError::Missing { file: path.into() },
            io::ErrorKind::IsADirectory => StoreError::Directory { file: path.into() },
            _ => StoreError::Unreadable { file: path.into(), source },
        };
        let file = File::open(path).map_err(unreadable)?;
        let about = file.metadata().map_err(unreadable)?;
        if about.is_dir() {
            return Err(StoreError::Directory { file: path.into() });
        }
        let too_large = || StoreError::TooLarge { file: path.into(), limit: MAX_BYTES };
        if about.len() > MAX_BYTES {
            return Err(too_large());
        }
        // Pipes and devices have no length, so the limit is kept while reading, too.
        let mut bytes = Vec::with_capacity(about.len() as usize);
        file.take(MAX_BYTES + 1).read_to_end(&mut bytes).map_err(unreadable)?;
        if bytes.len() as u64 > MAX_BYTES {
            return Err(too_large());
        }
        Self::from_bytes(path, bytes)
    }

    /// Takes bytes that were read elsewhere; errors name them `file`.
    ///
    /// # Errors
    /// When the bytes are not UTF-8 text or contain a zero byte.
    pub fn from_bytes(file: impl Into<PathBuf>, bytes: Vec<u8>) -> Result<Self, StoreError> {
        let file = file.into();
        let zero = bytes.iter().position(|&byte| byte == 0);
        match (String::from_utf8(bytes), zero) {
            (Ok(text), None) => Ok(Self { file, text }),
            (Ok(_), Some(offset)) => Err(StoreError::Binary { file, offset }),
            (Err(error), zero) => {
                let invalid = error.utf8_error().valid_up_to();
                let offset = zero.map_or(invalid, |zero| zero.min(invalid));
                Err(StoreError::Binary { file, offset })
            }
        }
    }

    /// The name of the file.
    pub fn file(&self) -> &Path {
        &self.file
    }

    /// Its text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The byte offset of the first character that is neither blank nor a byte order mark.
    pub(super) fn start(&self) -> usize {
        let blank = |c: char| c.is_whitespace() || c == '\u{feff}';
        self.text.len() - self.text.trim_start_matches(blank).len()
    }

    /// Whether the file holds JSON; else it is a text grid.
    pub(super) fn is_json(&self) -> bool {
        self.text[self.start()..].starts_with('{')
    }

    /// An error at a byte offset.
    pub(super) fn error_at(&self, offset: usize, message: impl Into<String>) -> StoreError {
        let mut offset = offset.min(self.text.len());
        while !self.text.is_char_boundary(offset) {
            offset -= 1;
        }
        let before = &self.text[..offset];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        StoreError::Syntax {
            file: self.file.clone(),
            line: before.bytes().filter(|&byte| byte == b'\n').count() + 1,
            column: before[line_start..].chars().filter(|&c| c != '\u{feff}').count() + 1,
            message: one_line(message.into()),
        }
    }

    /// An error in the cell of a row and column.
    pub(super) fn error_in(
        &self,
        (row, column): (usize, usize),
        message: impl Into<String>,
    ) -> StoreError {
        let message = one_line(message.into());
        StoreError::Cell { file: self.file.clone(), row, column, message }
    }

    /// An error of the file as a whole.
    pub(super) fn error(&self, message: impl Into<String>) -> StoreError {
        StoreError::Content { file: self.file.clone(), message: one_line(message.into()) }
    }
}

/// A message that quotes a file may be of any length and hold anything; people get one line.
fn one_line(message: String) -> String {
    const LONGEST: usize = 300;
    let mut line = String::with_capacity(message.len().min(4 * LONGEST));
    for (i, c) in message.chars().enumerate() {
        match c {
            _ if i == LONGEST => {
                line.push('…');
                break;
            }
            c if c.is_control() => line.extend(c.escape_default()),
            c => line.push(c),
        }
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_columns_count_characters_from_one() {
        let input = Input::from_bytes("f", "\u{feff}aé\n\nxyz".into()).unwrap();
        for (offset, place) in
            [(0, "1:1"), (3, "1:1"), (4, "1:2"), (6, "1:3"), (8, "3:1"), (10, "3:3"), (99, "3:4")]
        {
            let message = input.error_at(offset, "m").to_string();
            assert_eq!(message, format!("f:{place}: m"), "offset {offset}");
        }
    }

    #[test]
    fn messages_are_one_short_line() {
        let input = Input::from_bytes("f", "{".into()).unwrap();
        assert_eq!(input.error("a\nb\u{1b}[1m").to_string(), "f: a\\nb\\u{1b}[1m");
        assert_eq!(input.error("é".repeat(999)).to_string(), format!("f: {}…", "é".repeat(300)));
    }

    #[test]
    fn binary_files_are_refused() {
        for (bytes, offset) in [(&b"ab\xffcd"[..], 2), (b"a\0b", 1), (b"\0\xff", 0), (b"\xff\0", 0)]
        {
            let error = Input::from_bytes("f", bytes.to_vec()).unwrap_err();
            assert!(matches!(error, StoreError::Binary { offset: o, .. } if o == offset));
        }
    }
}

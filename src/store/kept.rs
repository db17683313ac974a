//! Packings met so far, in a file that grows.
//!
//! A list may be far larger than what a checkpoint should hold. So the packings met go to a file
//! of their own, label by label, one packing after the other, and only ever at its end; a
//! checkpoint says how long the file was and gives the BLAKE3 hash of that much. What a search
//! wrote after its last checkpoint it will meet again, and is cut off when it goes on.

use super::StoreError;
use std::fs::{self, File};
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// How much of the file counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Extent {
    /// Its length in bytes.
    pub length: u64,
    /// The BLAKE3 hash of so many bytes.
    pub hash: [u8; 32],
}

/// The file of packings met.
#[derive(Debug)]
pub struct Kept {
    path: PathBuf,
    length: u64,
    hasher: blake3::Hasher,
}

impl Kept {
    /// Begins a file; what an earlier search left under the name is not looked at.
    pub fn new(path: PathBuf) -> Self {
        Self { path, length: 0, hasher: blake3::Hasher::new() }
    }

    /// Goes on with a file as a checkpoint saw it.
    ///
    /// # Errors
    /// When the file is not there, is too short, or its beginning is not what it was.
    pub fn open(path: PathBuf, extent: Extent) -> Result<Self, StoreError> {
        let mut kept = Self::new(path);
        if extent.length > 0 {
            kept.read_through(extent.length, |_| {})?;
        }
        if kept.extent() != extent {
            return Err(kept.damaged());
        }
        Ok(kept)
    }

    /// How much there is.
    pub fn extent(&self) -> Extent {
        Extent { length: self.length, hash: *self.hasher.finalize().as_bytes() }
    }

    /// The name of the file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Adds packings and brings them to the disk.
    ///
    /// # Errors
    /// When the file cannot be written; nothing has been added then.
    pub fn add(&mut self, packings: &[Vec<u8>]) -> Result<(), StoreError> {
        if packings.is_empty() {
            return Ok(());
        }
        let bytes = packings.concat();
        self.write(&bytes).map_err(|error| StoreError::Unwritable {
            file: self.path.clone(),
            message: error.to_string(),
        })?;
        self.length += bytes.len() as u64;
        self.hasher.update(&bytes);
        Ok(())
    }

    fn write(&self, bytes: &[u8]) -> io::Result<()> {
        let mut file = File::options().write(true).create(true).truncate(false).open(&self.path)?;
        file.set_len(self.length)?;
        file.seek(SeekFrom::Start(self.length))?;
        file.write_all(bytes)?;
        file.sync_all()
    }

    /// The packings, of so many labels each.
    ///
    /// # Errors
    /// When the file cannot be read, or no longer holds what was written.
    pub fn packings(&self, labels: usize) -> Result<Vec<Vec<u8>>, StoreError> {
        let mut again = Self::new(self.path.clone());
        let mut all = Vec::new();
        if self.length > 0 {
            again.read_through(self.length, |bytes| all.extend_from_slice(bytes))?;
        }
        if again.extent() != self.extent() || all.len() % labels.max(1) != 0 {
            return Err(self.damaged());
        }
        Ok(all.chunks(labels.max(1)).map(<[u8]>::to_vec).collect())
    }

    /// Removes the file.
    pub fn remove(self) {
        // If it stays, it only takes space.
        let _ = fs::remove_file(self.path);
    }

    fn read_through(&mut self, length: u64, mut each: impl FnMut(&[u8])) -> Result<(), StoreError> {
        let unreadable = |source: io::Error| match source.kind() {
            io::ErrorKind::NotFound => StoreError::Missing { file: self.path.clone() },
            _ => StoreError::Unreadable { file: self.path.clone(), source },
        };
        let file = File::open(&self.path).map_err(unreadable)?;
        let mut file = BufReader::new(file).take(length);
        let mut buffer = vec![0; 1 << 16];
        loop {
            let read = file.read(&mut buffer).map_err(unreadable)?;
            if read == 0 {
                return Ok(());
            }
            self.length += read as u64;
            self.hasher.update(&buffer[..read]);
            each(&buffer[..read]);
        }
    }

    fn damaged(&self) -> StoreError {
        StoreError::Content {
            file: self.path.clone(),
            message: "does not hold the packings that were written to it".into(),
        }
    }
}

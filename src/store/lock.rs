//! One process at a time.
//!
//! Two processes that save to the same file would overwrite each other's work. Each first locks
//! a file beside it, `NAME.lock`. The lock belongs to the open file and ends with the process,
//! however that ends; the file is removed when the process lets go of it in good order, and a
//! file left behind by one that was killed is in nobody's way.

use super::{StoreError, beside};
use std::fs::{self, File, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A lock, held until dropped.
#[derive(Debug)]
pub struct Lock {
    path: PathBuf,
    /// Kept open: closing it ends the lock.
    _file: File,
}

impl Lock {
    /// Locks what is kept in `file`.
    ///
    /// # Errors
    /// When another process holds the lock, or no file can be made beside `file`.
    pub fn take(file: &Path) -> Result<Self, StoreError> {
        let path = beside(file, ".lock");
        let unwritable = |error: io::Error| {
            let message = format!("{} cannot be locked: {error}", path.display());
            StoreError::Unwritable { file: file.into(), message }
        };
        loop {
            let opened = File::options().write(true).create(true).truncate(false).open(&path);
            let mut lock = opened.map_err(unwritable)?;
            match lock.try_lock() {
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => {
                    return Err(StoreError::Locked { file: file.into(), lock: path });
                }
                Err(TryLockError::Error(error)) => return Err(unwritable(error)),
            }
            // The process that held it may have removed it between our two steps.
            if is_still_there(&lock, &path) {
                // For people who look; nothing reads it.
                let _ = lock.set_len(0).and_then(|()| writeln!(lock, "{}", std::process::id()));
                return Ok(Self { path, _file: lock });
            }
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // Still locked: nobody else can have taken it for theirs.
        let _ = fs::remove_file(&self.path);
    }
}

#[cfg(unix)]
fn is_still_there(lock: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let identity = |about: fs::Metadata| (about.dev(), about.ino());
    match (lock.metadata(), fs::metadata(path)) {
        (Ok(ours), Ok(there)) => identity(ours) == identity(there),
        _ => false,
    }
}

#[cfg(not(unix))]
fn is_still_there(_: &File, path: &Path) -> bool {
    path.exists()
}

//! Writing files whole or not at all.
//!
//! A result goes to a temporary file in the folder of its target, is brought to the disk, and
//! takes the name of the target in one step; then the folder is brought to the disk, too. A
//! crash, a full disk or a signal leaves the old file or none, never half a file. What is no
//! regular file (a pipe, `/dev/null`) cannot be replaced and is written directly.

use super::StoreError;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// A file that comes to be when [`AtomicFile::commit`] is called. Dropped before, it leaves
/// nothing behind.
#[derive(Debug)]
pub struct AtomicFile {
    /// As the user named it, for errors.
    file: PathBuf,
    out: Out,
}

#[derive(Debug)]
enum Out {
    /// A temporary file, and the file it replaces.
    Temporary(BufWriter<NamedTempFile>, PathBuf),
    Direct(BufWriter<File>),
}

impl AtomicFile {
    /// Begins a file; nothing is at `path` until the end.
    ///
    /// # Errors
    /// When the file cannot be written: see [`check_writable`].
    pub fn create(path: impl AsRef<Path>) -> Result<Self, StoreError> {
        let file = path.as_ref();
        let wrong = |error: io::Error| unwritable(file, &error);
        let out = match target(file)? {
            Target::Other => {
                Out::Direct(BufWriter::new(File::options().write(true).open(file).map_err(wrong)?))
            }
            Target::Regular(path) => {
                let temporary = temporary(file, &path)?;
                // A file that is replaced keeps its permissions.
                if let Ok(old) = fs::metadata(&path) {
                    temporary.as_file().set_permissions(old.permissions()).map_err(wrong)?;
                }
                Out::Temporary(BufWriter::new(temporary), path)
            }
        };
        Ok(Self { file: file.into(), out })
    }

    /// Brings what was written to the disk and gives it its name.
    ///
    /// # Errors
    /// When that fails; the target is then as it was before.
    pub fn commit(self) -> Result<(), StoreError> {
        let Self { file, out } = self;
        finish(out).map_err(|error| unwritable(&file, &error))
    }
}

fn finish(out: Out) -> io::Result<()> {
    match out {
        Out::Direct(mut out) => out.flush(),
        Out::Temporary(out, path) => {
            let temporary = out.into_inner().map_err(io::IntoInnerError::into_error)?;
            temporary.as_file().sync_all()?;
            temporary.persist(&path).map_err(|error| error.error)?;
            sync_folder(folder(&path));
            Ok(())
        }
    }
}

impl Write for AtomicFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.out {
            Out::Temporary(out, _) => out.write(bytes),
            Out::Direct(out) => out.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.out {
            Out::Temporary(out, _) => out.flush(),
            Out::Direct(out) => out.flush(),
        }
    }
}

/// Writes a file whole or not at all.
///
/// # Errors
/// When the file cannot be written, or what `write` reports.
pub fn write_file(
    path: impl AsRef<Path>,
    write: impl FnOnce(&mut AtomicFile) -> io::Result<()>,
) -> Result<(), StoreError> {
    let path = path.as_ref();
    let mut file = AtomicFile::create(path)?;
    write(&mut file).map_err(|error| unwritable(path, &error))?;
    file.commit()
}

/// Finds out, before a long search, whether its result could be written.
///
/// # Errors
/// When `path` is a directory, its folder does not exist or accepts no files, or a file is there
/// that is read-only.
pub fn check_writable(path: impl AsRef<Path>) -> Result<(), StoreError> {
    let file = path.as_ref();
    match target(file)? {
        Target::Other => Ok(()),
        Target::Regular(path) => temporary(file, &path).map(drop),
    }
}

enum Target {
    /// A regular file, there or not, with symbolic links followed: it is not the link that is to
    /// be replaced.
    Regular(PathBuf),
    /// A pipe or a device.
    Other,
}

fn target(file: &Path) -> Result<Target, StoreError> {
    let wrong =
        |message: &str| StoreError::Unwritable { file: file.into(), message: message.into() };
    match fs::metadata(file) {
        Ok(about) if about.is_dir() => Err(wrong("it is a directory")),
        Ok(about) if !about.is_file() => Ok(Target::Other),
        Ok(about) if about.permissions().readonly() => Err(wrong("the file is read-only")),
        Ok(_) => {
            fs::canonicalize(file).map(Target::Regular).map_err(|error| unwritable(file, &error))
        }
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(unwritable(file, &error)),
        Err(_) if file.file_name().is_none() => Err(wrong("it names no file")),
        Err(_) if file.as_os_str().as_encoded_bytes().ends_with(b"/") => {
            Err(wrong("it names a directory"))
        }
        Err(_) => Ok(Target::Regular(file.into())),
    }
}

/// The temporary file that will become the file at `path`.
fn temporary(file: &Path, path: &Path) -> Result<NamedTempFile, StoreError> {
    let folder = folder(path);
    if !folder.is_dir() {
        let message = format!("there is no directory {}", folder.display());
        return Err(StoreError::Unwritable { file: file.into(), message });
    }
    let mut builder = tempfile::Builder::new();
    builder.prefix(".tilepack-").suffix(".part");
    // Temporary files are private by default; a result is as readable as any other file.
    #[cfg(unix)]
    let permissions = std::os::unix::fs::PermissionsExt::from_mode(0o666);
    #[cfg(unix)]
    builder.permissions(permissions);
    builder.tempfile_in(folder).map_err(|error| {
        let message = format!("no file can be made in {}: {}", folder.display(), plain(&error));
        StoreError::Unwritable { file: file.into(), message }
    })
}

/// The folder of a file.
pub(super) fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Makes the new name durable. The file is complete already, and some file systems cannot do
/// this, so failing to is no error.
pub(super) fn sync_folder(folder: &Path) {
    #[cfg(unix)]
    {
        let _ = File::open(folder).and_then(|folder| folder.sync_all());
    }
    #[cfg(not(unix))]
    let _ = folder;
}

fn unwritable(file: &Path, error: &io::Error) -> StoreError {
    StoreError::Unwritable { file: file.into(), message: plain(error) }
}

/// The error without the random name of the temporary file, which tells nobody anything.
fn plain(error: &io::Error) -> String {
    let mut message = error.to_string();
    if let Some(path) = message.find(" at path \"") {
        message.truncate(path);
    }
    message
}

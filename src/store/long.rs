//! Checkpoints of counts whose tables are as large as the memory: written and read piece by piece.
//!
//! The payload of the [`frame`] is two texts, each after its length in 8 bytes: the job, and what is
//! to be done with the answer; then the bytes of the count, whose form is its own. As with other
//! checkpoints a new one is complete on the disk before it takes the name, and the one before it
//! stays as `NAME.previous`. A file is read twice: first its checksum, then what it holds.

use super::checkpoint::{previous, take_place};
use super::frame::{self, FrameKind, HASH, HEAD, MAGIC};
use super::{StoreError, beside, fingerprint};
use std::fs::{self, File};
use std::io::{self, BufReader, BufWriter, Read, Seek, SeekFrom, Take, Write};
use std::path::Path;

/// Bytes of a text at most.
const MOST_TEXT: u64 = 1 << 32;

/// A checkpoint that is whole.
#[derive(Debug)]
pub struct OpenedLong {
    /// The job.
    pub job: String,
    /// What is to be done with the answer.
    pub request: String,
    /// The bytes of the count.
    pub content: BufReader<Take<File>>,
    /// What is wrong with the newest, when this one is older.
    pub fault: Option<StoreError>,
}

/// What goes through is hashed.
struct Hashed<W> {
    out: W,
    hash: blake3::Hasher,
    length: u64,
}

impl<W: Write> Write for Hashed<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.out.write(bytes)?;
        self.hash.update(&bytes[..written]);
        self.length += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

/// Writes a checkpoint, `length` bytes of which are what `content` writes; the one before it is kept.
///
/// # Errors
/// When it cannot be written; the newest one is then that before it.
pub fn write_long(
    file: &Path,
    (job, request): (&str, &str),
    length: u64,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), StoreError> {
    let part = beside(file, ".part");
    let payload = 16 + (job.len() + request.len()) as u64 + length;
    let write = || {
        let out = BufWriter::new(File::create(&part)?);
        let mut out = Hashed { out, hash: blake3::Hasher::new(), length: 0 };
        out.write_all(&frame::head(FrameKind::Long, &fingerprint(job), payload))?;
        for text in [job, request] {
            out.write_all(&(text.len() as u64).to_le_bytes())?;
            out.write_all(text.as_bytes())?;
        }
        content(&mut out)?;
        if out.length != HEAD as u64 + payload {
            return Err(io::Error::other("its length was told wrong"));
        }
        let Hashed { mut out, hash, .. } = out;
        out.write_all(hash.finalize().as_bytes())?;
        out.into_inner().map_err(io::IntoInnerError::into_error)?.sync_all()?;
        take_place(file, &part)
    };
    write().map_err(|error| {
        // Room for the next attempt.
        let _ = fs::remove_file(&part);
        StoreError::Unwritable { file: file.into(), message: error.to_string() }
    })
}

/// Whether a file, or the one before it, begins like such a checkpoint.
pub fn holds_long(file: &Path) -> bool {
    let begins = |file: &Path| {
        let mut head = [0; 12];
        let read = File::open(file).and_then(|mut file| file.read_exact(&mut head));
        read.is_ok()
            && head.starts_with(MAGIC)
            && head[10..] == (FrameKind::Long as u16).to_le_bytes()
    };
    begins(file) || begins(&previous(file))
}

/// Reads the newest checkpoint that is whole, up to the bytes of the count.
///
/// # Errors
/// When there is none: what is wrong with the newest.
pub fn read_long(file: &Path) -> Result<OpenedLong, StoreError> {
    let fault = match read_one(file) {
        Ok(opened) => return Ok(opened),
        Err(fault @ (StoreError::Missing { .. } | StoreError::Content { .. })) => fault,
        Err(error) => return Err(error),
    };
    match read_one(&previous(file)) {
        Ok(opened) => Ok(OpenedLong { fault: Some(fault), ..opened }),
        Err(_) => Err(fault),
    }
}

fn read_one(file: &Path) -> Result<OpenedLong, StoreError> {
    let unreadable = |source: io::Error| match source.kind() {
        io::ErrorKind::NotFound => StoreError::Missing { file: file.into() },
        io::ErrorKind::IsADirectory => StoreError::Directory { file: file.into() },
        _ => StoreError::Unreadable { file: file.into(), source },
    };
    let wrong = |message: String| StoreError::Content { file: file.into(), message };
    let mut input = File::open(file).map_err(unreadable)?;
    let bytes = input.metadata().map_err(unreadable)?.len();
    let short = || wrong(format!("is cut short: {bytes} bytes are not even a frame"));
    let content = bytes.checked_sub(HASH as u64).filter(|&n| n >= HEAD as u64).ok_or_else(short)?;
    // The checksum, and the head.
    let mut head = Vec::new();
    let mut hash = blake3::Hasher::new();
    let mut buffer = vec![0; 1 << 20];
    let mut all = (&mut input).take(content);
    loop {
        let read = all.read(&mut buffer).map_err(unreadable)?;
        if read == 0 {
            break;
        }
        if head.len() < HEAD {
            head.extend_from_slice(&buffer[..read.min(HEAD - head.len())]);
        }
        hash.update(&buffer[..read]);
    }
    let mut expected = [0; HASH];
    input.read_exact(&mut expected).map_err(unreadable)?;
    if !head.starts_with(MAGIC) {
        return Err(wrong("is not a checkpoint: expected a file that begins with TILEPACK".into()));
    }
    if *hash.finalize().as_bytes() != expected {
        return Err(wrong(
            "is cut short or damaged: its checksum does not match its content".into(),
        ));
    }
    let version = u64::from(u16::from_le_bytes([head[8], head[9]]));
    if version > u64::from(frame::VERSION) {
        return Err(StoreError::Newer { file: file.into(), version, known: frame::VERSION });
    }
    if head[10..12] != (FrameKind::Long as u16).to_le_bytes() {
        return Err(wrong("is the checkpoint of another kind of search".into()));
    }
    // Then what it holds.
    input.seek(SeekFrom::Start(HEAD as u64)).map_err(unreadable)?;
    let mut content = BufReader::new(input.take(content - HEAD as u64));
    let mut text = || {
        let mut length = [0; 8];
        content.read_exact(&mut length).map_err(unreadable)?;
        let length = u64::from_le_bytes(length);
        let mut text = String::new();
        let read = (&mut content).take(length.min(MOST_TEXT)).read_to_string(&mut text);
        match read.map_err(unreadable)? as u64 == length {
            true => Ok(text),
            false => Err(wrong("is not what a checkpoint holds".into())),
        }
    };
    let (job, request) = (text()?, text()?);
    if head[20..HEAD] != fingerprint(&job) {
        return Err(wrong("its fingerprint is that of another search".into()));
    }
    Ok(OpenedLong { job, request, content, fault: None })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_flipped_bit_is_found_and_the_one_before_is_read() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("long.checkpoint");
        let write = |content: &[u8]| {
            write_long(&file, ("a job", "json"), content.len() as u64, |out| out.write_all(content))
        };
        let read = || {
            let mut opened = read_long(&file).unwrap();
            let mut content = Vec::new();
            opened.content.read_to_end(&mut content).unwrap();
            assert_eq!((&opened.job[..], &opened.request[..]), ("a job", "json"));
            (content, opened.fault.map(|fault| fault.to_string()))
        };
        assert!(matches!(read_long(&file), Err(StoreError::Missing { .. })));
        write(b"first").unwrap();
        assert_eq!(read(), (b"first".to_vec(), None));
        write(b"second").unwrap();
        assert_eq!(read(), (b"second".to_vec(), None));
        assert!(holds_long(&file));
        let whole = fs::read(&file).unwrap();
        for bit in 0..8 * whole.len() {
            let mut bytes = whole.clone();
            bytes[bit / 8] ^= 1 << (bit % 8);
            fs::write(&file, bytes).unwrap();
            let (content, fault) = read();
            assert_eq!(content, b"first");
            assert!(fault.unwrap().starts_with(&file.display().to_string()));
        }
        fs::write(&file, &whole[..whole.len() - 1]).unwrap();
        assert!(read().1.unwrap().contains("cut short"));
        fs::remove_file(previous(&file)).unwrap();
        assert!(read_long(&file).is_err());
        let wrong = write_long(&file, ("a", "b"), 3, |out| out.write_all(b"four"));
        assert!(wrong.is_err() && fs::read(&file).unwrap() == whole[..whole.len() - 1]);
    }
}

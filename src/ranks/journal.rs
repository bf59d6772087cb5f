//! What was made of a run so far, in files: a run that was killed goes on from there, on any number of ranks.
//!
//! The shared parts of a run follow each other in the same order every time ([`super`]). A journal numbers them, and keeps each
//! piece under the number of its part and its own. Each rank writes a file of its own; a run that goes on reads the files of all.
//! A file is a header and records, in little-endian numbers:
//!
//! ```text
//! header   8 bytes, 8 bytes of the fingerprint of the run
//! record   4 bytes length, 8 bytes part, 8 bytes pieces of the part, 8 bytes piece, the bytes of the piece, 4 bytes CRC-32
//! ```
//!
//! The last record of a rank that was killed may be torn: it fails its check, and its piece is made again.

use std::collections::HashMap;
use std::fmt;
use std::fmt::{Debug, Write as _};
use std::fs;
use std::fs::{File, OpenOptions};
use std::hash::{DefaultHasher, Hasher};
use std::io;
use std::io::{BufReader, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use flate2::Crc;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::ranks::bytes::{decoded, encoded};

/// What a file begins with; its last digit is the version of the format.
const MAGIC: &[u8; 8] = b"RADJRNL1";

/// The ending of the files.
const ENDING: &str = "journal";

/// Time after which records are handed to the system. Chosen: what a killed rank has to make again.
const PAUSE: Duration = Duration::from_secs(5);

/// A number that tells a run from others: of its scene and options, as they print for programmers, and of the version.
pub fn fingerprint(run: &dyn Debug) -> u64 {
    let mut hashed = Hashed(DefaultHasher::new());
    write!(hashed, "{} {run:?}", env!("CARGO_PKG_VERSION")).expect("a hash takes all text");
    hashed.0.finish()
}

/// Text that is not kept.
struct Hashed(DefaultHasher);

impl fmt::Write for Hashed {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.write(text.as_bytes());
        Ok(())
    }
}

/// Why a journal cannot be kept.
#[derive(Debug, thiserror::Error)]
pub enum JournalError {
    /// The folder or a file of it cannot be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The folder or the file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// It holds a journal, and nothing says that the run goes on from it.
    #[error("{}: a run was recorded here", path.display())]
    Used {
        /// The folder.
        path: PathBuf,
    },
    /// It holds no journal.
    #[error("{}: no run was recorded here", path.display())]
    Empty {
        /// The folder.
        path: PathBuf,
    },
    /// It holds the journal of another run.
    #[error("{}: this records a run of another scene, or with other options, or of another version", path.display())]
    Other {
        /// A file of it.
        path: PathBuf,
    },
}

impl JournalError {
    /// How to mend it.
    pub fn cure(&self) -> &'static str {
        match self {
            Self::File { .. } => "choose a folder that exists or can be made, and that can be written to",
            Self::Used { .. } => "add --resume to go on from there, or choose another folder",
            Self::Empty { .. } => "leave --resume out to begin, or give the folder of the run that was ended",
            Self::Other { .. } => "give the scene and the options of that run, or choose another folder",
        }
    }

    fn of(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::File { path, source }
    }
}

/// Where pieces of work are kept.
#[derive(Debug)]
pub struct Journal {
    known: HashMap<Key, Place>,
    files: Vec<Mutex<File>>,
    parts: AtomicU64,
    recalled: AtomicU64,
    writer: Mutex<Writer>,
}

/// A piece of a part of the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Key {
    part: u64,
    pieces: u64,
    piece: u64,
}

/// Where the bytes of a piece stand.
#[derive(Clone, Copy, Debug)]
struct Place {
    file: usize,
    start: u64,
    length: u32,
}

#[derive(Debug)]
struct Writer {
    file: BufWriter<File>,
    flushed: Instant,
    /// Why records are missing, if some are.
    failed: Option<String>,
}

/// Whether a run begins or goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Begin {
    /// In a folder without a journal.
    Anew,
    /// From the journal that the folder holds.
    Resume,
}

impl Journal {
    /// The journal in `folder` of the run with this fingerprint, of the rank with this number; `meet` returns when all ranks have
    /// called it.
    ///
    /// # Errors
    /// A folder that cannot be written, or that holds what `begin` does not say; all ranks get the error of the first.
    pub fn open(
        folder: &Path,
        fingerprint: u64,
        begin: Begin,
        (rank, meet): (usize, &dyn Fn()),
    ) -> Result<Self, JournalError> {
        let old = files(folder, begin)?;
        meet();
        let mut known = HashMap::new();
        let mut readers = Vec::new();
        for (number, path) in old.iter().enumerate() {
            let file = File::open(path).map_err(JournalError::of(path))?;
            read(&file, number, fingerprint, &mut known)
                .map_err(JournalError::of(path))?
                .ok_or_else(|| JournalError::Other { path: path.clone() })?;
            readers.push(Mutex::new(file));
        }
        let path = folder.join(format!("{:06}-{:06}.{ENDING}", old.len(), rank));
        let writer = Writer::new(&path, fingerprint).map_err(JournalError::of(&path))?;
        let (parts, recalled) = (AtomicU64::new(0), AtomicU64::new(0));
        Ok(Self { known, files: readers, parts, recalled, writer: Mutex::new(writer) })
    }

    /// The next part of the run, of so many pieces.
    pub(super) fn part(&self, pieces: usize) -> RecordedPart<'_> {
        let part = self.parts.fetch_add(1, Ordering::Relaxed);
        RecordedPart { journal: self, part, pieces: pieces as u64 }
    }

    /// Number of pieces that this rank did not make again.
    pub fn recalled(&self) -> u64 {
        self.recalled.load(Ordering::Relaxed)
    }

    /// Hands all records to the system; why some are missing, if they are.
    pub fn flush(&self) -> Option<String> {
        let mut writer = self.writer.lock().expect("no writer panics");
        writer.flush();
        writer.failed.clone()
    }

    /// The bytes of a piece, if they are known.
    fn recall(&self, key: &Key) -> Option<Vec<u8>> {
        let Place { file, start, length } = *self.known.get(key)?;
        let mut file = self.files[file].lock().expect("no reader panics");
        let mut bytes = vec![0; length as usize];
        file.seek(SeekFrom::Start(start)).and_then(|_| file.read_exact(&mut bytes)).ok()?;
        Some(bytes)
    }
}

/// A part of the run.
#[derive(Debug)]
pub(super) struct RecordedPart<'a> {
    journal: &'a Journal,
    part: u64,
    pieces: u64,
}

impl RecordedPart<'_> {
    /// A piece of it: as it was made before, or as `make` makes it.
    pub(super) fn known_or<T: Serialize + DeserializeOwned>(
        &self,
        piece: usize,
        make: impl Fn(usize) -> T,
    ) -> T {
        let key = Key { part: self.part, pieces: self.pieces, piece: piece as u64 };
        if let Some(bytes) = self.journal.recall(&key) {
            self.journal.recalled.fetch_add(1, Ordering::Relaxed);
            return decoded(&bytes);
        }
        let made = make(piece);
        let bytes = encoded(&made);
        self.journal.writer.lock().expect("no writer panics").write(&key, &bytes);
        made
    }
}

impl Drop for RecordedPart<'_> {
    fn drop(&mut self) {
        self.journal.flush();
    }
}

impl Writer {
    fn new(path: &Path, fingerprint: u64) -> io::Result<Self> {
        let mut file = BufWriter::new(OpenOptions::new().write(true).create_new(true).open(path)?);
        file.write_all(MAGIC)?;
        file.write_all(&fingerprint.to_le_bytes())?;
        file.flush()?;
        Ok(Self { file, flushed: Instant::now(), failed: None })
    }

    /// Appends a record; where that fails, none is written any more.
    fn write(&mut self, key: &Key, bytes: &[u8]) {
        if self.failed.is_some() {
            return;
        }
        let written = self.append(key, bytes);
        self.failed = written.err().map(|error| error.to_string());
        if self.flushed.elapsed() >= PAUSE {
            self.flush();
        }
    }

    fn append(&mut self, key: &Key, bytes: &[u8]) -> io::Result<()> {
        let length = u32::try_from(bytes.len()).map_err(|_| io::Error::other("a piece of more than 4 GB"))?;
        let mut record = Vec::with_capacity(bytes.len() + 32);
        record.extend(length.to_le_bytes());
        [key.part, key.pieces, key.piece].iter().for_each(|number| record.extend(number.to_le_bytes()));
        record.extend(bytes);
        record.extend(sum(&record).to_le_bytes());
        self.file.write_all(&record)
    }

    fn flush(&mut self) {
        if self.failed.is_none() {
            self.failed = self.file.flush().err().map(|error| error.to_string());
        }
        self.flushed = Instant::now();
    }
}

/// The check of a record.
fn sum(bytes: &[u8]) -> u32 {
    let mut crc = Crc::new();
    crc.update(bytes);
    crc.sum()
}

/// The files of the journal in `folder`, in order; makes the folder.
fn files(folder: &Path, begin: Begin) -> Result<Vec<PathBuf>, JournalError> {
    fs::create_dir_all(folder).map_err(JournalError::of(folder))?;
    let entries = fs::read_dir(folder).map_err(JournalError::of(folder))?;
    let paths = entries.map(|entry| entry.map(|entry| entry.path())).collect::<io::Result<Vec<_>>>();
    let mut paths = paths.map_err(JournalError::of(folder))?;
    paths.retain(|path| path.extension().is_some_and(|ending| ending == ENDING));
    paths.sort();
    match begin {
        Begin::Anew if !paths.is_empty() => Err(JournalError::Used { path: folder.to_owned() }),
        Begin::Resume if paths.is_empty() => Err(JournalError::Empty { path: folder.to_owned() }),
        Begin::Anew | Begin::Resume => Ok(paths),
    }
}

/// Takes note of the records of a file, up to the first that is torn; none where it is of another run.
fn read(
    file: &File,
    number: usize,
    fingerprint: u64,
    known: &mut HashMap<Key, Place>,
) -> io::Result<Option<()>> {
    let mut reader = BufReader::new(file);
    let mut header = [0; 16];
    if reader.read_exact(&mut header).is_err()
        || header[..8] != *MAGIC
        || header[8..] != fingerprint.to_le_bytes()
    {
        return Ok(None);
    }
    let mut start = header.len() as u64;
    while let Some((key, length)) = record(&mut reader)? {
        start += HEAD as u64;
        known.insert(key, Place { file: number, start, length });
        start += u64::from(length) + 4;
    }
    Ok(Some(()))
}

/// Bytes of a record before those of the piece.
const HEAD: usize = 28;

/// The next record; none at the end, or where it is torn.
fn record(reader: &mut impl Read) -> io::Result<Option<(Key, u32)>> {
    let mut head = [0; HEAD];
    if reader.read_exact(&mut head).is_err() {
        return Ok(None);
    }
    let number = |start: usize| u64::from_le_bytes(head[start..start + 8].try_into().expect("eight bytes"));
    let length = u32::from_le_bytes(head[..4].try_into().expect("four bytes"));
    let mut bytes = Vec::new();
    let whole = u64::from(length) + 4;
    if reader.by_ref().take(whole).read_to_end(&mut bytes)? as u64 != whole {
        return Ok(None);
    }
    let (piece, check) = bytes.split_at(length as usize);
    let is_whole = sum(&[&head[..], piece].concat()).to_le_bytes() == *check;
    Ok(is_whole.then(|| (Key { part: number(4), pieces: number(12), piece: number(20) }, length)))
}

//! The file of a journal that one rank writes.

use std::fs;
use std::fs::{File, OpenOptions};
use std::io;
use std::io::{BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::header::header;
use super::held_file::HeldFile;
use super::record::{Key, record};

/// Work of threads that a killed rank may lose because it was not handed to the system yet. Chosen.
const AT_STAKE: Duration = Duration::from_secs(1);

/// Bytes that are handed to the system together. Chosen.
const TOGETHER: usize = 1 << 16;

/// The file that this rank writes; a new one goes away where nothing was written into it.
#[derive(Debug)]
pub(super) struct Writer {
    path: PathBuf,
    is_new: bool,
    file: BufWriter<File>,
    /// Time that the pieces took that were not handed to the system yet.
    at_stake: Duration,
    written: Written,
}

/// Numbers of pieces and bytes that were written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Written {
    pub(super) pieces: u64,
    pub(super) bytes: u64,
    /// Reason why pieces are missing, if some are.
    pub(super) failed: Option<String>,
}

impl Writer {
    /// A new file.
    ///
    /// # Errors
    /// One that is there already, or cannot be written.
    pub(super) fn new(path: &Path, fingerprint: u64) -> io::Result<Self> {
        let file = OpenOptions::new().write(true).create_new(true).open(path)?;
        Self::to(file, path, true).beginning(fingerprint)
    }

    /// The file that is `held`, behind its first `end` bytes, which are whole; 0 where it holds nothing yet.
    ///
    /// # Errors
    /// One that cannot be written.
    pub(super) fn behind(end: u64, held: HeldFile, fingerprint: u64) -> io::Result<Self> {
        let HeldFile { mut file, path, is_new } = held;
        let path = path.as_path();
        if end > 0 {
            file.set_len(end)?;
            file.seek(SeekFrom::Start(end))?;
            return Ok(Self::to(file, path, is_new));
        }
        file.set_len(0)?;
        Self::to(file, path, is_new).beginning(fingerprint)
    }

    /// The writer behind its header.
    fn beginning(mut self, fingerprint: u64) -> io::Result<Self> {
        self.file.write_all(&header(fingerprint))?;
        self.file.flush()?;
        Ok(self)
    }

    fn to(file: File, path: &Path, is_new: bool) -> Self {
        let file = BufWriter::with_capacity(TOGETHER, file);
        let (path, written) = (path.to_owned(), Written::default());
        Self { path, is_new, file, at_stake: Duration::ZERO, written }
    }

    /// Appends a piece that took so long; where that fails, no further one is written.
    pub(super) fn write(&mut self, key: &Key, piece: &[u8], took: Duration) {
        if self.written.failed.is_some() {
            return;
        }
        match record(key, piece).and_then(|record| self.file.write_all(&record).map(|()| record.len())) {
            Ok(bytes) => {
                self.written.pieces += 1;
                self.written.bytes += bytes as u64;
            }
            Err(error) => self.written.failed = Some(error.to_string()),
        }
        self.at_stake += took;
        if self.at_stake >= AT_STAKE {
            self.flush();
        }
    }

    /// Hands all to the system.
    pub(super) fn flush(&mut self) {
        if self.written.failed.is_none() {
            self.written.failed = self.file.flush().err().map(|error| error.to_string());
        }
        self.at_stake = Duration::ZERO;
    }

    /// Numbers of pieces and bytes that were written so far.
    pub(super) fn written(&self) -> &Written {
        &self.written
    }
}

impl Drop for Writer {
    fn drop(&mut self) {
        if self.is_new && self.written.pieces == 0 {
            // A file that stays holds nothing that would be missed.
            drop(fs::remove_file(&self.path));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(target_os = "linux")]
    fn a_full_disk_is_told_and_work_goes_on() {
        let full = OpenOptions::new().write(true).open("/dev/full").expect("Linux has it");
        let mut writer = Writer::to(full, Path::new("nowhere/full.journal"), true);
        let key = Key { part: 1, piece: 0 };
        writer.write(&key, b"of work", Duration::ZERO);
        assert_eq!(writer.written().failed, None, "nothing was handed to the system");
        writer.write(&key, b"of work", AT_STAKE);
        assert!(writer.written().failed.as_ref().is_some_and(|why| why.contains("space")), "{writer:?}");
        writer.write(&key, b"of work", AT_STAKE);
        assert_eq!(writer.written().pieces, 2, "the third was not tried");
    }

    #[test]
    fn a_file_without_pieces_goes_away() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.journal");
        let writer = Writer::new(&path, 1).expect("it can be written");
        assert_eq!(fs::read(&path).expect("it is there"), header(1));
        drop(writer);
        assert!(!path.exists());
    }
}

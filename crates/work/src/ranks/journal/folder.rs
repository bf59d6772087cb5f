//! The folder of a journal.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::begin::Begin;
use super::error::JournalError;
use super::writer::Writer;

/// The ending of the files.
const ENDING: &str = "journal";

/// The folder of a journal; where it was made for it, it goes away if it is left empty.
#[derive(Debug)]
pub(super) struct Folder {
    path: PathBuf,
    /// Whether any rank has made it.
    pub(super) is_made: bool,
}

impl Folder {
    /// The folder at `path`, which is made if need be.
    ///
    /// # Errors
    /// One that cannot be made, or something else in its place.
    pub(super) fn open(path: &Path) -> Result<Self, JournalError> {
        let is_made = !path.exists();
        if !is_made && !path.is_dir() {
            let source = io::Error::new(io::ErrorKind::NotADirectory, "this is no folder");
            return Err(JournalError::of(path)(source));
        }
        fs::create_dir_all(path).map_err(JournalError::of(path))?;
        Ok(Self { path: path.to_owned(), is_made })
    }

    /// The files of the journal, in the order in which they were begun.
    ///
    /// # Errors
    /// A folder that cannot be read; one with files, where a run is to begin anew.
    pub(super) fn files(&self, begin: Begin) -> Result<Vec<PathBuf>, JournalError> {
        let entries = fs::read_dir(&self.path).map_err(JournalError::of(&self.path))?;
        let paths = entries.map(|entry| entry.map(|entry| entry.path())).collect::<io::Result<Vec<_>>>();
        let mut paths = paths.map_err(JournalError::of(&self.path))?;
        paths.retain(|path| path.extension().is_some_and(|ending| ending == ENDING));
        paths.sort();
        match begin {
            Begin::Anew if !paths.is_empty() => Err(JournalError::Used { path: self.path.clone() }),
            Begin::Anew | Begin::Resume => Ok(paths),
        }
    }

    /// The file of a rank, in a run after those of the `old` files.
    ///
    /// # Errors
    /// One that cannot be written; [`JournalError::Used`] where another run has begun here in the meantime.
    pub(super) fn begin(
        &self,
        old: &[PathBuf],
        rank: usize,
        fingerprint: u64,
    ) -> Result<Writer, JournalError> {
        let run = old.iter().filter_map(|path| number(path)).max().map_or(0, |last| last + 1);
        let path = self.path.join(format!("{run:06}-{rank:06}.{ENDING}"));
        Writer::new(&path, fingerprint).map_err(|error| match error.kind() {
            io::ErrorKind::AlreadyExists => JournalError::Used { path: self.path.clone() },
            _ => JournalError::of(&path)(error),
        })
    }
}

/// The number of the run that wrote a file.
fn number(path: &Path) -> Option<u64> {
    path.file_stem()?.to_str()?.split_once('-')?.0.parse().ok()
}

impl Drop for Folder {
    fn drop(&mut self) {
        if self.is_made {
            // It stays where it is not empty.
            drop(fs::remove_dir(&self.path));
        }
    }
}

//! A file that one run alone writes.

use std::fs::{File, OpenOptions, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use super::error::JournalError;

/// A file that no other run writes as long as it is open.
#[derive(Debug)]
pub(super) struct HeldFile {
    pub(super) file: File,
    pub(super) path: PathBuf,
    /// Whether it was made now.
    pub(super) is_new: bool,
}

impl HeldFile {
    /// The file at `path`, which is made if need be. Locks of Windows keep its own run from reading it, and some file
    /// systems have none: these are not taken.
    ///
    /// # Errors
    /// One that cannot be written, or that another run holds.
    pub(super) fn open(path: &Path) -> Result<Self, JournalError> {
        let is_new = !path.exists();
        let file = OpenOptions::new().write(true).create(true).truncate(false).open(path);
        let file = file.map_err(JournalError::of_transfers(path))?;
        if cfg!(not(windows)) {
            match file.try_lock() {
                Err(TryLockError::WouldBlock) => return Err(JournalError::Held { path: path.to_owned() }),
                Err(TryLockError::Error(error)) if error.kind() != io::ErrorKind::Unsupported => {
                    return Err(JournalError::of_transfers(path)(error));
                }
                Err(TryLockError::Error(_)) | Ok(()) => {}
            }
        }
        Ok(Self { file, path: path.to_owned(), is_new })
    }
}

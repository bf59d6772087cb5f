//! The journal of a run, in files: a run that was killed goes on from there, on any number of ranks.
//!
//! The shared parts of a run follow each other in the same order every time ([`super`]). A journal keeps each
//! piece under its own number and that of its part, which hangs on all that went before: names and numbers of
//! pieces of earlier parts, and what was chosen ([`Ranks::note_choice`](super::Ranks::note_choice)). A run
//! that took another way, because its time was up or it had less memory, therefore finds no foreign pieces.
//!
//! Each rank writes a file of its own, `RUN-RANK.journal`; a run that goes on reads the files of all. A file
//! is a header and records:
//!
//! ```text
//! header   8 bytes, 4 bytes of the version of pieces, 8 bytes of the fingerprint of the run
//! ```
//!
//! The last record of a rank that was killed may be torn: it fails its check, and its piece is made again.
//!
//! A file of transfers is such a file, of one rank alone, which other runs read and add to. It keeps those parts only
//! that follow from the surfaces and from what an assembly depends on besides
//! ([`Ranks::note_assembly`](super::Ranks::note_assembly)), and their numbers hang on nothing else.

mod begin;
mod error;
mod fingerprint;
mod record;
mod header;
mod held_file;
mod writer;
mod stored_pieces;
mod folder;

use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard};
use std::time::Instant;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::ranks::bytes::{encoded, strictly_decoded};
use crate::ranks::part_name::PartName;
pub use begin::Begin;
pub use error::JournalError;
use fingerprint::digest;
pub use fingerprint::fingerprint;
use folder::Folder;
use header::{HEADER, Owner};
use held_file::HeldFile;
use record::Key;
use stored_pieces::StoredPieces;
use writer::Writer;

/// Pieces that a rank has recalled and recorded so far.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Tally {
    /// Whether transfers alone are kept.
    pub are_transfers: bool,
    /// Number of pieces that the rank did not make again.
    pub recalled: u64,
    /// Number of pieces that the rank made and wrote.
    pub recorded: u64,
    /// Bytes of the pieces that it wrote.
    pub bytes: u64,
    /// Why further ones are missing, if they are.
    pub failed: Option<String>,
}

/// Where the pieces of a run are kept.
#[derive(Debug)]
pub struct Journal {
    stored_pieces: StoredPieces,
    recalled: AtomicU64,
    /// The number of the last part, and of what was chosen since.
    last_number: Mutex<u64>,
    writer: Mutex<Writer>,
    /// The fingerprint of the surfaces, where their transfers alone are kept.
    surfaces: Option<u64>,
    /// The last to be dropped: it goes away where it is empty.
    _folder: Option<Folder>,
}

impl Journal {
    /// The journal in `folder` of the run with this fingerprint, of the rank with this number; `any` tells,
    /// once all ranks have called it, whether any of them said yes.
    ///
    /// # Errors
    /// A folder that cannot be written; one that holds a journal where a run is to begin anew, or that of another run.
    pub(super) fn open(
        folder: &Path,
        fingerprint: u64,
        begin: Begin,
        rank: usize,
        any: &dyn Fn(bool) -> bool,
    ) -> Result<Self, JournalError> {
        let mut folder = Folder::open(folder)?;
        let old = folder.files(begin)?;
        let mut stored_pieces = StoredPieces::default();
        for path in &old {
            match stored_pieces.add(path, fingerprint).map_err(JournalError::of(path))? {
                Owner::Own | Owner::Begun => {}
                Owner::Earlier => return Err(JournalError::Earlier { path: path.clone() }),
                Owner::Other => return Err(JournalError::Other { path: path.clone() }),
            }
        }
        // No rank makes its file before all have seen which there are.
        folder.is_made = any(folder.is_made);
        let writer = folder.begin(&old, rank, fingerprint)?;
        // Nor does any leave, and take away an empty folder, before all have made theirs.
        any(false);
        Ok(Self {
            stored_pieces,
            recalled: AtomicU64::new(0),
            last_number: Mutex::new(fingerprint),
            writer: Mutex::new(writer),
            surfaces: None,
            _folder: Some(folder),
        })
    }

    /// The transfers between the surfaces of this fingerprint that the file at `path` keeps, to be added to.
    ///
    /// # Errors
    /// One that cannot be read and written, or that holds something else.
    pub(super) fn of_transfers(path: &Path, surfaces: u64) -> Result<Self, JournalError> {
        let held = HeldFile::open(path)?;
        let mut stored_pieces = StoredPieces::default();
        let owner = stored_pieces.add(path, surfaces).map_err(JournalError::of_transfers(path))?;
        let size = held.file.metadata().map_err(JournalError::of_transfers(path))?.len();
        match owner {
            Owner::Own => {}
            Owner::Begun if size <= HEADER as u64 => {}
            Owner::Earlier => return Err(JournalError::EarlierTransfers { path: path.to_owned() }),
            // Zeros that go on are of somebody else.
            Owner::Begun | Owner::Other => return Err(JournalError::OtherGeometry { path: path.to_owned() }),
        }
        let writer = Writer::behind(stored_pieces.end(), held, surfaces);
        Ok(Self {
            stored_pieces,
            recalled: AtomicU64::new(0),
            last_number: Mutex::new(surfaces),
            writer: Mutex::new(writer.map_err(JournalError::of_transfers(path))?),
            surfaces: Some(surfaces),
            _folder: None,
        })
    }

    /// Whether it keeps transfers alone.
    pub(super) fn is_of_transfers(&self) -> bool {
        self.surfaces.is_some()
    }

    /// The next part of the run, of so many pieces; None where it keeps no such part.
    pub(super) fn part(&self, name: PartName, pieces: usize) -> Option<RecordedPart<'_>> {
        if self.is_of_transfers() && !name.is_of_transfers() {
            return None;
        }
        let mut last_number = self.last_number.lock().expect("nobody panics on the way");
        *last_number = digest(&(*last_number, name, pieces));
        Some(RecordedPart { journal: self, number: *last_number })
    }

    /// Takes note of a choice, for the numbers of all later parts
    /// ([`Ranks::note_choice`](super::Ranks::note_choice)).
    pub(super) fn note_choice(&self, choice: &dyn std::fmt::Debug) {
        let mut last_number = self.last_number.lock().expect("nobody panics on the way");
        *last_number = digest(&(*last_number, choice));
    }

    /// Takes note of all that the parts of an assembly follow from
    /// ([`Ranks::note_assembly`](super::Ranks::note_assembly)).
    pub(super) fn note_assembly(&self, assembly: &dyn std::fmt::Debug) {
        if let Some(surfaces) = self.surfaces {
            *self.last_number.lock().expect("nobody panics on the way") = surfaces;
        }
        self.note_choice(assembly);
    }

    /// Pieces that this rank has recalled and recorded so far; all of it is handed to the system.
    pub fn tally(&self) -> Tally {
        let mut writer = self.writer();
        writer.flush();
        let written = writer.written();
        Tally {
            are_transfers: self.is_of_transfers(),
            recalled: self.recalled.load(Ordering::Relaxed),
            recorded: written.pieces,
            bytes: written.bytes,
            failed: written.failed.clone(),
        }
    }

    fn writer(&self) -> MutexGuard<'_, Writer> {
        self.writer.lock().expect("no writer panics")
    }
}

/// A part of the run.
#[derive(Debug)]
pub(super) struct RecordedPart<'a> {
    journal: &'a Journal,
    number: u64,
}

impl RecordedPart<'_> {
    /// A piece of it: as it was made before, or as `make` makes it.
    pub(super) fn known_or<T: Serialize + DeserializeOwned>(
        &self,
        piece: usize,
        make: impl Fn(usize) -> T,
    ) -> T {
        let key = Key { part: self.number, piece: piece as u32 };
        let known = self.journal.stored_pieces.get(&key);
        if let Some(known) = known.and_then(|bytes| strictly_decoded(&bytes)) {
            self.journal.recalled.fetch_add(1, Ordering::Relaxed);
            return known;
        }
        let start = Instant::now();
        let made = make(piece);
        let (bytes, took) = (encoded(&made), start.elapsed());
        self.journal.writer().write(&key, &bytes, took);
        made
    }
}

impl Drop for RecordedPart<'_> {
    fn drop(&mut self) {
        self.journal.writer().flush();
    }
}

//! The pieces that the files of a journal hold.

use std::collections::HashMap;
use std::fs::File;
use std::io;
use std::io::{BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use super::error::JournalError;
use super::header::{HEADER, Owner, owner};
use super::record::{CHECK, HEAD, Key, next_head, piece};

/// Files that stay open; others are opened for each piece. Chosen: systems commonly allow 1024.
const OPEN: usize = 256;

/// The pieces that the files of a journal hold: some fifty bytes of memory each.
#[derive(Debug, Default)]
pub(super) struct StoredPieces {
    files: Vec<StoredFile>,
    places: HashMap<Key, RecordPlace>,
}

/// A file of a journal.
#[derive(Debug)]
struct StoredFile {
    path: PathBuf,
    open: Option<Mutex<File>>,
}

/// Where a record stands.
#[derive(Clone, Copy, Debug)]
struct RecordPlace {
    start: u64,
    length: u32,
    file: u32,
}

impl StoredPieces {
    /// Takes note of what a file holds; how it was made says `fingerprint`. A piece is checked when it is
    /// wanted.
    ///
    /// # Errors
    /// One that cannot be read, or is of another run or of an earlier version of the program.
    pub(super) fn add(&mut self, path: &Path, fingerprint: u64) -> Result<(), JournalError> {
        let file = File::open(path).map_err(JournalError::of(path))?;
        let number = self.files.len() as u32;
        let mut reader = BufReader::new(&file);
        match begun(&mut reader, fingerprint).map_err(JournalError::of(path))? {
            Owner::Own => {
                let size = file.metadata().map_err(JournalError::of(path))?.len();
                self.places.extend(records(reader, size, number).map_err(JournalError::of(path))?);
            }
            Owner::Begun => {}
            Owner::Earlier => return Err(JournalError::Earlier { path: path.to_owned() }),
            Owner::Other => return Err(JournalError::Other { path: path.to_owned() }),
        }
        let open = (self.files.len() < OPEN).then(|| Mutex::new(file));
        self.files.push(StoredFile { path: path.to_owned(), open });
        Ok(())
    }

    /// The bytes of a piece, if they are known and whole.
    pub(super) fn get(&self, key: &Key) -> Option<Vec<u8>> {
        let place = self.places.get(key)?;
        let record = self.files[place.file as usize].read(place).ok()?;
        piece(key, &record).map(<[u8]>::to_vec)
    }
}

impl StoredFile {
    fn read(&self, place: &RecordPlace) -> io::Result<Vec<u8>> {
        match &self.open {
            Some(file) => read_at(&mut file.lock().expect("no reader panics"), place),
            None => read_at(&mut File::open(&self.path)?, place),
        }
    }
}

fn read_at(file: &mut File, place: &RecordPlace) -> io::Result<Vec<u8>> {
    let mut record = vec![0; place.length as usize + HEAD + CHECK];
    file.seek(SeekFrom::Start(place.start))?;
    file.read_exact(&mut record)?;
    Ok(record)
}

/// The owner of a file, by its header.
fn begun(reader: &mut impl Read, fingerprint: u64) -> io::Result<Owner> {
    let mut begins = Vec::new();
    reader.take(HEADER as u64).read_to_end(&mut begins)?;
    Ok(owner(&begins, fingerprint))
}

/// Where the records of a file of this size stand, whose header was read.
fn records(mut reader: BufReader<&File>, size: u64, file: u32) -> io::Result<HashMap<Key, RecordPlace>> {
    let mut found = HashMap::new();
    let mut start = HEADER as u64;
    while let Some((key, length)) = next_head(&mut reader) {
        let end = start + u64::from(length) + (HEAD + CHECK) as u64;
        if end > size {
            break;
        }
        found.insert(key, RecordPlace { start, length, file });
        reader.seek_relative((end - start) as i64 - HEAD as i64)?;
        start = end;
    }
    Ok(found)
}

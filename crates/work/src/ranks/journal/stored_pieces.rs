//! The pieces that the files of a journal hold.

use std::collections::HashMap;
use std::fs::File;
use std::io;
use std::io::{BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

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
    /// Takes note of what a file holds that was made with this fingerprint, and tells whose it is. A piece is checked
    /// when it is wanted.
    ///
    /// # Errors
    /// One that cannot be read.
    pub(super) fn add(&mut self, path: &Path, fingerprint: u64) -> io::Result<Owner> {
        let file = File::open(path)?;
        let mut reader = BufReader::new(&file);
        let owner = begun(&mut reader, fingerprint)?;
        if owner == Owner::Own {
            let (size, number) = (file.metadata()?.len(), self.files.len() as u32);
            self.places.extend(records(reader, size, number)?);
        }
        let open = (self.files.len() < OPEN).then(|| Mutex::new(file));
        self.files.push(StoredFile { path: path.to_owned(), open });
        Ok(owner)
    }

    /// Where the last whole record ends; 0 without one.
    pub(super) fn end(&self) -> u64 {
        self.places.values().map(RecordPlace::end).max().unwrap_or(0)
    }

    /// The bytes of a piece, if they are known and whole.
    pub(super) fn get(&self, key: &Key) -> Option<Vec<u8>> {
        let place = self.places.get(key)?;
        let record = self.files[place.file as usize].read(place).ok()?;
        piece(key, &record).map(<[u8]>::to_vec)
    }
}

impl RecordPlace {
    fn end(&self) -> u64 {
        self.start + u64::from(self.length) + (HEAD + CHECK) as u64
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
        let place = RecordPlace { start, length, file };
        let end = place.end();
        if end > size {
            break;
        }
        found.insert(key, place);
        reader.seek_relative((end - start) as i64 - HEAD as i64)?;
        start = end;
    }
    Ok(found)
}

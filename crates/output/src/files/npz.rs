//! NPZ, the archives of NumPy: arrays by name, each in [NPY](super::npy), in a ZIP file without compression.
//!
//! ```text
//! with numpy.load("F.npz") as file: file["F"], file["names"]
//! ```
//!
//! A sparse matrix has the members that `scipy.sparse.load_npz` reads: `format`, `shape` and `data`, with
//! `row` and `col`, or with `indices` and `indptr`.

use std::io::{self, Write};

use zip::write::{SimpleFileOptions, StreamWriter};
use zip::{CompressionMethod, ZipWriter};

use super::npy::{self, EntryKind};

/// An archive that is being written.
pub(crate) struct Archive<W: Write> {
    zip: ZipWriter<StreamWriter<W>>,
}

impl<W: Write> Archive<W> {
    /// An archive without arrays.
    pub(crate) fn new(out: W) -> Self {
        Self { zip: ZipWriter::new_stream(out) }
    }

    /// Adds a square matrix of `count` rows, each made when it is written.
    ///
    /// # Errors
    /// Errors of writing to the output.
    pub(crate) fn square(
        &mut self,
        name: &str,
        count: usize,
        rows: impl Iterator<Item = impl AsRef<[f64]>>,
    ) -> io::Result<()> {
        self.begin(name, EntryKind::Float64.size() * count * count)?;
        npy::square(count, rows, &mut self.zip)
    }

    /// Adds a list of `count` numbers.
    ///
    /// # Errors
    /// Errors of writing to the output.
    pub(crate) fn numbers(
        &mut self,
        name: &str,
        count: usize,
        numbers: impl Iterator<Item = f64>,
    ) -> io::Result<()> {
        self.entries(name, EntryKind::Float64, count, numbers.map(f64::to_le_bytes))
    }

    /// Adds a list of `count` indices of rows or columns, 32 bits wide.
    ///
    /// # Errors
    /// Errors of writing to the output.
    pub(super) fn indices(
        &mut self,
        name: &str,
        count: usize,
        indices: impl Iterator<Item = usize>,
    ) -> io::Result<()> {
        self.entries(name, EntryKind::Int32, count, indices.map(|index| (index as i32).to_le_bytes()))
    }

    /// Adds a list of `count` counts, 64 bits wide.
    ///
    /// # Errors
    /// Errors of writing to the output.
    pub(super) fn counts(
        &mut self,
        name: &str,
        count: usize,
        counts: impl Iterator<Item = usize>,
    ) -> io::Result<()> {
        self.entries(name, EntryKind::Int64, count, counts.map(|count| (count as i64).to_le_bytes()))
    }

    /// Adds a list of texts.
    ///
    /// # Errors
    /// Errors of writing to the output.
    pub(crate) fn texts<'a>(
        &mut self,
        name: &str,
        texts: impl ExactSizeIterator<Item = &'a str> + Clone,
    ) -> io::Result<()> {
        let longest = texts.clone().map(|text| text.chars().count()).max().unwrap_or(0).max(1);
        let (kind, count) = (EntryKind::Text(longest), texts.len());
        let code = |letter: Option<char>| letter.map_or(0, u32::from).to_le_bytes();
        let padded = |text: &'a str| {
            let letters = text.chars().map(Some).chain(std::iter::repeat(None));
            letters.take(longest).flat_map(code).collect::<Vec<u8>>()
        };
        self.entries(name, kind, count, texts.map(padded))
    }

    /// Adds a single word of ASCII letters.
    ///
    /// # Errors
    /// Errors of writing to the output.
    pub(super) fn word(&mut self, name: &str, word: &str) -> io::Result<()> {
        self.begin(name, word.len())?;
        npy::header(EntryKind::Bytes(word.len()), &[], &mut self.zip)?;
        self.zip.write_all(word.as_bytes())
    }

    /// Ends the archive.
    ///
    /// # Errors
    /// Errors of writing to the output.
    pub(crate) fn finish(self) -> io::Result<()> {
        self.zip.finish()?;
        Ok(())
    }

    fn entries(
        &mut self,
        name: &str,
        kind: EntryKind,
        count: usize,
        entries: impl Iterator<Item = impl AsRef<[u8]>>,
    ) -> io::Result<()> {
        self.begin(name, kind.size() * count)?;
        npy::header(kind, &[count], &mut self.zip)?;
        for entry in entries {
            self.zip.write_all(entry.as_ref())?;
        }
        Ok(())
    }

    /// Begins an array of so many bytes and a header.
    fn begin(&mut self, name: &str, bytes: usize) -> io::Result<()> {
        let is_large = bytes as u64 + 1024 > u64::from(u32::MAX);
        let options = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
        Ok(self.zip.start_file(format!("{name}.npy"), options.large_file(is_large))?)
    }
}

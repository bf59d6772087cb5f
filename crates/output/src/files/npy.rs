//! NPY, the format of NumPy, version 1.0.
//!
//! A magic text, the length of the header, a header in Python's notation padded to a multiple of 64 bytes,
//! then the numbers, little-endian, in C order.

use std::io::{self, Write};

/// Bytes of magic text, version and length.
const PREFIX: usize = 10;

/// The kind of an array's entries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EntryKind {
    /// f64.
    Float64,
    /// i32.
    Int32,
    /// i64.
    Int64,
    /// Texts of so many characters at the most, in UTF-32, filled up with zeros.
    Text(usize),
    /// Texts of so many bytes.
    Bytes(usize),
}

impl EntryKind {
    /// `NumPy`'s type string of the kind, such as `<f8`.
    fn word(self) -> String {
        match self {
            Self::Float64 => "<f8".to_owned(),
            Self::Int32 => "<i4".to_owned(),
            Self::Int64 => "<i8".to_owned(),
            Self::Text(longest) => format!("<U{longest}"),
            Self::Bytes(length) => format!("|S{length}"),
        }
    }

    /// Bytes of an entry.
    pub(super) fn size(self) -> usize {
        match self {
            Self::Float64 | Self::Int64 => 8,
            Self::Int32 => 4,
            Self::Text(longest) => 4 * longest,
            Self::Bytes(length) => length,
        }
    }
}

/// Writes the header of an array; its entries follow.
///
/// # Errors
/// Errors of writing to `out`.
pub(super) fn header(kind: EntryKind, shape: &[usize], mut out: impl Write) -> io::Result<()> {
    let shape: String = shape.iter().map(|count| format!("{count}, ")).collect();
    // Python writes (4, 5) and (4,).
    let shape = shape.trim_end().strip_suffix(',').map_or(String::new(), |shape| match shape.contains(',') {
        true => shape.to_owned(),
        false => format!("{shape},"),
    });
    let word = kind.word();
    let header = format!("{{'descr': '{word}', 'fortran_order': False, 'shape': ({shape}), }}");
    let length = (PREFIX + header.len() + 1).next_multiple_of(64) - PREFIX;
    out.write_all(b"\x93NUMPY\x01\x00")?;
    out.write_all(&(length as u16).to_le_bytes())?;
    writeln!(out, "{header:<width$}", width = length - 1)
}

/// Writes a square matrix of `count` rows, each made when it is written.
///
/// # Errors
/// Errors of writing to `out`.
pub(crate) fn square(
    count: usize,
    rows: impl Iterator<Item = impl AsRef<[f64]>>,
    mut out: impl Write,
) -> io::Result<()> {
    header(EntryKind::Float64, &[count, count], &mut out)?;
    for row in rows {
        for number in row.as_ref() {
            out.write_all(&number.to_le_bytes())?;
        }
    }
    Ok(())
}

//! NPY, the format of NumPy, version 1.0.
//!
//! A magic text, the length of the header, a header in Python's notation padded to a multiple of 64 bytes, then the numbers
//! as little-endian f64 in C order.

use std::io::{self, Write};

/// Bytes of magic text, version and length.
const PREFIX: usize = 10;

/// A square matrix of so many rows, each made when it is written.
///
/// # Errors
/// What `out` reports.
pub fn square(
    count: usize,
    rows: impl Iterator<Item = impl AsRef<[f64]>>,
    mut out: impl Write,
) -> io::Result<()> {
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({count}, {count}), }}");
    let length = (PREFIX + header.len() + 1).next_multiple_of(64) - PREFIX;
    out.write_all(b"\x93NUMPY\x01\x00")?;
    out.write_all(&(length as u16).to_le_bytes())?;
    writeln!(out, "{header:<width$}", width = length - 1)?;
    for row in rows {
        for number in row.as_ref() {
            out.write_all(&number.to_le_bytes())?;
        }
    }
    Ok(())
}

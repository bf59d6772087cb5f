//! The XML of VTK: arrays with their names, numbers in base64.
//!
//! Each array is one run of base64: the number of bytes as u64, then the numbers, all little-endian.

use std::io::{self, Write};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// The numbers of an array.
#[derive(Clone, Copy, Debug)]
pub(super) enum Numbers<'a> {
    Float64(&'a [f64]),
    Int64(&'a [i64]),
    UInt8(&'a [u8]),
}

impl Numbers<'_> {
    fn kind(self) -> &'static str {
        match self {
            Self::Float64(_) => "Float64",
            Self::Int64(_) => "Int64",
            Self::UInt8(_) => "UInt8",
        }
    }

    fn bytes(self) -> Vec<u8> {
        match self {
            Self::Float64(numbers) => numbers.iter().flat_map(|x| x.to_le_bytes()).collect(),
            Self::Int64(numbers) => numbers.iter().flat_map(|x| x.to_le_bytes()).collect(),
            Self::UInt8(numbers) => numbers.to_vec(),
        }
    }
}

/// A file that is being written.
pub(super) struct Document<W> {
    out: W,
}

impl<W: Write> Document<W> {
    /// Begins an unstructured grid.
    pub(super) fn begin(mut out: W) -> io::Result<Self> {
        writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
        let attributes = "version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"";
        writeln!(out, "<VTKFile type=\"UnstructuredGrid\" {attributes}>\n<UnstructuredGrid>")?;
        Ok(Self { out })
    }

    /// Ends the file.
    pub(super) fn end(mut self) -> io::Result<()> {
        writeln!(self.out, "</UnstructuredGrid>\n</VTKFile>")
    }

    /// Begins an element, named with its attributes.
    pub(super) fn open(&mut self, tag: &str) -> io::Result<()> {
        writeln!(self.out, "<{tag}>")
    }

    /// Ends an element.
    pub(super) fn close(&mut self, name: &str) -> io::Result<()> {
        writeln!(self.out, "</{name}>")
    }

    /// An array of tuples of so many `components`.
    pub(super) fn array(&mut self, name: &str, components: usize, numbers: Numbers) -> io::Result<()> {
        let bytes = numbers.bytes();
        let tuples = match numbers {
            Numbers::Float64(all) => all.len(),
            Numbers::Int64(all) => all.len(),
            Numbers::UInt8(all) => all.len(),
        } / components;
        let shape = format!("NumberOfComponents=\"{components}\" NumberOfTuples=\"{tuples}\"");
        self.data(numbers.kind(), name, &shape, &bytes)
    }

    /// An array of texts, each ended by a zero.
    pub(super) fn strings<'a>(
        &mut self,
        name: &str,
        texts: impl IntoIterator<Item = &'a str>,
    ) -> io::Result<()> {
        let (mut bytes, mut count) = (Vec::new(), 0);
        for text in texts {
            bytes.extend(text.bytes().filter(|byte| *byte != 0));
            bytes.push(0);
            count += 1;
        }
        self.data("String", name, &format!("NumberOfTuples=\"{count}\""), &bytes)
    }

    fn data(&mut self, kind: &str, name: &str, shape: &str, bytes: &[u8]) -> io::Result<()> {
        let name = escaped(name);
        write!(self.out, "<DataArray type=\"{kind}\" Name=\"{name}\" {shape} format=\"binary\">")?;
        let all = [&(bytes.len() as u64).to_le_bytes()[..], bytes].concat();
        self.out.write_all(STANDARD.encode(all).as_bytes())?;
        writeln!(self.out, "</DataArray>")
    }
}

/// A text as the value of an attribute; what XML has no characters for becomes a blank.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for letter in text.chars() {
        match letter {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            letter if letter.is_control() || matches!(letter, '\u{FFFE}' | '\u{FFFF}') => escaped.push(' '),
            letter => escaped.push(letter),
        }
    }
    escaped
}

//! The header of a PLY: how what follows is encoded, and the elements with their properties.

use radiosity_photometry::error::{Refusal, refuse, refuse_at};
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::text::short;

use crate::scalar::Scalar;

/// Encoding of the elements behind the header.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    Little,
    Big,
}

/// The type of numbers of a name.
fn scalar(name: &str) -> Result<Scalar, Refusal> {
    Ok(match name.to_ascii_lowercase().as_str() {
        "char" | "int8" => Scalar::I8,
        "uchar" | "uint8" => Scalar::U8,
        "short" | "int16" => Scalar::I16,
        "ushort" | "uint16" => Scalar::U16,
        "int" | "int32" => Scalar::I32,
        "uint" | "uint32" => Scalar::U32,
        "float" | "float32" => Scalar::F32,
        "double" | "float64" => Scalar::F64,
        _ => {
            return refuse(
                format!("'{}' is no type of numbers", short(name)),
                "write char, uchar, short, ushort, int, uint, float or double",
            );
        }
    })
}

/// A property: a number, or a list of numbers behind their count.
#[derive(Clone, Debug)]
pub(super) struct Property {
    pub(super) name: String,
    /// The type of a list's count.
    pub(super) count: Option<Scalar>,
    pub(super) item: Scalar,
}

impl Property {
    /// The fewest bytes that it takes.
    pub(super) fn least(&self) -> usize {
        self.count.unwrap_or(self.item).size()
    }
}

/// A table of elements of one kind.
#[derive(Clone, Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: usize,
    pub(super) properties: Vec<Property>,
    /// The line of the header that announces it.
    pub(super) line: usize,
}

/// A header: encoding and layout of the elements behind it.
#[derive(Clone, Debug)]
pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// The first line that names a file of a texture, as MeshLab and others write it into a comment.
    pub(super) texture: Option<usize>,
    /// Byte of the file at which the elements begin.
    pub(super) body: usize,
    /// Number of lines of the header.
    pub(super) lines: usize,
}

impl Header {
    /// The header that the bytes begin with.
    pub(super) fn of(bytes: &[u8]) -> Result<Header, Refusal> {
        let (mut encoding, mut elements, mut texture) = (None, Vec::new(), None);
        let mut lines = Lines::of(bytes);
        let mut number = 0;
        while let Some(line) = lines.next() {
            number += 1;
            let line = String::from_utf8_lossy(line);
            let words: Vec<&str> = line.split_whitespace().collect();
            let is_end = words.first() == Some(&"end_header");
            if is_end {
                let Some(encoding) = encoding else {
                    return refuse_at(
                        FilePlace::Line(number),
                        "the header names no format",
                        "add 'format ascii 1.0' below 'ply'",
                    );
                };
                return Ok(Header { encoding, elements, texture, body: lines.at, lines: number });
            }
            if matches!(words[..], ["comment" | "obj_info", "TextureFile", _, ..]) {
                texture = texture.or(Some(number));
            }
            let read = match number {
                1 => magic(&words),
                _ => statement(&words, number, &mut encoding, &mut elements),
            };
            read.map_err(|fault| fault.at(FilePlace::Line(number)))?;
        }
        refuse_at(
            FilePlace::Line(number.max(1)),
            "the header does not end",
            "export the model again; a header ends with 'end_header'",
        )
    }
}

fn magic(words: &[&str]) -> Result<(), Refusal> {
    match words {
        ["ply"] => Ok(()),
        _ => refuse("the file does not begin with 'ply'", "name the format that the file has"),
    }
}

fn statement(
    words: &[&str],
    line: usize,
    encoding: &mut Option<Encoding>,
    elements: &mut Vec<Element>,
) -> Result<(), Refusal> {
    match words {
        [] | ["comment" | "obj_info", ..] => Ok(()),
        ["format", kind, version] => {
            *encoding = Some(encoding_of(kind, version)?);
            Ok(())
        }
        ["element", name, count] => {
            let count = count.parse().map_err(|_| {
                Refusal::new(
                    format!("the number of '{}' is '{}'", short(name), short(count)),
                    "write how many there are",
                )
            })?;
            elements.push(Element { name: (*name).to_owned(), count, properties: Vec::new(), line });
            Ok(())
        }
        ["property", "list", count, item, name] => add(elements, name, Some(scalar(count)?), scalar(item)?),
        ["property", item, name] => add(elements, name, None, scalar(item)?),
        [first, ..] => refuse(
            format!("'{}' is no statement of a header", short(first)),
            "write 'element NAME COUNT', 'property TYPE NAME', 'property list TYPE TYPE NAME' or 'comment'",
        ),
    }
}

fn encoding_of(kind: &str, version: &str) -> Result<Encoding, Refusal> {
    match (kind, version) {
        ("ascii", "1.0") => Ok(Encoding::Text),
        ("binary_little_endian", "1.0") => Ok(Encoding::Little),
        ("binary_big_endian", "1.0") => Ok(Encoding::Big),
        (_, "1.0") => refuse(
            format!("'{}' is no format of PLY", short(kind)),
            "write ascii, binary_little_endian or binary_big_endian",
        ),
        _ => refuse(format!("the version {} is not known", short(version)), "save the file as version 1.0"),
    }
}

/// Adds a property to the last element; a list has a `count` before its items.
fn add(elements: &mut [Element], name: &str, count: Option<Scalar>, item: Scalar) -> Result<(), Refusal> {
    let Some(element) = elements.last_mut() else {
        return refuse("a property stands before all elements", "put it behind its 'element'");
    };
    element.properties.push(Property { name: name.to_owned(), count, item });
    Ok(())
}

/// Lines that end as the first one does: with a line feed, a carriage return, or both.
struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    end: u8,
}

impl<'a> Lines<'a> {
    fn of(bytes: &'a [u8]) -> Self {
        let first = bytes.iter().position(|byte| matches!(byte, b'\r' | b'\n'));
        let is_return = first.is_some_and(|at| bytes[at] == b'\r' && bytes.get(at + 1) != Some(&b'\n'));
        let at = if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 };
        Lines { bytes, at, end: if is_return { b'\r' } else { b'\n' } }
    }

    fn next(&mut self) -> Option<&'a [u8]> {
        let rest = self.bytes.get(self.at..).filter(|rest| !rest.is_empty())?;
        let length = rest.iter().position(|byte| *byte == self.end).unwrap_or(rest.len());
        self.at = (self.at + length + 1).min(self.bytes.len());
        Some(&rest[..length])
    }
}

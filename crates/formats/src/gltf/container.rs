//! GLB: a header of 12 bytes, a chunk of JSON, and a chunk of binary data (section 4.4). A file without that
//! header is the JSON itself.

use radiosity_photometry::error::{Refusal, refuse_at};
use radiosity_photometry::file_place::FilePlace;

use crate::tolerances::MOST_BYTES_OF_TEXT;

const MAGIC: &[u8] = b"glTF";
const JSON: u32 = 0x4E4F_534A;
const BINARY: u32 = 0x004E_4942;

/// The parts of a file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parts<'a> {
    /// Text of the JSON.
    pub(super) text: &'a str,
    /// Byte of a binary container at which the JSON begins; none in a `.gltf`.
    pub(super) start: Option<usize>,
    /// Bytes of the binary chunk, if there is one.
    pub(super) binary: Option<&'a [u8]>,
}

/// The parts of a `.gltf` or a `.glb`.
pub(super) fn parts(bytes: &[u8]) -> Result<Parts<'_>, Refusal> {
    if !bytes.starts_with(MAGIC) {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        return Ok(Parts { text: text(bytes, 0)?, start: None, binary: None });
    }
    if word(bytes, 4) != Some(2) {
        return refuse_at(FilePlace::Byte(4), "this is no GLB of version 2", "export the model as glTF 2.0");
    }
    let length = word(bytes, 8).map_or(0, |length| length as usize);
    if length > bytes.len() {
        return refuse_at(
            FilePlace::Byte(8),
            format!("the file has {} bytes, its header says {length}", bytes.len()),
            "copy or export it again",
        );
    }
    let first = Chunk::at(bytes, 12)?;
    if first.kind != JSON {
        return refuse_at(FilePlace::Byte(16), "the first chunk is not JSON", "export the model again");
    }
    let mut binary = None;
    if first.next < length {
        let second = Chunk::at(bytes, first.next)?;
        binary = (second.kind == BINARY).then_some(second.bytes);
    }
    Ok(Parts { text: text(first.bytes, 20)?, start: Some(20), binary })
}

/// A chunk of a GLB.
struct Chunk<'a> {
    kind: u32,
    bytes: &'a [u8],
    /// Byte of the file at which the next one begins.
    next: usize,
}

impl<'a> Chunk<'a> {
    /// The chunk that begins at a byte.
    fn at(bytes: &'a [u8], at: usize) -> Result<Self, Refusal> {
        let header = word(bytes, at).zip(word(bytes, at + 4));
        let chunk = header.and_then(|(length, kind)| {
            let (start, length) = (at + 8, length as usize);
            let part = bytes.get(start..)?.get(..length)?;
            Some(Chunk { kind, bytes: part, next: start + length.next_multiple_of(4) })
        });
        chunk.ok_or_else(|| {
            Refusal::new("the file ends within a chunk", "copy or export it again").at(FilePlace::Byte(at))
        })
    }
}

/// The little-endian word at a byte.
fn word(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(*bytes.get(at..)?.first_chunk()?))
}

fn text(bytes: &[u8], start: usize) -> Result<&str, Refusal> {
    if bytes.len() > MOST_BYTES_OF_TEXT {
        return refuse_at(
            FilePlace::Byte(start),
            format!("the JSON is longer than {MOST_BYTES_OF_TEXT} bytes"),
            "keep buffers in files beside it",
        );
    }
    std::str::from_utf8(bytes).map_err(|error| {
        let place = FilePlace::Byte(start + error.valid_up_to());
        Refusal::new("the JSON is not UTF-8", "save it as UTF-8, or name the format that the file has")
            .at(place)
    })
}

//! Bytes of a file or of standard input, not more than a scene can need.

use std::fs::File;
use std::io;

use radiosity_photometry::files::{MOST_BYTES, all};
use radiosity_photometry::text::decode_western;
use radiosity_scene::{Fault, FaultKind};
use radiosity_work::{
    ranks::Ranks,
    wording::{command, words},
};

/// The bytes of a file, or of standard input for `-`: that of the first of these ranks, which shares it.
///
/// # Errors
/// A file that cannot be opened or read, or is longer than 2³⁰ bytes.
pub fn bytes(source: &str, ranks: &Ranks) -> io::Result<Vec<u8>> {
    match source {
        "-" => {
            let own = if ranks.is_first() { all(io::stdin(), MOST_BYTES)? } else { Vec::new() };
            Ok(ranks.of_first(own))
        }
        path => all(File::open(path)?, MOST_BYTES),
    }
}

/// The text of a file, or of standard input for `-`.
///
/// # Errors
/// As [`bytes`], and text that is not UTF-8.
pub fn text(source: &str, ranks: &Ranks) -> io::Result<String> {
    decoded(bytes(source, ranks)?)
}

/// The text of these bytes.
///
/// # Errors
/// Text that is not UTF-8.
pub(super) fn decoded(bytes: Vec<u8>) -> io::Result<String> {
    let no_text = |_| io::Error::new(io::ErrorKind::InvalidData, "stream did not contain valid UTF-8");
    String::from_utf8(bytes).map_err(no_text)
}

/// The text of these bytes; text that is not UTF-8 is read as Latin-1.
///
/// # Errors
/// Zero bytes.
pub(super) fn western(bytes: Vec<u8>) -> io::Result<String> {
    decode_western(&bytes).map_err(|fault| io::Error::new(io::ErrorKind::InvalidData, fault.cause))
}

/// The fault of a scene whose file or standard input cannot be read.
pub(super) fn unreadable(error: &io::Error) -> Fault {
    let cure =
        words("check the path and its permissions; ") + command("scenes") + " lists scenes that need no file";
    Fault::new(FaultKind::Unreadable(error.kind()), format!("cannot be read: {error}"), cure)
}

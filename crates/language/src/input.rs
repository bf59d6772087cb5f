//! Bytes of a file or of standard input, not more than a scene can need.

use std::fs::File;
use std::io::{self, Read};

use radiosity_formats::tolerances::MOST_BYTES;
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
        path => of_file(path),
    }
}

/// The bytes of a file, whatever it is called.
///
/// # Errors
/// As [`bytes`].
pub(super) fn of_file(path: &str) -> io::Result<Vec<u8>> {
    all(File::open(path)?, MOST_BYTES)
}

/// The text of a file, or of standard input for `-`.
///
/// # Errors
/// As [`bytes`], and text that is not UTF-8.
pub fn text(source: &str, ranks: &Ranks) -> io::Result<String> {
    decoded(bytes(source, ranks)?)
}

/// The text of a file, whatever it is called.
///
/// # Errors
/// As [`text`].
pub(super) fn file(path: &str) -> io::Result<String> {
    decoded(of_file(path)?)
}

fn decoded(bytes: Vec<u8>) -> io::Result<String> {
    let no_text = |_| io::Error::new(io::ErrorKind::InvalidData, "stream did not contain valid UTF-8");
    String::from_utf8(bytes).map_err(no_text)
}

/// The text of a file, whatever it is called; text that is not UTF-8 is read as Latin-1.
///
/// # Errors
/// As [`bytes`], and zero bytes.
pub(super) fn western(path: &str) -> io::Result<String> {
    decode_western(&of_file(path)?).map_err(|fault| io::Error::new(io::ErrorKind::InvalidData, fault.cause))
}

/// The fault of a scene whose file or standard input cannot be read.
pub(super) fn unreadable(error: &io::Error) -> Fault {
    let cure =
        words("check the path and its permissions; ") + command("scenes") + " lists scenes that need no file";
    Fault::new(FaultKind::Unreadable(error.kind()), format!("cannot be read: {error}"), cure)
}

fn all(input: impl Read, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        let message = format!("it is longer than {most} bytes, the most that is read");
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, message));
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_endless_input_is_refused() {
        assert_eq!(all(&b"abc"[..], 3).expect("it fits"), b"abc");
        assert!(all(&b"abcd"[..], 3).is_err());
        assert!(all(io::repeat(0), 1000).is_err());
    }
}

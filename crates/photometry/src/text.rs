//! Texts: bytes that must be characters, words that must be numbers.

use radiosity_work::printable::printable;

use crate::error::{Refusal, refuse};
use crate::file_place::FilePlace;

/// The characters of a text file. A byte order mark is dropped, lines that end with a carriage return alone
/// end with a line feed, bytes that are not UTF-8 become `�`.
///
/// # Errors
/// Bytes that are no text: a zero byte among them.
pub fn decode(bytes: &[u8]) -> Result<String, Refusal> {
    decode_with(bytes, |bytes| String::from_utf8_lossy(bytes).into_owned())
}

/// The characters of a text, as [`decode`] reads them.
///
/// # Errors
/// A zero byte, at its place.
pub fn decoded(bytes: &[u8]) -> Result<String, Refusal> {
    let zero = || bytes.iter().position(|byte| *byte == 0).unwrap_or(0);
    decode(bytes).map_err(|refusal| refusal.at(FilePlace::Byte(zero())))
}

/// The characters of a text file, as [`decode`] reads them, but of Latin-1 where it is not UTF-8, as old
/// programs for Windows write it.
///
/// # Errors
/// Bytes that are no text: a zero byte among them.
pub fn decode_western(bytes: &[u8]) -> Result<String, Refusal> {
    decode_with(bytes, |bytes| match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().map(|byte| char::from(*byte)).collect(),
    })
}

fn decode_with(bytes: &[u8], characters: impl Fn(&[u8]) -> String) -> Result<String, Refusal> {
    if bytes.contains(&0) {
        return refuse("this is not a text: it holds a zero byte", "name its format, or save it as UTF-8");
    }
    let text = characters(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes));
    match text.contains('\r') && !text.contains('\n') {
        true => Ok(text.replace('\r', "\n")),
        false => Ok(text),
    }
}

/// The finite number that `word` states.
///
/// # Errors
/// A word that is no number, or no finite one; `what` names it: "the radius".
pub fn number(word: &str, what: &str) -> Result<f64, Refusal> {
    match word.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => refuse(format!("{what} is {word}"), "write a finite number"),
        Err(_) => refuse(format!("{what} is '{}', which is no number", short(word)), "write a number"),
    }
}

/// `value` as messages quote it: numbers beyond all measure with an exponent.
pub(crate) fn told(value: f64) -> String {
    match value.abs() < 1e15 {
        true => value.to_string(),
        false => format!("{value:e}"),
    }
}

/// `word` as messages quote it: at most forty characters, as a terminal prints them.
pub fn short(word: &str) -> String {
    const LONGEST: usize = 40;
    match word.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", printable(&word[..end])),
        None => printable(word).into_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_and_line_ends_of_other_systems_are_read() {
        assert_eq!(decode(b"\xef\xbb\xbfv a\rp 1").as_deref(), Ok("v a\np 1"));
        assert_eq!(decode(b"a\r\nb").as_deref(), Ok("a\r\nb"));
        assert!(decode(b"glTF\x02\0\0\0").is_err());
        assert_eq!(decode(b"Stra\xdfe").as_deref(), Ok("Stra\u{fffd}e"));
        assert_eq!(decode_western(b"Stra\xdfe").as_deref(), Ok("Straße"));
        assert_eq!(decode_western("Straße".as_bytes()).as_deref(), Ok("Straße"));
    }

    #[test]
    fn quoted_words_command_no_terminal() {
        assert_eq!(short("é\u{1b}[2J\n"), r"é\u{1b}[2J\n");
    }

    #[test]
    fn great_numbers_are_told_in_few_digits() {
        assert_eq!([-2.5, 1000.0, 1e300].map(told), ["-2.5", "1000", "1e300"]);
    }

    #[test]
    fn only_finite_numbers_are_numbers() {
        assert_eq!(number("+1.5e2", "it"), Ok(150.0));
        for word in ["1e999", "nan", "inf", "", "one", "0x10"] {
            assert!(number(word, "it").is_err(), "{word}");
        }
    }
}

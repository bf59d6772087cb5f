//! Texts that a terminal prints as they stand.

use std::borrow::Cow;

/// The text of a name for a line of a message: what ends a line, commands a terminal or turns the direction of
/// writing is escaped, letters of all languages and quotes stay.
pub fn printable(text: &str) -> Cow<'_, str> {
    escaped(text, is_printable)
}

/// The text of whole lines for a terminal: as [`printable`], but for ends of lines and tabs, which stay.
pub fn printable_lines(text: &str) -> Cow<'_, str> {
    escaped(text, |letter| is_printable(letter) || matches!(letter, '\n' | '\t'))
}

/// Whether a name of these letters can be printed as it stands.
pub fn is_printable(letter: char) -> bool {
    let is_end_of_line = matches!(letter, '\u{2028}' | '\u{2029}');
    // Marks of direction, its embeddings, its isolates; a mark of byte order.
    let is_turn = matches!(letter, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    !letter.is_control() && !is_end_of_line && !is_turn && letter != '\u{feff}'
}

fn escaped(text: &str, stays: impl Fn(char) -> bool) -> Cow<'_, str> {
    if text.chars().all(&stays) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    for letter in text.chars() {
        if stays(letter) { shown.push(letter) } else { shown.extend(letter.escape_default()) }
    }
    Cow::Owned(shown)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_of_terminals_and_ends_of_lines_are_escaped() {
        let name = "a\nb\u{1b}[2J\u{7}\u{9b}c\r\u{202e}\u{2028}";
        assert_eq!(printable(name), r"a\nb\u{1b}[2J\u{7}\u{9b}c\r\u{202e}\u{2028}");
        assert_eq!(printable_lines("a\n\tb\u{1b}"), "a\n\tb\\u{1b}");
    }

    #[test]
    fn letters_and_quotes_stay() {
        let name = r#"Tür "Süd" 'é' 光 \ می\u{200c}روم"#;
        assert_eq!(printable(name), name);
        assert!(matches!(printable(name), Cow::Borrowed(_)));
    }
}

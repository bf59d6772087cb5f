//! The text a scene is read from, and places in it.

use std::{fmt, ops::Range, sync::Arc};

/// Longest line that is kept for messages, bytes.
const LONGEST_LINE: usize = 4096;

/// Byte range in a source text.
pub(super) type Span = Range<usize>;

/// A value and the bytes it was read from.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct At<T> {
    /// What was read.
    pub value: T,
    /// Where it stands.
    pub span: Span,
}

impl<T> At<T> {
    /// `value`, read from `span`.
    pub(super) fn new(value: T, span: &Span) -> Self {
        At { value, span: span.clone() }
    }
}

/// A scene's text with the name shown in messages: a path, `<stdin>` or a built-in scene's name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// Name shown in messages.
    pub origin: Arc<str>,
    /// The whole text.
    pub text: Arc<str>,
}

/// A line and a column of a source, with the line's text to show beside a message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Name of the source.
    pub origin: Arc<str>,
    /// Line, counted from 1.
    pub line: usize,
    /// Column in characters, counted from 1.
    pub column: usize,
    /// The line, without its end; tabs are single spaces so that columns line up. Empty if it is too long to read.
    pub text: String,
    /// Characters of the line that are meant, at least 1.
    pub width: usize,
}

impl Source {
    /// The text `text`, called `origin` in messages.
    pub fn new(origin: &str, text: &str) -> Self {
        Source { origin: origin.into(), text: text.into() }
    }

    /// The place where `span` starts. A span over several lines is cut at the end of its first.
    pub(super) fn place(&self, span: &Span) -> Place {
        let start = floor_boundary(&self.text, span.start);
        let line_start = self.text[..start].rfind('\n').map_or(0, |end| end + 1);
        let line_end = self.text[start..].find('\n').map_or(self.text.len(), |length| start + length);
        let end = floor_boundary(&self.text, span.end).clamp(start, line_end);
        // Every surface keeps its place: a long line must not be copied into all of them.
        let line =
            &self.text[line_start..if line_end - line_start > LONGEST_LINE { line_start } else { line_end }];
        Place {
            origin: self.origin.clone(),
            line: self.text[..line_start].matches('\n').count() + 1,
            column: self.text[line_start..start].chars().count() + 1,
            text: line.trim_end_matches('\r').replace('\t', " "),
            width: self.text[start..end].trim_end().chars().count().max(1),
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.origin, self.line, self.column)
    }
}

/// The last character boundary at or before `index`; parsers may point past the end or into a character.
fn floor_boundary(text: &str, index: usize) -> usize {
    let mut index = index.min(text.len());
    while !text.is_char_boundary(index) {
        index -= 1;
    }
    index
}

#[cfg(test)]
mod tests {
    use super::{LONGEST_LINE, Source};

    #[test]
    fn columns_count_characters_not_bytes() {
        let source = Source::new("s.toml", "a = 1\r\nρ = \"é\"\nz");
        let start = source.text.find("\"é\"").unwrap();
        let place = source.place(&(start..start + 4));
        assert_eq!((place.line, place.column, place.width), (2, 5, 3));
        assert_eq!(place.text, "ρ = \"é\"");
        assert_eq!(place.to_string(), "s.toml:2:5");
    }

    #[test]
    fn a_line_too_long_to_read_is_not_kept() {
        let place = Source::new("s.json", &"é".repeat(LONGEST_LINE)).place(&(10..12));
        assert_eq!((place.line, place.column, place.text.as_str()), (1, 6, ""));
    }

    #[test]
    fn a_span_past_the_end_is_at_the_end() {
        let source = Source::new("s.toml", "a\n");
        let place = source.place(&(40..50));
        assert_eq!((place.line, place.column, place.width), (2, 1, 1));
    }
}

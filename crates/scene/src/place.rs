//! Places in a text, or in a tree, and the values that stand there.

use std::{fmt, ops::Range, sync::Arc};

/// Longest line that is kept for messages, bytes. A scene on one line would be kept by each of its surfaces,
/// and nobody reads as much of a line.
const LONGEST_LINE: usize = 4096;

/// Bytes between the positions of a text before which characters are counted once. With fewer the index takes
/// more memory, now less than a hundredth of the text; with more each place takes longer to find.
const STRIDE: usize = 1024;

/// Range of the bytes of a text, or of the numbers of the values of a tree (`super::numbering`).
pub type Span = Range<usize>;

/// A value and where it was read from.
#[derive(Clone, Debug, PartialEq)]
pub struct At<T> {
    /// The value.
    pub value: T,
    /// Its place in the source.
    pub span: Span,
}

impl<T> At<T> {
    /// `value`, read from `span`.
    pub fn new(value: T, span: &Span) -> Self {
        At { value, span: span.clone() }
    }
}

/// A line and a column of a source, with the line's text for messages.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Name of the source.
    pub origin: Arc<str>,
    /// Line, counted from 1.
    pub line: usize,
    /// Column in characters, counted from 1.
    pub column: usize,
    /// The line, without its end; tabs are single spaces so that columns line up. Empty if it is too long to
    /// read.
    pub text: String,
    /// Number of characters of the line that are meant, at least 1.
    pub width: usize,
}

/// Longest part of a line that an excerpt shows, in characters. Chosen.
const SHOWN: usize = 100;

impl Place {
    /// The line with the part in question underlined; nothing where the line is not known.
    ///
    /// ```text
    ///    |
    /// 12 | reflectance = 1.2
    ///    |               ^^^
    /// ```
    pub fn excerpt(&self) -> String {
        if self.text.is_empty() {
            return String::new();
        }
        let number = self.line.to_string();
        let margin = " ".repeat(number.len());
        // Of a long line show the part from a little before the place.
        let skipped = (self.column - 1).saturating_sub(SHOWN / 2);
        let shown: String = self.text.chars().skip(skipped).take(SHOWN).collect();
        let indent = " ".repeat(self.column - 1 - skipped);
        let marks = "^".repeat(self.width.min(SHOWN.saturating_sub(indent.len()).max(1)));
        format!("{margin} |\n{number} | {shown}\n{margin} | {indent}{marks}\n")
    }
}

/// A line of a text, with the name of the text where it is an included one. Displays as `line 9` or `line 9
/// of lamps.toml`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// Number of the line, counted from 1.
    pub number: usize,
    /// Name of the included text; none for the including one.
    pub file: Option<Arc<str>>,
}

/// Index of the lines and characters of a text, since every surface looks up its place.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LineIndex {
    /// Starts of lines, ascending.
    line_starts: Arc<[usize]>,
    /// Number of characters before each [`STRIDE`] bytes of the text.
    characters: Arc<[usize]>,
}

impl LineIndex {
    pub(super) fn of(text: &str) -> Self {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        let counts = text.as_bytes().chunks(STRIDE).map(characters).scan(0, |before, count| {
            *before += count;
            Some(*before)
        });
        LineIndex {
            line_starts: std::iter::once(0).chain(ends.map(|(end, _)| end + 1)).collect(),
            characters: std::iter::once(0).chain(counts).collect(),
        }
    }

    /// The line on which `index` stands in a text of that length, counted from 1.
    pub(super) fn line(&self, index: usize, length: usize) -> usize {
        self.line_starts.partition_point(|start| *start <= index.min(length))
    }

    /// Number of characters of `text` that start before `index`.
    fn characters_before(&self, text: &str, index: usize) -> usize {
        let counted = index / STRIDE;
        self.characters[counted] + characters(&text.as_bytes()[counted * STRIDE..index])
    }

    /// The place where `span` starts in `text`.
    pub(super) fn place(&self, origin: &Arc<str>, text: &str, span: &Span) -> Place {
        let start = floor_boundary(text, span.start);
        let line = self.line(start, text.len());
        let line_start = self.line_starts[line - 1];
        let line_end = self.line_starts.get(line).map_or(text.len(), |next| next - 1);
        let end = floor_boundary(text, span.end).clamp(start, line_end);
        // Every surface keeps its place: a long line must not be copied into all of them.
        let shown =
            &text[line_start..if line_end - line_start > LONGEST_LINE { line_start } else { line_end }];
        Place {
            origin: Arc::clone(origin),
            line,
            column: self.characters_before(text, start) - self.characters_before(text, line_start) + 1,
            text: shown.trim_end_matches('\r').replace('\t', " "),
            width: text[start..end].trim_end().chars().count().max(1),
        }
    }
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}", self.number)?;
        self.file.as_ref().map_or(Ok(()), |file| write!(f, " of {file}"))
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.origin, self.line, self.column)
    }
}

/// Number of characters that start in these bytes of a text: bytes 10xxxxxx go on with one.
fn characters(bytes: &[u8]) -> usize {
    bytes.iter().filter(|byte| **byte & 0xC0 != 0x80).count()
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
    use super::{LONGEST_LINE, LineIndex, Place, Span};

    fn place(text: &str, span: Span) -> Place {
        LineIndex::of(text).place(&"s.toml".into(), text, &span)
    }

    #[test]
    fn columns_count_characters_not_bytes() {
        let text = "a = 1\r\nρ = \"é\"\nz";
        let start = text.find("\"é\"").unwrap();
        let place = place(text, start..start + 4);
        assert_eq!((place.line, place.column, place.width), (2, 5, 3));
        assert_eq!(place.text, "ρ = \"é\"");
        assert_eq!(place.to_string(), "s.toml:2:5");
    }

    #[test]
    fn a_line_too_long_to_read_is_not_kept() {
        let place = place(&"é".repeat(LONGEST_LINE), 10..12);
        assert_eq!((place.line, place.column, place.text.as_str()), (1, 6, ""));
    }

    #[test]
    fn places_are_those_found_by_counting_from_the_start() {
        let text = "é\n\nρ = 1, \n".repeat(500) + &"ñx".repeat(1000);
        let index = LineIndex::of(&text);
        for (at, _) in text.char_indices().step_by(7) {
            let place = index.place(&"s.toml".into(), &text, &(at..at));
            let before = &text[..at];
            let line_start = before.rfind('\n').map_or(0, |end| end + 1);
            let column = before[line_start..].chars().count() + 1;
            assert_eq!((place.line, place.column), (before.matches('\n').count() + 1, column));
        }
    }

    #[test]
    fn a_span_past_the_end_is_at_the_end() {
        let place = place("a\n", 40..50);
        assert_eq!((place.line, place.column, place.width), (2, 1, 1));
    }
}

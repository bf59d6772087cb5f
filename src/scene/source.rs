//! The text a scene is read from, and places in it.

use std::{collections::BTreeMap, fmt, ops::Range, sync::Arc};

use crate::scene::imported::Imported;

/// Longest line that is kept for messages, bytes. Chosen; not tuned.
const LONGEST_LINE: usize = 4096;

/// Characters before every so many bytes are counted once. Chosen; not tuned.
const STRIDE: usize = 1024;

/// A mark that some editors put before a text.
const BYTE_ORDER_MARK: char = '\u{feff}';

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
#[derive(Clone, Debug, PartialEq)]
pub struct Source {
    /// Name shown in messages.
    pub origin: Arc<str>,
    /// The whole text, without a byte-order mark before it.
    pub text: Arc<str>,
    /// Distance (scene length) within which corners and planes are made to agree, instead of that of the input.
    pub tolerance: Option<f64>,
    /// Values of its variables, by name, instead of those that the text gives them.
    pub settings: Arc<BTreeMap<String, f64>>,
    /// The moment, a real number of frames, of which the still scene is read; none where all of its motions are.
    pub moment: Option<f64>,
    /// What was done to the file of another program that it was made from.
    pub imported: Option<Arc<Imported>>,
    /// The texts that it includes, or may include.
    included: Arc<Vec<Included>>,
    /// The pictures that it names, or may name: the path and the bytes of each.
    pictures: Arc<BTreeMap<String, Arc<[u8]>>>,
    /// Whether files that it includes may be read.
    reads_files: bool,
    index: LineIndex,
}

/// A text that another includes. In places of the whole its bytes come behind those of the texts before it.
#[derive(Clone, Debug, PartialEq)]
struct Included {
    origin: Arc<str>,
    text: Arc<str>,
    /// Its first byte in places of the whole.
    base: usize,
    index: LineIndex,
}

/// Where the lines and characters of a text are, since every surface looks up its place.
#[derive(Clone, Debug, PartialEq)]
struct LineIndex {
    /// Starts of lines, ascending.
    line_starts: Arc<[usize]>,
    /// Characters before each [`STRIDE`] bytes of the text.
    characters: Arc<[usize]>,
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
    /// The line, without its end; tabs are single spaces so that columns line up. Empty if it is too long to read.
    pub text: String,
    /// Characters of the line that are meant, at least 1.
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

/// A line of a text, and which text where that is an included one. Displays as `line 9` or `line 9 of lamps.toml`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// Counted from 1.
    pub number: usize,
    /// Name of the included text; none for that which includes.
    pub file: Option<Arc<str>>,
}

impl Source {
    /// The text `text`, called `origin` in messages.
    pub fn new(origin: &str, text: &str) -> Self {
        let text = without_mark(text);
        Source {
            origin: origin.into(),
            text: text.into(),
            tolerance: None,
            settings: Arc::default(),
            moment: None,
            imported: None,
            included: Arc::default(),
            pictures: Arc::default(),
            reads_files: false,
            index: LineIndex::of(text),
        }
    }

    /// The same text, to be read with corners and planes made to agree within `tolerance` (scene length).
    #[must_use]
    pub fn within(self, tolerance: Option<f64>) -> Self {
        Self { tolerance, ..self }
    }

    /// The same text, to be read with these variables set, the last setting of each.
    #[must_use]
    pub fn set<'a>(mut self, settings: impl IntoIterator<Item = (&'a str, f64)>) -> Self {
        let settings = settings.into_iter().map(|(name, value)| (name.to_owned(), value));
        Arc::make_mut(&mut self.settings).extend(settings);
        self
    }

    /// The same text, to be read as the still scene of a moment, a real number of frames.
    #[must_use]
    pub fn at(self, moment: f64) -> Self {
        Self { moment: Some(moment), ..self }
    }

    /// The same text, made from a file of another program.
    pub(super) fn made_from(self, imported: Imported) -> Self {
        Self { imported: Some(Arc::new(imported)), ..self }
    }

    /// The same text with another, called `origin`, that it may include: by the path `origin` itself, or one that leads
    /// there from the including text.
    #[must_use]
    pub fn including(mut self, origin: &str, text: &str) -> Self {
        self.include(origin, text);
        self
    }

    /// The texts that it includes, or may include: the name and the text of each.
    pub fn included(&self) -> impl Iterator<Item = (&str, &str)> {
        self.included.iter().map(|own| (&*own.origin, &*own.text))
    }

    /// The same text with a picture, a file of these bytes, that it may name: by the path `origin` itself, or one that leads
    /// there from the text.
    #[must_use]
    pub fn with_picture(mut self, origin: &str, bytes: impl Into<Arc<[u8]>>) -> Self {
        self.add_picture(origin, bytes.into());
        self
    }

    /// The pictures that it names, or may name: the path and the bytes of each.
    pub fn pictures(&self) -> impl Iterator<Item = (&str, &[u8])> {
        self.pictures.iter().map(|(path, bytes)| (path.as_str(), &**bytes))
    }

    /// Adds a picture that it names.
    pub(super) fn add_picture(&mut self, path: &str, bytes: Arc<[u8]>) {
        Arc::make_mut(&mut self.pictures).insert(path.to_owned(), bytes);
    }

    /// The bytes of the picture of that path.
    pub(super) fn picture(&self, path: &str) -> Option<Arc<[u8]>> {
        self.pictures.get(path).cloned()
    }

    /// The same text, which may include files.
    pub fn with_files(self) -> Self {
        Self { reads_files: true, ..self }
    }

    /// Whether files that it includes may be read.
    pub(super) fn reads_files(&self) -> bool {
        self.reads_files
    }

    /// Adds a text that it includes. Returns its first byte in places of the whole.
    pub(super) fn include(&mut self, origin: &str, text: &str) -> usize {
        let last = self.included.last().map_or(self.text.len(), |last| last.base + last.text.len());
        let (text, base) = (without_mark(text), last + 1);
        let index = LineIndex::of(text);
        let included = Included { origin: origin.into(), text: text.into(), base, index };
        Arc::make_mut(&mut self.included).push(included);
        base
    }

    /// The included text of that name, with its first byte in places of the whole.
    pub(super) fn included_text(&self, origin: &str) -> Option<(Arc<str>, usize)> {
        let own = self.included.iter().find(|own| *own.origin == *origin)?;
        Some((Arc::clone(&own.text), own.base))
    }

    /// The included text in which `index` stands; none for the text itself.
    fn included_at(&self, index: usize) -> Option<&Included> {
        let count = self.included.partition_point(|own| own.base <= index);
        self.included[..count].last()
    }

    /// The name of the text in which `index` stands.
    pub(super) fn origin_at(&self, index: usize) -> &str {
        self.included_at(index).map_or(&*self.origin, |own| &*own.origin)
    }

    /// The line on which `index` stands.
    pub(super) fn line(&self, index: usize) -> Line {
        match self.included_at(index) {
            Some(own) => {
                let number = own.index.line(index - own.base, own.text.len());
                Line { number, file: Some(Arc::clone(&own.origin)) }
            }
            None => Line { number: self.index.line(index, self.text.len()), file: None },
        }
    }

    /// The place where `span` starts. A span over several lines is cut at the end of its first.
    pub(super) fn place(&self, span: &Span) -> Place {
        match self.included_at(span.start) {
            Some(own) => {
                let span = span.start - own.base..span.end.saturating_sub(own.base);
                own.index.place(&own.origin, &own.text, &span)
            }
            None => self.index.place(&self.origin, &self.text, span),
        }
    }
}

impl LineIndex {
    fn of(text: &str) -> Self {
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
    fn line(&self, index: usize, length: usize) -> usize {
        self.line_starts.partition_point(|start| *start <= index.min(length))
    }

    /// How many characters of `text` start before `index`.
    fn characters_before(&self, text: &str, index: usize) -> usize {
        let counted = index / STRIDE;
        self.characters[counted] + characters(&text.as_bytes()[counted * STRIDE..index])
    }

    /// The place where `span` starts in `text`.
    fn place(&self, origin: &Arc<str>, text: &str, span: &Span) -> Place {
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

fn without_mark(text: &str) -> &str {
    text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text)
}

/// How many characters start in these bytes of a text: bytes 10xxxxxx go on with one.
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
    fn places_are_those_found_by_counting_from_the_start() {
        let text = "é\n\nρ = 1, \n".repeat(500) + &"ñx".repeat(1000);
        let source = Source::new("s.toml", &text);
        for (index, _) in text.char_indices().step_by(7) {
            let place = source.place(&(index..index));
            let before = &text[..index];
            let line_start = before.rfind('\n').map_or(0, |end| end + 1);
            let column = before[line_start..].chars().count() + 1;
            assert_eq!((place.line, place.column), (before.matches('\n').count() + 1, column));
        }
    }

    #[test]
    fn a_span_past_the_end_is_at_the_end() {
        let source = Source::new("s.toml", "a\n");
        let place = source.place(&(40..50));
        assert_eq!((place.line, place.column, place.width), (2, 1, 1));
    }
}

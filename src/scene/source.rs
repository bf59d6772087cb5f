//! The text a scene is read from, and places in it.

use std::{collections::BTreeMap, sync::Arc};

use crate::scene::{
    imported::Imported,
    place::{Line, LineIndex, Place, Span},
};

/// A mark that some editors put before a text.
const BYTE_ORDER_MARK: char = '\u{feff}';

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

fn without_mark(text: &str) -> &str {
    text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text)
}

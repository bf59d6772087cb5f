//! Documents for people: headings, texts, tables and pictures in their order. [`html`](super::html) and
//! [`markdown`](super::markdown) write them.

use crate::drawings::picture::Picture;
use crate::table::Table;

/// A document.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// Its title.
    pub title: String,
    /// The line below the title.
    pub subtitle: String,
    /// Parts of the document, in the order of reading.
    pub blocks: Vec<Block>,
}

/// A part of a document. Texts are plain: nothing in them is markup.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// Heading of a section, which ends at the next heading.
    Heading(String),
    /// Heading of a part of a section.
    Subheading(String),
    /// A paragraph.
    Text(String),
    /// Numbers to be seen at a glance.
    Highlights(Vec<Highlight>),
    /// Items that want to be heeded.
    Warnings(Vec<String>),
    /// Items of a list without numbers.
    List(Vec<String>),
    /// A table.
    Table(Table<'static>),
    /// A picture.
    Figure(Figure),
    /// A command as it is typed.
    Command(String),
}

/// A number to be seen at a glance.
#[derive(Clone, Debug, PartialEq)]
pub struct Highlight {
    /// Name of the number.
    pub(super) label: String,
    /// The number with its unit.
    pub(super) value: String,
    /// Note in small letters; empty for none.
    pub(super) note: String,
}

/// A picture with its caption.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// A word for the name of its file, unique in the document: letters, digits and hyphens.
    pub name: String,
    /// The picture.
    pub picture: Picture,
    /// Text in place of the picture, for readers who do not see it.
    pub alternative: String,
    /// The text below it.
    pub caption: String,
}

//! Documents for people: headings, texts, tables and pictures in their order. [`html`](super::html) and
//! [`markdown`](super::markdown) write them.

use crate::drawings::picture::Picture;

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
    Table(Table),
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

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Heading of the column.
    pub(super) head: String,
    /// The unit of its numbers; empty where they have none.
    pub(super) unit: String,
    /// Whether the cells hold numbers, which are set to the right.
    pub(super) is_numeric: bool,
}

impl Column {
    /// A column of texts.
    pub(super) fn text(head: &str) -> Self {
        Self { head: head.to_owned(), unit: String::new(), is_numeric: false }
    }

    /// A column of numbers in `unit`.
    pub(super) fn numbers(head: &str, unit: &str) -> Self {
        Self { head: head.to_owned(), unit: unit.to_owned(), is_numeric: true }
    }

    /// Head and unit in a line.
    pub fn line(&self) -> String {
        match self.unit.as_str() {
            "" => self.head.clone(),
            unit => format!("{} {unit}", self.head),
        }
    }
}

/// A table. Every row has a cell for each column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    /// Its columns.
    pub columns: Vec<Column>,
    /// Its rows.
    pub rows: Vec<Vec<String>>,
    /// A row that sums up the others.
    pub total: Option<Vec<String>>,
}

impl Table {
    /// A table without rows.
    pub(super) fn new(columns: impl Into<Vec<Column>>) -> Self {
        Self { columns: columns.into(), rows: Vec::new(), total: None }
    }

    /// Adds a row at the end.
    ///
    /// # Panics
    /// If `cells` has not one entry for each column.
    pub(super) fn row(&mut self, cells: impl Into<Vec<String>>) {
        let cells = cells.into();
        assert_eq!(cells.len(), self.columns.len(), "a cell for each column");
        self.rows.push(cells);
    }
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

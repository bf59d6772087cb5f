//! Tables: columns, and rows with a value for each; written as CSV, JSON or text, and set in documents.

mod text;
mod listed;
mod value;

pub use listed::Listed;
pub use value::Value;

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its heading for people, and its key in JSON.
    pub(crate) head: String,
    /// The unit of its numbers; empty where they have none.
    pub(crate) unit: String,
    /// Whether the values are numbers, which are set to the right.
    pub(crate) is_numeric: bool,
    /// Names of the numbers of its values in CSV; none where CSV leaves the column out.
    names: Vec<String>,
    digits: Digits,
}

/// How people see the numbers of a column; CSV and JSON have every digit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Digits {
    /// As few as tell a number from all others.
    All,
    /// So many after the point.
    Decimals(usize),
    /// So many after the point of the mantissa, with a power of ten.
    Mantissa(usize),
}

impl Column {
    /// A column of texts.
    pub fn text(head: &str) -> Self {
        Self { is_numeric: false, ..Self::numbers(head, "") }
    }

    /// A column of numbers in `unit`.
    pub fn numbers(head: &str, unit: &str) -> Self {
        let names = vec![head.to_owned()];
        Self { head: head.to_owned(), unit: unit.to_owned(), is_numeric: true, names, digits: Digits::All }
    }

    /// A column of several numbers in a row, of which each has a name in CSV; without names CSV leaves the
    /// column out.
    pub fn several(head: &str, names: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Self { names: names.into_iter().map(Into::into).collect(), ..Self::numbers(head, "") }
    }

    /// A column with a number for each of these bands, named after the band and a letter, such as `E_red`.
    pub fn bands(head: &str, letter: char, bands: &[String]) -> Self {
        Self::several(head, bands.iter().map(|band| format!("{letter}_{band}")))
    }

    /// The column with `digits` for people.
    #[must_use]
    pub fn with(self, digits: Digits) -> Self {
        Self { digits, ..self }
    }

    /// Head and unit in a line.
    fn line(&self) -> String {
        match self.unit.as_str() {
            "" => self.head.clone(),
            unit => format!("{} {unit}", self.head),
        }
    }
}

/// A table. Every row has a value for each column.
#[derive(Clone, Debug, PartialEq)]
pub struct Table<'a> {
    /// Its columns.
    pub(crate) columns: Vec<Column>,
    /// Its rows.
    pub(crate) rows: Vec<Vec<Value<'a>>>,
    /// A row that sums up the others.
    pub(crate) total: Option<Vec<Value<'a>>>,
}

impl<'a> Table<'a> {
    /// The table of these columns and rows.
    ///
    /// # Panics
    /// If a row has not a value for each column.
    pub fn new<R: IntoIterator<Item: Into<Value<'a>>>>(
        columns: impl Into<Vec<Column>>,
        rows: impl IntoIterator<Item = R>,
    ) -> Self {
        let rows = rows.into_iter().map(|row| row.into_iter().map(Into::into).collect());
        let table = Self { columns: columns.into(), rows: rows.collect(), total: None };
        let is_full = |row: &Vec<Value>| row.len() == table.columns.len();
        assert!(table.rows.iter().all(is_full), "a value for each column");
        table
    }

    /// Its rows, for CSV and JSON.
    pub fn listed(&self) -> Listed<'_, std::slice::Iter<'_, Vec<Value<'a>>>> {
        Listed { columns: &self.columns, rows: self.rows.iter() }
    }
}

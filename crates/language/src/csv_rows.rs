//! The rows of a CSV text, each with its place.
//!
//! Fields are trimmed; blank lines and lines that start with `#` are left out. The CSV reader reports the
//! position before such lines, so the start of a row is searched after them.

use csv::{ReaderBuilder, StringRecord, Trim};

/// A row that is not blank.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Fields of the row, without the blanks and the quotes around them.
    pub fields: Vec<String>,
    /// Byte at which the row starts.
    pub start: usize,
    /// Line on which the row starts, counted from 1.
    pub line: usize,
}

/// The rows of `text`, in order.
pub fn rows(text: &str) -> impl Iterator<Item = Row> {
    let reader = ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(Trim::All)
        .from_reader(text.as_bytes());
    let row = |record: Result<StringRecord, csv::Error>| {
        let record = record.expect("rows of a text are texts, of any number of fields");
        let [from, line] = record.position().map_or([0, 1], |at| [at.byte() as usize, at.line() as usize]);
        let start = row_start(text.as_bytes(), from);
        let line = line + text[from..start].matches('\n').count();
        Row { fields: record.iter().map(str::to_owned).collect(), start, line }
    };
    let is_blank = |row: &Row| matches!(row.fields.as_slice(), [field] if field.is_empty());
    reader.into_records().map(row).filter(move |row| !is_blank(row))
}

/// Byte at which the row starts that is read from byte `from` on: behind ends of lines, comments and blanks.
fn row_start(text: &[u8], from: usize) -> usize {
    let mut start = from.min(text.len());
    loop {
        match text.get(start) {
            Some(b'\n' | b'\r') => start += 1,
            Some(b'#') => {
                start = text[start..].iter().position(|byte| *byte == b'\n').map_or(text.len(), |k| start + k)
            }
            _ => return start + text[start..].iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count(),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::csv_rows::rows;

    #[test]
    fn rows_start_after_comments_and_blank_lines() {
        let text = "# a\n\n  one, 1\n# b\r\n   \n\r\n# c\n\"two\nlines\",2\nthree,3";
        let found: Vec<_> = rows(text).map(|row| (row.start, row.line)).collect();
        assert_eq!(found, [(7, 3), (29, 8), (43, 10)]);
    }
}

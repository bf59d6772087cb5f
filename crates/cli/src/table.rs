//! Columns of text, padded to line up.

use std::fmt;

use radiosity_output::documents::document::{self, Column};

/// A table with a header and left-aligned columns, two spaces between.
#[derive(Debug)]
pub(crate) struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table of this header and no rows.
    pub(crate) fn new<const N: usize>(header: [&str; N]) -> Self {
        Table { rows: vec![header.map(str::to_owned).to_vec()] }
    }

    /// The text of a table of a document.
    pub(crate) fn of(table: &document::Table) -> Self {
        let header = table.columns.iter().map(Column::line).collect();
        Table { rows: [header].into_iter().chain(table.rows.iter().cloned()).collect() }
    }

    /// Adds a row at the end.
    pub(crate) fn row<const N: usize>(&mut self, cells: [String; N]) {
        self.rows.push(cells.to_vec());
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let columns = self.rows.first().map_or(0, Vec::len);
        let width =
            |column: usize| self.rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..columns).map(width).collect();
        for row in &self.rows {
            let padded: Vec<String> =
                row.iter().zip(&widths).map(|(cell, width)| padded(cell, *width)).collect();
            writeln!(f, "{}", padded.join("  ").trim_end())?;
        }
        Ok(())
    }
}

/// A cell followed by spaces; the widths of `format!` end at 65 535.
fn padded(cell: &str, width: usize) -> String {
    cell.to_owned() + &" ".repeat(width.saturating_sub(cell.chars().count()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_line_up_beside_cells_of_any_length() {
        let mut table = Table::new(["a", "b"]);
        table.row(["é".repeat(70_000), "c".to_owned()]);
        let lines: Vec<String> = table.to_string().lines().map(str::to_owned).collect();
        assert_eq!(lines[0], format!("a{}b", " ".repeat(70_001)));
        assert!(lines[1].ends_with("é  c"));
    }
}

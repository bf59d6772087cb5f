//! Tables as text: left-aligned columns, two spaces between.

use std::fmt;

use super::{Column, Table};

impl fmt::Display for Table<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let header: Vec<String> = self.columns.iter().map(Column::line).collect();
        let told = self
            .rows
            .iter()
            .chain(&self.total)
            .map(|row| row.iter().zip(&self.columns).map(|(value, column)| value.told(column)).collect());
        let rows: Vec<Vec<String>> = [header].into_iter().chain(told).collect();
        let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..self.columns.len()).map(width).collect();
        for row in &rows {
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
        let table = Table::new(["a", "b"].map(Column::text), [["é".repeat(70_000), "c".to_owned()]]);
        let lines: Vec<String> = table.to_string().lines().map(str::to_owned).collect();
        assert_eq!(lines[0], format!("a{}b", " ".repeat(70_001)));
        assert!(lines[1].ends_with("é  c"));
    }
}

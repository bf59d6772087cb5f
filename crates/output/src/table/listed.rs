//! Rows of a table as CSV and JSON, each made when it is written.

use std::borrow::Cow;
use std::io::{self, Write};

use serde::{Serialize, Serializer};

use super::{Column, Value};

/// Columns and the rows below them, each with a value for every column.
#[derive(Clone, Debug)]
pub struct Listed<'c, R> {
    /// The columns.
    pub columns: &'c [Column],
    /// The rows.
    pub rows: R,
}

impl<'a, R: Iterator<Item: AsRef<[Value<'a>]>> + Clone> Listed<'_, R> {
    /// Writes CSV with a header.
    ///
    /// # Errors
    /// Errors of writing to `out`.
    pub fn csv(&self, out: impl Write) -> io::Result<()> {
        // The crate csv hides the kind of an error of writing, by which a closed pipe is told.
        self.records(csv::Writer::from_writer(out)).map_err(|error| match error.into_kind() {
            csv::ErrorKind::Io(error) => error,
            kind => io::Error::other(format!("{kind:?}")),
        })
    }

    fn records(&self, mut writer: csv::Writer<impl Write>) -> csv::Result<()> {
        for name in self.columns.iter().flat_map(|column| &column.names) {
            writer.write_field(no_formula(name).as_bytes())?;
        }
        writer.write_record(None::<&[u8]>)?;
        for row in self.rows.clone() {
            for (column, value) in self.columns.iter().zip(row.as_ref()) {
                for field in value.fields(column.names.len()) {
                    writer.write_field(no_formula(&field).as_bytes())?;
                }
            }
            writer.write_record(None::<&[u8]>)?;
        }
        Ok(writer.flush()?)
    }
}

/// A cell that no spreadsheet takes for a formula: an apostrophe stands before text that begins as one does.
fn no_formula(cell: &str) -> Cow<'_, str> {
    let begins = cell.starts_with(['=', '+', '-', '@', '\t', '\r']);
    match begins && cell.parse::<f64>().is_err() {
        true => Cow::Owned(format!("'{cell}")),
        false => Cow::Borrowed(cell),
    }
}

/// A list of objects, a row each.
impl<'a, R: Iterator<Item: AsRef<[Value<'a>]>> + Clone> Serialize for Listed<'_, R> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.rows.clone().map(|row| Object { columns: self.columns, row }))
    }
}

/// The values of a row by their columns.
struct Object<'c, R> {
    columns: &'c [Column],
    row: R,
}

impl<'a, R: AsRef<[Value<'a>]>> Serialize for Object<'_, R> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let keys = self.columns.iter().map(|column| &column.head);
        serializer.collect_map(keys.zip(self.row.as_ref()))
    }
}

#[cfg(test)]
mod tests {
    use crate::table::{Column, Table, Value};

    #[test]
    fn rows_have_all_their_fields_in_csv_and_all_their_keys_in_json() {
        let columns = [Column::text("a"), Column::several("b", ["x", "y"]), Column::several("c", [""; 0])];
        let row = [Value::from("p,q"), Value::numbers(vec![0.5, -2.0]), 7.0.into()];
        let table = Table::new(columns, [row, [Value::from(3), Value::None, Value::None]]);
        let mut csv = Vec::new();
        table.listed().csv(&mut csv).unwrap();
        assert_eq!(String::from_utf8(csv).unwrap(), "a,x,y\n\"p,q\",0.5,-2\n3,,\n");
        let json = serde_json::to_string(&table.listed()).unwrap();
        assert_eq!(json, r#"[{"a":"p,q","b":[0.5,-2.0],"c":7.0},{"a":3,"b":null,"c":null}]"#);
    }
}

//! Numbers that a text repeats from a table of a document.
//!
//! Behind such a number stands where it is from: a part of the command of the table, cells of the row, the
//! first of which may be the line above the table, and the column.
//!
//! ```text
//! at the defaults 0.22<!-- read_off → default → Gather 4, 2 → both, % --> %
//! ```

use crate::documents::block::{Block, Table, blocks};
use crate::documents::number::{Number, Part, parts};
use crate::documents::steps::{Kind, Step};

const OPENED: &str = "<!-- ";
const CLOSED: &str = " -->";
const BETWEEN: &str = " → ";

/// A text whose repeated numbers are those of the tables.
pub struct Renewed {
    /// The text.
    pub text: String,
    /// Complaints about marks that name no cell, or more than one; the numbers before them are as they were.
    pub faults: Vec<String>,
}

/// The text with its repeated numbers as the tables of these steps have them now, with as many digits as
/// they are written with.
pub fn renewed(text: &str, tables: &[Step]) -> Renewed {
    let mut pieces = text.split(OPENED);
    let mut fresh = Renewed { text: pieces.next().unwrap_or_default().to_owned(), faults: Vec::new() };
    for piece in pieces {
        let mark = piece.split(CLOSED).next().unwrap_or_default();
        if mark.contains(BETWEEN) && !mark.contains('\n') {
            fresh.faults.extend(renew(&mut fresh.text, mark, tables).err());
        }
        fresh.text += OPENED;
        fresh.text += piece;
    }
    fresh
}

/// Puts the number that `mark` names in place of the last one of a text.
fn renew(text: &mut String, mark: &str, tables: &[Step]) -> Result<(), String> {
    let line = text.rfind('\n').map_or(0, |end| end + 1);
    let own = parts(&text[line..]).into_iter().last();
    let Some(Part::Number(own)) = own else { return Err(format!("no number stands before '{mark}'")) };
    let cell = cell(mark, tables)?;
    let number = first_number(&cell).ok_or_else(|| format!("'{mark}' names '{cell}', which is no number"))?;
    let (start, written) = (line + own.start, number.written_as(&own));
    text.replace_range(start.., &written);
    Ok(())
}

fn first_number(cell: &str) -> Option<Number<'_>> {
    parts(cell).into_iter().find_map(|part| match part {
        Part::Number(number) => Some(number),
        Part::Word(_) => None,
    })
}

/// The text of the cell that a mark names.
fn cell(mark: &str, tables: &[Step]) -> Result<String, String> {
    let words: Vec<&str> = mark.split(BETWEEN).map(str::trim).collect();
    let [command, cells @ .., column] = &words[..] else { return Err(format!("'{mark}' names no cell")) };
    let mut found = Vec::new();
    for step in tables.iter().filter(|step| step.command.contains(command)) {
        let Kind::Output(place) = &step.kind else { continue };
        let mut title = String::new();
        for block in blocks(&place.there) {
            match block {
                Block::Line(line) => title = line,
                Block::Table(table) => found.extend(in_table(&title, &table, cells, column)),
            }
        }
    }
    match &found[..] {
        [cell] => Ok(cell.clone()),
        [] => Err(format!("no table has what '{mark}' names")),
        _ => Err(format!("'{mark}' names {} cells", found.len())),
    }
}

/// The cells of a column in rows that hold these cells in this order, behind the line above the table.
fn in_table(title: &str, table: &Table, cells: &[&str], column: &str) -> Vec<String> {
    let Some(at) = table.columns.iter().position(|own| own.name == column) else { return Vec::new() };
    let holds = |row: &&Vec<String>| {
        let mut rest = std::iter::once(title).chain(row.iter().map(String::as_str));
        cells.iter().all(|cell| rest.any(|own| own == *cell))
    };
    table.rows.iter().filter(holds).filter_map(|row| row.get(at).cloned()).collect()
}

//! Tables and lines of the output of a command.

use crate::documents::number::TIMES;

/// A table, or lines that belong to none.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// A table.
    Table(Table),
    /// A line.
    Line(String),
}

/// A table.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Names of its columns.
    pub columns: Vec<Column>,
    /// The texts of its cells, row after row.
    pub rows: Vec<Vec<String>>,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// Whether it depends on the machine: times, whose names end with a unit of time; and memory of a process
    /// and what is reckoned from times, which tables of Markdown have at the right (`---:`).
    pub of_machine: bool,
}

impl Column {
    fn new(name: String, is_at_right: bool) -> Self {
        let is_time = name.rsplit([' ', ',']).next().is_some_and(|word| TIMES.contains(&word));
        Self { name, of_machine: is_at_right || is_time }
    }
}

/// The parts of a text, as tables of Markdown, tables of text whose first line names a column `seconds`, and
/// lines.
pub fn blocks(text: &str) -> Vec<Block> {
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    let mut blocks = Vec::new();
    let mut at = 0;
    while at < lines.len() {
        let rest = &lines[at..];
        let long = |goes_on: fn(&str) -> bool| rest.iter().take_while(|line| goes_on(line)).count();
        let marked = long(|line| line.starts_with('|'));
        if marked > 1 {
            blocks.push(Block::Table(markdown(&rest[..marked])));
            at += marked;
        } else if cells_of_text(rest[0]).contains(&"seconds".to_owned()) {
            let filled = long(|line| !line.is_empty());
            blocks.push(Block::Table(plain(&rest[..filled])));
            at += filled;
        } else {
            if !rest[0].is_empty() {
                blocks.push(Block::Line(rest[0].to_owned()));
            }
            at += 1;
        }
    }
    blocks
}

fn markdown(lines: &[&str]) -> Table {
    let cells = |line: &str| -> Vec<String> {
        let inside = line.trim_start_matches('|').trim_end_matches('|');
        inside.split('|').map(|cell| cell.trim().to_owned()).collect()
    };
    let sides = cells(lines[1]);
    let is_at_right =
        |k: usize| sides.get(k).is_some_and(|side| side.starts_with('-') && side.ends_with(':'));
    let columns = cells(lines[0]).into_iter().enumerate().map(|(k, name)| Column::new(name, is_at_right(k)));
    Table { columns: columns.collect(), rows: lines[2..].iter().map(|line| cells(line)).collect() }
}

fn plain(lines: &[&str]) -> Table {
    let columns = cells_of_text(lines[0]).into_iter();
    let columns = columns.map(|name| Column::new(name, false));
    Table { columns: columns.collect(), rows: lines[1..].iter().map(|line| cells_of_text(line)).collect() }
}

/// Parts of a line with two blanks or more between them.
fn cells_of_text(line: &str) -> Vec<String> {
    line.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).map(str::to_owned).collect()
}

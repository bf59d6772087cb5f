//! Differences between what a command prints and what stands in a document.
//!
//! Times never differ: numbers before a unit of time, and columns that depend on the machine
//! ([`Column::of_machine`]). Counts and words have to be equal, other numbers to agree to a unit of their
//! last digit. A row is found by its first columns: it is the one with most of them equal.

use std::fmt::{Display, Formatter, Result};

use crate::documents::block::{Block, Column, Table, blocks};
use crate::documents::number::{Part, agree, parts};

/// Cells at most that name a row.
const NAMING: usize = 5;

/// How much of what stands in a document a command prints.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Extent {
    /// All of it.
    Whole,
    /// Some tables, and some of their rows.
    Part,
}

/// A cell, a row or a line that is different.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Difference {
    /// The row's first columns, or the line.
    pub row: String,
    /// The column's name; empty of rows and lines.
    pub column: String,
    /// The text in the document; empty where none stands.
    pub there: String,
    /// The text that is printed; empty where none is.
    pub now: String,
}

impl Display for Difference {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let Self { row, column, there, now } = self;
        let or_nothing =
            |text: &str| if text.is_empty() { "nothing".to_owned() } else { format!("'{text}'") };
        let column = if column.is_empty() { String::new() } else { format!(", column '{column}'") };
        write!(f, "row '{row}'{column}: {} there, {} now", or_nothing(there), or_nothing(now))
    }
}

/// All that is different between what stands `there` and what is printed `now`.
pub fn differences(there: &str, now: &str, extent: Extent) -> Vec<Difference> {
    let [there, now] = [there, now].map(blocks);
    let mut found = Vec::new();
    let mut rest = &there[..];
    for block in &now {
        let Some(at) = rest.iter().position(|other| is_kin(other, block)) else {
            found.push(missing(&title(block), "", &title(block)));
            continue;
        };
        if extent == Extent::Whole {
            found.extend(rest[..at].iter().map(|block| missing(&title(block), &title(block), "")));
        }
        match (&rest[at], block) {
            (Block::Table(there), Block::Table(now)) => compare_tables(there, now, extent, &mut found),
            (Block::Line(there), Block::Line(now)) if !agree(there, now) => {
                found.push(missing(now, there, now))
            }
            _ => {}
        }
        rest = &rest[at + 1..];
    }
    if extent == Extent::Whole {
        found.extend(rest.iter().map(|block| missing(&title(block), &title(block), "")));
    }
    found
}

fn missing(row: &str, there: &str, now: &str) -> Difference {
    let [row, there, now] = [row, there, now].map(str::to_owned);
    Difference { row, column: String::new(), there, now }
}

fn names(table: &Table) -> impl Iterator<Item = &str> {
    table.columns.iter().map(|column| column.name.as_str())
}

/// Whether two blocks are of a table, or lines of equal words.
fn is_kin(one: &Block, other: &Block) -> bool {
    let words =
        |line| parts(line).into_iter().filter(|part| matches!(part, Part::Word(_))).collect::<Vec<_>>();
    match (one, other) {
        (Block::Table(one), Block::Table(other)) => names(one).eq(names(other)),
        (Block::Line(one), Block::Line(other)) => words(one) == words(other),
        _ => false,
    }
}

fn title(block: &Block) -> String {
    match block {
        Block::Table(table) => names(table).collect::<Vec<_>>().join(" | "),
        Block::Line(line) => line.clone(),
    }
}

fn compare_tables(there: &Table, now: &Table, extent: Extent, found: &mut Vec<Difference>) {
    let whole = |row: &[String]| row.join(" | ");
    let mut rest = &there.rows[..];
    for row in &now.rows {
        let Some(at) = place(rest, row) else {
            found.push(missing(&whole(row), "", &whole(row)));
            continue;
        };
        if extent == Extent::Whole {
            found.extend(rest[..at].iter().map(|row| missing(&whole(row), &whole(row), "")));
        }
        compare_rows(&now.columns, &rest[at], row, found);
        rest = &rest[at + 1..];
    }
    if extent == Extent::Whole {
        found.extend(rest.iter().map(|row| missing(&whole(row), &whole(row), "")));
    }
}

/// The first of the rows with most of the first columns equal to those of a row, one at least.
fn place(rows: &[Vec<String>], row: &[String]) -> Option<usize> {
    let equal = |other: &[String]| row.iter().zip(other).take_while(|(own, other)| own == other).count();
    let most = rows.iter().map(|other| equal(other)).max().filter(|most| *most > 0)?;
    rows.iter().position(|other| equal(other) == most)
}

fn compare_rows(columns: &[Column], there: &[String], now: &[String], found: &mut Vec<Difference>) {
    let cell = |row: &[String], k: usize| row.get(k).cloned().unwrap_or_default();
    // The row is named up to the cell that is different, by few cells.
    let name = |k: usize| now[..k.clamp(1, NAMING).min(now.len())].join(" | ");
    for k in 0..there.len().max(now.len()) {
        let (column, there, now) = (columns.get(k), cell(there, k), cell(now, k));
        if column.is_some_and(|column| column.of_machine) || agree(&there, &now) {
            continue;
        }
        let column = column.map_or_else(|| format!("{}", k + 1), |column| column.name.clone());
        found.push(Difference { row: name(k), column, there, now });
    }
}

//! A document as Markdown (CommonMark with the tables of GitHub), its pictures as files beside it.

use std::io::{self, Write};

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};

use super::document::{Block, Document, Figure};
use crate::table::{Column, Table, Value};

/// Characters that are percent-encoded in the name of a picture's file within a link.
const ENCODED: &AsciiSet = &NON_ALPHANUMERIC.remove(b'-').remove(b'_').remove(b'.').remove(b'~');

/// The name of the file of a figure of the document whose file is named `stem` without its ending.
pub fn picture_name(stem: &str, figure: &str) -> String {
    format!("{stem}-{figure}.png")
}

/// Writes the text of the document, whose file is named `stem` without its ending. Its figures are to be
/// written beside it under their [`picture_name`].
///
/// # Errors
/// Whatever `out` reports.
pub fn write(document: &Document, stem: &str, mut out: impl Write) -> io::Result<()> {
    writeln!(out, "# {}\n\n{}", escaped(&document.title), escaped(&document.subtitle))?;
    document.blocks.iter().try_for_each(|block| {
        writeln!(out)?;
        write_block(block, stem, &mut out)
    })
}

fn write_block(block: &Block, stem: &str, out: &mut impl Write) -> io::Result<()> {
    match block {
        Block::Heading(text) => writeln!(out, "## {}", escaped(text)),
        Block::Subheading(text) => writeln!(out, "### {}", escaped(text)),
        Block::Text(text) => writeln!(out, "{}", escaped(text)),
        Block::Highlights(highlights) => highlights.iter().try_for_each(|highlight| {
            let [label, value, note] =
                [&highlight.label, &highlight.value, &highlight.note].map(|text| escaped(text));
            let note = if note.is_empty() { note } else { format!(" ({note})") };
            writeln!(out, "- {label}: **{value}**{note}")
        }),
        Block::Warnings(items) => items.iter().try_for_each(|item| writeln!(out, "> ⚠ {}\n>", escaped(item))),
        Block::List(items) => items.iter().try_for_each(|item| writeln!(out, "- {}", escaped(item))),
        Block::Table(table) => write_table(table, out),
        Block::Figure(figure) => write_figure(figure, stem, out),
        Block::Command(command) => {
            writeln!(
                out,
                "{}",
                command.lines().map(|line| format!("    {line}")).collect::<Vec<_>>().join("\n")
            )
        }
    }
}

fn write_table(table: &Table, out: &mut impl Write) -> io::Result<()> {
    let head = |column: &Column| match column.unit.as_str() {
        "" => column.head.clone(),
        unit => format!("{} ({unit})", column.head),
    };
    write_row(table.columns.iter().map(head), out)?;
    let rule = |column: &Column| if column.is_numeric { "---:" } else { "---" };
    writeln!(out, "| {} |", table.columns.iter().map(rule).collect::<Vec<_>>().join(" | "))?;
    let told = |(value, column): (&Value, &Column)| value.told(column);
    let mut rows = table.rows.iter().chain(&table.total);
    rows.try_for_each(|row| write_row(row.iter().zip(&table.columns).map(told), out))
}

fn write_row(cells: impl Iterator<Item = String>, out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "| {} |", cells.map(|cell| escaped(&cell)).collect::<Vec<_>>().join(" | "))
}

fn write_figure(figure: &Figure, stem: &str, out: &mut impl Write) -> io::Result<()> {
    let name = picture_name(stem, &figure.name);
    let [alternative, caption] = [&figure.alternative, &figure.caption].map(|text| escaped(text));
    writeln!(out, "![{alternative}]({})\n\n{caption}", utf8_percent_encode(&name, ENCODED))
}

/// The text in a line, with a backslash before what Markdown reads otherwise.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '#' | '|' | '~' | '&' | '$' => {
                escaped.extend(['\\', character]);
            }
            '\n' | '\r' => escaped.push(' '),
            character => escaped.push(character),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_in_texts_is_text() {
        assert_eq!(escaped("a|b\n<i> *c* _d_ [e](f)"), "a\\|b \\<i\\> \\*c\\* \\_d\\_ \\[e\\](f)");
    }

    #[test]
    fn numbers_stand_at_the_right() {
        let columns = [Column::text("surface"), Column::numbers("area", "m²")];
        let table = Table::new(columns, [["a|b", "2"]]);
        let mut out = Vec::new();
        write_table(&table, &mut out).unwrap();
        let text = String::from_utf8(out).unwrap();
        assert_eq!(text, "| surface | area (m²) |\n| --- | ---: |\n| a\\|b | 2 |\n");
    }
}

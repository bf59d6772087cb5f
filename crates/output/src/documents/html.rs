//! A document as one HTML file, which needs no network: its style stands in it, and its pictures as data.

use std::io::{self, Write};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::document::{Block, Document, Figure, Highlight};
use crate::drawings::markup::escaped;
use crate::table::{Column, Table, Value};

/// Style sheet of the page: for screens, light and dark, and for paper of the size A4.
const STYLE: &str = include_str!("html/style.css");

/// Content security policy: the page loads nothing but its own parts.
const POLICY: &str = "default-src 'none'; img-src data:; style-src 'unsafe-inline'";

/// Writes the document.
///
/// # Errors
/// Whatever `out` reports.
pub fn write(document: &Document, mut out: impl Write) -> io::Result<()> {
    let title = escaped(&document.title);
    writeln!(out, "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">")?;
    writeln!(out, "<meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">")?;
    writeln!(out, "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">")?;
    writeln!(out, "<meta name=\"color-scheme\" content=\"light dark\">")?;
    writeln!(out, "<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>")?;
    writeln!(out, "<header>\n<h1>{title}</h1>\n<p>{}</p>\n</header>", escaped(&document.subtitle))?;
    document.blocks.iter().try_for_each(|block| write_block(block, &mut out))?;
    writeln!(out, "</main>\n</body>\n</html>")
}

fn write_block(block: &Block, out: &mut impl Write) -> io::Result<()> {
    match block {
        Block::Heading(text) => writeln!(out, "<h2>{}</h2>", escaped(text)),
        Block::Subheading(text) => writeln!(out, "<h3>{}</h3>", escaped(text)),
        Block::Text(text) => writeln!(out, "<p>{}</p>", escaped(text)),
        Block::Highlights(highlights) => write_highlights(highlights, out),
        Block::Warnings(items) => write_list("warnings", items, out),
        Block::List(items) => write_list("plain", items, out),
        Block::Table(table) => write_table(table, out),
        Block::Figure(figure) => write_figure(figure, out),
        Block::Command(command) => writeln!(out, "<pre><code>{}</code></pre>", escaped(command)),
    }
}

fn write_highlights(highlights: &[Highlight], out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "<dl class=\"highlights\">")?;
    for Highlight { label, value, note } in highlights {
        let [label, value, note] = [label, value, note].map(|text| escaped(text));
        writeln!(out, "<div><dt>{label}</dt><dd>{value}</dd><dd class=\"note\">{note}</dd></div>")?;
    }
    writeln!(out, "</dl>")
}

fn write_list(class: &str, items: &[String], out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "<ul class=\"{class}\">")?;
    items.iter().try_for_each(|item| writeln!(out, "<li>{}</li>", escaped(item)))?;
    writeln!(out, "</ul>")
}

/// Most rows of a table that is kept on one page. Chosen: half of one.
const SHORT: usize = 24;

fn write_table(table: &Table, out: &mut impl Write) -> io::Result<()> {
    let class_of_table = if table.rows.len() <= SHORT { "wide short" } else { "wide" };
    writeln!(out, "<div class=\"{class_of_table}\"><table>\n<thead><tr>")?;
    for column in &table.columns {
        let unit = match column.unit.as_str() {
            "" => String::new(),
            unit => format!(" <small>{}</small>", escaped(unit)),
        };
        writeln!(out, "<th scope=\"col\"{}>{}{unit}</th>", class(column), escaped(&column.head))?;
    }
    writeln!(out, "</tr></thead>\n<tbody>")?;
    table.rows.iter().try_for_each(|row| write_row(&table.columns, row, out))?;
    writeln!(out, "</tbody>")?;
    if let Some(total) = &table.total {
        writeln!(out, "<tbody class=\"total\">")?;
        write_row(&table.columns, total, out)?;
        writeln!(out, "</tbody>")?;
    }
    writeln!(out, "</table></div>")
}

fn write_row(columns: &[Column], cells: &[Value], out: &mut impl Write) -> io::Result<()> {
    let cell = |(column, value): (&Column, &Value)| {
        format!("<td{}>{}</td>", class(column), escaped(&value.told(column)))
    };
    let cells: String = columns.iter().zip(cells).map(cell).collect();
    writeln!(out, "<tr>{cells}</tr>")
}

fn class(column: &Column) -> &'static str {
    if column.is_numeric { " class=\"number\"" } else { "" }
}

fn write_figure(figure: &Figure, out: &mut impl Write) -> io::Result<()> {
    let mut png = Vec::new();
    figure.picture.write_png(&mut png)?;
    let [width, height] = figure.picture.size();
    let [alternative, caption] = [&figure.alternative, &figure.caption].map(|text| escaped(text));
    write!(out, "<figure><img width=\"{width}\" height=\"{height}\" alt=\"{alternative}\" ")?;
    writeln!(out, "src=\"data:image/png;base64,{}\">", STANDARD.encode(&png))?;
    writeln!(out, "<figcaption>{caption}</figcaption></figure>")
}

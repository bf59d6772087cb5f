//! TOML text → tree.

use radiosity_scene::{
    Fault, FaultKind,
    error::Located,
    place::At,
    tree::{Node, Value},
};
use toml::{
    Spanned,
    de::{DeTable, DeValue},
};

/// Message of the parser where a key stands twice.
const DUPLICATE: &str = "duplicate key";

/// Parses a TOML document.
pub(super) fn parse(text: &str) -> Result<Node, Located> {
    let table = DeTable::parse(text).map_err(|error| {
        let cause = format!("syntax error: {}", error.message());
        let cure = match error.message() {
            DUPLICATE => "keep one of them",
            _ => "TOML wants `key = value`, texts in quotes, and lists in brackets with commas",
        };
        let fault = Fault::new(FaultKind::Syntax, cause, cure);
        Located::at(&error.span().unwrap_or(0..0), fault)
    })?;
    let span = table.span();
    Ok(At::new(table_value(table.into_inner()), &span))
}

fn node(spanned: Spanned<DeValue<'_>>) -> Node {
    let span = spanned.span();
    let value = match spanned.into_inner() {
        DeValue::String(text) => Value::Text(text.into_owned()),
        DeValue::Integer(integer) => Value::Number(integer_value(integer.as_str(), integer.radix())),
        DeValue::Float(float) => Value::Number(float.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(truth) => Value::Truth(truth),
        DeValue::Datetime(_) => Value::Other("a date".into()),
        DeValue::Array(items) => Value::List(items.into_iter().map(node).collect()),
        DeValue::Table(table) => table_value(table),
    };
    At::new(value, &span)
}

/// Integers beyond 64 bits are infinite, and thereby refused wherever a number is read.
fn integer_value(digits: &str, radix: u32) -> f64 {
    i64::from_str_radix(digits, radix).map_or(f64::INFINITY, |integer| integer as f64)
}

/// The entries in the order they are written, which the parser's map does not keep.
fn table_value(table: DeTable<'_>) -> Value {
    let mut entries: Vec<_> = table
        .into_iter()
        .map(|(key, value)| (At::new(key.get_ref().clone().into_owned(), &key.span()), node(value)))
        .collect();
    entries.sort_by_key(|(key, _)| key.span.start);
    Value::Table(entries)
}

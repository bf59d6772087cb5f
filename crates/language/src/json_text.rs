//! JSON text → tree.
//!
//! `serde_json` reports no positions of values, but gives access to each value's own piece of the text
//! ([`RawValue`]); the start of the piece within the whole is its position. Each level is split into pieces
//! in turn.

use std::fmt;

use radiosity_scene::{
    Fault, FaultKind,
    error::Located,
    place::{At, Span},
    tree::{DEEPEST, Node, Value},
};
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde_json::value::RawValue;

/// Parses a JSON document.
pub(super) fn parse(text: &str) -> Result<Node, Located> {
    let raw: &RawValue =
        serde_json::from_str(text).map_err(|error| syntax(&error_span(text, &error), &error))?;
    node(text, raw, 0)
}

fn node(text: &str, raw: &RawValue, depth: usize) -> Result<Node, Located> {
    let piece = raw.get();
    let start = piece.as_ptr().addr() - text.as_ptr().addr();
    let span = start..start + piece.len();
    if depth > DEEPEST {
        return Err(syntax(&span, &format!("nested more than {DEEPEST} levels deep")));
    }
    let value = match piece.as_bytes().first() {
        Some(b'{') => Value::Table(entries(text, piece, &span, depth)?),
        Some(b'[') => {
            let items: Vec<&RawValue> = inner(piece, &span)?;
            Value::List(items.into_iter().map(|item| node(text, item, depth + 1)).collect::<Result<_, _>>()?)
        }
        Some(b'"') => Value::Text(inner(piece, &span)?),
        Some(b't' | b'f') => Value::Truth(inner(piece, &span)?),
        Some(b'n') => Value::Other("null".into()),
        _ => Value::Number(piece.parse().unwrap_or(f64::NAN)),
    };
    Ok(At::new(value, &span))
}

fn entries(text: &str, piece: &str, span: &Span, depth: usize) -> Result<Vec<(At<String>, Node)>, Located> {
    let pieces: Entries<'_> = inner(piece, span)?;
    let mut entries: Vec<(At<String>, Node)> = Vec::with_capacity(pieces.0.len());
    for (key, value) in pieces.0 {
        let start = key.get().as_ptr().addr() - text.as_ptr().addr();
        let key_span = start..start + key.get().len();
        let key: String = inner(key.get(), &key_span)?;
        if entries.iter().any(|(earlier, _)| earlier.value == key) {
            return Err(Located::at(&key_span, Fault::repeated_key(&key)));
        }
        entries.push((At::new(key, &key_span), node(text, value, depth + 1)?));
    }
    Ok(entries)
}

/// Reads one level of `piece`; deeper levels stay text.
fn inner<'a, T: Deserialize<'a>>(piece: &'a str, span: &Span) -> Result<T, Located> {
    serde_json::from_str(piece).map_err(|error| syntax(span, &error))
}

fn syntax(span: &Span, message: &dyn fmt::Display) -> Located {
    // serde_json ends its messages with the place, which our messages begin with.
    let message = message.to_string();
    let cause = format!("syntax error: {}", message.split(" at line ").next().unwrap_or_default());
    let cure = "JSON wants quotes around every key and a comma between items, none after the last";
    Located::at(span, Fault::new(FaultKind::Syntax, cause, cure))
}

/// The byte serde_json's line and column mean; its columns count bytes from 1, 0 being the line's start.
fn error_span(text: &str, error: &serde_json::Error) -> Span {
    let line_start: usize =
        text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum();
    let start = line_start + error.column().saturating_sub(1);
    start..start + 1
}

/// An object's keys and values as pieces of text, repeated keys included.
struct Entries<'a>(Vec<(&'a RawValue, &'a RawValue)>);

impl<'a> Deserialize<'a> for Entries<'a> {
    fn deserialize<D: Deserializer<'a>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(EntriesVisitor)
    }
}

struct EntriesVisitor;

impl<'a> Visitor<'a> for EntriesVisitor {
    type Value = Entries<'a>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'a>>(self, mut map: A) -> Result<Entries<'a>, A::Error> {
        let mut entries = Vec::new();
        while let Some(entry) = map.next_entry()? {
            entries.push(entry);
        }
        Ok(Entries(entries))
    }
}

#[cfg(test)]
mod tests {
    use radiosity_scene::tree::{Value, entry};

    use super::parse;

    fn entries(text: &str) -> Vec<(radiosity_scene::place::At<String>, radiosity_scene::tree::Node)> {
        match parse(text).unwrap().value {
            Value::Table(entries) => entries,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn values_know_where_they_stand() {
        let text = "{ \"name\": \"é\\n\",\n  \"list\": [1, -2.5e3, true] }";
        let entries = entries(text);
        let name = entry(&entries, "name").unwrap();
        assert_eq!(name.value, Value::Text("é\n".into()));
        assert_eq!(&text[name.span.clone()], "\"é\\n\"");
        let Value::List(items) = &entry(&entries, "list").unwrap().value else { panic!() };
        assert_eq!(items[1].value, Value::Number(-2500.0));
        assert_eq!(&text[items[1].span.clone()], "-2.5e3");
        assert_eq!(&text[entries[1].0.span.clone()], "\"list\"");
    }

    #[test]
    fn numbers_are_read_exactly() {
        let entries = entries("{\"x\": 0.1, \"y\": 1e999}");
        assert_eq!(entries[0].1.value, Value::Number(0.1));
        assert_eq!(entries[1].1.value, Value::Number(f64::INFINITY));
    }

    #[test]
    fn deep_nesting_is_refused_not_followed() {
        assert!(parse(&"[".repeat(100_000)).is_err());
        assert!(parse(&format!("{}{}", "[".repeat(5000), "]".repeat(5000))).is_err());
    }
}

//! Tree → text: TOML or JSON that reads as the same tree.
//!
//! The lists and tables of a scene stand on lines of their own, each surface on one.

use crate::{
    place::At,
    tree::{Node, Value},
};

/// Whole numbers below this are written without a decimal point, all numbers from here on with an exponent.
/// Chosen.
const LARGE: f64 = 1e15;

/// Numbers nearer to 0 are written with an exponent. Chosen.
const SMALL: f64 = 1e-5;

/// A language that scenes are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// TOML.
    Toml,
    /// JSON.
    Json,
}

impl Notation {
    /// The text of a tree.
    pub fn text(self, tree: &Node) -> String {
        match self {
            Notation::Toml => toml(tree),
            Notation::Json => json(tree),
        }
    }

    /// Writes a value on one line.
    fn inline(self, node: &Node, text: &mut String) {
        let number = |number: &f64, text: &mut String| text.push_str(&number_text(*number));
        match &node.value {
            Value::List(items) => bracketed(items, text, |own, text| self.inline(own, text)),
            Value::Points(points) => {
                bracketed(points, text, |point, text| bracketed(&point.to_array(), text, number));
            }
            Value::Table(entries) => {
                let [open, close] = if self == Notation::Toml { ["{ ", " }"] } else { ["{", "}"] };
                text.push_str(open);
                separated(entries, text, |(key, own), text| self.entry(key, own, text));
                text.push_str(close);
            }
            Value::Text(own) => text.push_str(&self.quoted(own)),
            Value::Formula(formula) => text.push_str(&Notation::Json.quoted(&formula.text)),
            Value::Number(own) => number(own, text),
            Value::Truth(truth) => text.push_str(&truth.to_string()),
            Value::Other(_) => text.push_str("null"),
        }
    }

    /// Writes a key and its value on one line.
    fn entry(self, key: &At<String>, node: &Node, text: &mut String) {
        text.push_str(&self.key(&key.value));
        text.push_str(if self == Notation::Toml { " = " } else { ": " });
        self.inline(node, text);
    }

    /// A key, in TOML in quotes only where it needs them.
    fn key(self, key: &str) -> String {
        let is_bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        match self == Notation::Toml && !key.is_empty() && key.chars().all(is_bare) {
            true => key.to_owned(),
            false => self.quoted(key),
        }
    }

    fn quoted(self, text: &str) -> String {
        match self {
            Notation::Toml => toml::Value::String(text.to_owned()).to_string(),
            Notation::Json => serde_json::Value::String(text.to_owned()).to_string(),
        }
    }
}

/// A tree in JSON.
fn json(tree: &Node) -> String {
    let mut text = String::new();
    json_outer(tree, 0, &mut text);
    text.push('\n');
    text
}

/// A tree in TOML, which has to be a table.
fn toml(tree: &Node) -> String {
    let Value::Table(entries) = &tree.value else { return String::new() };
    let mut text = String::new();
    for (key, node) in entries.iter().filter(|(_, node)| !is_section(node)) {
        line(&mut text, key, node);
    }
    for (key, node) in entries.iter().filter(|(_, node)| is_section(node)) {
        section(&Notation::Toml.key(&key.value), node, &mut text);
    }
    text
}

/// Whether an entry of the whole scene gets headers of its own.
fn is_section(node: &Node) -> bool {
    match &node.value {
        Value::Table(_) => true,
        Value::List(items) => !items.is_empty() && items.iter().all(is_table),
        _ => false,
    }
}

fn is_table(node: &Node) -> bool {
    matches!(node.value, Value::Table(_))
}

/// A table, or a list of tables, with headers.
fn section(path: &str, node: &Node, text: &mut String) {
    match &node.value {
        Value::List(items) => {
            for item in items {
                header(&format!("[[{path}]]"), text);
                lines(item, text);
            }
        }
        Value::Table(entries) if !entries.is_empty() && entries.iter().all(|(_, own)| is_table(own)) => {
            for (key, own) in entries {
                header(&format!("[{path}.{}]", Notation::Toml.key(&key.value)), text);
                lines(own, text);
            }
        }
        _ => {
            header(&format!("[{path}]"), text);
            lines(node, text);
        }
    }
}

fn header(header: &str, text: &mut String) {
    if !text.is_empty() {
        text.push('\n');
    }
    text.push_str(header);
    text.push('\n');
}

/// The entries of a table, each on a line.
fn lines(node: &Node, text: &mut String) {
    let Value::Table(entries) = &node.value else { return };
    entries.iter().for_each(|(key, own)| line(text, key, own));
}

fn line(text: &mut String, key: &At<String>, node: &Node) {
    Notation::Toml.entry(key, node, text);
    text.push('\n');
}

/// A table of the whole scene, or a list or table in it, over several lines; all that is deeper on one.
fn json_outer(node: &Node, depth: usize, text: &mut String) {
    let indent = "  ".repeat(depth + 1);
    let next = |node: &Node, text: &mut String| match depth == 0 && is_section(node) {
        true => json_outer(node, depth + 1, text),
        false => Notation::Json.inline(node, text),
    };
    let mut first = true;
    let mut begin = |text: &mut String| {
        text.push_str(if first { "\n" } else { ",\n" });
        text.push_str(&indent);
        first = false;
    };
    let ends = match &node.value {
        Value::Table(entries) => {
            text.push('{');
            for (key, own) in entries {
                begin(text);
                text.push_str(&Notation::Json.key(&key.value));
                text.push_str(": ");
                next(own, text);
            }
            '}'
        }
        Value::List(items) => {
            text.push('[');
            for own in items {
                begin(text);
                next(own, text);
            }
            ']'
        }
        _ => return Notation::Json.inline(node, text),
    };
    text.push('\n');
    text.push_str(&"  ".repeat(depth));
    text.push(ends);
}

fn separated<T>(items: &[T], text: &mut String, write: impl Fn(&T, &mut String)) {
    for (index, item) in items.iter().enumerate() {
        if index > 0 {
            text.push_str(", ");
        }
        write(item, text);
    }
}

fn bracketed<T>(items: &[T], text: &mut String, write: impl Fn(&T, &mut String)) {
    text.push('[');
    separated(items, text, write);
    text.push(']');
}

fn number_text(number: f64) -> String {
    let is_whole = number.fract() == 0.0 && number.abs() < LARGE;
    match is_whole || (SMALL..LARGE).contains(&number.abs()) {
        true => format!("{number}"),
        false => format!("{number:e}"),
    }
}

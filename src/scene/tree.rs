//! A scene's text as a tree of values, each with the bytes it stands on: what TOML and JSON have in common.

use crate::scene::{
    error::Fault,
    place::{At, Span},
};

/// A value and where it stands.
pub(super) type Node = At<Value>;

/// A value by kind.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    /// A string.
    Text(String),
    /// A string that begins with `=`, evaluated: a number where one is read, else a text.
    Formula(Box<Formula>),
    /// Any number; integers are exact up to 2⁵³.
    Number(f64),
    /// `true` or `false`.
    Truth(bool),
    /// A list.
    List(Vec<Node>),
    /// A table (TOML) or an object (JSON), in the order the parser gives.
    Table(Vec<(At<String>, Node)>),
    /// Something no scene uses: a date (TOML), `null` (JSON).
    Other(&'static str),
}

/// A formula and what comes out, or the fault and where that stands.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Formula {
    /// The whole string.
    pub text: String,
    /// Its value.
    pub outcome: Result<f64, At<Fault>>,
}

impl Value {
    /// The kind of value, for messages.
    pub(super) fn kind(&self) -> &'static str {
        match self {
            Value::Text(_) | Value::Formula(_) => "a text",
            Value::Number(_) => "a number",
            Value::Truth(_) => "true or false",
            Value::List(_) => "a list",
            Value::Table(_) => "a table",
            Value::Other(kind) => kind,
        }
    }
}

impl Node {
    /// Moves it and all in it by `base` bytes: a piece of a text that stands there in the whole.
    pub(super) fn shift(&mut self, base: usize) {
        let moved = |span: &mut Span| *span = span.start + base..span.end + base;
        moved(&mut self.span);
        match &mut self.value {
            Value::List(items) => items.iter_mut().for_each(|item| item.shift(base)),
            Value::Table(entries) => entries.iter_mut().for_each(|(key, item)| {
                moved(&mut key.span);
                item.shift(base);
            }),
            Value::Formula(formula) => {
                if let Err(fault) = &mut formula.outcome {
                    moved(&mut fault.span);
                }
            }
            Value::Text(_) | Value::Number(_) | Value::Truth(_) | Value::Other(_) => {}
        }
    }
}

/// The entries of a table, by key.
pub(super) fn entry<'a>(entries: &'a [(At<String>, Node)], key: &str) -> Option<&'a Node> {
    entries.iter().find(|(name, _)| name.value == key).map(|(_, node)| node)
}

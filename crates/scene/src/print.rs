//! Tree → text: TOML or JSON that reads as the same tree.
//!
//! In JSON each surface stands on a line.

use std::io::{self, Write};

use serde::{Serialize, Serializer};
use serde_json::ser::Formatter;

use crate::tree::{Node, Value};

/// Levels of JSON that stand on lines of their own: the scene, and its lists and tables.
const LEVELS: usize = 2;

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
            Notation::Toml => toml::to_string(&Written(tree)).expect("a scene is a table"),
            Notation::Json => {
                let mut text = Vec::new();
                let mut to = serde_json::Serializer::with_formatter(&mut text, Lines { depth: 0 });
                Written(tree).serialize(&mut to).expect("a Vec takes all bytes");
                String::from_utf8(text).unwrap_or_default() + "\n"
            }
        }
    }
}

/// A tree as serializers see it.
struct Written<'a>(&'a Node);

/// A number, without a point where it is whole.
struct Number(f64);

impl Serialize for Written<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match &self.0.value {
            Value::List(items) => to.collect_seq(items.iter().map(Written)),
            Value::Points(points) => to.collect_seq(points.iter().map(|point| point.to_array().map(Number))),
            Value::Table(entries) => {
                to.collect_map(entries.iter().map(|(key, own)| (&key.value, Written(own))))
            }
            Value::Text(own) => to.serialize_str(own),
            Value::Formula(formula) => to.serialize_str(&formula.text),
            Value::Number(own) => Number(*own).serialize(to),
            Value::Truth(truth) => to.serialize_bool(*truth),
            Value::Other(kind) => to.serialize_str(kind),
        }
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let whole = self.0 as i64;
        // −0 is no integer.
        match (whole as f64).to_bits() == self.0.to_bits() {
            true => to.serialize_i64(whole),
            false => to.serialize_f64(self.0),
        }
    }
}

/// Writes the outer levels of JSON over several lines, all that is deeper on one.
struct Lines {
    depth: usize,
}

impl Lines {
    fn open<W: ?Sized + Write>(&mut self, to: &mut W, bracket: &[u8]) -> io::Result<()> {
        self.depth += 1;
        to.write_all(bracket)
    }

    fn close<W: ?Sized + Write>(&mut self, to: &mut W, bracket: &[u8]) -> io::Result<()> {
        self.depth -= 1;
        if self.depth < LEVELS {
            write!(to, "\n{}", "  ".repeat(self.depth))?;
        }
        to.write_all(bracket)
    }

    fn next<W: ?Sized + Write>(&self, to: &mut W, first: bool) -> io::Result<()> {
        match (self.depth <= LEVELS, first) {
            (true, true) => write!(to, "\n{}", "  ".repeat(self.depth)),
            (true, false) => write!(to, ",\n{}", "  ".repeat(self.depth)),
            (false, true) => Ok(()),
            (false, false) => to.write_all(b", "),
        }
    }
}

impl Formatter for Lines {
    fn begin_array<W: ?Sized + Write>(&mut self, to: &mut W) -> io::Result<()> {
        self.open(to, b"[")
    }

    fn end_array<W: ?Sized + Write>(&mut self, to: &mut W) -> io::Result<()> {
        self.close(to, b"]")
    }

    fn begin_array_value<W: ?Sized + Write>(&mut self, to: &mut W, first: bool) -> io::Result<()> {
        self.next(to, first)
    }

    fn begin_object<W: ?Sized + Write>(&mut self, to: &mut W) -> io::Result<()> {
        self.open(to, b"{")
    }

    fn end_object<W: ?Sized + Write>(&mut self, to: &mut W) -> io::Result<()> {
        self.close(to, b"}")
    }

    fn begin_object_key<W: ?Sized + Write>(&mut self, to: &mut W, first: bool) -> io::Result<()> {
        self.next(to, first)
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, to: &mut W) -> io::Result<()> {
        to.write_all(b": ")
    }
}

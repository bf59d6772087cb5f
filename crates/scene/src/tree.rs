//! A scene as a tree of values: what TOML, JSON and code have in common. Each value knows its place, bytes of
//! a text or a number that stands for it (`numbered`).

use std::{borrow::Cow, collections::BTreeSet, sync::Arc};

use radiosity_geom::DVec3;

use crate::{
    fault::Fault,
    place::{At, Span},
};

/// A value and where it stands.
pub type Node = At<Value>;

/// A value by kind.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
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
    /// A list of lists of three numbers.
    Points(Arc<Vec<DVec3>>),
    /// A table (TOML) or an object (JSON), in the order the parser gives.
    Table(Vec<(At<String>, Node)>),
    /// Something no scene uses: a date (TOML), `null` (JSON), an object of another language.
    Other(Cow<'static, str>),
}

/// A formula with its value, or with its fault and the place of that.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// The whole string, `=` included.
    pub text: String,
    /// Its value, or its fault and the place of that.
    pub outcome: Result<f64, At<Fault>>,
}

impl Value {
    /// Adds its keys and texts to these words.
    pub fn add_words(&self, words: &mut BTreeSet<String>) {
        match self {
            Self::Text(text) => drop(words.insert(text.clone())),
            Self::List(items) => items.iter().for_each(|item| item.value.add_words(words)),
            Self::Table(entries) => {
                for (key, item) in entries {
                    words.insert(key.value.clone());
                    item.value.add_words(words);
                }
            }
            Self::Formula(_) | Self::Number(_) | Self::Truth(_) | Self::Points(_) | Self::Other(_) => {}
        }
    }
}

/// Deeper nesting is refused, of values, parentheses, parts and files; a scene needs six levels. More would
/// only end in an overflow of the stack.
pub const DEEPEST: usize = 32;

/// Number of places that a point of [`Value::Points`] takes behind that of the list: its own, and those of
/// its coordinates.
pub(super) const PLACES_OF_POINT: usize = 4;

impl Value {
    /// The kind of value, for messages.
    pub fn kind(&self) -> Cow<'static, str> {
        match self {
            Value::Text(_) | Value::Formula(_) => "a text".into(),
            Value::Number(_) => "a number".into(),
            Value::Truth(_) => "true or false".into(),
            Value::List(_) | Value::Points(_) => "a list".into(),
            Value::Table(_) => "a table".into(),
            Value::Other(kind) => kind.clone(),
        }
    }
}

impl Node {
    /// Items of a list; none for other values.
    pub fn items(&self) -> Option<Cow<'_, [Node]>> {
        match &self.value {
            Value::List(items) => Some(Cow::Borrowed(items)),
            Value::Points(points) => {
                let points = points.iter().zip(self.point_places());
                Some(points.map(|(point, place)| coordinates(*point, place)).collect())
            }
            _ => None,
        }
    }

    /// Places of the items of a list; empty for other values.
    pub fn item_places(&self) -> Vec<Span> {
        match &self.value {
            Value::List(items) => items.iter().map(|item| item.span.clone()).collect(),
            Value::Points(points) => points.iter().zip(self.point_places()).map(|(_, place)| place).collect(),
            _ => Vec::new(),
        }
    }

    /// Places of the points of a list, one behind the other, without end.
    fn point_places(&self) -> impl Iterator<Item = Span> + use<> {
        (self.span.start + 1..).step_by(PLACES_OF_POINT).map(|start| start..start + PLACES_OF_POINT)
    }

    /// Moves the places of the value and of all values in it by `base` bytes, where its text begins in the
    /// whole source.
    pub fn shift(&mut self, base: usize) {
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
            Value::Text(_) | Value::Number(_) | Value::Truth(_) | Value::Points(_) | Value::Other(_) => {}
        }
    }
}

/// The list of the coordinates of a point of [`Value::Points`], which stands at `span`.
fn coordinates(point: DVec3, span: Span) -> Node {
    let numbers = point.to_array().into_iter().zip(span.start + 1..);
    let numbers = numbers.map(|(number, place)| At::new(Value::Number(number), &(place..place + 1)));
    At { value: Value::List(numbers.collect()), span }
}

/// The value of `key` in the entries of a table, if it is there.
pub fn entry<'a>(entries: &'a [(At<String>, Node)], key: &str) -> Option<&'a Node> {
    entries.iter().find(|(name, _)| name.value == key).map(|(_, node)| node)
}

/// A scene, or a value in it, that is made in code by the keys of scene files (docs/scene.md);
/// `radiosity_language::read` makes a scene of its [`Source`](crate::Source).
#[derive(Clone, Debug, PartialEq)]
pub struct Tree(pub(crate) Node);

impl Tree {
    /// A text; one that begins with `=` is a formula where a number is read.
    pub fn text(text: impl Into<String>) -> Self {
        Self::of(Value::Text(text.into()))
    }

    /// The node at the top of the tree.
    pub fn top(&self) -> &Node {
        &self.0
    }

    /// A number.
    pub fn number(number: f64) -> Self {
        Self::of(Value::Number(number))
    }

    /// True or false.
    pub fn flag(flag: bool) -> Self {
        Self::of(Value::Truth(flag))
    }

    /// A list.
    pub fn list(items: impl IntoIterator<Item = Tree>) -> Self {
        Self::of(Value::List(items.into_iter().map(|item| item.0).collect()))
    }

    /// A list of points, each as a list of its three coordinates.
    pub fn points(points: Vec<DVec3>) -> Self {
        Self::of(Value::Points(Arc::new(points)))
    }

    /// A table of values by key.
    pub fn table<K: Into<String>>(entries: impl IntoIterator<Item = (K, Tree)>) -> Self {
        let entries = entries.into_iter().map(|(key, item)| (At::new(key.into(), &(0..0)), item.0));
        Self::of(Value::Table(entries.collect()))
    }

    /// A value that no scene has, refused wherever it is read; `kind` names it in messages, such as `a date`.
    pub fn foreign(kind: impl Into<String>) -> Self {
        Self::of(Value::Other(Cow::Owned(kind.into())))
    }

    fn of(value: Value) -> Self {
        Tree(At::new(value, &(0..0)))
    }
}

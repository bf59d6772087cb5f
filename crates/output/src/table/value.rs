//! Values of tables.

use std::borrow::Cow;

use serde::Serialize;

use super::{Column, Digits};

/// A value of a table.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value<'a> {
    /// Nothing is known.
    None,
    /// A text.
    Text(Cow<'a, str>),
    /// A whole number.
    Count(u64),
    /// A number.
    Number(f64),
    /// Several numbers.
    Numbers(Cow<'a, [f64]>),
}

impl<'a> Value<'a> {
    /// Several numbers.
    pub fn numbers(numbers: impl Into<Cow<'a, [f64]>>) -> Self {
        Self::Numbers(numbers.into())
    }

    /// Its fields in CSV, in a column of `count` names.
    pub(super) fn fields(&self, count: usize) -> Vec<Cow<'_, str>> {
        match self {
            _ if count == 0 => Vec::new(),
            Self::None => vec![Cow::Borrowed(""); count],
            Self::Text(text) => vec![Cow::Borrowed(text)],
            Self::Count(count) => vec![count.to_string().into()],
            Self::Number(number) => vec![number.to_string().into()],
            Self::Numbers(numbers) => numbers.iter().map(|number| number.to_string().into()).collect(),
        }
    }

    /// Its text for people.
    pub(crate) fn told(&self, column: &Column) -> String {
        let number = |x: f64| match column.digits {
            Digits::All => x.to_string(),
            Digits::Decimals(digits) => format!("{x:.digits$}"),
            Digits::Mantissa(digits) => format!("{x:.digits$e}"),
        };
        match self {
            Self::None => "–".to_owned(),
            Self::Text(text) => text.clone().into_owned(),
            Self::Count(count) => count.to_string(),
            Self::Number(x) => number(*x),
            Self::Numbers(numbers) => numbers.iter().map(|x| number(*x)).collect::<Vec<_>>().join(" "),
        }
    }
}

impl From<String> for Value<'_> {
    fn from(text: String) -> Self {
        Self::Text(text.into())
    }
}

impl<'a> From<&'a str> for Value<'a> {
    fn from(text: &'a str) -> Self {
        Self::Text(text.into())
    }
}

impl From<usize> for Value<'_> {
    fn from(count: usize) -> Self {
        Self::Count(count as u64)
    }
}

impl From<f64> for Value<'_> {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl<'a, V: Into<Value<'a>>> From<Option<V>> for Value<'a> {
    fn from(value: Option<V>) -> Self {
        value.map_or(Self::None, Into::into)
    }
}

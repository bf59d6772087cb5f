//! What a side file states: values of materials, materials of surfaces, each with its line.

use std::borrow::Cow;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::Refusal;
use crate::fault::Fault;
use crate::mesh::GREATEST;
use crate::text::{number, short};

/// The table that gives surfaces their materials.
const SURFACES: &str = "surfaces";

/// Most characters of a message about TOML. Chosen; not tuned.
const LONGEST: usize = 160;

/// Something and the line that it stands in.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Lined<T> {
    /// What.
    pub(super) value: T,
    /// Its line, counted from 1.
    pub(super) line: usize,
}

/// The values of a material that a side file states.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Values {
    /// Diffuse reflectance, 0 to 1: of all bands or of each.
    pub(super) reflectance: Option<Lined<Vec<f64>>>,
    /// Exitance, ≥ 0: of all bands or of each.
    pub(super) emission: Option<Lined<Vec<f64>>>,
    /// Whether surfaces of it reflect and emit on both sides.
    pub(super) two_sided: Option<bool>,
}

/// All that a side file states, in its order.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Stated {
    /// Materials by name.
    pub(super) materials: Vec<(Lined<String>, Values)>,
    /// Names of surfaces, with a `*` at the end beginnings of names, and the names of their materials.
    pub(super) surfaces: Vec<(Lined<String>, String)>,
}

/// A file and where its lines begin.
struct Text<'a> {
    file: &'a str,
    lines: Vec<usize>,
}

impl Stated {
    /// What the text of `file` states.
    ///
    /// # Errors
    /// Text that is no TOML, keys that are not known, values of another kind or out of range.
    pub(super) fn of(text: &str, file: &str) -> Result<Self, Refusal> {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        let whole = Text { file, lines: std::iter::once(0).chain(ends.map(|(at, _)| at + 1)).collect() };
        let table = DeTable::parse(text).map_err(|error| {
            let message: String = error.message().chars().take(LONGEST).collect();
            let at = error.span().map_or(0, |span| span.start);
            whole.refusal(
                at,
                format!("this is no TOML: {message}"),
                "write [NAME] and below it reflectance = 0.8",
            )
        })?;
        let mut stated = Stated::default();
        for (key, value) in in_order(table.into_inner()) {
            let at = key.span().start;
            let name = Lined { value: key.into_inner().into_owned(), line: whole.line(at) };
            let DeValue::Table(entries) = value.into_inner() else {
                let cure = format!("write [{}] and below it reflectance = 0.8", short(&name.value));
                return Err(whole.refusal(at, format!("'{}' is no table", short(&name.value)), cure));
            };
            match name.value == SURFACES {
                true => stated.surfaces = whole.surfaces(entries)?,
                false => stated.materials.push((name, whole.values(entries)?)),
            }
        }
        Ok(stated)
    }
}

impl Text<'_> {
    fn line(&self, at: usize) -> usize {
        self.lines.partition_point(|line| *line <= at)
    }

    fn refusal(&self, at: usize, cause: String, cure: impl Into<String>) -> Refusal {
        Fault::new(cause, cure).in_line(self.file, self.line(at))
    }

    fn surfaces(&self, entries: DeTable<'_>) -> Result<Vec<(Lined<String>, String)>, Refusal> {
        let mut surfaces = Vec::new();
        for (key, value) in in_order(entries) {
            let at = key.span().start;
            let DeValue::String(material) = value.get_ref() else {
                let cause = format!("the material of '{}' is no name", short(key.get_ref()));
                return Err(self.refusal(at, cause, "write \"NAME\" = \"MATERIAL\""));
            };
            let name = Lined { value: key.get_ref().clone().into_owned(), line: self.line(at) };
            surfaces.push((name, material.clone().into_owned()));
        }
        Ok(surfaces)
    }

    fn values(&self, entries: DeTable<'_>) -> Result<Values, Refusal> {
        let mut values = Values::default();
        for (key, value) in in_order(entries) {
            let at = key.span().start;
            let line = self.line(at);
            match (key.get_ref().as_ref(), value.get_ref()) {
                ("reflectance", given) => {
                    values.reflectance =
                        Some(Lined { value: self.numbers(at, "reflectance", given, 1.0)?, line });
                }
                ("emission", given) => {
                    values.emission =
                        Some(Lined { value: self.numbers(at, "emission", given, GREATEST)?, line });
                }
                ("two_sided", DeValue::Boolean(is_two_sided)) => values.two_sided = Some(*is_two_sided),
                ("two_sided", _) => {
                    let cause = "two_sided is neither true nor false".to_owned();
                    return Err(self.refusal(at, cause, "write two_sided = true or two_sided = false"));
                }
                (other, _) => {
                    let cause = format!("materials have no '{}'", short(other));
                    return Err(self.refusal(at, cause, "write reflectance, emission or two_sided"));
                }
            }
        }
        Ok(values)
    }

    /// One number, or a list of them, all from 0 to `most`.
    fn numbers(&self, at: usize, what: &str, given: &DeValue<'_>, most: f64) -> Result<Vec<f64>, Refusal> {
        let numbers: Option<Vec<f64>> = match given {
            DeValue::Array(items) => items.iter().map(|item| of_value(item.get_ref())).collect(),
            one => of_value(one).map(|number| vec![number]),
        };
        let Some(numbers) = numbers.filter(|numbers| !numbers.is_empty()) else {
            let cause = format!("{what} is neither a number nor a list of finite numbers");
            return Err(self.refusal(at, cause, format!("write {what} = 0.8 or {what} = [0.8, 0.7, 0.6]")));
        };
        match numbers.iter().find(|number| !(0.0..=most).contains(*number)) {
            None => Ok(numbers),
            Some(out) => {
                let cure =
                    if most == 1.0 { "write numbers from 0 to 1" } else { "write numbers of 0 or more" };
                Err(self.refusal(at, format!("{what} is {out}"), cure))
            }
        }
    }
}

/// The finite number that a value is.
fn of_value(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Integer(integer) => {
            i64::from_str_radix(integer.as_str(), integer.radix()).ok().map(|x| x as f64)
        }
        DeValue::Float(float) => number(float.as_str(), "it").ok(),
        _ => None,
    }
}

/// The entries in the order they are written, which the parser's map does not keep.
fn in_order<'t>(table: DeTable<'t>) -> Vec<(Spanned<Cow<'t, str>>, Spanned<DeValue<'t>>)> {
    let mut entries: Vec<_> = table.into_iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries
}

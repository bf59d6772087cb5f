//! Parameters: values that `<default>` gives to names, and texts with `$name` in them.

use std::borrow::Cow;
use std::collections::HashMap;

use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::text::short;

use super::element::Sources;

/// Most bytes of a parameter's name; each length up to it is looked up where a text names one.
const LONGEST_NAME: usize = 100;
/// Most bytes of a parameter's value: numbers and names of files are shorter.
const LONGEST_VALUE: usize = 10_000;
/// Most bytes of a text with its parameters filled in, which may name one many times.
const LONGEST_TEXT: usize = 100_000;

/// The value of a parameter, and the files that it was made of.
#[derive(Debug)]
struct Parameter {
    value: String,
    sources: Sources,
}

/// The parameters that are known so far.
#[derive(Debug, Default)]
pub(super) struct Parameters {
    values: HashMap<String, Parameter>,
}

impl Parameters {
    /// Gives a parameter its value, which was made of these files, unless it has one.
    ///
    /// # Errors
    /// A name without characters, a name or a value that is too long.
    pub(super) fn add(&mut self, name: &str, value: &str, sources: Sources) -> Result<(), Refusal> {
        if name.is_empty() {
            return refuse("a parameter has no name", "write name=\"…\" in <default>");
        }
        if name.len() > LONGEST_NAME || value.len() > LONGEST_VALUE {
            return refuse(
                format!(
                    "the parameter '{}' is longer than {LONGEST_NAME} or its value than {LONGEST_VALUE} bytes",
                    short(name)
                ),
                "write the value in its place",
            );
        }
        self.values.entry(name.to_owned()).or_insert_with(|| Parameter { value: value.to_owned(), sources });
        Ok(())
    }

    /// `text` with the values of its parameters, the files of which are added to `sources`. Of several names that
    /// fit behind a `$` the longest counts;
    /// `\$` is a `$`.
    ///
    /// # Errors
    /// A parameter that has no value, and a text that becomes too long.
    pub(super) fn fill<'t>(&self, text: &'t str, sources: &mut Sources) -> Result<Cow<'t, str>, Refusal> {
        if !text.contains('$') {
            return Ok(Cow::Borrowed(text));
        }
        let (mut filled, mut rest) = (String::new(), text);
        while let Some((before, behind)) = rest.split_once('$') {
            match before.strip_suffix('\\') {
                Some(before) => {
                    filled.push_str(before);
                    filled.push('$');
                    rest = behind;
                }
                None => {
                    let (name, Parameter { value, sources: own }) = self.first(behind)?;
                    filled.push_str(before);
                    filled.push_str(value);
                    sources.extend(own.iter().cloned());
                    rest = &behind[name..];
                }
            }
            if filled.len() > LONGEST_TEXT {
                return refuse(
                    format!("a text with its parameters is longer than {LONGEST_TEXT} bytes"),
                    "shorten it",
                );
            }
        }
        filled.push_str(rest);
        Ok(Cow::Owned(filled))
    }

    /// Length (bytes) of the name that `text` begins with, and that parameter.
    fn first(&self, text: &str) -> Result<(usize, &Parameter), Refusal> {
        let ends = (1..=text.len().min(LONGEST_NAME)).rev().filter(|end| text.is_char_boundary(*end));
        let known = ends.filter_map(|end| Some((end, self.values.get(&text[..end])?))).next();
        known.ok_or_else(|| {
            let is_of_name = |c: char| c.is_alphanumeric() || c == '_';
            let end = text.find(|c| !is_of_name(c)).unwrap_or(text.len());
            let name = short(&text[..end]);
            Refusal::new(
                format!("the parameter ${name} has no value"),
                format!("write <default name=\"{name}\" value=\"…\"/> above, or the value in its place"),
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_name_and_the_first_value_count() {
        let mut parameters = Parameters::default();
        for (name, value) in [("a", "1"), ("ab", "2"), ("a", "3"), ("é", "4")] {
            let source = Sources::from([value.into()]);
            assert_eq!(parameters.add(name, value, source), Ok(()));
        }
        let told = [("$a", "1"), ("$ab$a", "21"), ("$ac", "1c"), ("x\\$a", "x$a"), ("$é$é", "44"), ("", "")];
        for (text, expected) in told {
            assert_eq!(parameters.fill(text, &mut Sources::new()).as_deref(), Ok(expected), "{text}");
        }
        let mut sources = Sources::new();
        assert!(parameters.fill("$ab$a$ab", &mut sources).is_ok());
        assert_eq!(sources.iter().map(|own| &**own).collect::<Vec<_>>(), ["1", "2"]);
        for text in ["$", "$c", "1$ ab"] {
            let filled = parameters.fill(text, &mut Sources::new());
            assert!(filled.is_err_and(|fault| fault.cause.contains("has no value")), "{text}");
        }
    }

    #[test]
    fn texts_do_not_grow_without_end() {
        let mut parameters = Parameters::default();
        let mut add = |name: &str, value: &str| parameters.add(name, value, Sources::new());
        assert_eq!(add("a", &"1".repeat(9999)), Ok(()));
        assert!(add("b", &"1".repeat(10_001)).is_err());
        assert!(add(&"b".repeat(101), "1").is_err());
        assert!(add("", "1").is_err());
        assert!(parameters.fill(&"$a".repeat(99_999), &mut Sources::new()).is_err());
    }
}

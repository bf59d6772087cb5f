//! Sentences of messages in which options and commands are data: each front end calls them as its users type
//! them.
//!
//! Text that a user gave, such as the name of a file, is text, whatever it looks like. `Display` writes the
//! sentence as the command line has it: `--shadow-eps 1e-3`, `` `radiosity check` ``.

use std::fmt;
use std::ops::Add;

use serde::{Serialize, Serializer};

/// A sentence of a message.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wording {
    parts: Vec<Part>,
}

/// A part of a sentence, by which front ends tell text from options and commands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Part {
    /// Text as it is.
    Text(String),
    /// An option, with its value if that is said.
    Option {
        /// Name of the option, words joined by `-`.
        name: &'static str,
        /// Value of the option, if that is said.
        value: Option<String>,
    },
    /// Another value of an option that was named before.
    Value(&'static str),
    /// A verb of the command, such as `check`.
    Command(&'static str),
}

/// Text as it is.
pub fn words(text: impl Into<String>) -> Wording {
    Part::Text(text.into()).into()
}

/// An option by its name, words joined by `-`.
pub fn option(name: &'static str) -> Wording {
    Part::Option { name, value: None }.into()
}

/// An option that is set to a value.
pub fn set(name: &'static str, value: impl fmt::Display) -> Wording {
    Part::Option { name, value: Some(value.to_string()) }.into()
}

/// Another value of an option that was named before: `--solver cg or gmres`.
pub fn value(name: &'static str) -> Wording {
    Part::Value(name).into()
}

/// A verb of the command.
pub fn command(name: &'static str) -> Wording {
    Part::Command(name).into()
}

impl Wording {
    /// The sentence, with each part as `spell` writes it.
    pub fn spelt(&self, spell: impl Fn(&Part) -> String) -> String {
        self.parts.iter().map(spell).collect()
    }
}

impl fmt::Display for Wording {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.parts.iter().try_for_each(|part| part.fmt(f))
    }
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text(text) => f.write_str(text),
            Self::Option { name, value: None } => write!(f, "--{name}"),
            Self::Option { name, value: Some(value) } => write!(f, "--{name} {value}"),
            Self::Value(name) => f.write_str(name),
            Self::Command(name) => write!(f, "`radiosity {name}`"),
        }
    }
}

impl Serialize for Wording {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl From<Part> for Wording {
    fn from(part: Part) -> Self {
        Self { parts: vec![part] }
    }
}

impl From<&str> for Wording {
    fn from(text: &str) -> Self {
        words(text)
    }
}

impl From<String> for Wording {
    fn from(text: String) -> Self {
        words(text)
    }
}

impl<T: Into<Wording>> Add<T> for Wording {
    type Output = Wording;

    fn add(mut self, more: T) -> Wording {
        self.parts.append(&mut more.into().parts);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_and_verbs_are_spelt_and_text_is_not() {
        let told = words("--eps of `radiosity check`: ")
            + set("shadow-eps", 1e-3)
            + ", "
            + option("for")
            + " or "
            + command("check");
        assert_eq!(
            told.to_string(),
            "--eps of `radiosity check`: --shadow-eps 0.001, --for or `radiosity check`"
        );
        let spelt = told.spelt(|part| match part {
            Part::Text(text) => text.clone(),
            Part::Option { name, value } => format!("<{name} {value:?}>"),
            Part::Value(name) | Part::Command(name) => format!("<{name}>"),
        });
        assert_eq!(spelt, "--eps of `radiosity check`: <shadow-eps Some(\"0.001\")>, <for None> or <check>");
    }
}

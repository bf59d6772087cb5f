//! Numbers in a row: words of a text, each with its line, read one after another.

use std::borrow::Cow;
use std::fmt;

use crate::error::{Refusal, refuse_at};
use crate::file_place::FilePlace;
use crate::text::{number, short, told};

/// The name of one number among several.
struct Nth<'a> {
    what: &'a str,
    index: usize,
    count: usize,
}

impl fmt::Display for Nth<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({} of {})", self.what, self.index + 1, self.count)
    }
}

/// Reads words as numbers, one after another. A decimal comma counts as a decimal point.
pub(crate) struct Numbers<'a> {
    words: Box<dyn Iterator<Item = (usize, &'a str)> + 'a>,
    /// Line of the word that was read last.
    line: usize,
}

impl<'a> Numbers<'a> {
    /// Reads `words`, which come with their lines; `line` is the line where they begin.
    pub(crate) fn new(words: impl Iterator<Item = (usize, &'a str)> + 'a, line: usize) -> Self {
        Self { words: Box::new(words), line }
    }

    /// Place of the word that was read last.
    pub(crate) fn place(&self) -> FilePlace {
        FilePlace::Line(self.line)
    }

    /// A fault at the word that was read last.
    pub(crate) fn fault(&self, cause: impl Into<String>, cure: impl Into<String>) -> Refusal {
        Refusal::new(cause, cure).at(self.place())
    }

    /// The next word. `what` names it: "the multiplier".
    pub(crate) fn word(&mut self, what: impl fmt::Display) -> Result<&'a str, Refusal> {
        match self.words.next() {
            Some((line, word)) => {
                self.line = line;
                Ok(word)
            }
            None => {
                Err(self
                    .fault(format!("the text ends before {what}"), "complete it, or fetch the file again"))
            }
        }
    }

    /// The next number.
    pub(crate) fn next(&mut self, what: impl fmt::Display) -> Result<f64, Refusal> {
        let word = self.word(&what)?;
        self.parse(word, what)
    }

    /// The next number, 0 where the word is blank.
    pub(crate) fn next_or_zero(&mut self, what: impl fmt::Display) -> Result<f64, Refusal> {
        match self.word(&what)? {
            "" => Ok(0.0),
            word => self.parse(word, what),
        }
    }

    fn parse(&self, word: &str, what: impl fmt::Display) -> Result<f64, Refusal> {
        let has_decimal_comma = word.matches(',').count() == 1 && !word.contains('.');
        let word: Cow<str> = if has_decimal_comma { word.replace(',', ".").into() } else { word.into() };
        match word.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            _ => number(&word, &what.to_string()).map_err(|fault| fault.at(self.place())),
        }
    }

    /// The next number, which is at least 0.
    pub(crate) fn amount(&mut self, what: impl fmt::Display) -> Result<f64, Refusal> {
        let value = self.next(&what)?;
        self.no_less(value, what)
    }

    /// The next number, which is at least 0; 0 where the word is blank.
    pub(crate) fn amount_or_zero(&mut self, what: impl fmt::Display) -> Result<f64, Refusal> {
        let value = self.next_or_zero(&what)?;
        self.no_less(value, what)
    }

    fn no_less(&self, value: f64, what: impl fmt::Display) -> Result<f64, Refusal> {
        match value >= 0.0 {
            // −0 is 0.
            true => Ok(value.abs()),
            false => Err(self.fault(format!("{what} is {}", told(value)), "write a number of at least 0")),
        }
    }

    /// The next number, which is above 0.
    pub(crate) fn factor(&mut self, what: impl fmt::Display) -> Result<f64, Refusal> {
        let value = self.next(&what)?;
        match value > 0.0 {
            true => Ok(value),
            false => Err(self.fault(format!("{what} is {}", told(value)), "write a number above 0")),
        }
    }

    /// The next number, which is whole and from `least` to `most`.
    pub(crate) fn whole(&mut self, what: &str, least: usize, most: usize) -> Result<usize, Refusal> {
        let value = self.next(what)?;
        let is_right = value.fract() == 0.0 && value >= least as f64 && value <= most as f64;
        match is_right {
            true => Ok(value as usize),
            false => Err(self.fault(
                format!("{what} is {}", told(value)),
                format!("write a whole number from {least} to {most}"),
            )),
        }
    }

    /// The next `count` numbers, each greater than the one before it. `what` is one of them: "a vertical
    /// angle".
    pub(crate) fn increasing(&mut self, count: usize, what: &str) -> Result<Vec<f64>, Refusal> {
        let mut values: Vec<f64> = Vec::new();
        for index in 0..count {
            let value = self.next(Nth { what, index, count })?;
            if let Some(before) = values.last().filter(|before| **before >= value) {
                return Err(self.fault(
                    format!("{what} is {} behind {}", told(value), told(*before)),
                    "let the angles increase; check the counts of angles above",
                ));
            }
            values.push(value);
        }
        Ok(values)
    }

    /// The next `count` numbers, each at least 0.
    pub(crate) fn amounts(&mut self, count: usize, what: &str) -> Result<Vec<f64>, Refusal> {
        // No room is kept beforehand: a count is no promise that so many follow.
        (0..count).map(|index| self.amount(Nth { what, index, count })).collect()
    }

    /// Checks that no number follows.
    pub(crate) fn end(&mut self) -> Result<(), Refusal> {
        let left = self.words.find(|(_, word)| word.replace(',', ".").parse::<f64>().is_ok());
        match left {
            None => Ok(()),
            Some((line, word)) => refuse_at(
                FilePlace::Line(line),
                format!("'{}' is left over", short(word)),
                "check the counts of angles; they say how many intensities there are",
            ),
        }
    }
}

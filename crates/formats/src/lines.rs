//! Lines of a text: a backslash at the end of a line joins it with the next, in MGF of a comment too.

use std::borrow::Cow;

/// A line with those that it is continued by.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Line<'a> {
    /// Number of its first line, from 1.
    pub(crate) number: usize,
    /// Text of the line; blanks stand for the ends of lines.
    pub(crate) text: Cow<'a, str>,
}

/// A reading of lines, which can go back to a place where it was.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lines<'a> {
    text: &'a str,
    at: usize,
    number: usize,
    /// The part of a line as it stands that counts.
    plain: fn(&str) -> &str,
}

impl<'a> Lines<'a> {
    /// A reading from the first line on, of which the part counts that `plain` leaves.
    pub(crate) fn new(text: &'a str, plain: fn(&str) -> &str) -> Self {
        Self { text, at: 0, number: 1, plain }
    }

    /// Number of the line that comes next.
    pub(crate) fn number(&self) -> usize {
        self.number
    }

    /// One line as it stands, without its end.
    fn physical(&mut self) -> Option<&'a str> {
        let rest = self.text.get(self.at..).filter(|rest| !rest.is_empty())?;
        let (line, used) = match rest.find('\n') {
            Some(end) => (&rest[..end], end + 1),
            None => (rest, rest.len()),
        };
        self.at += used;
        self.number += 1;
        Some((self.plain)(line.strip_suffix('\r').unwrap_or(line)))
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        let number = self.number;
        let mut last = self.physical()?;
        if !last.ends_with('\\') {
            return Some(Line { number, text: last.into() });
        }
        let mut text = String::new();
        while let Some(start) = last.strip_suffix('\\') {
            text.push_str(start);
            text.push(' ');
            last = self.physical().unwrap_or("");
        }
        text.push_str(last);
        Some(Line { number, text: text.into() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn continued_lines_are_one_and_numbers_go_on() {
        let told: Vec<(usize, String)> = Lines::new("a\\\r\nb \\\nc\n\n# d\\\ne\nf\\", |line| line)
            .map(|line| (line.number, line.text.into()))
            .collect();
        let expected = [(1, "a b  c"), (4, ""), (5, "# d e"), (7, "f ")];
        assert_eq!(told, expected.map(|(number, text)| (number, text.to_owned())));
    }
}

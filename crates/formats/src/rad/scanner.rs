//! The words of a Radiance scene: primitives, commands, comments.
//!
//! Source: Radiance reference manual, "Scene Description": a primitive is modifier, type and name, then three
//! lists, each with its count before it: texts, integers (none), numbers. An alias has the name of another
//! modifier instead.

use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::text::{number, short};

/// An item of a scene and the line that it begins in.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Item {
    /// A line that begins with `!`, without it; continued lines are joined.
    Command(String),
    /// A surface, a material, a pattern, …
    Primitive(Primitive),
}

/// A surface, a material, a pattern, …
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Primitive {
    /// The name of what it is made of, or `void`.
    pub(super) modifier: String,
    /// Type of the primitive: `polygon`, `plastic`, …
    pub(super) kind: String,
    /// Name of the primitive.
    pub(super) name: String,
    /// Text arguments; of an alias the name that it stands for.
    pub(super) strings: Vec<String>,
    /// Real arguments.
    pub(super) reals: Vec<f64>,
}

/// A reading of a text.
#[derive(Debug)]
pub(super) struct Scanner<'a> {
    rest: &'a str,
    line: usize,
}

impl<'a> Scanner<'a> {
    /// A reading from the start of a text.
    pub(super) fn new(text: &'a str) -> Self {
        Self { rest: text, line: 1 }
    }

    /// The line that is being read.
    pub(super) fn line(&self) -> usize {
        self.line
    }

    /// Number of bytes that are left.
    pub(super) fn left(&self) -> usize {
        self.rest.len()
    }

    /// The next item and its line; none at the end.
    ///
    /// # Errors
    /// A primitive that is cut off, or whose counts and numbers are none.
    pub(super) fn next(&mut self) -> Result<Option<(usize, Item)>, Refusal> {
        self.skip_comments();
        let line = self.line;
        if self.rest.is_empty() {
            return Ok(None);
        }
        if self.rest.starts_with('!') {
            return Ok(Some((line, Item::Command(self.command()))));
        }
        let mut primitive = Primitive {
            modifier: self.word("a modifier")?,
            kind: self.word("a type")?,
            name: self.word("a name")?,
            ..Primitive::default()
        };
        if primitive.kind == "alias" {
            primitive.strings.push(self.word("the name that an alias stands for")?);
            return Ok(Some((line, Item::Primitive(primitive))));
        }
        for _ in 0..self.count("texts")? {
            primitive.strings.push(self.word("a text")?);
        }
        for _ in 0..self.count("integers")? {
            self.number()?;
        }
        for _ in 0..self.count("numbers")? {
            let value = self.number()?;
            primitive.reals.push(value);
        }
        Ok(Some((line, Item::Primitive(primitive))))
    }

    fn skip(&mut self, bytes: usize) -> &'a str {
        let (skipped, rest) = self.rest.split_at(bytes);
        self.line += skipped.bytes().filter(|byte| *byte == b'\n').count();
        self.rest = rest;
        skipped
    }

    fn skip_blanks(&mut self) {
        self.skip(self.rest.find(|c: char| !c.is_ascii_whitespace()).unwrap_or(self.rest.len()));
    }

    fn skip_comments(&mut self) {
        self.skip_blanks();
        while self.rest.starts_with('#') {
            self.skip(self.rest.find('\n').unwrap_or(self.rest.len()));
            self.skip_blanks();
        }
    }

    /// A line from behind its `!` on.
    fn command(&mut self) -> String {
        let mut command = String::new();
        loop {
            let end = self.rest.find('\n').map_or(self.rest.len(), |end| end + 1);
            let line = self.skip(end).trim_end_matches(['\n', '\r']);
            match line.strip_suffix('\\') {
                Some(line) if !self.rest.is_empty() => {
                    command.push_str(line);
                    command.push(' ');
                }
                _ => {
                    command.push_str(line);
                    return command.trim_start_matches('!').to_owned();
                }
            }
        }
    }

    /// The next word, in quotes if it has blanks.
    fn word(&mut self, what: &str) -> Result<String, Refusal> {
        self.skip_blanks();
        if let Some(quote) = self.rest.chars().next().filter(|c| *c == '"' || *c == '\'')
            && let Some(end) = self.rest[1..].find(quote)
        {
            let word = self.skip(end + 2);
            return Ok(word[1..=end].to_owned());
        }
        match self.skip(self.rest.find(|c: char| c.is_ascii_whitespace()).unwrap_or(self.rest.len())) {
            "" => Err(cut_off(what)),
            word => Ok(word.to_owned()),
        }
    }

    fn count(&mut self, what: &str) -> Result<usize, Refusal> {
        self.skip_comments();
        let word = self.word(&format!("the number of {what}"))?;
        let count: usize = word.parse().map_err(|_| {
            Refusal::new(
                format!("'{}' is no number of {what}", short(&word)),
                "write how many follow: a primitive has three lists, each with its count before it",
            )
        })?;
        // Each needs a blank and a character.
        match count <= self.rest.len() {
            true => Ok(count),
            false => refuse(
                format!("{count} {what} are announced, more than the file holds"),
                "write how many follow",
            ),
        }
    }

    fn number(&mut self) -> Result<f64, Refusal> {
        self.skip_comments();
        let word = self.word("a number")?;
        number(&word, "a number")
    }
}

fn cut_off(what: &str) -> Refusal {
    Refusal::new(
        format!("the file ends where {what} must stand"),
        "complete the last primitive: modifier, type, name, and three lists with their counts",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn items(text: &str) -> Vec<(usize, Item)> {
        let mut scanner = Scanner::new(text);
        let mut found = Vec::new();
        while let Some(item) = scanner.next().expect("this text is right") {
            found.push(item);
        }
        found
    }

    #[test]
    fn primitives_commands_and_comments_are_told_apart() {
        let found = items(
            "# head\n\nvoid plastic 'light red'\n0 0 # none\n5 .5 .1 .1 0 0\n!xform -t 1 0 0 \\\r\n a.rad\nm alias n o",
        );
        let told: Vec<usize> = found.iter().map(|(line, _)| *line).collect();
        assert_eq!(told, [3, 6, 8]);
        let Item::Primitive(plastic) = &found[0].1 else { panic!("a primitive") };
        assert_eq!((plastic.name.as_str(), plastic.reals.len()), ("light red", 5));
        assert_eq!(found[1].1, Item::Command("xform -t 1 0 0   a.rad".to_owned()));
        let Item::Primitive(alias) = &found[2].1 else { panic!("a primitive") };
        assert_eq!(alias.strings, ["o"]);
    }

    #[test]
    fn what_is_cut_off_is_refused() {
        for text in ["void", "void plastic m 0 0 5 1", "void plastic m 0 0 1e9", "m polygon p 0 0 99999999"] {
            assert!(Scanner::new(text).next().is_err_and(|fault| !fault.cure.is_empty()), "{text}");
        }
    }
}

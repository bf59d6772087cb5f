//! Words of notes, in which what a file says is marked.

use std::fmt;
use std::ops::{Deref, Range};

use radiosity_work::listed::Between;

/// Stands for what is hidden.
const HIDDEN: &str = "…";

/// Words of a note, without a full stop; names and words that a file says in it are marked, and can be hidden.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct NoteText {
    text: String,
    /// Bytes of the text that a file says, in their order.
    quoted: Vec<Range<usize>>,
}

impl NoteText {
    /// Own words, which hold numbers of a file at the most.
    pub fn own(words: impl Into<String>) -> Self {
        Self { text: words.into(), quoted: Vec::new() }
    }

    /// The text with what a file says, as it is to be shown, behind it.
    #[must_use]
    pub fn quoting(mut self, said: impl AsRef<str>) -> Self {
        let start = self.text.len();
        self.text += said.as_ref();
        self.quoted.push(start..self.text.len());
        self
    }

    /// The text with own words behind it.
    #[must_use]
    pub fn then(mut self, words: impl AsRef<str>) -> Self {
        self.text += words.as_ref();
        self
    }

    /// The text with another behind it.
    #[must_use]
    pub fn followed(mut self, other: &Self) -> Self {
        let start = self.text.len();
        self.text += &other.text;
        self.quoted.extend(other.quoted.iter().map(|own| start + own.start..start + own.end));
        self
    }

    /// The text with a name that a file says behind it, in double quotes.
    #[must_use]
    pub fn naming(self, name: impl AsRef<str>) -> Self {
        self.quoting(format!("{:?}", name.as_ref()))
    }

    /// The text with names that a file says behind it, a few of many: `"a", "b" and "c"`.
    #[must_use]
    pub fn naming_all(self, names: &[impl AsRef<str>]) -> Self {
        let Between { before, behind } = Between::of(names.len());
        before
            .iter()
            .zip(names)
            .fold(self, |text, (before, name)| text.then(before).naming(name))
            .then(behind)
    }

    /// All of it.
    pub fn as_str(&self) -> &str {
        &self.text
    }

    /// The own words, with an ellipsis for each thing that a file says.
    pub fn without_quotes(&self) -> String {
        let mut shown = String::new();
        let mut end = 0;
        for own in &self.quoted {
            shown = shown + &self.text[end..own.start] + HIDDEN;
            end = own.end;
        }
        shown + &self.text[end..]
    }
}

impl From<&'static str> for NoteText {
    fn from(words: &'static str) -> Self {
        Self::own(words)
    }
}

impl Deref for NoteText {
    type Target = str;

    fn deref(&self) -> &str {
        &self.text
    }
}

impl fmt::Display for NoteText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_hidden_with_their_quotes() {
        let text =
            NoteText::default().naming("a \"b\" \\").then(" lies on ").naming("c\\").then("; it was raised");
        assert_eq!(text.without_quotes(), "… lies on …; it was raised");
        let many = NoteText::from("the ").naming_all(&["a", "b", "c", "d", "e", "f"]).then(" \"own\"");
        assert_eq!(many.as_str(), r#"the "a", "b", "c", "d" and 2 more "own""#);
        assert_eq!(many.without_quotes(), r#"the …, …, …, … and 2 more "own""#);
    }

    #[test]
    fn what_a_file_says_is_hidden_whatever_its_signs() {
        let text = NoteText::from("the lamp's material ").quoting("'it's \"so\" é'").then(" is left out");
        assert_eq!(text.as_str(), "the lamp's material 'it's \"so\" é' is left out");
        assert_eq!(text.without_quotes(), "the lamp's material … is left out");
        let inner = NoteText::from("of meshes: ").followed(&text).quoting("x");
        assert_eq!(inner.as_str(), "of meshes: the lamp's material 'it's \"so\" é' is left outx");
        assert_eq!(inner.without_quotes(), "of meshes: the lamp's material … is left out…");
        assert_eq!(
            NoteText::from("the lamp's light is 'left' out").without_quotes(),
            "the lamp's light is 'left' out"
        );
    }
}

//! Words of notes, in which what a file says is marked.

use std::fmt;
use std::ops::{Deref, Range};

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

    /// Words in which double quotes stand about what a file says alone, as `{:?}` writes them.
    pub fn with_quotes(words: impl Into<String>) -> Self {
        let text = words.into();
        let (mut quoted, mut start, mut is_escaped) = (Vec::new(), None, false);
        for (at, sign) in text.char_indices() {
            match (sign, start) {
                _ if is_escaped => is_escaped = false,
                ('\\', Some(_)) => is_escaped = true,
                ('"', Some(begin)) => {
                    quoted.push(begin..at + 1);
                    start = None;
                }
                ('"', None) => start = Some(at),
                _ => {}
            }
        }
        Self { text, quoted }
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
    fn what_stands_in_quotes_is_hidden_with_its_quotes() {
        let text = format!("{:?} lies on {:?}; it was raised", "a \"b\" \\", "c\\");
        assert_eq!(NoteText::with_quotes(text).without_quotes(), "… lies on …; it was raised");
        assert_eq!(NoteText::with_quotes("it's 'own'").without_quotes(), "it's 'own'");
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

//! JSON whose parts know where they stand.

use radiosity_photometry::error::Refusal;
use radiosity_photometry::file_place::FilePlace;
use serde::Deserialize;
use serde_json::value::RawValue;

use super::container::Parts;
use crate::tolerances::LONGEST_CAUSE;

/// A text of JSON.
#[derive(Debug)]
pub(super) struct Json<'a> {
    text: &'a str,
    /// Byte of a binary file at which the text begins; none in a text file.
    start: Option<usize>,
    /// Bytes of the text at which its lines begin.
    lines: Vec<usize>,
}

impl<'a> Json<'a> {
    /// The text of a file.
    pub(super) fn new(parts: &Parts<'a>) -> Self {
        let ends = parts.text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        let lines = std::iter::once(0).chain(ends.map(|(at, _)| at + 1)).collect();
        Json { text: parts.text, start: parts.start, lines }
    }

    /// The whole text.
    pub(super) fn text(&self) -> &'a str {
        self.text
    }

    /// Place at which a part of the text begins: the line in a text file, the byte in a binary one.
    pub(super) fn place(&self, part: &str) -> FilePlace {
        self.at((part.as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize))
    }

    /// Place of byte `at` of the text.
    fn at(&self, at: usize) -> FilePlace {
        match self.start {
            Some(start) => FilePlace::Byte(start + at),
            None => FilePlace::Line(self.lines.partition_point(|line| *line <= at).max(1)),
        }
    }

    /// Value of a part of the text; `what` names the part in messages: "the node 3".
    ///
    /// # Errors
    /// Text that is no JSON, members that are missing or of another kind.
    pub(super) fn parse<T: Deserialize<'a>>(&self, part: &'a str, what: &str) -> Result<T, Refusal> {
        serde_json::from_str(part).map_err(|error| {
            let lines = || part.match_indices('\n').map(|(at, _)| at + 1);
            let line = if error.line() < 2 { Some(0) } else { lines().nth(error.line() - 2) };
            let inside = (line.unwrap_or(0) + error.column().saturating_sub(1)).min(part.len());
            let start = (part.as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize);
            let message = error.to_string();
            let message = message.rsplit_once(" at line ").map_or(message.as_str(), |(cause, _)| cause);
            let message: String = message.chars().take(LONGEST_CAUSE).collect();
            Refusal::new(format!("{what}: {message}"), "correct it, or export the model again")
                .at(self.at(start + inside))
        })
    }

    /// Value of the item `index` of a list, and its place; `what` names items in messages: "node". `from` is
    /// the place that refers to the item.
    ///
    /// # Errors
    /// An index beyond the list, and as [`Json::parse`].
    pub(super) fn item<T: Deserialize<'a>>(
        &self,
        list: &[&'a RawValue],
        index: usize,
        what: &str,
        from: FilePlace,
    ) -> Result<(T, FilePlace), Refusal> {
        let Some(item) = list.get(index) else {
            return Err(unlisted(what, index, list.len()).at(from));
        };
        let value = self.parse(item.get(), &format!("the {what} {index}"))?;
        Ok((value, self.place(item.get())))
    }
}

/// Refusal of the index of an item that a list of so many does not have.
pub(super) fn unlisted(what: &str, index: usize, count: usize) -> Refusal {
    Refusal::new(
        format!("the {what} {index} is named, {count} are listed, from 0 on"),
        "correct the index, or export the model again",
    )
}

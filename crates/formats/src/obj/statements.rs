//! Statements of OBJ and MTL: lines without comments, joined where they end with a backslash.
//!
//! A number sign begins a comment at the beginning of a line or behind a blank. Where a statement gives a
//! name, a blank has to follow too: programs write `usemtl Material #25`.

use std::borrow::Cow;

use crate::lines::{Line, Lines};

/// Statements that give a name.
const NAMED: [&str; 5] = ["o", "g", "usemtl", "newmtl", "mtllib"];

/// The statements of a text, each with the line that it begins in. Blank ones are left out.
pub(super) fn statements(text: &str) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
    Lines::new(text, plain).map(trimmed).filter(|(_, statement)| !statement.is_empty())
}

fn trimmed(Line { number, text }: Line<'_>) -> (usize, Cow<'_, str>) {
    match text {
        Cow::Borrowed(text) => (number, Cow::Borrowed(text.trim())),
        Cow::Owned(text) => (number, Cow::Owned(text.trim().to_owned())),
    }
}

/// A line without its comment.
fn plain(line: &str) -> &str {
    let (keyword, _) = split(line.trim_start());
    let is_named = NAMED.iter().any(|known| known.eq_ignore_ascii_case(keyword));
    let is_comment = |at: &usize| {
        line[..*at].chars().next_back().is_none_or(char::is_whitespace)
            && (!is_named || line[at + 1..].chars().next().is_none_or(char::is_whitespace))
    };
    let end = line.match_indices('#').map(|(at, _)| at).find(is_comment).unwrap_or(line.len());
    line[..end].trim_end()
}

/// The first word and what follows it.
pub(super) fn split(statement: &str) -> (&str, &str) {
    let (keyword, rest) = statement.split_once(char::is_whitespace).unwrap_or((statement, ""));
    (keyword, rest.trim())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_go_and_lines_are_joined() {
        let text = "# C:\\models\\\nv 1 2 \\\n  3 # three\n\nusemtl a#1 #2 # 3\nf 1 2 3 \\";
        let found: Vec<(usize, String)> = statements(text).map(|(line, x)| (line, x.into_owned())).collect();
        let expected = [(2, "v 1 2    3"), (5, "usemtl a#1 #2"), (6, "f 1 2 3")];
        assert_eq!(found, expected.map(|(line, x)| (line, x.to_owned())));
    }
}

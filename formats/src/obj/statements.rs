//! Statements of OBJ and MTL: lines without comments, joined where they end with a backslash.

use std::borrow::Cow;

/// The statements of a text, each with the line that it begins in. Blank ones are left out.
pub(super) fn statements(text: &str) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
    let mut lines = text.lines().enumerate();
    std::iter::from_fn(move || {
        loop {
            let (index, line) = lines.next()?;
            let mut statement = Cow::Borrowed(plain(line));
            while let Some(start) = statement.strip_suffix('\\') {
                let next = lines.next().map_or("", |(_, line)| plain(line));
                let mut joined = start.to_owned();
                joined.push(' ');
                joined.push_str(next);
                statement = Cow::Owned(joined);
            }
            let statement = match statement {
                Cow::Borrowed(statement) => Cow::Borrowed(statement.trim()),
                Cow::Owned(statement) => Cow::Owned(statement.trim().to_owned()),
            };
            if !statement.is_empty() {
                return Some((index + 1, statement));
            }
        }
    })
}

/// A line without its comment: a number sign at its beginning or behind a blank, so that names may hold one.
fn plain(line: &str) -> &str {
    let is_comment = |at: &usize| line[..*at].chars().next_back().is_none_or(char::is_whitespace);
    let end = line.match_indices('#').map(|(at, _)| at).find(is_comment).unwrap_or(line.len());
    line[..end].trim_end()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_go_and_lines_are_joined() {
        let text = "# C:\\models\\\nv 1 2 \\\n  3 # three\n\nusemtl a#1\nf 1 2 3 \\";
        let found: Vec<(usize, String)> = statements(text).map(|(line, x)| (line, x.into_owned())).collect();
        let expected = [(2, "v 1 2    3"), (5, "usemtl a#1"), (6, "f 1 2 3")];
        assert_eq!(found, expected.map(|(line, x)| (line, x.to_owned())));
    }
}

//! Lists of names in messages.

use std::borrow::Cow;

use crate::printable::printable;

/// Most names that a message spells out. Chosen: about a line of a terminal.
pub const SPELT: usize = 5;

/// Most names that a list spells out which stands by itself. Chosen: a screen of them.
pub const LONG: usize = 20;

/// Names parted by commas, at most so many of them, as a terminal prints them: "a, b, c and 3 more".
pub fn listed(names: &[impl AsRef<str>], most: usize) -> String {
    let spelt: Vec<Cow<'_, str>> = names.iter().take(most).map(|name| printable(name.as_ref())).collect();
    match names.len().saturating_sub(most) {
        0 => spelt.join(", "),
        more => format!("{} and {more} more", spelt.join(", ")),
    }
}

/// Names in quotes for a sentence: `"a"`, `"a" and "b"`, `"a", "b" and 3 more`.
pub fn quoted(names: &[impl AsRef<str>]) -> String {
    let Between { before, behind } = Between::of(names.len());
    let spelt = before.iter().zip(names).map(|(before, name)| format!("{before}{:?}", name.as_ref()));
    spelt.collect::<String>() + &behind
}

/// Words about the names that a sentence spells out.
#[derive(Debug)]
pub struct Between {
    /// Words before each of them: `""`, `", "` or `" and "`.
    pub before: Vec<&'static str>,
    /// Words behind the last.
    pub behind: String,
}

impl Between {
    /// The words about so many names.
    pub fn of(count: usize) -> Self {
        let spelt = if count <= SPELT { count } else { SPELT - 1 };
        let word = |name: usize| match name {
            0 => "",
            _ if name + 1 == count => " and ",
            _ => ", ",
        };
        let behind = if spelt == count { String::new() } else { format!(" and {} more", count - spelt) };
        Self { before: (0..spelt).map(word).collect(), behind }
    }
}

#[cfg(test)]
mod tests {
    use super::{listed, quoted};

    #[test]
    fn many_names_are_cut() {
        assert_eq!(listed(&["a", "b"], 5), "a, b");
        assert_eq!(listed(&["a", "b", "c", "d", "e"], 5), "a, b, c, d, e");
        assert_eq!(listed(&["a", "b", "c", "d", "e", "f", "g"], 5), "a, b, c, d, e and 2 more");
    }

    #[test]
    fn names_are_printable() {
        assert_eq!(listed(&["a\u{1b}[2J", "b\nwarning: é"], 5), r"a\u{1b}[2J, b\nwarning: é");
    }

    #[test]
    fn names_in_a_sentence_are_quoted() {
        assert_eq!(quoted(&[""; 0]), "");
        assert_eq!(quoted(&["a"]), r#""a""#);
        assert_eq!(quoted(&["a", "b\""]), r#""a" and "b\"""#);
        assert_eq!(quoted(&["a", "b", "c", "d", "e"]), r#""a", "b", "c", "d" and "e""#);
        assert_eq!(quoted(&["a", "b", "c", "d", "e", "f", "g"]), r#""a", "b", "c", "d" and 3 more"#);
    }
}

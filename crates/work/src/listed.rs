//! Lists of names in messages.

/// Most names that a message spells out. Chosen: about a line of a terminal.
pub const SPELT: usize = 5;

/// Most names that a list spells out which stands by itself. Chosen: a screen of them.
pub const LONG: usize = 20;

/// Names parted by commas, at most so many of them: "a, b, c and 3 more".
pub fn listed(names: &[impl AsRef<str>], most: usize) -> String {
    let spelt: Vec<&str> = names.iter().take(most).map(AsRef::as_ref).collect();
    match names.len().saturating_sub(most) {
        0 => spelt.join(", "),
        more => format!("{} and {more} more", spelt.join(", ")),
    }
}

/// Names in quotes for a sentence: `"a"`, `"a" and "b"`, `"a", "b" and 3 more`.
pub fn quoted(names: &[impl AsRef<str>]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("{:?}", name.as_ref())).collect();
    match quoted.split_last() {
        Some((last, rest)) if !rest.is_empty() && quoted.len() <= SPELT => {
            format!("{} and {last}", rest.join(", "))
        }
        _ => listed(&quoted, SPELT - 1),
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
    fn names_in_a_sentence_are_quoted() {
        assert_eq!(quoted(&[""; 0]), "");
        assert_eq!(quoted(&["a"]), r#""a""#);
        assert_eq!(quoted(&["a", "b\""]), r#""a" and "b\"""#);
        assert_eq!(quoted(&["a", "b", "c", "d", "e"]), r#""a", "b", "c", "d" and "e""#);
        assert_eq!(quoted(&["a", "b", "c", "d", "e", "f", "g"]), r#""a", "b", "c", "d" and 3 more"#);
    }
}

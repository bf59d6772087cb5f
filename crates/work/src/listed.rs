//! Lists of names in messages.

/// Most names that a message spells out. Chosen: about a line of a terminal.
const SPELT: usize = 5;

/// Names parted by commas, the first ones of many: "a, b, c, d, e and 3 more".
pub fn listed(names: &[impl AsRef<str>]) -> String {
    let spelt: Vec<&str> = names.iter().take(SPELT).map(AsRef::as_ref).collect();
    match names.len().saturating_sub(SPELT) {
        0 => spelt.join(", "),
        more => format!("{} and {more} more", spelt.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::listed;

    #[test]
    fn many_names_are_cut() {
        assert_eq!(listed(&["a", "b"]), "a, b");
        assert_eq!(listed(&["a", "b", "c", "d", "e"]), "a, b, c, d, e");
        assert_eq!(listed(&["a", "b", "c", "d", "e", "f", "g"]), "a, b, c, d, e and 2 more");
    }
}

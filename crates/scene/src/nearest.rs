//! The known name nearest to one that is not known, for "did you mean".

use strsim::damerau_levenshtein;

/// The name among `known` that `name` is most likely a slip of, if any is near enough.
///
/// Near enough: at most one edit, plus one for every three letters typed.
pub(super) fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let typed = name.to_lowercase();
    known
        .into_iter()
        .map(|candidate| (damerau_levenshtein(&typed, &candidate.to_lowercase()), candidate))
        .min_by_key(|&(edits, _)| edits)
        .filter(|&(edits, _)| edits <= 1 + typed.chars().count() / 3)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    const KEYS: [&str; 3] = ["reflectance", "emission", "material"];

    #[test]
    fn a_slip_finds_its_word() {
        assert_eq!(nearest("reflectence", KEYS), Some("reflectance"));
        assert_eq!(nearest("Emision", KEYS), Some("emission"));
    }

    #[test]
    fn a_stranger_finds_nothing() {
        assert_eq!(nearest("colour", KEYS), None);
        assert_eq!(nearest("anything", []), None);
    }
}

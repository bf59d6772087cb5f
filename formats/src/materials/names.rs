//! Names that are looked for: the closest one to a name that is not there.

use strsim::damerau_levenshtein;

use crate::text::short;

/// Most names that are compared. Chosen.
const MOST: usize = 1000;

/// A sentence part that names the closest of some names, if one is near: one edit and one more for every three letters.
pub(super) fn closest<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    let typed = short(name).to_lowercase();
    let near = known
        .take(MOST)
        .map(|known| (damerau_levenshtein(&typed, &short(known).to_lowercase()), known))
        .min_by_key(|(edits, _)| *edits)
        .filter(|(edits, _)| *edits <= 1 + typed.chars().count() / 3);
    near.map_or(String::new(), |(_, known)| format!("; '{}' is closest", short(known)))
}

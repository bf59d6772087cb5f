//! The language of a scene's text: what its ending says, or else how it begins.

use std::path::Path;

use radiosity_scene::Source;

use crate::polygon_list;

/// A language that scenes are read from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Language {
    Toml,
    Json,
    /// A list of polygons.
    Csv,
}

impl Language {
    /// The language of `source`; that of a tree made in code is JSON.
    pub(super) fn of(source: &Source) -> Self {
        match source.tree() {
            None => Self::of_text(&source.origin, &source.text()),
            Some(_) => Language::Json,
        }
    }

    /// The language of the text `text` called `origin`; upper and lower case of its ending are the same.
    pub(super) fn of_text(origin: &str, text: &str) -> Self {
        let ending = Path::new(origin).extension().unwrap_or_default().to_string_lossy();
        match ending.to_ascii_lowercase().as_str() {
            "json" => Language::Json,
            // A solution keeps a scene made in code as JSON, whatever its name; no row of a list is a bracket
            // alone.
            "csv" if text.lines().next() != Some("{") => Language::Csv,
            // No TOML starts like that.
            _ if text.trim_start().starts_with('{') => Language::Json,
            "toml" => Language::Toml,
            _ if starts_with_points(text) => Language::Json,
            _ if polygon_list::starts_csv(text) => Language::Csv,
            _ => Language::Toml,
        }
    }

    /// Whether `source` is a list of polygons, in whatever language.
    pub(super) fn is_polygon_list(source: &Source) -> bool {
        match (source.tree(), Language::of(source)) {
            (Some(tree), _) => tree.items().is_some(),
            (None, Language::Toml) => false,
            (None, Language::Json) => source.text().trim_start().starts_with('['),
            (None, Language::Csv) => true,
        }
    }
}

/// Whether a text starts as a list of polygons in JSON: `[[[`, or `[[` and a number, which lacks a bracket.
fn starts_with_points<'a>(text: &'a str) -> bool {
    let inner = |text: &'a str| text.trim_start().strip_prefix('[');
    let first = inner(text).and_then(inner).map(str::trim_start).and_then(|rest| rest.chars().next());
    first.is_some_and(|c| c == '[' || c == '-' || c.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ending_decides_first() {
        let language = |origin, text| Language::of(&Source::new(origin, text));
        for (origin, expected) in
            [("a.JSON", Language::Json), ("a.b.Csv", Language::Csv), ("a.TOML", Language::Toml)]
        {
            assert_eq!(language(origin, "[[1]]"), expected);
        }
        assert_eq!(language("a.toml", "\u{feff} {}"), Language::Json);
        assert_eq!(language("a.csv", "{\n}"), Language::Json);
    }

    #[test]
    fn a_text_without_ending_is_known_by_its_beginning() {
        let language = |text| Language::of(&Source::new("<stdin>", text));
        for text in ["{", "\u{feff}{", "[[[0,0,0]", " [\n [\n  [0", "[[0, 0, 0], ", "[[-1"] {
            assert_eq!(language(text), Language::Json, "{text}");
        }
        for text in ["name,x,y,z\n", "# two\n\nName, X, Y, Z", "\u{feff}a,0,1e3,-2\n", "\"a, b\",0,0,0"] {
            assert_eq!(language(text), Language::Csv, "{text}");
        }
        for text in ["", "[[surfaces]]", "title = \"a,0,0,0\"", "a,b,c,d", "# only this"] {
            assert_eq!(language(text), Language::Toml, "{text}");
        }
    }
}

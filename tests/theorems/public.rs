//! Names that no other package uses are not public: each public function, constant and module of a crate is named,
//! as a word, in the sources of another package, in a test, an example or a bench, or in an example of the
//! documentation.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::sources::texts;

/// The sources that a file belongs to: those of a crate below `crates/`, or none where it is outside of all.
fn crate_of(file: &Path) -> Option<String> {
    let parts: Vec<_> =
        file.components().map(|part| part.as_os_str().to_string_lossy().into_owned()).collect();
    (parts[0] == "crates" && parts[2] == "src").then(|| parts[1].clone())
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty())
}

/// The lines of Rust in the examples of a file's documentation.
fn examples(text: &str) -> Vec<&str> {
    let mut language = None;
    let mut found = Vec::new();
    for line in text.lines().map(str::trim_start) {
        let Some(line) = line.strip_prefix("///").or(line.strip_prefix("//!")).map(str::trim_start) else {
            language = None;
            continue;
        };
        match (line.strip_prefix("```"), language) {
            (Some(_), Some(_)) => language = None,
            (Some(own), None) => language = Some(own),
            (None, Some("")) => found.push(line),
            (None, _) => {}
        }
    }
    found
}

/// The names of public functions, constants and modules that a file declares.
fn public(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter_map(|line| {
        let rest = line.trim_start().strip_prefix("pub ")?;
        let rest = rest.strip_prefix("const fn ").map_or(rest, |_| &rest["const ".len()..]);
        let kinds = ["fn ", "const ", "static ", "mod "];
        words(kinds.iter().find_map(|kind| rest.strip_prefix(kind))?).next()
    })
}

#[test]
fn what_no_other_package_names_is_not_public() {
    let texts = texts();
    // Of each word the crates that name it; "" stands for all that is outside of them.
    let mut named: BTreeMap<&str, BTreeSet<String>> = BTreeMap::new();
    for (file, text) in &texts {
        let own = crate_of(file).unwrap_or_default();
        words(text).for_each(|word| _ = named.entry(word).or_default().insert(own.clone()));
        for word in examples(text).into_iter().flat_map(words) {
            named.entry(word).or_default().insert(String::new());
        }
    }
    let (mut found, mut faults) = (0, Vec::new());
    for (file, text) in &texts {
        let Some(own) = crate_of(file) else { continue };
        for name in public(text) {
            found += 1;
            if named[name].iter().all(|other| *other == own) {
                faults.push(format!("{}: {name}", file.display()));
            }
        }
    }
    assert!(found > 1000, "{found} public names");
    assert!(faults.is_empty(), "public, but named nowhere else:\n{}", faults.join("\n"));
}

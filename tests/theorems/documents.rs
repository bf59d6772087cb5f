//! What the documents name is there: examples, tests and benches that commands run, pictures, marks in pairs.

use std::fs;
use std::path::{Path, PathBuf};

/// The documents of all packages.
const DOCUMENTS: [&str; 5] = [
    "README.md",
    "benches/README.md",
    "core/benches/README.md",
    "geom/benches/README.md",
    "solvers/benches/README.md",
];
const PACKAGES: [&str; 4] = [".", "core", "geom", "solvers"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn texts() -> impl Iterator<Item = (&'static str, String)> {
    DOCUMENTS
        .iter()
        .map(|name| (*name, fs::read_to_string(root().join(name)).expect("the document is there")))
}

/// Words that follow `flag` in a text.
fn named<'a>(text: &'a str, flag: &'a str) -> impl Iterator<Item = &'a str> {
    let words = text.split(|c: char| c.is_whitespace() || "`,;)".contains(c)).filter(|word| !word.is_empty());
    words.clone().zip(words.skip(1)).filter(move |(word, _)| *word == flag).map(|(_, name)| name)
}

/// Whether a target is a file, or a folder with its own `main.rs`, in one of the packages.
fn target(folder: &str, name: &str) -> bool {
    let places = PACKAGES.iter().flat_map(|package| {
        let place: PathBuf = root().join(package).join(folder).join(name);
        [place.with_extension("rs"), place.join("main.rs")]
    });
    places.into_iter().any(|place| place.exists())
}

#[test]
fn commands_run_what_exists() {
    let mut found = 0;
    for (document, text) in texts() {
        for (flag, folder) in [("--example", "examples"), ("--test", "tests"), ("--bench", "benches")] {
            for name in named(&text, flag) {
                found += 1;
                assert!(target(folder, name), "{document}: nothing in {folder} is called '{name}'");
            }
        }
    }
    assert!(found > 10, "the commands were found");
}

#[test]
fn pictures_are_there() {
    let text = fs::read_to_string(root().join("README.md")).expect("the document is there");
    let pictures: Vec<&str> = text
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next())
        .filter(|link| link.contains("docs/"))
        .collect();
    assert!(pictures.len() > 2, "the pictures were found");
    pictures.iter().for_each(|picture| assert!(root().join(picture).exists(), "{picture} is missing"));
}

#[test]
fn marks_come_in_pairs() {
    for (document, text) in texts() {
        let marks =
            text.lines().map(str::trim).filter(|line| line.starts_with("<!-- ") && *line != "<!-- run -->");
        let marks: Vec<&str> = marks.collect();
        for pair in marks.chunks(2) {
            let paired = pair[0].starts_with("<!-- output") && pair.get(1) == Some(&"<!-- end -->");
            assert!(paired, "{document}: {pair:?} do not pair");
        }
    }
}

#[test]
fn outputs_are_filled_in() {
    let mut found = 0;
    for (document, text) in texts() {
        for place in text.split("<!-- output").skip(1) {
            let (_, output) = place.split_once("-->").expect("the mark is closed");
            let output = output.split("<!--").next().unwrap_or_default();
            found += 1;
            assert!(!output.trim().is_empty(), "{document}: output {found} is empty, make it anew");
        }
    }
    assert!(found > 5, "the outputs were found");
}

//! All that the documents name is there: examples, tests and benches that commands run, pictures and links,
//! marks in pairs; and the packages' examples are those of their documentation, where they are run.

use std::fs;
use std::path::{Path, PathBuf};

/// The documents of all packages.
const DOCUMENTS: [&str; 16] = [
    "README.md",
    "CHANGELOG.md",
    "CONTRIBUTING.md",
    "docs/measured.md",
    "docs/outputs.md",
    "docs/ranks.md",
    "docs/viewer.md",
    "benches/README.md",
    "core/README.md",
    "core/benches/README.md",
    "geom/README.md",
    "geom/benches/README.md",
    "python/README.md",
    "python/docs/tutorial.md",
    "solvers/README.md",
    "solvers/benches/README.md",
];
/// The documents that say where in the sources things live.
const MAPS: [&str; 8] = [
    "docs/glossary.md",
    "docs/theory/transport.md",
    "docs/theory/visibility.md",
    "docs/theory/gathering.md",
    "docs/theory/solvers.md",
    "docs/theory/variational.md",
    "docs/theory/animation.md",
    "docs/viewer.md",
];
const PACKAGES: [&str; 6] = [".", "core", "crates/formats", "geom", "solvers", "studies"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn texts() -> impl Iterator<Item = (&'static str, String)> {
    DOCUMENTS
        .iter()
        .map(|name| (*name, fs::read_to_string(root().join(name)).expect("the document is there")))
}

fn maps() -> impl Iterator<Item = (&'static str, String)> {
    MAPS.iter().map(|name| (*name, fs::read_to_string(root().join(name)).expect("the document is there")))
}

/// Words that follow `flag` in a text.
fn named<'a>(text: &'a str, flag: &'a str) -> impl Iterator<Item = &'a str> {
    let words = text.split(|c: char| c.is_whitespace() || "`,;)".contains(c)).filter(|word| !word.is_empty());
    words.clone().zip(words.skip(1)).filter(move |(word, _)| *word == flag).map(|(_, name)| name)
}

/// Where the links of a text lead.
fn links(text: &str) -> impl Iterator<Item = &str> {
    text.split("](").skip(1).filter_map(|rest| rest.split(')').next())
}

/// Where a link of a document leads, which is relative to the document's own folder.
fn beside(document: &str, link: &str) -> PathBuf {
    root().join(document).with_file_name(link)
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
        let folders =
            [("--bin", "src/bin"), ("--example", "examples"), ("--test", "tests"), ("--bench", "benches")];
        for (flag, folder) in folders {
            for name in named(&text, flag) {
                found += 1;
                assert!(target(folder, name), "{document}: nothing in {folder} is called '{name}'");
            }
        }
    }
    assert!(found > 10, "the commands were found");
}

/// Whether there are tests whose names begin so, below `tests/theorems`: a module, or the first words of a function in it.
fn is_theorem(name: &str) -> bool {
    let file =
        |module: &str| root().join("tests/theorems").join(module.replace("::", "/")).with_extension("rs");
    let in_file = |(module, start): (&str, &str)| {
        fs::read_to_string(file(module)).is_ok_and(|text| text.contains(&format!("fn {start}")))
    };
    file(name.trim_end_matches("::")).exists() || name.rsplit_once("::").is_some_and(in_file)
}

#[test]
fn theorems_that_are_named_exist() {
    let mut found = 0;
    for (document, text) in texts().chain(maps()) {
        let commands = text.split("--test theorems").skip(1).filter_map(|rest| rest.split('`').next());
        for name in commands.filter_map(|rest| rest.split_whitespace().next()) {
            found += 1;
            assert!(is_theorem(name), "{document}: no theorem is called '{name}'");
        }
    }
    assert!(found > 10, "{found} theorems were named");
}

#[test]
fn links_lead_somewhere() {
    let mut pictures = 0;
    for (document, text) in texts() {
        for link in links(&text).filter(|link| !link.starts_with("https://") && !link.starts_with('#')) {
            let file = link.split('#').next().unwrap_or(link);
            pictures += usize::from(file.ends_with(".png") || file.ends_with(".svg"));
            assert!(beside(document, file).exists(), "{document}: {link} is missing");
        }
    }
    assert!(pictures > 5, "the pictures were found");
}

#[test]
fn places_in_the_sources_are_there() {
    let mut found = 0;
    for (map, text) in maps() {
        let places = text.split('`').skip(1).step_by(2);
        for place in places.filter(|place| place.contains('/') && !place.contains([' ', '*', '…'])) {
            let known = [
                "src/",
                "crates/",
                "formats/",
                "core/",
                "geom/",
                "solvers/",
                "tests/",
                "examples/",
                "studies/",
                "benches/",
            ];
            if known.iter().any(|folder| place.starts_with(folder)) {
                found += 1;
                assert!(root().join(place).exists(), "{map} names {place}");
            }
        }
    }
    assert!(found > 80, "{found} places");
}

#[test]
fn marks_come_in_pairs() {
    for (document, text) in texts() {
        let is_mark = |line: &&str| line.starts_with("<!-- output") || *line == "<!-- end -->";
        let marks: Vec<&str> = text.lines().map(str::trim).filter(is_mark).collect();
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

#[test]
fn examples_of_packages_are_doc_tests() {
    for (package, source) in [("core", "lib.rs"), ("geom", "lib.rs"), ("solvers", "dense.rs")] {
        let folder = root().join(package);
        let readme = fs::read_to_string(folder.join("README.md")).expect("the document is there");
        let (_, example) = readme.split_once("```rust\n").expect("there is an example");
        let (example, _) = example.split_once("```").expect("the example is closed");
        let documented = documentation(&folder.join("src").join(source));
        assert!(documented.contains(example), "{package}: {source} does not run the README's example");
    }
}

/// The documentation in a source file, without its marks.
fn documentation(source: &Path) -> String {
    let text = fs::read_to_string(source).expect("the source is there");
    let lines = text.lines().filter_map(|line| line.strip_prefix("//!").or(line.strip_prefix("///")));
    lines.map(|line| line.strip_prefix(' ').unwrap_or(line).to_owned() + "\n").collect()
}

//! All that the documents name is there: examples, tests and benches that commands run, pictures and links,
//! marks in pairs; and the packages' examples are those of their documentation, where they are run.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{fs, iter};

use radiosity_test_support::documents::stamp::is_stamp;

/// Folders without documents or sources of the house.
const ELSEWHERE: [&str; 3] = ["target", ".git", "node_modules"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The files in a folder whose names end so, at any depth, relative to the root.
fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(root().join(folder)).expect("the folder can be listed") {
        let entry = entry.expect("the folder can be listed");
        let (name, is_folder) = (entry.file_name(), entry.path().is_dir());
        let name = name.to_string_lossy();
        if is_folder && !ELSEWHERE.contains(&&*name) {
            found.extend(files(&folder.join(&*name), ending));
        } else if !is_folder && name.ends_with(ending) {
            found.push(folder.join(&*name));
        }
    }
    found.sort();
    found
}

/// All files whose names end so, with their texts.
fn texts_of(ending: &str) -> impl Iterator<Item = (String, String)> {
    files(Path::new(""), ending).into_iter().map(|file| {
        let text = fs::read_to_string(root().join(&file)).expect("the file can be read");
        (file.to_string_lossy().into_owned(), text)
    })
}

/// The documents of all packages.
fn texts() -> impl Iterator<Item = (String, String)> {
    texts_of(".md")
}

/// The folders of all packages.
fn packages() -> Vec<PathBuf> {
    let manifests = files(Path::new(""), "Cargo.toml").into_iter();
    manifests.filter_map(|manifest| manifest.parent().map(Path::to_owned)).collect()
}

/// The folder of the package that a file belongs to.
fn package_of<'a>(file: &str, packages: &'a [PathBuf]) -> &'a Path {
    let own = packages.iter().filter(|package| Path::new(file).starts_with(package));
    own.max_by_key(|package| package.components().count()).expect("the root is a package")
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
fn target(packages: &[PathBuf], folder: &str, name: &str) -> bool {
    let places = packages.iter().flat_map(|package| {
        let place: PathBuf = root().join(package).join(folder).join(name);
        [place.with_extension("rs"), place.join("main.rs")]
    });
    places.into_iter().any(|place| place.exists())
}

#[test]
fn commands_run_what_exists() {
    let (mut found, packages) = (0, packages());
    let benches = fs::read_to_string(root().join("benches/Cargo.toml")).expect("the manifest can be read");
    for (document, text) in texts() {
        for (flag, folder) in [("--bin", "src/bin"), ("--example", "examples"), ("--test", "tests")] {
            for name in named(&text, flag) {
                found += 1;
                assert!(
                    target(&packages, folder, name),
                    "{document}: nothing in {folder} is called '{name}'"
                );
            }
        }
        for name in named(&text, "--bench") {
            found += 1;
            assert!(
                benches.contains(&format!("name = \"{name}\"")),
                "{document}: no bench is called '{name}'"
            );
        }
    }
    assert!(found > 10, "the commands were found");
}

/// Whether there are tests whose names begin so, below `tests/theorems`: a module, or the first words of a
/// function in it.
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
    for (document, text) in texts() {
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
            assert!(beside(&document, file).exists(), "{document}: {link} is missing");
        }
    }
    assert!(pictures > 5, "the pictures were found");
}

/// The name that readers of Markdown give a heading.
fn anchor(heading: &str) -> String {
    let letters = heading.trim().to_lowercase().replace(' ', "-");
    letters.chars().filter(|c| c.is_alphanumeric() || "-_".contains(*c)).collect()
}

/// The names of a document's headings; those that return are numbered.
fn anchors(text: &str) -> BTreeSet<String> {
    let (mut found, mut is_code) = (BTreeSet::new(), false);
    for line in text.lines() {
        is_code ^= line.starts_with("```");
        if is_code || !line.starts_with('#') {
            continue;
        }
        let name = anchor(line.trim_start_matches('#'));
        let numbered = (1..).map(|number| format!("{name}-{number}"));
        let mut free = iter::once(name.clone()).chain(numbered).filter(|name| !found.contains(name));
        let free = free.next().expect("numbers do not end");
        found.insert(free);
    }
    found
}

#[test]
fn links_to_headings_find_them() {
    let mut found = 0;
    for (document, text) in texts() {
        for (file, name) in links(&text).filter_map(|link| link.split_once('#')) {
            if file.starts_with("https://") || !file.is_empty() && !file.ends_with(".md") {
                continue;
            }
            found += 1;
            let there = if file.is_empty() {
                anchors(&text)
            } else {
                let other = fs::read_to_string(beside(&document, file)).expect("the document is there");
                anchors(&other)
            };
            assert!(there.contains(name), "{document}: {file} has no heading '{name}'");
        }
    }
    assert!(found > 100, "{found} links to headings");
}

/// Paths in a text between backticks.
fn places(text: &str) -> impl Iterator<Item = &str> {
    let marked = text.split('`').skip(1).step_by(2);
    marked.filter(|place| place.contains('/') && !place.contains([' ', '*', '…', '\n']))
}

#[test]
fn places_in_the_sources_are_there() {
    let (mut found, packages) = (0, packages());
    for (document, text) in texts() {
        let package = package_of(&document, &packages);
        for place in places(&text) {
            let first = place.split('/').next().unwrap_or_default();
            if !first.is_empty() && root().join(first).is_dir() && !ELSEWHERE.contains(&first) {
                found += 1;
                let is_there =
                    [Path::new(""), package].iter().any(|from| root().join(from).join(place).exists());
                assert!(is_there, "{document} names {place}");
            }
        }
    }
    assert!(found > 150, "{found} places");
}

#[test]
fn sources_that_comments_name_are_there() {
    let (mut found, packages) = (0, packages());
    for (file, text) in texts_of(".rs") {
        let comments = text.lines().map(str::trim_start).filter(|line| line.starts_with("//"));
        for place in comments.flat_map(places).filter(|place| place.ends_with(".rs")) {
            found += 1;
            let package = package_of(&file, &packages);
            let is_there = [root().join(place), root().join(package).join(place), beside(&file, place)];
            assert!(is_there.iter().any(|path| path.exists()), "{file} names {place}");
        }
    }
    assert!(found > 3, "{found} places");
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
            let is_filled = output.lines().any(|line| !line.trim().is_empty() && !is_stamp(line));
            assert!(is_filled, "{document}: output {found} is empty, make it anew");
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

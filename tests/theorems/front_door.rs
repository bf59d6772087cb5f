//! The front door is whole: the README is short, the book has every page, and CONTRIBUTING.md
//! knows every folder.

use std::fs;
use std::path::{Path, PathBuf};

/// Lines of the README at most, and letters in one of them.
const LINES: usize = 170;
const COLUMNS: usize = 120;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn text(name: &str) -> String {
    fs::read_to_string(root().join(name)).expect("the document is there")
}

/// Entries of a folder, by name.
fn entries(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("folders can be read");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("folders can be listed").path()).collect();
    paths.sort();
    paths
}

/// The pages below a folder; `docs/book`, which mdbook makes of them, apart.
fn pages(folder: &Path) -> Vec<PathBuf> {
    let below = |path: PathBuf| match path.is_dir() {
        true if path.ends_with("docs/book") => Vec::new(),
        true => pages(&path),
        false => vec![path],
    };
    entries(folder)
        .into_iter()
        .flat_map(below)
        .filter(|path| path.extension().is_some_and(|it| it == "md"))
        .collect()
}

#[test]
fn the_readme_is_short() {
    let readme = text("README.md");
    let count = readme.lines().count();
    assert!(count <= LINES, "README.md has {count} lines: move what few readers need to a page of docs/");
    let long = readme.lines().find(|line| line.chars().count() > COLUMNS);
    assert_eq!(long, None, "a line of README.md has more than {COLUMNS} letters");
}

#[test]
fn the_book_has_every_page() {
    let docs = root().join("docs");
    let summary = text("docs/SUMMARY.md");
    let named: Vec<PathBuf> = summary
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next())
        .map(|page| docs.join(page))
        .collect();
    for page in pages(&docs).iter().filter(|page| !page.ends_with("SUMMARY.md")) {
        assert!(named.contains(page), "docs/SUMMARY.md does not name {}", page.display());
    }
    named.iter().for_each(|page| assert!(page.exists(), "docs/SUMMARY.md names {}", page.display()));
}

/// Folders that hold what is made, or is named with the folder that it lies in.
const UNNAMED: [&str; 2] = ["target", "docs/book"];

#[test]
fn contributing_names_every_folder() {
    let contributing = text("CONTRIBUTING.md");
    let named: Vec<&str> = contributing.split('`').skip(1).step_by(2).collect();
    let mut folders = entries(root());
    for folder in ["crates", "docs", "python", "tests"] {
        folders.extend(entries(&root().join(folder)));
    }
    let mut found = 0;
    for folder in folders.iter().filter(|path| path.is_dir()) {
        let name = folder.strip_prefix(root()).expect("it lies below the root").to_string_lossy();
        let is_hidden = name.split('/').any(|part| part.starts_with(['.', '_']));
        if is_hidden || UNNAMED.contains(&&*name) {
            continue;
        }
        found += 1;
        assert!(named.contains(&&*format!("{name}/")), "CONTRIBUTING.md does not say what is in `{name}/`");
    }
    assert!(found > 40, "{found} folders");
}

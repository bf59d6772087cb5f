//! The house stays a staircase: a module imports only what stands above it, and no file is an orphan.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Names declared by `mod name;` lines of a file, in order.
fn declared(file: &Path) -> Vec<String> {
    let text = fs::read_to_string(file).expect("source files can be read");
    let name = |line: &str| {
        let line = line.trim();
        let (visibility, rest) = line.split_once("mod ")?;
        let is_declaration = visibility.is_empty() || visibility.starts_with("pub");
        rest.strip_suffix(';').filter(|_| is_declaration).map(str::to_owned)
    };
    text.lines().filter_map(name).collect()
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("source folders can be read") {
        let path = entry.expect("source folders can be listed").path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            files.push(path);
        }
    }
    files
}

fn sources() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// The top module of the library that a file belongs to.
fn top_module(file: &Path) -> String {
    let relative = file.strip_prefix(sources()).expect("files lie in src");
    let first = relative.components().next().expect("a file has a name").as_os_str().to_string_lossy();
    first.trim_end_matches(".rs").to_owned()
}

#[test]
fn modules_import_only_what_stands_above_them() {
    let order = declared(&sources().join("lib.rs"));
    assert!(order.len() > 5, "lib.rs lists the modules of the flow");
    let rank = |name: &str| order.iter().position(|module| module == name);
    let mut checked = 0;
    for file in rust_files(&sources()) {
        let Some(own) = rank(&top_module(&file)) else { continue };
        let text = fs::read_to_string(&file).expect("source files can be read");
        for part in text.split("crate::").skip(1) {
            assert!(!part.starts_with('{'), "{} imports several modules at once: name each", file.display());
            let name: String = part.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            let Some(imported) = rank(&name) else { continue };
            checked += 1;
            assert!(imported <= own, "{} imports crate::{name}, which stands below it", file.display());
        }
    }
    assert!(checked > 10, "the imports were found");
}

#[test]
fn no_source_file_is_an_orphan() {
    for package in ["", "core", "geom", "solvers"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(package).join("src");
        let mut known: BTreeSet<PathBuf> =
            ["lib.rs", "main.rs"].iter().map(|root| folder.join(root)).filter(|root| root.exists()).collect();
        let mut open: Vec<PathBuf> = known.iter().cloned().collect();
        while let Some(file) = open.pop() {
            let is_root = file.parent() == Some(folder.as_path())
                && matches!(file.file_name().and_then(|name| name.to_str()), Some("lib.rs" | "main.rs"));
            let children = if is_root { folder.clone() } else { file.with_extension("") };
            for name in declared(&file) {
                let child = children.join(format!("{name}.rs"));
                if known.insert(child.clone()) {
                    open.push(child);
                }
            }
        }
        let found: BTreeSet<PathBuf> = rust_files(&folder).into_iter().collect();
        assert_eq!(
            found,
            known,
            "files of {} that no `mod` names, or names without a file",
            folder.display()
        );
    }
}

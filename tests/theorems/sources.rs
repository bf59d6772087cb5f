//! Source files of the house, for tests that read them.

use std::fs;
use std::path::{Path, PathBuf};

/// Folders without sources of the house, by name.
const ELSEWHERE: [&str; 3] = ["target", ".git", "node_modules"];

/// Rust files in a folder and in those below it.
pub(crate) fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("source folders can be read") {
        let path = entry.expect("source folders can be listed").path();
        if path.is_dir() {
            let is_ours = path.file_name().is_none_or(|name| ELSEWHERE.iter().all(|other| name != *other));
            files.extend(is_ours.then(|| rust_files(&path)).into_iter().flatten());
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            files.push(path);
        }
    }
    files
}

/// All Rust files with their texts, named from the root of the repository.
pub(crate) fn texts() -> Vec<(PathBuf, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let named = |path: PathBuf| {
        let text = fs::read_to_string(&path).expect("source files can be read");
        (path.strip_prefix(root).expect("they lie in the root").to_owned(), text)
    };
    rust_files(root).into_iter().map(named).collect()
}

//! The house stays a staircase: in every folder a module imports only what is declared above it, no file
//! imports one that imports it, and no file is an orphan.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use crate::sources::rust_files;

use crate::packages::folders;

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

/// A crate's files by the modules that they are, each with its text.
struct House {
    files: BTreeMap<Vec<String>, String>,
    /// The modules that a file declares, in order.
    declared: BTreeMap<Vec<String>, Vec<String>>,
}

/// An import: from which module, of which, and whether it only passes a name on.
struct Import {
    from: Vec<String>,
    of: Vec<String>,
    is_passed_on: bool,
}

impl House {
    fn of(sources: &Path) -> Self {
        let (mut files, mut names) = (BTreeMap::new(), BTreeMap::new());
        for path in rust_files(sources) {
            let relative = path.strip_prefix(sources).expect("files lie in the sources").with_extension("");
            let module: Vec<String> =
                relative.components().map(|part| part.as_os_str().to_string_lossy().into_owned()).collect();
            let module = if module == ["lib"] || module == ["main"] { Vec::new() } else { module };
            names.entry(module.clone()).or_insert_with(Vec::new).extend(declared(&path));
            files.insert(module, fs::read_to_string(&path).expect("source files can be read"));
        }
        Self { files, declared: names }
    }

    /// All imports between its modules, tests and comments left out.
    fn imports(&self) -> Vec<Import> {
        let mut found = Vec::new();
        for (from, text) in &self.files {
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            let lines: Vec<&str> =
                code.lines().map(|line| line.split("//").next().unwrap_or_default()).collect();
            // Of nested imports, which rustfmt writes over several lines, every name counts.
            for statement in lines.join(" ").split(';') {
                let is_passed_on = statement.trim_start().starts_with("pub use ");
                for path in paths(statement) {
                    let Some(of) = self.module_of(from, &path) else { continue };
                    found.push(Import { from: from.clone(), of, is_passed_on });
                }
            }
        }
        found
    }

    /// The deepest module that a path from `from` names, other than itself.
    fn module_of(&self, from: &[String], path: &[String]) -> Option<Vec<String>> {
        let ups = path.iter().take_while(|part| *part == "super").count();
        let names = match path.first()?.as_str() {
            "crate" => path[1..].to_vec(),
            // Within a module of the file itself the parents are fewer.
            "super" => [&from[..from.len().checked_sub(ups)?], &path[ups..]].concat(),
            child if self.declared.get(from).is_some_and(|names| names.iter().any(|name| name == child)) => {
                [from, path].concat()
            }
            _ => return None,
        };
        let known = |length: &usize| self.files.contains_key(&names[..*length]);
        let length = (0..=names.len()).rev().find(known)?;
        (names[..length] != *from).then(|| names[..length].to_vec())
    }

    /// The fault of an import, if it has one: it goes to a room that stands below, or from a child to a
    /// parent that imports it.
    fn fault(&self, import: &Import, all: &[Import]) -> Option<String> {
        let Import { from, of, .. } = import;
        let told = || format!("{} imports {}", from.join("::"), of.join("::"));
        if of.starts_with(from) {
            return None;
        }
        if from.starts_with(of) {
            let is_mutual =
                all.iter().any(|other| other.from == *of && other.of == *from && !other.is_passed_on);
            return is_mutual.then(|| format!("{}, which imports it", told()));
        }
        let common = from.iter().zip(of).take_while(|(a, b)| a == b).count();
        let order = self.declared.get(&from[..common])?;
        let [own, other] = [from, of].map(|module| order.iter().position(|name| *name == module[common]));
        (other? > own?).then(|| format!("{}, which stands below it", told()))
    }
}

/// The paths in a statement that begin with `crate` or `super`, or that it imports, groups in braces spread
/// out.
fn paths(statement: &str) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    if let Some((_, imported)) = statement.split_once("use ") {
        let is_import = !imported.starts_with("crate::") && !imported.starts_with("super::");
        is_import.then(|| spread(imported, Vec::new(), &mut found));
    }
    for start in ["crate::", "super::"].iter().flat_map(|root| statement.match_indices(root)) {
        let before = statement[..start.0].chars().next_back();
        // `super` after `super` belongs to the same path, and `pub(in crate::…)` imports nothing.
        if before.is_some_and(|c| c.is_alphanumeric() || c == ':' || c == '$')
            || statement[..start.0].ends_with("(in ")
        {
            continue;
        }
        spread(&statement[start.0..], Vec::new(), &mut found);
    }
    found
}

/// Adds the paths that `text` begins with, behind `stem`. Returns what follows them.
fn spread<'a>(text: &'a str, mut stem: Vec<String>, found: &mut Vec<Vec<String>>) -> &'a str {
    let mut rest = text.trim_start();
    loop {
        if let Some(group) = rest.strip_prefix('{') {
            rest = group;
            loop {
                rest = spread(rest, stem.clone(), found).trim_start();
                match rest.chars().next() {
                    Some(',') => rest = rest[1..].trim_start(),
                    Some('}') => return &rest[1..],
                    _ => return rest,
                }
            }
        }
        let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len());
        if end == 0 {
            return rest;
        }
        stem.push(rest[..end].to_owned());
        rest = &rest[end..];
        match rest.strip_prefix("::") {
            Some(next) => rest = next,
            None => {
                found.push(stem);
                let alias = rest.strip_prefix(" as ");
                return alias
                    .map_or(rest, |name| name.trim_start_matches(|c: char| c.is_alphanumeric() || c == '_'));
            }
        }
    }
}

/// The source folders of all packages.
fn sources() -> Vec<PathBuf> {
    folders().into_iter().map(|folder| folder.join("src")).filter(|folder| folder.exists()).collect()
}

/// Whether the code of a file has a line that imports a module of its own crate.
fn imports_a_module(text: &str) -> bool {
    let code = text.split("#[cfg(test)]").next().unwrap_or_default();
    code.lines().any(|line| line.starts_with("use crate::") || line.starts_with("use super::"))
}

#[test]
fn in_every_folder_modules_import_only_what_stands_above_them() {
    let (mut found, mut faults) = (0, Vec::new());
    for folder in sources() {
        let house = House::of(&folder);
        let imports = house.imports();
        found += imports.len();
        let wrong = imports.iter().filter_map(|import| house.fault(import, &imports));
        faults.extend(wrong.map(|fault| format!("{}: {fault}", folder.display())));
        // The reader of imports overlooks no file.
        let importers: BTreeSet<&Vec<String>> = imports.iter().map(|import| &import.from).collect();
        let overlooked = house.files.iter().filter(|(module, text)| {
            let is_code = module.last().is_some_and(|name| name != "tests");
            is_code && imports_a_module(text) && !importers.contains(module)
        });
        let overlooked: Vec<&Vec<String>> = overlooked.map(|(module, _)| module).collect();
        assert!(overlooked.is_empty(), "{}: no imports found in {overlooked:?}", folder.display());
    }
    assert!(found > 3000, "{found} imports");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn imports_against_the_order_are_found() {
    let module = |path: &str| path.split("::").map(str::to_owned).collect::<Vec<_>>();
    let file = |path: &str, text: &str| (module(path), text.to_owned());
    let house = House {
        files: BTreeMap::from([
            file("a", "use crate::b::x::{Y, z};"),
            file("b", "mod x; mod y; pub use x::Z; use y::V;"),
            file("b::x", "use super::y::{self, W}; use super::U;"),
            file("b::y", "use crate::b::U; use crate::a::T;"),
        ]),
        declared: BTreeMap::from([
            (Vec::new(), vec!["a".into(), "b".into()]),
            (module("b"), vec!["x".into(), "y".into()]),
        ]),
    };
    let imports = house.imports();
    let faults: BTreeSet<String> =
        imports.iter().filter_map(|import| house.fault(import, &imports)).collect();
    let expected = [
        "a imports b::x, which stands below it",
        "b::x imports b::y, which stands below it",
        "b::y imports b, which imports it",
    ];
    assert_eq!(faults.into_iter().collect::<Vec<_>>(), expected);
}

/// Files that no other declares: the roots of a package's library and programs.
fn roots(folder: &Path) -> BTreeSet<PathBuf> {
    let mut roots: BTreeSet<PathBuf> = ["lib.rs", "main.rs"].iter().map(|root| folder.join(root)).collect();
    for entry in fs::read_dir(folder.join("bin")).into_iter().flatten() {
        let path = entry.expect("programs can be listed").path();
        roots.insert(if path.is_dir() { path.join("main.rs") } else { path });
    }
    roots.retain(|root| root.exists());
    roots
}

#[test]
fn no_source_file_is_an_orphan() {
    for folder in sources() {
        let roots = roots(&folder);
        let (mut known, mut open) = (roots.clone(), Vec::from_iter(roots.clone()));
        while let Some(file) = open.pop() {
            let beside = file.parent().filter(|_| roots.contains(&file)).map(Path::to_owned);
            let children = beside.unwrap_or_else(|| file.with_extension(""));
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

/// Modules of the package for Python, each with those that it imports, at its head or within functions. What
/// is imported for type checkers alone is never loaded.
fn python_imports(root: &Path) -> BTreeMap<PathBuf, BTreeSet<PathBuf>> {
    let mut imports = BTreeMap::new();
    let mut open = vec![root.to_owned()];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(&folder).expect("the package can be listed") {
            let path = entry.expect("the package can be listed").path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|ending| ending == "py") {
                let text = fs::read_to_string(&path).expect("modules can be read");
                imports.insert(path, relative_imports(&folder, &text));
            }
        }
    }
    imports
}

/// Modules that the text of a module in `folder` imports by `from .`.
fn relative_imports(folder: &Path, text: &str) -> BTreeSet<PathBuf> {
    let mut found = BTreeSet::new();
    let mut is_for_types = false;
    for line in text.lines().filter(|line| !line.is_empty()) {
        is_for_types = line.starts_with("if TYPE_CHECKING:") || is_for_types && line.starts_with(' ');
        let Some((from, names)) =
            line.trim_start().strip_prefix("from .").and_then(|rest| rest.split_once(" import "))
        else {
            continue;
        };
        if is_for_types {
            continue;
        }
        let module = from.trim_start_matches('.');
        let package = folder.ancestors().nth(from.len() - module.len()).expect("dots stay in the package");
        let modules = if module.is_empty() { names.split(", ").collect() } else { vec![module] };
        for module in modules {
            let path = package.join(module.replace('.', "/"));
            let files = [path.with_extension("py"), path.join("__init__.py")];
            found.extend(files.into_iter().find(|file| file.exists()));
        }
    }
    found
}

#[test]
fn no_module_for_python_imports_one_that_imports_it() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("python/radiosity");
    let mut open = python_imports(&root);
    assert!(open.values().map(BTreeSet::len).sum::<usize>() > 50, "imports were found: {open:?}");
    // Modules that import none that is left are taken out, until none is.
    while let Some(last) = open.iter().find_map(|(own, others)| others.is_empty().then(|| own.clone())) {
        open.remove(&last);
        open.values_mut().for_each(|others| _ = others.remove(&last));
    }
    assert!(open.is_empty(), "modules that import each other: {open:?}");
}

#[test]
fn imports_of_python_are_read() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("python/radiosity");
    let text = "from . import _radiosity, heat\nfrom .scene import Scene\nif TYPE_CHECKING:\n    from .plane import Plane\n\n\
                def f():\n    from ..tables import x\n";
    let found = relative_imports(&root.join("interop"), text);
    assert_eq!(
        found,
        BTreeSet::from([root.join("tables.py")]),
        "of the folder `interop` none of the others is"
    );
    let found = relative_imports(&root, &text.replace("..", "."));
    assert_eq!(found, ["heat.py", "scene.py", "tables.py"].map(|name| root.join(name)).into());
}

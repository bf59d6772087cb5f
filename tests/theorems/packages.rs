//! The packages are what the documents say of them: `docs/architecture.md`, its picture and the heads of the
//! crates follow the manifests.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Packages beside the staircase: nothing that is released imports them.
const BESIDE: [&str; 3] = ["benches", "studies", "test-support"];

/// A package of the house with the others that its manifest names.
struct Package {
    folder: PathBuf,
    /// Packages that it always imports.
    imports: BTreeSet<String>,
    /// Packages that a feature of it adds.
    optional: BTreeSet<String>,
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn manifest(folder: &Path) -> toml::Table {
    toml::from_str(&read(&folder.join("Cargo.toml"))).expect("manifests are TOML")
}

/// The folders of all packages of the workspace.
pub(crate) fn folders() -> Vec<PathBuf> {
    let members = manifest(root())["workspace"]["members"].as_array().cloned().expect("there are members");
    let names = members.iter().filter_map(toml::Value::as_str);
    names
        .flat_map(|member| match member.strip_suffix("/*") {
            None => vec![root().join(member)],
            Some(parent) => {
                let children = fs::read_dir(root().join(parent)).expect("the folder can be listed");
                children.map(|child| child.expect("a folder can be listed").path()).collect()
            }
        })
        .collect()
}

/// A package's name as the documents write it.
fn short(name: &str) -> &str {
    name.strip_prefix("radiosity-").unwrap_or(name)
}

impl Package {
    /// The package in a folder, with its name.
    fn of(folder: PathBuf) -> (String, Self) {
        let manifest = manifest(&folder);
        let name = short(manifest["package"]["name"].as_str().expect("packages have names")).to_owned();
        let (mut imports, mut optional) = (BTreeSet::new(), BTreeSet::new());
        let dependencies = manifest.get("dependencies").and_then(toml::Value::as_table);
        for (dependency, how) in dependencies.into_iter().flatten() {
            if dependency == "radiosity" || dependency.starts_with("radiosity-") {
                let is_optional = how.get("optional").and_then(toml::Value::as_bool).unwrap_or(false);
                let kind = if is_optional { &mut optional } else { &mut imports };
                kind.insert(short(dependency).to_owned());
            }
        }
        (name, Self { folder, imports, optional })
    }

    /// All packages of the staircase by their names.
    fn all() -> BTreeMap<String, Self> {
        folders().into_iter().map(Self::of).filter(|(name, _)| !BESIDE.contains(&name.as_str())).collect()
    }
}

/// The cells of the rows of the table below a heading of `docs/architecture.md`, its head left out.
fn table(heading: &str) -> Vec<Vec<String>> {
    let text = read(&root().join("docs/architecture.md"));
    let below = text.split_once(heading).expect("the heading is there").1;
    let lines =
        below.lines().skip_while(|line| !line.starts_with('|')).take_while(|line| line.starts_with('|'));
    let cells = |line: &str| line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect();
    lines.skip(2).map(cells).collect()
}

/// The words of a cell in backticks.
fn marked(cell: &str) -> Vec<&str> {
    cell.split('`').skip(1).step_by(2).collect()
}

/// The packages in the order of the first table.
fn staircase() -> Vec<String> {
    table("# Architecture").iter().map(|row| marked(&row[0])[0].to_owned()).collect()
}

/// Packages in the order of the staircase, with a comma between each two.
fn listed(packages: &BTreeSet<String>, staircase: &[String]) -> String {
    let ordered: Vec<&str> =
        staircase.iter().filter(|name| packages.contains(*name)).map(String::as_str).collect();
    ordered.join(", ")
}

#[test]
fn the_table_lists_every_package_with_what_its_manifest_imports() {
    let (packages, staircase) = (Package::all(), staircase());
    assert_eq!(staircase.iter().collect::<BTreeSet<_>>(), packages.keys().collect(), "the packages");
    for row in table("# Architecture") {
        let name = marked(&row[0])[0];
        let Package { imports, optional, .. } = &packages[name];
        let own = staircase.iter().position(|other| other == name).expect("it has a row");
        let above: BTreeSet<&String> = staircase[..own].iter().collect();
        let below: Vec<_> = imports.iter().chain(optional).filter(|other| !above.contains(other)).collect();
        assert!(below.is_empty(), "{name} imports {below:?}, which stand below it");
        let always = listed(imports, &staircase);
        let expected = match (always.is_empty(), optional.is_empty()) {
            (true, _) => "–".to_owned(),
            (false, true) => always,
            (false, false) => format!("{always}; by a feature {}", listed(optional, &staircase)),
        };
        assert_eq!(row[2], expected, "imports of {name}");
    }
}

#[test]
fn heads_of_crates_say_what_the_manifests_import() {
    let (packages, staircase) = (Package::all(), staircase());
    let crates = packages.values().filter(|package| package.folder.starts_with(root().join("crates")));
    for Package { folder, imports, .. } in crates {
        let text = read(&folder.join("src/lib.rs"));
        let head: Vec<&str> =
            text.lines().map_while(|line| line.strip_prefix("//!")).map(str::trim_start).collect();
        let names: Vec<String> =
            staircase.iter().filter(|name| imports.contains(*name)).map(|name| format!("`{name}`")).collect();
        let expected = match names.split_last() {
            None => "Imports no other crate of the workspace.".to_owned(),
            Some((last, [])) => format!("Imports {last}."),
            Some((last, others)) => format!("Imports {} and {last}.", others.join(", ")),
        };
        assert!(head.join(" ").contains(&expected), "{}: its head lacks: {expected}", folder.display());
    }
}

/// All that a package imports, directly or not.
fn reached<'a>(name: &str, packages: &'a BTreeMap<String, Package>) -> BTreeSet<&'a str> {
    let direct = &packages[name].imports;
    let further = direct.iter().flat_map(|import| reached(import, packages));
    direct.iter().map(String::as_str).chain(further).collect()
}

#[test]
fn the_picture_has_an_arrow_for_each_import_that_follows_from_no_other() {
    let packages = Package::all();
    let mut expected = BTreeSet::new();
    for (name, Package { imports, optional, .. }) in &packages {
        let further: BTreeSet<&str> = imports.iter().flat_map(|import| reached(import, &packages)).collect();
        let direct = imports.iter().filter(|import| !further.contains(import.as_str()));
        expected.extend(direct.map(|import| format!("{name} imports {import}")));
        expected.extend(optional.iter().map(|import| format!("{name} imports {import} with a feature")));
    }
    let picture = read(&root().join("docs/architecture.svg"));
    let titles = picture.split("<title>").skip(1).filter_map(|rest| rest.split("</title>").next());
    assert_eq!(titles.map(str::to_owned).collect::<BTreeSet<_>>(), expected);
}

#[test]
fn public_nouns_are_public() {
    let packages = Package::all();
    let rows = table("## Public nouns");
    let libraries: BTreeSet<&str> =
        packages.keys().map(String::as_str).filter(|name| !["radiosity", "python"].contains(name)).collect();
    assert_eq!(rows.iter().map(|row| marked(&row[0])[0]).collect::<BTreeSet<_>>(), libraries);
    for row in &rows {
        let name = marked(&row[0])[0];
        let text = sources(&packages[name].folder.join("src"));
        let words: Vec<&str> =
            text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty()).collect();
        for noun in marked(&row[1]) {
            let kinds = ["struct", "enum", "trait", "fn"];
            let is_there = words
                .windows(3)
                .any(|three| three[0] == "pub" && kinds.contains(&three[1]) && three[2] == noun);
            assert!(is_there, "{name} has no public {noun}");
        }
    }
}

/// Whether documentation holds a program, which rustdoc would try.
fn documents_programs(text: &str) -> bool {
    let lines = text.lines().map(str::trim_start);
    let documents = lines.filter_map(|line| line.strip_prefix("//!").or(line.strip_prefix("///")));
    let fences = documents.filter_map(|line| line.trim_start().strip_prefix("```"));
    // Every other one ends what the one before begins.
    fences.step_by(2).any(|language| !["text", "toml"].contains(&language))
}

/// Manifests leave out the tests of targets that have none, which would be compiled and linked for nothing.
#[test]
fn tests_are_left_out_where_there_are_none() {
    for folder in folders().into_iter().filter(|folder| folder.join("src").is_dir()) {
        let (manifest, name) = (manifest(&folder), folder.display());
        let bins = manifest.get("bin").and_then(toml::Value::as_array).into_iter().flatten();
        let targets: Vec<&toml::Value> = manifest.get("lib").into_iter().chain(bins).collect();
        let is_off = |key: &str| targets.iter().any(|target| target.get(key) == Some(&false.into()));
        let text = sources(&folder.join("src"));
        let has_tests = ["#[test]", "proptest! {"].iter().any(|mark| text.contains(mark));
        assert!(!(is_off("test") && has_tests), "{name}: its manifest leaves tests out");
        assert!(
            !(is_off("doctest") && documents_programs(&text)),
            "{name}: its manifest leaves programs out"
        );
    }
}

/// The texts of all sources in a folder, one after another.
fn sources(folder: &Path) -> String {
    let entries = fs::read_dir(folder).expect("source folders can be listed");
    let paths = entries.map(|entry| entry.expect("source folders can be listed").path());
    paths.map(|path| if path.is_dir() { sources(&path) } else { read(&path) }).collect()
}

//! The table of cures: each row has an input that draws a message with a cure, parts of that message, and the input
//! changed as the cure says, which draws no message.

mod warnings;
mod scenes;
mod files;
mod workplace;
mod commands;
mod runs;
mod drawn;
mod literals;
mod messages;
mod untried;
mod coverage;

use std::collections::BTreeSet;

use radiosity_test_support::folders::folder;
use serde_json::Value;

use crate::program::{self, assert_refused, radiosity};

/// A part of [`ROOM`], what stands in its place, wrongly and cured, and parts of the message.
struct Row {
    part: &'static str,
    bad: &'static str,
    cured: &'static str,
    told: &'static [&'static str],
}

/// A file that rows change, and the scene that is checked with it.
struct Changed {
    /// The scene that `check` reads.
    scene: &'static str,
    /// The file that rows change.
    changed: &'static str,
    /// Arguments of `check` behind the scene.
    arguments: &'static [&'static str],
    /// Names and texts of all files, which are right.
    files: &'static [(&'static str, &'static str)],
    rows: &'static [Row],
}

/// A command as it is typed, wrongly and cured, and parts of the message.
struct Typed {
    bad: &'static str,
    cured: &'static str,
    told: &'static [&'static str],
}

/// A room in which nothing looks wrong.
const ROOM: &str = r#"title = "room"
bands = ["grey"]
[camera]
eye = [2, -2.6, 1.4]
target = [0, 0, 0.3]
[materials.white]
reflectance = 0.5
[materials.lamp]
reflectance = 0
emission = 100
[[surfaces]]
name = "room"
material = "white"
box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
[[surfaces]]
name = "lamp"
material = "lamp"
disk = { center = [-1, -1, 2.4], normal = [0, 0, -1], radius = 0.2 }
# more
"#;

/// The part of the room to add to.
const MORE: &str = "# more\n";

/// A room that takes no time.
const CUBE: &str = r#"title = "room"
bands = ["grey"]
[camera]
eye = [0.2, 0.2, 0.5]
target = [1, 1, 0.5]
[planes.desk]
origin = [0.2, 0.2, 0.5]
edges = [[0.5, 0, 0], [0, 0.5, 0]]
spacing = 0.5
[materials.white]
reflectance = 0.5
emission = 1
[[surfaces]]
name = "room"
material = "white"
box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true }
"#;

impl Row {
    /// The right `text` with `new` in place of the part.
    fn put(&self, text: &str, new: &str) -> String {
        assert!(text.contains(self.part), "{:?} is no part of\n{text}", self.part);
        text.replacen(self.part, new, 1)
    }

    fn with(&self, text: &str) -> String {
        self.put(ROOM, text)
    }
}

impl Changed {
    /// The outcome of `check` where `put` changes the text of the file.
    fn checked(&self, put: impl Fn(&str) -> String, more: &[&str]) -> std::process::Output {
        let change = |name: &str, text: &str| if name == self.changed { put(text) } else { text.to_owned() };
        let files: Vec<(&str, String)> =
            self.files.iter().map(|(name, text)| (*name, change(name, text))).collect();
        let folder = folder(&files);
        radiosity(folder.path(), &[&["check", self.scene], self.arguments, more].concat())
    }

    fn refused(&self, row: &Row) -> std::process::Output {
        self.checked(|text| row.put(text, row.bad), &[])
    }

    /// Kinds of warnings, and what is told of the import.
    #[track_caller]
    fn findings(&self, put: impl Fn(&str) -> String) -> BTreeSet<String> {
        let [found, _] = program::succeeded(self.checked(put, &["--format", "json"]));
        let found: Value = serde_json::from_str(&found).expect("JSON");
        let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
        let warnings = list(&found["warnings"]).into_iter().map(|warning| warning["code"].to_string());
        let remarks = list(&found["imported"]["remarks"]).into_iter().map(|remark| remark.to_string());
        warnings.chain(remarks).collect()
    }
}

/// Words of a strict `check` of a scene, which finds nothing wrong.
#[track_caller]
fn assert_clean(scene: &str) {
    let folder = folder(&[("room.toml", scene)]);
    let output = radiosity(folder.path(), &["check", "--strict", "room.toml"]);
    let [found, refused] = [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text));
    assert!(output.status.success(), "{found}{refused}\nin\n{scene}");
    assert!(found.contains("nothing looks wrong"), "{found}");
}

#[test]
fn what_is_warned_of_is_cured_as_the_warning_says() {
    assert_clean(ROOM);
    for (row, drawn) in warnings::ROWS.iter().zip(drawn::WARNED.iter()) {
        let [found, _] = program::succeeded(drawn.clone());
        let is_told = |line: &str| row.told.iter().all(|part| line.contains(part));
        assert!(found.lines().any(is_told), "{:?} is missing in\n{found}", row.told);
        assert_clean(&row.with(row.cured));
    }
}

#[test]
fn faults_of_scenes_are_cured_as_the_message_says() {
    for (row, drawn) in scenes::ROWS.iter().copied().flatten().zip(drawn::ROOMS.iter()) {
        assert_refused(drawn, row.told);
        assert_clean(&row.with(row.cured));
    }
}

#[test]
fn faults_of_files_are_cured_as_the_message_says() {
    let mut drawn = drawn::FILES.iter();
    for file in files::CHANGED {
        let usual = file.findings(str::to_owned);
        for (row, drawn) in file.rows.iter().zip(&mut drawn) {
            assert_refused(drawn, row.told);
            let found = file.findings(|text| row.put(text, row.cured));
            assert!(found.is_subset(&usual), "{}: {:?}: {found:?} beyond {usual:?}", file.scene, row.cured);
        }
    }
}

/// Asserts that the cured commands run without a warning, but that mirrors are mirrors.
#[track_caller]
fn assert_cured<'a>(rows: impl IntoIterator<Item = &'a Typed>) {
    for row in rows {
        let output = &drawn::COMMANDS.cured[row.cured];
        let told = String::from_utf8_lossy(&output.stderr);
        let warns = |line: &str| line.starts_with("warning: ") && !line.contains("few real materials exceed");
        assert!(output.status.success() && !told.lines().any(warns), "{}: {told}", row.cured);
    }
}

#[test]
fn commands_that_are_refused_are_cured_as_the_message_says() {
    let rows = || commands::ROWS.iter().copied().flatten();
    for (row, drawn) in rows().zip(&drawn::COMMANDS.refused) {
        assert_refused(drawn, row.told);
    }
    assert_cured(rows());
}

#[test]
fn what_runs_warn_of_is_cured_as_the_warning_says() {
    for (row, drawn) in runs::ROWS.iter().zip(&drawn::COMMANDS.warned) {
        let told = String::from_utf8_lossy(&drawn.stderr);
        let is_told = |line: &str| row.told.iter().all(|part| line.contains(part));
        let is_meant = |line: &str| ["warning: ", "help: "].iter().any(|start| line.starts_with(start));
        assert!(told.lines().any(|line| is_meant(line) && is_told(line)), "{told}");
    }
    assert_cured(runs::ROWS);
}

/// A ball that rests on the floor, a partition that reaches a centimetre into a wall, a globe of two sides about a
/// lamp: nothing of them is to be turned over.
#[test]
fn what_is_right_is_not_to_be_turned_over() {
    let objects = [
        "sphere = { center = [0, 0, 0.4], radius = 0.4 }",
        "box = { origin = [-3.01, 0, 0], size = [3.01, 0.1, 2] }",
        "two_sided = true\nsphere = { center = [-1, -1, 2.4], radius = 0.3 }",
    ];
    for object in objects {
        let scene = format!("{ROOM}[[surfaces]]\nname = \"object\"\nmaterial = \"white\"\n{object}\n");
        let folder = folder(&[("room.toml", &scene)]);
        let [found, _] = program::done(folder.path(), &["check", "room.toml"]);
        assert!(!found.contains("flip"), "{found}");
    }
}

/// Of a house on a ground, open below, no roof is to be turned over, though it faces nothing.
#[test]
fn a_house_open_below_is_right() {
    let quad = |name: &str, corners: &str| {
        format!(
            "[[surfaces]]\nname = \"{name}\"\nmaterial = \"white\"\nquad = {{ vertices = [{corners}] }}\n"
        )
    };
    let walls = [
        ("ground", "[-9,-9,0],[9,-9,0],[9,9,0],[-9,9,0]"),
        ("roof", "[0,0,3],[1,0,3],[1,1,3],[0,1,3]"),
        ("south", "[0,0,0],[1,0,0],[1,0,3],[0,0,3]"),
        ("east", "[1,0,0],[1,1,0],[1,1,3],[1,0,3]"),
        ("north", "[1,1,0],[0,1,0],[0,1,3],[1,1,3]"),
        ("west", "[0,1,0],[0,0,0],[0,0,3],[0,1,3]"),
    ];
    let parts: String = walls.iter().map(|(name, corners)| quad(name, corners)).collect();
    let lamp = "[[luminaires]]\nposition = [0.5, 0.5, 9]\npoint = {}\nflux = 100\n";
    let scene = format!("bands = [\"grey\"]\n[materials.white]\nreflectance = 0.5\n{lamp}{parts}");
    let folder = folder(&[("house.toml", scene)]);
    let [found, _] = program::done(folder.path(), &["check", "house.toml"]);
    assert!(!found.contains("flip"), "{found}");
}

/// A lone point in a solid, where light is rounding, is warned of.
#[test]
fn a_lone_point_in_a_solid_is_warned_of() {
    let solid = "[[surfaces]]\nname = \"solid\"\nmaterial = \"white\"\nbox = { origin = [0, 0, 0.5], size = [1, 1, 1] }\n";
    let files = [("room.toml", format!("{ROOM}{solid}")), ("point.csv", "0.5,0.5,1,0,0,1\n".to_owned())];
    let folder = folder(&files);
    let [_, told] = program::done(folder.path(), &["probe", "room.toml", "--points", "point.csv"]);
    assert!(told.contains("1 of the 1 points lie outside of the room or in solids: move them"), "{told}");
}

/// Keys that cures name are those of scene files: a file of another program is cured once it is converted.
#[test]
fn a_file_of_another_program_is_cured_once_it_is_converted() {
    let away = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\no floor\nf 1 2 3 4\n\
                o lid\nf 5 6 7 8\n";
    let folder = folder(&[("scene.obj", away)]);
    let [found, _] = program::done(folder.path(), &["check", "scene.obj"]);
    for cure in [
        "add a [camera] with eye and target, in the scene converted to .toml",
        "flip = true turns it over, in the scene converted to .toml",
        "or a sky and an opening to it, in the scene converted to .toml",
    ] {
        assert!(found.contains(cure), "{cure:?} is missing in\n{found}");
    }
    program::done(folder.path(), &["convert", "scene.obj", "scene.toml"]);
    let scene = std::fs::read_to_string(folder.path().join("scene.toml")).expect("the scene");
    let turned = scene.replacen("name = \"lid\"", "name = \"lid\"\nflip = true", 1);
    let camera = "[camera]\neye = [0.5, 0.2, 0.5]\ntarget = [0.5, 0.9, 0.5]\n";
    let lamp = "[[luminaires]]\nposition = [0.5, 0.5, 0.5]\npoint = {}\nflux = 1\n";
    let scene = format!("{turned}\n{camera}{lamp}");
    let folder = self::folder(&[("room.toml", &scene)]);
    let [found, _] = program::done(folder.path(), &["check", "room.toml"]);
    assert!(
        !found.contains("flip") && !found.contains("camera]") && !found.contains("nothing emits"),
        "{found}"
    );
}

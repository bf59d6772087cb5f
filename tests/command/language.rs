//! Variables, files within files and the schema on the command line.

use radiosity_test_support::folders::folder;
use std::fs;

use crate::program::{done, refused};

const ROOM: &str = r#"include = "white.toml"
variables = { width = 2, emission = 10 }
[materials.lamp]
reflectance = 0
emission = "=emission"
group = "lamps"
[[surfaces]]
name = "floor"
material = "white"
parallelogram = { origin = [0, 0, 0], edge1 = ["=width", 0, 0], edge2 = [0, 1, 0] }
[[surfaces]]
name = "lamp"
material = "lamp"
parallelogram = { origin = [0, 0, 1], edge1 = [0, 1, 0], edge2 = [1, 0, 0] }
"#;

const FILES: [(&str, &str); 2] =
    [("room.toml", ROOM), ("white.toml", "materials.white = { reflectance = 0.5 }")];

/// The means of all cells, one for each surface.
fn means(table: &str) -> Vec<f64> {
    let column = table.lines().next().unwrap().split(',').position(|name| name == "E_grey");
    let column = column.unwrap_or_else(|| panic!("no E_grey in {table}"));
    table.lines().skip(1).map(|line| line.split(',').nth(column).unwrap().parse().unwrap()).collect()
}

#[test]
fn variables_and_light_groups_are_set_together() {
    let folder = folder(&FILES);
    let here = folder.path();
    let [told, _] = done(here, &["check", "room.toml", "--set", "width=3"]);
    assert!(told.contains("variables: width = 3, emission = 10"), "{told}");
    assert!(told.contains("total area 4.000000"), "{told}");
    let [told, _] = done(here, &["check", "room.toml", "--set", "width=3", "--format", "json"]);
    let told: serde_json::Value = serde_json::from_str(&told).unwrap();
    assert_eq!(told["variables"], serde_json::json!({ "emission": 10.0, "width": 3.0 }));
    assert_eq!(told["bands"], serde_json::json!(["grey"]));

    let method = ["--order", "1", "--eps", "0.1", "-q"];
    let grid =
        |args: &[&str]| means(&done(here, &[&["grid"], args, &["--cells", "1x1"], &method[..]].concat())[0]);
    let [once, twice] = ["10", "20"].map(|e| grid(&["room.toml", "--set", &format!("emission={e}")]));
    let dimmed = grid(&["room.toml", "--set", "emission=20", "--set", "lamps=0.5"]);
    for ((once, twice), dimmed) in once.iter().zip(&twice).zip(&dimmed) {
        assert!((2.0 * once - twice).abs() < 1e-12 * twice && (once - dimmed).abs() < 1e-12 * once);
    }

    let set = ["--set", "emission=20", "--set", "lamps=0.5"];
    done(here, &[&["solve", "room.toml", "-o", "room.json"], &set[..], &method].concat());
    fs::remove_file(here.join("room.toml")).unwrap();
    fs::remove_file(here.join("white.toml")).unwrap();
    assert_eq!(means(&done(here, &["grid", "room.json", "--cells", "1x1", "-q"])[0]), dimmed);
    let parts = ["\"emission\" is a variable", "help: give the scene itself with --set emission="];
    refused(here, &["relight", "room.json", "--set", "emission=1"], &parts);
    refused(here, &["grid", "room.json", "--set", "emission=1"], &parts);
}

#[test]
fn names_of_nothing_are_refused_with_what_there_is() {
    let folder = folder(&FILES);
    let here = folder.path();
    let cure = "help: did you mean \"lamps\"? variables of this scene: width, emission; light groups: lamps";
    refused(
        here,
        &["grid", "room.toml", "--set", "lamp=1"],
        &["there is no variable or light group \"lamp\"", cure],
    );
    let parts = ["there is no variable \"lamps\"", "variables of this scene: width, emission"];
    refused(here, &["check", "room.toml", "--set", "lamps=1"], &parts);
    let both = ROOM.replace("\"lamps\"", "\"width\"");
    fs::write(here.join("room.toml"), both).unwrap();
    let parts = ["a variable and a light group are both called \"width\"", "help: rename one of them"];
    refused(here, &["grid", "room.toml", "--set", "width=1"], &parts);
    fs::write(here.join("room.toml"), ROOM.replace("white.toml", "black.toml")).unwrap();
    let parts = ["room.toml:1:11: include: \"black.toml\" cannot be read: ", "help: check the path"];
    refused(here, &["check", "room.toml"], &parts);
    fs::write(here.join("room.toml"), ROOM).unwrap();
    fs::write(here.join("white.toml"), "\nmaterials.white = { reflectance = 1.5 }").unwrap();
    let parts = [
        "white.toml:2:35: material \"white\": the reflectance is 1.5",
        "2 | materials.white = { reflectance",
    ];
    refused(here, &["check", "room.toml"], &parts);
}

#[test]
fn the_schema_is_printed() {
    let folder = tempfile::tempdir().unwrap();
    let printed: serde_json::Value = serde_json::from_str(&done(folder.path(), &["schema"])[0]).unwrap();
    assert_eq!(printed, radiosity::language::schema());
}

//! `relight`, and `--set` of light groups: what is written is what solving the dimmed scene would write.

use std::fs;

use base64::{Engine, prelude::BASE64_STANDARD as STANDARD};
use radiosity_test_support::folders::{self, json};
use radiosity_test_support::solved::sealed;
use serde_json::Value;

use crate::program::{done, radiosity, refused};

/// A closed room with lamps on its ceiling, a window of the same material and a wall that glows on its own;
/// exitances of lamps and window.
fn room(lamps: f64, window: f64) -> String {
    let quad = |name: &str, keys: &str, vertices: &str| {
        format!("[[surfaces]]\nname = \"{name}\"\n{keys}\nquad = {{ vertices = [{vertices}] }}\n")
    };
    let white = "material = \"white\"";
    let walls = [
        quad("floor", white, "[0,0,0],[1,0,0],[1,1,0],[0,1,0]"),
        quad("ceiling", "material = \"lamp\"", "[0,0,1],[0,1,1],[1,1,1],[1,0,1]"),
        quad("west", "material = \"pane\"\ngroup = \"window\"", "[0,0,0],[0,1,0],[0,1,1],[0,0,1]"),
        quad("east", white, "[1,0,0],[1,0,1],[1,1,1],[1,1,0]"),
        quad("south", "material = \"glow\"", "[0,0,0],[0,0,1],[1,0,1],[1,0,0]"),
        quad("north", white, "[0,1,0],[1,1,0],[1,1,1],[0,1,1]"),
    ];
    format!(
        "bands = [\"lm\"]\n\
         camera = {{ eye = [0.5, 0.1, 0.5], target = [0.5, 1, 0.4], width = 16, height = 12 }}\n\
         [materials]\n\
         white = {{ reflectance = 0.6 }}\n\
         lamp = {{ reflectance = 0, emission = {lamps:?}, group = \"lamps\" }}\n\
         pane = {{ reflectance = 0.1, emission = {window:?}, group = \"lamps\" }}\n\
         glow = {{ reflectance = 0.2, emission = 1 }}\n{}",
        walls.concat()
    )
}

const METHOD: [&str; 4] = ["--order", "2", "--eps", "1e-4"];

/// A folder with the room and its solution, `room.json`.
fn folder() -> tempfile::TempDir {
    let folder = folders::folder(&[("room.toml", room(10.0, 4.0))]);
    done(folder.path(), &[&["solve", "room.toml", "-o", "room.json", "-q"][..], &METHOD].concat());
    folder
}

/// Coefficients of all elements.
fn irradiance(file: &Value) -> Vec<f64> {
    let elements = file["elements"].as_array().unwrap().iter();
    let own = elements.flat_map(|element| element["irradiance"][0].as_array().unwrap());
    own.map(|value| value.as_f64().unwrap()).collect()
}

#[test]
fn a_relit_solution_is_that_of_the_dimmed_scene() {
    let folder = folder();
    let here = folder.path();
    let set = ["--set", "lamps=0.3", "--set", "window=1.2"];
    done(here, &[&["relight", "room.json", "-o", "relit.json", "--report", "r.json"][..], &set].concat());
    fs::write(here.join("dimmed.toml"), room(3.0, 4.8)).unwrap();
    let again = ["solve", "dimmed.toml", "-o", "dimmed.json", "-q", "--report", "d.json"];
    done(here, &[&again[..], &METHOD].concat());
    let [relit, dimmed] = ["relit.json", "dimmed.json"].map(|name| irradiance(&json(&here.join(name))));
    let scale = relit.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    assert!(relit.len() == dimmed.len() && scale > 1.0);
    let far = relit.iter().zip(&dimmed).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(far <= 1e-12 * scale, "{far:e} of {scale:e}");
    let [relit, dimmed] = ["r.json", "d.json"].map(|name| json(&here.join(name)));
    for key in ["energy_in", "energy_absorbed", "energy_lost"] {
        let [a, b] = [&relit, &dimmed].map(|report| report["checks"][key].as_f64().unwrap());
        assert!((a - b).abs() <= 1e-12 * relit["checks"]["energy_in"].as_f64().unwrap(), "{key}: {a} {b}");
    }
    let groups = serde_json::json!([{"name": "lamps", "factor": 0.3}, {"name": "window", "factor": 1.2}]);
    assert_eq!(relit["light_groups"], groups);
}

#[test]
fn the_file_the_solution_and_the_scene_read_alike_at_the_same_factors() {
    let folder = folder();
    let here = folder.path();
    let set = ["--set", "window=0.5", "--set", "lamps=0"];
    let [_, told] = done(here, &[&["relight", "room.json"][..], &set].concat());
    assert!(told.contains("light groups: lamps × 0, window × 0.5"), "{told}");
    assert!(told.contains("wrote room.relit.json"), "{told}");
    let quiet = [&set[..], &["-q"]].concat();
    done(here, &[&["solve", "room.toml", "-o", "solved.json"][..], &quiet, &METHOD].concat());
    let [relit, solved] = ["room.relit.json", "solved.json"].map(|name| fs::read(here.join(name)).unwrap());
    assert_eq!(relit, solved);
    fs::write(here.join("p.csv"), "0.5,0.5,0.5,0,0,1\n0.2,0.3,0,0,0,1\n").unwrap();
    let verbs: [&[&str]; 3] = [
        &["grid", "--cells", "3x2", "--read-eps", "1e-3"],
        &["probe", "--points", "p.csv", "--read-eps", "1e-3"],
        &["render", "-o", "picture.png"],
    ];
    for verb in verbs {
        let read = |scene: &str, options: &[&str]| {
            let [table, _] = done(here, &[verb, &[scene], options].concat());
            (table, fs::read(here.join("picture.png")).ok())
        };
        let relit = read("room.relit.json", &["-q"]);
        assert!(relit == read("room.json", &quiet), "{verb:?}");
        assert!(relit == read("room.toml", &[&quiet[..], &METHOD].concat()), "{verb:?}");
        assert!(relit != read("room.json", &["-q"]), "{verb:?}: factors were passed over");
    }
}

#[test]
fn factors_are_those_of_the_scene_so_that_lights_come_back() {
    let folder = folder();
    let here = folder.path();
    done(here, &["relight", "room.json", "--set", "lamps=0", "-o", "off.json", "-q"]);
    done(here, &["relight", "off.json", "--set", "lamps=1", "-o", "on.json", "-q"]);
    let [first, on] = ["room.json", "on.json"].map(|name| fs::read_to_string(here.join(name)).unwrap());
    assert_eq!(first, on);
}

#[test]
fn all_lights_may_be_off() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    fs::write(here.join("room.toml"), room(10.0, 4.0).replace("emission = 1 ", "")).unwrap();
    done(here, &[&["solve", "room.toml", "-o", "room.json", "-q"][..], &METHOD].concat());
    let off = ["--set", "lamps=0", "--set", "window=0"];
    let [_, told] = done(here, &[&["relight", "room.json", "-o", "off.json"][..], &off].concat());
    assert!(!told.contains("NaN"), "{told}");
    done(here, &["render", "off.json", "-o", "off.png"]);
    done(here, &["grid", "off.json", "--cells", "2x2"]);
}

#[test]
fn changed_light_of_a_group_is_refused() {
    let folder = folder();
    let here = folder.path();
    let mut file = json(&here.join("room.json"));
    let given = file["groups"][1]["bands"][0]["irradiance"].as_str().expect("it is a text").to_owned();
    let refuses = |file: &serde_json::Value, what: &str| {
        fs::write(here.join("changed.json"), sealed(&file.to_string())).unwrap();
        let output = radiosity(here, &["grid", "changed.json"]);
        let told = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(2) && told.contains(what), "{what}: {told}");
    };
    let mut bytes = STANDARD.decode(&given).expect("it is Base64");
    for (number, what) in [
        (1e3, "element 0: the light of its groups"),
        (1e20, "element 0: the size of the coefficients"),
        (f64::NAN, "coefficients of a light group that are no numbers"),
    ] {
        bytes[..8].copy_from_slice(&f64::to_le_bytes(number));
        file["groups"][1]["bands"][0]["irradiance"] = STANDARD.encode(&bytes).into();
        refuses(&file, what);
    }
    file["groups"][1]["bands"][0]["irradiance"] = STANDARD.encode(&bytes[4..]).into();
    refuses(&file, "coefficients of a light group that are no numbers");
    file["groups"][1]["bands"][0]["irradiance"] = STANDARD.encode(&bytes[8..]).into();
    refuses(&file, "the number of coefficients of the light groups");
    file["groups"] = serde_json::json!([]);
    refuses(&file, "the list of light groups");
}

#[test]
fn settings_that_make_no_sense_are_refused() {
    let folder = folder();
    let here = folder.path();
    for verb in [&["relight", "room.json"][..], &["grid", "room.json"], &["grid", "room.toml"]] {
        let refused = |set: &[&str], parts: &[&str]| {
            let set: Vec<&str> = set.iter().flat_map(|setting| ["--set", setting]).collect();
            refused(here, &[verb, &set].concat(), parts);
        };
        let known = "help: did you mean \"lamps\"? light groups of this scene: lamps, window";
        refused(&["lamp=0.5"], &["room.toml: no light comes from a group \"lamp\"", known]);
        refused(&["lamps=1", "lamps=1"], &["the light group \"lamps\" is set twice", "help: keep one"]);
        let parts = ["light group \"lamps\": the factor is -1, outside factor ≥ 0", "help: choose a value"];
        refused(&["lamps=-1"], &parts);
        for value in ["lamps=NaN", "lamps=inf", "lamps=1e999", "lamps=half", "lamps"] {
            refused(&[value], &["expected a name and a finite number", "--set"]);
        }
    }
    refused(here, &["relight", "room.json"], &["--set <GROUP=FACTOR>"]);
    let parts = ["room.toml: this is no solution", "help: solve it first"];
    refused(here, &["relight", "room.toml", "--set", "lamps=1"], &parts);
    let parts = ["this is the file of the scene as well", "help: choose another name"];
    refused(here, &["relight", "room.json", "--set", "lamps=1", "-o", "room.json"], &parts);
    refused(here, &["relight", "none.json", "--set", "lamps=1"], &["none.json: cannot be read"]);
}

#[test]
fn scenes_without_groups_say_how_to_have_some() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    done(here, &["solve", "furnace-cube", "--order", "1", "-o", "cube.json", "-q"]);
    let parts = [
        "furnace-cube: no light comes from a group \"lamps\"",
        "help: this scene has no light groups",
        "group =",
    ];
    refused(here, &["relight", "cube.json", "--set", "lamps=0.5"], &parts);
    refused(here, &["grid", "cube.json", "--set", "lamps=0.5"], &parts);
    let parts = ["there is no parameter \"lamps\"", "parameters of this scene"];
    refused(here, &["grid", "furnace-cube", "--set", "lamps=0.5"], &parts);
    fs::write(here.join("room.toml"), room(1.0, 1.0)).unwrap();
    refused(
        here,
        &["check", "room.toml", "--set", "lamps=0.5"],
        &["the scene has no variables, yet \"lamps\" is set", "help: define it: [variables]"],
    );
}

//! Solutions written and read back: whatever is read from the file is what would be read from the run that
//! wrote it.

use std::fs;

use radiosity::Work;
use radiosity::reading::files::solution_file::{SolutionFile, is_solution, read};
use radiosity::scene::Source;
use radiosity::solve::Options;
use radiosity::solve::solved::Solved;
use radiosity::solve::studies::adaptation::{Aim, Goal};
use radiosity_test_support::folders::folder;
use radiosity_test_support::scenes::{builtin, parsed};
use radiosity_test_support::solved::{sealed, solved_of};
use serde_json::{Value, json};

use crate::program::{self, done};

/// A bent floor, a wall with a hole, a triangle that is lit on both sides and shades the rest, a lamp.
const ROOM: &str = r#"bands = ["red", "far, infrared"]
[camera]
eye = [0.5, -2, 0.7]
target = [0.5, 0.5, 0.5]
width = 24
height = 16
[materials.white]
reflectance = [0.7, 0.3]
[materials.lamp]
reflectance = 0
emission = [10, 0.1]
[[surfaces]]
name = "floor"
material = "white"
quad = { vertices = [[0,0,0],[1,0,0],[1,1,0.02],[0,1,0]] }
[[surfaces]]
name = "wall"
material = "white"
polygon = { vertices = [[0,1,0.3],[1,1,0.3],[1,1,1],[0,1,1]], holes = [[[0.4,1,0.5],[0.6,1,0.5],[0.5,1,0.8]]] }
[[surfaces]]
name = "sail"
material = "white"
two_sided = true
triangle = { vertices = [[0.2,0.3,0.5],[0.7,0.3,0.5],[0.4,0.6,0.6]] }
[[surfaces]]
name = "lamp"
material = "lamp"
quad = { vertices = [[0.3,0.3,0.95],[0.3,0.6,0.95],[0.6,0.6,0.95],[0.6,0.3,0.95]] }
"#;

#[test]
fn pictures_and_grids_are_the_same_bytes() {
    let methods = [
        "--order 3 --eps 0.1 --shadow-eps 0.3",
        "--order 2 --tensor --subdivide 1 --layers 1 --eps 0.3 --shadows off",
        "--order 0 --subdivide 2 --eps 0.1 --solver southwell",
    ];
    for method in methods {
        let method: &[&str] = &method.split(' ').collect::<Vec<_>>();
        let folder = folder(&[("room.toml", ROOM)]);
        let here = folder.path();
        let run = |verb: &[&str], options: &[&str]| done(here, &[verb, options, &["--quiet"]].concat());
        run(&["solve", "room.toml", "-o", "one.json", "--threads", "1"], method);
        run(&["solve", "room.toml", "-o", "three.json", "--threads", "3"], method);
        let [one, three] = ["one.json", "three.json"].map(|name| fs::read(here.join(name)).unwrap());
        assert_eq!(one, three, "{method:?}: the number of threads is in the file");

        let direct = run(&["grid", "room.toml", "--cells", "5x3"], method);
        let read = run(&["grid", "one.json", "--cells", "5x3", "--threads", "3"], &[]);
        assert_eq!(direct[0], read[0], "{method:?}");

        for mode in ["basis", "direct"] {
            run(&["render", "room.toml", "-o", "direct.png", "--read", mode], method);
            run(&["render", "one.json", "-o", "read.png", "--read", mode, "--threads", "3"], &[]);
            let [direct, read] = ["direct.png", "read.png"].map(|name| fs::read(here.join(name)).unwrap());
            assert_eq!(direct, read, "{method:?}, --read {mode}");
        }
    }
}

fn solved() -> Solved {
    let scene = parsed(&Source::new("rooms/room.toml", ROOM));
    solved_of(scene, Options { order: 2, eps: 0.1, shadow_eps: 0.3, ..Options::default() })
}

fn text_of(solved: &Solved) -> String {
    serde_json::to_string(&SolutionFile::new(solved)).unwrap()
}

#[test]
fn what_was_read_is_written_as_it_was() {
    let text = text_of(&solved());
    assert!(is_solution(&text));
    let again = read(&Source::new("a.json", &text)).unwrap();
    assert_eq!(again.scene.name, "room");
    assert_eq!(text_of(&again), text);
}

#[test]
fn refined_elements_are_read_as_they_were() {
    let scene = builtin("empty-box");
    let goal = Goal::new(1e-3, Aim::Gathered);
    let solved = Solved::to_accuracy(scene, &Options::default(), &goal, &Work::alone()).unwrap();
    assert!(solved.outcome.solution.elements().refined_mesh().is_some(), "the box needs refined elements");
    let text = text_of(&solved);
    let again = read(&Source::new("a.json", &text)).unwrap();
    assert_eq!(
        again.outcome.solution.elements().refined_mesh(),
        solved.outcome.solution.elements().refined_mesh()
    );
    assert_eq!(text_of(&again), text);
    let mut file: Value = serde_json::from_str(&text).unwrap();
    file["mesh"][0] = json!({ "cut": { "across": "u", "at": 3.0, "parts": [{ "leaf": 2 }, { "leaf": 2 }] } });
    let message = read(&Source::new("a.json", &sealed(&file.to_string()))).unwrap_err().to_string();
    assert!(message.contains("the mesh"), "{message}");
}

#[test]
fn a_reader_needs_nothing_but_the_file_to_evaluate_it() {
    // By the words of `evaluation`, at the middle of the wall, which is a plane element of the total space.
    let solved = solved();
    let file: Value = serde_json::from_str(&text_of(&solved)).unwrap();
    let elements = solved.outcome.solution.elements();
    let wall = solved.scene.surfaces.iter().position(|surface| surface.name == "wall").unwrap();
    let index = elements.at(wall, [-0.7, 0.3]).unwrap();
    let position = elements.shape(wall).jet(-0.7, 0.3).position;
    let saved = &file["elements"][index];
    assert_eq!(saved["surface"], "wall");
    let vector =
        |value: &Value| radiosity_geom::DVec3::from_array([0, 1, 2].map(|k| value[k].as_f64().unwrap()));
    let plane = &saved["frame"]["plane"];
    let offset = position - vector(&plane["origin"]);
    let [a, b] = ["first", "second"].map(|side| offset.dot(vector(&plane[side])));
    let legendre = |n: usize, x: f64| (n as f64 + 0.5).sqrt() * [1.0, x, 1.5 * x * x - 0.5][n];
    let places = [[0, 0], [1, 0], [0, 1], [2, 0], [1, 1], [0, 2]];
    let term = |(k, [i, j]): (usize, &[usize; 2])| {
        saved["irradiance"][0][k].as_f64().unwrap() * legendre(*i, a) * legendre(*j, b)
    };
    let value: f64 = places.iter().enumerate().map(term).sum();
    let place = radiosity::solve::solution::SurfacePlace { surface: wall, parameters: [-0.7, 0.3], position };
    let known = solved.outcome.solution.irradiance(0, index, &place);
    assert!((value - known).abs() < 1e-12 * known.abs(), "{value} {known}");
}

/// The message about a file whose tree was changed, by one who wrote its checksum anew.
fn refused(change: impl Fn(&mut Value)) -> String {
    let mut file: Value = serde_json::from_str(&text_of(&solved())).unwrap();
    change(&mut file);
    read(&Source::new("a.json", &sealed(&file.to_string()))).unwrap_err().to_string()
}

#[test]
fn changed_files_are_refused() {
    let message = refused(|file| file["format_version"] = 99.into());
    assert!(message.contains("a.json: the format's version is 99"), "{message}");
    let message = refused(|file| file["elements"].as_array_mut().unwrap().truncate(3));
    assert!(message.contains("the number of elements is not that of its scene"), "{message}");
    let message = refused(|file| file["elements"][2]["orthonormal"]["irradiance"][1][0] = 1e3.into());
    assert!(message.contains("element 2: the irradiance is not that of its scene"), "{message}");
    let message = refused(|file| file["elements"][0]["orthonormal"]["direct"][1] = Value::Array(Vec::new()));
    assert!(message.contains("element 0: the number of coefficients"), "{message}");
    let message = refused(|file| file["elements"][1]["order"] = 3.into());
    assert!(message.contains("element 1: the order"), "{message}");
    let message = refused(|file| file["discretization"]["subdivide"] = json!({ "uniform": 1_000_000 }));
    assert!(message.contains("subdivi"), "{message}");
    let message = refused(|file| file["scene"]["text"] = ROOM.replace("0.7, 0.3", "0.6, 0.3").into());
    assert!(message.contains("the reflectance is not that of its scene"), "{message}");
    let message = refused(|file| file["scene"]["text"] = ROOM.replace("0.7, 0.3", "1.7, 0.3").into());
    assert!(
        message.contains("the scene in it: rooms/room.toml:8:16: material \"white\": the reflectance is 1.7")
    );
    let message = refused(|file| file["options"]["method"] = "guess".into());
    assert!(message.contains("guess"), "{message}");
}

#[test]
fn damage_is_told() {
    let text = text_of(&solved());
    for (old, new) in [("\"energy_in\":", "\"energy_in\":1"), ("rooms/room.toml", "rooms/roam.toml")] {
        let changed = text.replacen(old, new, 1);
        assert_ne!(changed, text, "{old} is there");
        let error = read(&Source::new("a.json", &changed)).map(drop).unwrap_err();
        assert_eq!(error.to_string(), "a.json: damaged: its checksum is not that of its content", "{old}");
        assert_eq!(error.cure(), "the file is damaged or was changed: solve the scene again");
    }
    // One who writes the same content in another way did no damage.
    let file: Value = serde_json::from_str(&text).unwrap();
    assert!(read(&Source::new("a.json", &format!("{file:#}"))).is_ok());
}

#[test]
fn light_that_nothing_makes_is_refused() {
    let message = refused(|file| file["elements"][2]["orthonormal"]["direct"][1][0] = 1e20.into());
    assert!(
        message.contains("element 2: the size of the coefficients is not that of its scene"),
        "{message}"
    );
}

#[test]
fn the_command_line_refuses_what_makes_no_sense() {
    let folder = folder(&[("room.toml", ROOM)]);
    let here = folder.path();
    done(here, &["solve", "room.toml", "--order", "1", "--eps", "0.1", "--quiet"]);
    let file = "room.solution.json";
    let parts = ["error: --order: room.solution.json is a solution", "help: leave the option out"];
    program::refused(here, &["render", file, "-o", "x.png", "--order", "1"], &parts);
    program::refused(
        here,
        &["grid", file, "--shadow-eps", "0.1"],
        &["error: --shadow-eps: room.solution.json"],
    );
    program::refused(
        here,
        &["solve", file, "-o", "x.json"],
        &["this is a solution already", "help: give it to render"],
    );
    let text = fs::read_to_string(here.join(file)).unwrap();
    fs::write(here.join("cut.json"), &text[..text.len() / 2]).unwrap();
    let parts = ["error: cut.json: damaged at line 1, column", "help: the file is damaged"];
    program::refused(here, &["grid", "cut.json"], &parts);
}

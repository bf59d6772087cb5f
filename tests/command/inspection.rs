//! Findings of `check`: contacts, closed surfaces and their volumes by closed forms, gaps, crossings, fronts.

use std::f64::consts::PI;
use std::process::Command;

use radiosity::geom::Adjacency;
use radiosity::scene::Scene;
use radiosity::visibility::inspection::{Fronts, Inspection};
use radiosity_test_support::folders::json;
use radiosity_test_support::scenes::{builtin, typed};
use serde_json::Value;

use crate::program::done;

/// A scene of these surfaces, each `name | options and shape`, all of a material that emits.
fn scene(surfaces: &[&str]) -> Scene {
    let entry = |text: &&str| {
        let (name, rest) = text.split_once(" | ").expect("name | shape");
        format!("[[surfaces]]\nname = {name:?}\nmaterial = \"m\"\n{rest}\n")
    };
    let surfaces: String = surfaces.iter().map(entry).collect();
    let text = format!(
        "[camera]\neye = [0.4, 0.45, 0.55]\ntarget = [0, 0, 0]\n[materials.m]\nreflectance = 0.5\nemission = 1\n{surfaces}"
    );
    typed(&text)
}

fn inspect(surfaces: &[&str]) -> Inspection {
    Inspection::of(&scene(surfaces))
}

fn codes(inspection: &Inspection) -> Vec<&'static str> {
    inspection.warnings.iter().map(|warning| warning.code).collect()
}

/// The walls of the unit cube, fronts inside.
const CUBE: [&str; 6] = [
    "z0 | quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }",
    "z1 | quad = { vertices = [[0,0,1],[0,1,1],[1,1,1],[1,0,1]] }",
    "x0 | quad = { vertices = [[0,0,0],[0,1,0],[0,1,1],[0,0,1]] }",
    "x1 | quad = { vertices = [[1,0,0],[1,0,1],[1,1,1],[1,1,0]] }",
    "y0 | quad = { vertices = [[0,0,0],[0,0,1],[1,0,1],[1,0,0]] }",
    "y1 | quad = { vertices = [[0,1,0],[1,1,0],[1,1,1],[0,1,1]] }",
];

/// The cube with wall `k` replaced.
fn cube_with(k: usize, wall: &str) -> Vec<&str> {
    let mut walls = CUBE.to_vec();
    walls[k] = wall;
    walls
}

#[track_caller]
fn assert_closed(surfaces: &[&str], volume: f64, fronts: Fronts) {
    let found = inspect(surfaces);
    let [shell] = &found.shells[..] else { panic!("{:?} {:?}", found.shells, found.warnings) };
    assert!((shell.volume - volume).abs() < 1e-12 * volume, "{} instead of {volume}", shell.volume);
    assert_eq!(shell.fronts, fronts, "{:?}", found.warnings);
}

#[test]
fn closed_surfaces_have_their_volumes() {
    assert_closed(&CUBE, 1.0, Fronts::Inside);
    let moved = "transform = { scale = 2, rotate = [1,2,3,40], translate = [9,9,9] }\n";
    assert_closed(
        &[&format!("ball | {moved}sphere = {{ center = [1,0,0], radius = 0.5 }}")],
        4.0 / 3.0 * PI,
        Fronts::Outside,
    );
    assert_closed(
        &["ring | torus = { center = [5,0,0], axis = [0,1,1], major = 2, minor = 0.5 }"],
        PI * PI,
        Fronts::Outside,
    );
    let barrel = [
        "wall | cylinder = { base = [5,0,0], axis = [0,0,3], radius = 2, angle = [0, 360] }",
        "bottom | disk = { center = [5,0,0], normal = [0,0,-1], radius = 2, angle = [0, 360] }",
        // Its rim starts elsewhere than the wall's.
        "top | disk = { center = [5,0,3], normal = [0,0,1], radius = 2, angle = [-77, 283] }",
    ];
    assert_closed(&barrel, 12.0 * PI, Fronts::Outside);
    let dome = [
        "dome | sphere = { center = [5,0,0], radius = 2, z = [0, 2] }",
        "floor | disk = { center = [5,0,0], normal = [0,0,-1], radius = 2 }",
    ];
    assert_closed(&dome, 16.0 / 3.0 * PI, Fronts::Outside);
    let drop = [
        "tip | cone = { base = [5,0,0], axis = [0,0,3], radius1 = 2, radius2 = 0 }",
        "bowl | sphere = { center = [5,0,0], radius = 2, z = [-2, 0] }",
    ];
    assert_closed(&drop, 4.0 * PI + 16.0 / 3.0 * PI, Fronts::Outside);
}

#[test]
fn a_wall_of_two_parts_closes_the_room_too() {
    let mut walls = CUBE.to_vec();
    walls[0] = "left | quad = { vertices = [[0,0,0],[0.3,0,0],[0.3,1,0],[0,1,0]] }";
    walls.push("right | quad = { vertices = [[0.3,0,0],[1,0,0],[1,1,0],[0.3,1,0]] }");
    assert_closed(&walls, 1.0, Fronts::Inside);
}

#[test]
fn open_rooms_are_not_closed() {
    let found = inspect(&CUBE[..5]);
    assert!(found.shells.is_empty());
    assert_eq!(codes(&found), [""; 0]);
    let narrow = "z0 | quad = { vertices = [[0,0,0],[0.95,0,0],[0.95,1,0],[0,1,0]] }";
    assert!(inspect(&cube_with(0, narrow)).shells.is_empty());
}

#[test]
fn the_cube_has_twelve_edges() {
    let found = inspect(&CUBE);
    assert_eq!(found.contacts.len(), 12);
    assert!(found.contacts.iter().all(|contact| contact.touch == Adjacency::Edge));
    assert_eq!(codes(&found), [""; 0]);
    assert_eq!(found.areas, [1.0; 6]);
}

#[test]
fn ways_of_touching_are_told_apart() {
    let floor = "floor | quad = { vertices = [[0,0,0],[4,0,0],[4,4,0],[0,4,0]] }";
    let touch = |other: &str| inspect(&[floor, other]).contacts.iter().map(|c| c.touch).collect::<Vec<_>>();
    assert_eq!(touch("a | quad = { vertices = [[0,0,0],[4,0,0],[4,0,4],[0,0,4]] }"), [Adjacency::Edge]);
    assert_eq!(touch("a | quad = { vertices = [[1,2,0],[3,2,0],[3,2,2],[1,2,2]] }"), [Adjacency::Tee]);
    assert_eq!(touch("a | quad = { vertices = [[0,0,0],[-4,0,0],[-4,-4,1],[0,-4,1]] }"), [Adjacency::Vertex]);
    assert_eq!(touch("a | disk = { center = [2,2,1], normal = [0,0,-1], radius = 1 }"), []);
}

#[test]
fn surfaces_that_pass_through_each_other_are_named_with_a_place() {
    let found = inspect(&[
        "floor | quad = { vertices = [[0,0,0],[4,0,0],[4,4,0],[0,4,0]] }",
        "pillar | cylinder = { base = [2,2,-1], axis = [0,0,2], radius = 0.5 }",
    ]);
    let [crossing] = &found.warnings[..] else { panic!("{:?}", found.warnings) };
    assert_eq!(crossing.code, "crossing");
    assert!(
        crossing.message.starts_with("surface \"floor\" passes through \"pillar\" near ("),
        "{}",
        crossing.message
    );
    let Adjacency::Crossing { at } = found.contacts[0].touch else { panic!("{:?}", found.contacts) };
    assert!(at.z.abs() < 1e-2 && ((at.x - 2.0).hypot(at.y - 2.0) - 0.5).abs() < 1e-2, "{at}");
}

#[test]
fn gaps_are_found_between_a_millionth_and_a_hundredth() {
    let lid = |height: f64| {
        format!("z1 | quad = {{ vertices = [[0,0,{height}],[0,1,{height}],[1,1,{height}],[1,0,{height}]] }}")
    };
    let found = inspect(&cube_with(1, &lid(1.001)));
    assert_eq!(codes(&found), ["gap"; 4]);
    assert!(
        found.warnings.iter().all(|warning| warning.message.contains("a gap of 1.00e-3 to")),
        "{:?}",
        found.warnings
    );
    assert!(found.shells.is_empty());
    for height in [1.0 + 1e-8, 1.05] {
        let found = inspect(&cube_with(1, &lid(height)));
        assert_eq!(codes(&found), [""; 0], "{height}");
        assert_eq!(found.shells.len(), usize::from(height < 1.01));
    }
    // A curtain that ends above the floor.
    let found = inspect(&[
        CUBE[0],
        "curtain | two_sided = true\nquad = { vertices = [[0.2,0.5,0.005],[0.8,0.5,0.005],[0.8,0.5,0.9],[0.2,0.5,0.9]] }",
    ]);
    assert_eq!(codes(&found), ["gap"]);
}

#[test]
fn plates_close_to_each_other_leave_no_gap() {
    let found =
        inspect(&[CUBE[0], "lid | quad = { vertices = [[0,0,0.005],[0,1,0.005],[1,1,0.005],[1,0,0.005]] }"]);
    assert_eq!(codes(&found), [""; 0]);
}

#[test]
fn a_wall_that_faces_the_other_way_is_named() {
    let turned = format!("{}\nflip = true", CUBE[3]);
    let found = inspect(&cube_with(3, &turned));
    assert_eq!(found.shells[0].fronts, Fronts::Mixed);
    assert!((found.shells[0].volume - 1.0).abs() < 1e-12);
    let named: Vec<_> = found.warnings.iter().map(|w| (w.code, w.surface.as_deref())).collect();
    assert_eq!(named, [("front-turned", Some("x1")), ("front-blind", Some("x1"))]);
}

#[test]
fn rooms_and_solids_turned_inside_out_are_named() {
    let flipped: Vec<String> = CUBE.iter().map(|wall| format!("{wall}\nflip = true")).collect();
    let flipped: Vec<&str> = flipped.iter().map(String::as_str).collect();
    // The camera stands in the room.
    assert_eq!(codes(&inspect(&flipped))[0], "front-outside");
    let solid = "transform = { translate = [7,0,0] }\nsphere = { center = [0,0,0], radius = 1 }";
    let far = "far | quad = { vertices = [[9,-1,-1],[9,-1,1],[9,1,1],[9,1,-1]] }";
    assert_eq!(codes(&inspect(&[&format!("ball | {solid}"), far])), [""; 0]);
    let dark = scene(&[
        &format!("ball | {solid}\nflip = true"),
        far,
        "other | quad = { vertices = [[99,-1,-1],[99,-1,1],[99,1,1],[99,1,-1]] }",
    ]);
    let mut dark = dark;
    dark.surfaces[0].material = radiosity::scene::Material::new(vec![0.5; 3], vec![0.0; 3]).unwrap();
    assert_eq!(codes(&Inspection::of(&dark)), ["front-inside"]);
}

#[test]
fn fronts_that_see_no_other_are_named() {
    let away = "away | flip = true\nquad = { vertices = [[0,0,1],[0,1,1],[1,1,1],[1,0,1]] }";
    let found = inspect(&[CUBE[0], away]);
    assert_eq!(codes(&found), ["front-blind"; 2]);
    // Sheets with two sides, and hollow ones that see themselves, are not blind.
    assert_eq!(codes(&inspect(&[CUBE[0], &format!("{away}\ntwo_sided = true")])), [""; 0]);
    let tube = "tube | flip = true\ncylinder = { base = [5,0,0], axis = [0,0,1], radius = 1 }";
    assert_eq!(codes(&inspect(&[tube, away])), ["front-blind"]);
}

#[test]
fn neither_light_nor_material_is_needed() {
    let text = "[[surfaces]]\nsphere = { center = [0,0,0], radius = 1 }\n";
    let found = Inspection::of(&typed(text));
    assert_eq!(codes(&found), ["no-emitter", "no-camera", "no-material"]);
    let bright = "[materials.m]\nreflectance = 0.99\n[[surfaces]]\nmaterial = \"m\"\nsphere = { center = [0,0,0], radius = 1 }";
    assert!(codes(&Inspection::of(&typed(bright))).contains(&"bright"));
}

#[test]
fn nothing_looks_wrong_in_the_built_in_rooms() {
    for name in [
        "cornell-box",
        "empty-box",
        "occluder-box",
        "two-boxes",
        "furnace-cube",
        "furnace-sphere",
        "hinge-squares",
    ] {
        let found = Inspection::of(&builtin(name));
        assert_eq!(codes(&found), [""; 0], "{name}: {:?}", found.warnings);
    }
}

#[test]
fn the_binary_prints_the_findings_as_text_and_as_json() {
    let run = |args: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_radiosity")).args(args).output().unwrap();
        assert!(output.status.success());
        String::from_utf8(output.stdout).unwrap()
    };
    let text = run(&["check", "furnace-cube"]);
    assert!(text.contains("floor    edge     wall-x0, wall-x1, wall-y0, wall-y1"), "{text}");
    assert!(text.contains(
        "closed: floor, ceiling, wall-x0, wall-x1, wall-y0, wall-y1; volume 1.000000, fronts inside"
    ));
    assert!(text.ends_with("nothing looks wrong\n"));
    let json: serde_json::Value =
        serde_json::from_str(&run(&["check", "furnace-cube", "--format", "json"])).unwrap();
    assert_eq!(json["contacts"].as_array().unwrap().len(), 12);
    assert_eq!(json["contacts"][0]["surfaces"], serde_json::json!(["floor", "wall-x0"]));
    assert_eq!(json["closed"][0]["volume"], 1.0);
    assert_eq!(json["surfaces"][0]["name"], "floor");
    assert_eq!(json["warnings"], serde_json::json!([]));
}

#[test]
fn long_lists_are_shortened_as_text_and_whole_as_json() {
    let folder = tempfile::tempdir().unwrap();
    // A fan of 30 squares that share their first edge.
    let square = |k: u32| {
        let (y, z) = f64::from(12 * k).to_radians().sin_cos();
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, y, z], [0.0, y, z]];
        format!("[[surfaces]]\nname = \"leaf-{k}\"\nquad = {{ vertices = {corners:?} }}\n")
    };
    std::fs::write(folder.path().join("fan.toml"), (0..30).map(square).collect::<String>()).unwrap();
    let run = |args: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_radiosity")).current_dir(&folder).args(args).output();
        String::from_utf8(output.unwrap().stdout).unwrap()
    };
    let text = run(&["check", "fan.toml"]);
    assert!(text.contains("leaf-19, leaf-20 and 9 more\n"), "{text}");
    assert!(
        text.contains("warning: 10 more of the kind \"no-material\": --format json names them all"),
        "{text}"
    );
    let json: serde_json::Value =
        serde_json::from_str(&run(&["check", "fan.toml", "--format", "json"])).unwrap();
    assert_eq!(json["contacts"].as_array().unwrap().len(), 30 * 29 / 2);
    let bare = json["warnings"].as_array().unwrap().iter().filter(|warning| warning["code"] == "no-material");
    assert_eq!(bare.count(), 30);
}

#[test]
fn a_strict_check_fails_where_anything_looks_wrong() {
    let folder = tempfile::tempdir().unwrap();
    let check = |name: &str, surfaces: &[&str], strict: bool| {
        let list = surfaces.iter().map(|text| text.split_once(" | ").unwrap());
        let entries =
            list.map(|(name, shape)| format!("[[surfaces]]\nname = {name:?}\nmaterial = \"m\"\n{shape}\n"));
        let material = "[materials.m]\nreflectance = 0.5\nemission = 1\n".to_owned();
        std::fs::write(folder.path().join(name), material + &entries.collect::<String>()).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_radiosity"));
        command.current_dir(&folder).args(["check", name]);
        command.args(strict.then_some("--strict")).output().unwrap().status.code()
    };
    assert_eq!(check("cube.toml", &CUBE, true), Some(0));
    let turned = cube_with(1, "z1 | flip = true\nquad = { vertices = [[0,0,1],[0,1,1],[1,1,1],[1,0,1]] }");
    assert_eq!(check("turned.toml", &turned, false), Some(0));
    assert_eq!(check("turned.toml", &turned, true), Some(1));
}

/// `check` names all materials that no surface has in one line; nothing else does.
#[test]
fn materials_that_no_surface_has_are_named() {
    let text = "[camera]\neye = [1, 0, 1]\ntarget = [0, 0, 0]\n[materials.used]\nreflectance = 0\nemission = 1\n[materials.spare]\n\
                reflectance = 0.5\n[materials.back]\nreflectance = 0.5\n[materials.odd]\nreflectance = 0.5\n[[surfaces]]\n\
                material = \"used\"\nback_material = \"back\"\ntwo_sided = true\n\
                quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }\n";
    let folder = radiosity_test_support::folders::folder(&[("a.toml", text)]);
    let [found, _] = crate::program::done(folder.path(), &["check", "a.toml"]);
    assert_eq!(found.matches("materials that no surface has: odd, spare\n").count(), 1, "{found}");
    let [found, _] = crate::program::done(folder.path(), &["check", "a.toml", "--format", "json"]);
    let found: serde_json::Value = serde_json::from_str(&found).expect("JSON");
    assert_eq!(found["unused_materials"], serde_json::json!(["odd", "spare"]));
    let [_, told] = crate::program::done(folder.path(), &["solve", "a.toml", "-o", "a.json"]);
    assert!(!told.contains("spare"), "{told}");
}

/// Materials that no surface has are a list like others: a screen of them as text, all of them as JSON.
#[test]
fn many_unused_materials_are_cut() {
    let unused: String = (0..30).map(|k| format!("[materials.unused-{k:02}]\nreflectance = 0.5\n")).collect();
    let floor = "[[surfaces]]\nname = \"floor\"\nmaterial = \"white\"\nquad = { vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] }\n";
    let scene = format!("[materials.white]\nreflectance = 0.5\nemission = 1\n{unused}{floor}");
    let folder = radiosity_test_support::folders::folder(&[("room.toml", &scene)]);
    let [text, _] = crate::program::done(folder.path(), &["check", "room.toml"]);
    let told = "materials that no surface has: unused-00, unused-01, ";
    assert!(text.contains(told) && text.contains("unused-19 and 10 more\n"), "{text}");
    let [json, _] = crate::program::done(folder.path(), &["check", "room.toml", "--format", "json"]);
    let found: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(found["unused_materials"].as_array().map(Vec::len), Some(30));
    assert_eq!(found["read_outside"], serde_json::json!([]));
}

/// Counts that `check --cost` tells are those that a run then has, whichever way carries the light.
#[test]
fn the_cost_that_is_told_counts_what_a_run_has() {
    let folder = tempfile::tempdir().expect("a folder");
    let of_cost = |scene: &str| -> Value {
        let [found, _] = done(folder.path(), &["check", scene, "--cost", "--format", "json"]);
        serde_json::from_str::<Value>(&found).expect("JSON")["cost"].clone()
    };
    for scene in ["empty-box", "teapot"] {
        let ways = of_cost(scene);
        for way in ways.as_array().expect("ways").iter().filter(|way| way["seconds"].as_f64() < Some(5.0)) {
            let options = way["options"].as_str().expect("options").split_whitespace();
            let args: Vec<&str> = ["solve", scene].into_iter().chain(options).collect();
            done(folder.path(), &[&args[..], &["-o", "s.json", "--report", "r.json"]].concat());
            let report = json(&folder.path().join("r.json"));
            assert_eq!(way["unknowns"], report["unknowns"], "{args:?}");
            assert_eq!(way["elements"], report["elements"], "{args:?}");
            assert_eq!(way["rays"].is_null(), (report["transport"]["kind"] == "exact"), "{args:?}");
        }
    }
    // Rules take longer in a teapot, and less memory.
    let ways = of_cost("teapot");
    let [usual, exact] = [0, 4].map(|way| &ways[way]);
    assert!(exact["seconds"].as_f64() > usual["seconds"].as_f64());
    assert!(exact["bytes"].as_u64() < usual["bytes"].as_u64());
}

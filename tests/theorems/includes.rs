//! Scenes of several files: what is taken in, from where, once; where faults stand; and that a solution needs
//! no file.

use std::path::Path;

use radiosity::reading::files::solution_file::{SolutionFile, read};
use radiosity::scene::{Scene, SceneError, Source};
use radiosity::solve::Options;
use radiosity_test_support::folders;
use radiosity_test_support::scenes::parsed;
use radiosity_test_support::solved::solved_of;

const ROOM: &str = r#"title = "room"
include = ["parts/lamps.toml"]
camera = { eye = [1, 1, 1], target = [0, 0, 0] }
[variables]
depth = "=2 * width"
[[surfaces]]
material = "white"
parallelogram = { origin = [0, 0, 0], edge1 = ["=width", 0, 0], edge2 = [0, "=depth", 0] }
[[instances]]
part = "lamp"
transform = { translate = [1, 1, 2] }
"#;

const LAMPS: &str = r#"title = "lamps"
include = "../white.toml"
camera = { eye = [9, 9, 9], target = [0, 0, 0] }
[[parts.lamp.surfaces]]
name = "bulb"
material = "white"
group = "lamps"
flux = 10
sphere = { center = [0, 0, 0], radius = 0.1 }
[[surfaces]]
material = "white"
disk = { center = [0, 0, 3], normal = [0, 0, -1], radius = 0.5 }
"#;

const WHITE: &str = r#"{
  "variables": {"width": 3},
  "materials": {"white": {"reflectance": 0.5}},
  "planes": {"desk": {"origin": [0, 0, 1], "edges": [[1, 0, 0], [0, 1, 0]], "spacing": 0.5}}
}
"#;

/// A folder of the three files, `old` in one of them replaced by `new`.
fn folder(file: &str, old: &str, new: &str) -> tempfile::TempDir {
    let files = [("room.toml", ROOM), ("parts/lamps.toml", LAMPS), ("white.toml", WHITE)];
    folders::folder(
        &files.map(|(name, text)| {
            (name, if name == file { replaced(text, old, new) } else { text.to_owned() })
        }),
    )
}

fn replaced(text: &str, old: &str, new: &str) -> String {
    assert!(text.contains(old), "{old}");
    text.replacen(old, new, 1)
}

fn load(folder: &Path) -> Result<Scene, SceneError> {
    radiosity::load(&folder.join("room.toml").to_string_lossy())
}

/// The message without the folder's name, and the cure.
fn refused(file: &str, old: &str, new: &str) -> (String, String) {
    let folder = folder(file, old, new);
    let error = load(folder.path()).expect_err(new);
    let path = format!("{}/", folder.path().to_string_lossy());
    (error.to_string().replace(&path, ""), error.cure().unwrap_or_default().replace(&path, ""))
}

#[test]
fn a_scene_is_made_of_all_its_files() {
    let folder = folder("room.toml", "room", "room");
    let scene = load(folder.path()).unwrap();
    assert_eq!((scene.name.as_str(), scene.title.as_deref()), ("room", Some("room")));
    let names: Vec<&str> = scene.surfaces.iter().map(|surface| surface.name.as_str()).collect();
    assert_eq!(names, ["lamps.surface-1", "surface-1", "lamp-1.bulb"]);
    assert!((scene.surfaces[1].shape.area() - 18.0).abs() < 1e-12, "variables of all files are known in all");
    assert_eq!(scene.camera.as_ref().unwrap().eye.to_array(), [1.0; 3]);
    assert_eq!(scene.planes.len(), 1);
    let place = scene.surfaces[0].place.as_ref().unwrap();
    assert!(place.origin.ends_with("parts/lamps.toml") && (place.line, place.column) == (10, 1), "{place}");
    let set =
        radiosity::language::source(&folder.path().join("room.toml").to_string_lossy(), &[("width", 1.0)])
            .and_then(|source| radiosity::language::read(&source))
            .unwrap();
    assert!((set.surfaces[1].shape.area() - 2.0).abs() < 1e-12);
}

#[test]
fn files_that_are_included_twice_count_once() {
    let folder =
        folder("room.toml", "[\"parts/lamps.toml\"]", "[\"white.toml\", \"parts/../parts/lamps.toml\"]");
    assert_eq!(load(folder.path()).unwrap().surfaces.len(), 3);
}

#[test]
fn a_solution_needs_no_file() {
    let folder = folder("room.toml", "room", "room");
    let scene = load(folder.path()).unwrap().dimmed(&[("lamps", 0.5)]).unwrap();
    let solved = solved_of(scene, Options { order: 1, eps: 0.3, ..Options::default() });
    let text = serde_json::to_string(&SolutionFile::new(&solved)).unwrap();
    drop(folder);
    let again = read(&Source::new("a.json", &text)).unwrap();
    assert_eq!(again.scene.surfaces.len(), 3);
    assert_eq!(serde_json::to_string(&SolutionFile::new(&again)).unwrap(), text);
    let mut file: serde_json::Value = serde_json::from_str(&text).unwrap();
    file["scene"]["included"] = serde_json::json!([]);
    let file: SolutionFile = serde_json::from_value(file).unwrap();
    let text = serde_json::to_string(&file.sealed()).unwrap();
    let message = read(&Source::new("a.json", &text)).unwrap_err().to_string();
    assert!(message.contains("cannot be included: the text is not that of a file"), "{message}");
}

#[test]
fn a_text_includes_what_it_is_given_and_no_file() {
    let given = Source::new("a/room.toml", ROOM)
        .including("a/parts/lamps.toml", &format!("\u{feff}{LAMPS}"))
        .including("a/white.toml", WHITE);
    let scene = parsed(&given);
    assert_eq!(scene.surfaces.len(), 3);
    let broken = Source::new("a/room.toml", ROOM)
        .including("a/white.toml", WHITE)
        .including("a/parts/lamps.toml", &LAMPS.replace("\n", "\r\n").replace("radius = 0.1", "radius = -1"));
    let error = radiosity::language::read(&broken).unwrap_err();
    let told =
        "a/parts/lamps.toml:9:41: surface \"lamp-1.bulb\": `radius` is -1; it must be greater than zero";
    assert_eq!(error.to_string(), told);
    assert_eq!(error.place.unwrap().text, "sphere = { center = [0, 0, 0], radius = -1 }");
    let error = radiosity::language::read(&Source::new("a/room.toml", ROOM)).unwrap_err();
    let told = "a/room.toml:2:12: include: \"a/parts/lamps.toml\" cannot be included: the text is not that of a file";
    assert_eq!(error.to_string(), told);
}

#[test]
fn faults_stand_in_the_file_where_they_are() {
    for (file, old, new, message, cure) in [
        (
            "parts/lamps.toml",
            "radius = 0.5",
            "radius = nan",
            "parts/lamps.toml:12:60: surface \"lamps.surface-1\": NaN",
            "finite",
        ),
        (
            "parts/lamps.toml",
            "flux",
            "flox",
            "parts/lamps.toml:8:1: surface \"bulb\": unknown key \"flox\"",
            "\"flux\"",
        ),
        ("parts/lamps.toml", "[0, 0, 3]", "[0, 0, 3", "parts/lamps.toml:12:", "TOML wants"),
        ("white.toml", "0.5}", "0.5", "white.toml:6:1: syntax error", "JSON wants"),
        (
            "white.toml",
            "0.5}",
            "1.5}",
            "white.toml:3:42: material \"white\": the reflectance is 1.5",
            "choose",
        ),
        (
            "white.toml",
            "\"width\": 3",
            "\"width\": \"=x\"",
            "white.toml:2:28: variable \"width\": there is no variable \"x\"",
            "depth",
        ),
        (
            "parts/lamps.toml",
            "[[surfaces]]",
            "[planes]\nroom = 1\n[[surfaces]]",
            "parts/lamps.toml:11:8: plane \"room\"",
            "",
        ),
        (
            "room.toml",
            "[variables]",
            "[materials.white]\nreflectance = 0.2\n[variables]",
            "room.toml:4:12: material \"white\": the name \"white\" is given twice",
            "which stands on line 3 of white.toml",
        ),
        (
            "room.toml",
            "[variables]",
            "[parts.lamp]\n[variables]",
            "room.toml:4:8: part \"lamp\": the name \"lamp\" is given twice",
            "rename",
        ),
        (
            "room.toml",
            "depth =",
            "width =",
            "room.toml:5:1: the name \"width\" is given twice",
            "line 2 of white.toml",
        ),
        ("room.toml", "part = \"lamp\"", "name = \"lamps\"\npart = \"lamp\"", "", ""),
        ("parts/lamps.toml", "title", "bands = [\"a\"]\ntitle", "", ""),
        ("room.toml", "title", "bands = [\"a\"]\nunit = \"lx\"\ntitle", "", ""),
        (
            "room.toml",
            "parts/lamps.toml",
            "parts/lamp.toml",
            "room.toml:2:12: include: \"parts/lamp.toml\" cannot be read: ",
            "check the path",
        ),
        (
            "room.toml",
            "[\"parts/lamps.toml\"]",
            "3",
            "room.toml:2:11: expected a text in quotes, found a number",
            "in quotes",
        ),
        ("room.toml", "parts/lamps.toml", " ", "this text is empty", "letter"),
        (
            "white.toml",
            "{\n",
            "{\n\"include\": [\"room.toml\"],\n",
            "white.toml:2:13: include: the file includes itself: room.toml → parts/lamps.toml → white.toml → room.toml",
            "take one of these includes out",
        ),
        (
            "parts/lamps.toml",
            "../white.toml",
            "lamps.toml",
            "parts/lamps.toml:2:11: include: the file includes itself",
            "take",
        ),
    ] {
        if message.is_empty() {
            assert!(load(folder(file, old, new).path()).is_ok(), "{new}");
            continue;
        }
        let (told, mended) = refused(file, old, new);
        assert!(
            told.starts_with(message) || !message.contains(':') && told.contains(message),
            "{new}: {told}"
        );
        assert!(mended.contains(cure), "{new}: {mended}");
    }
}

#[test]
fn bands_and_units_are_those_of_all_files() {
    for (bands, unit, told) in [
        ("[\"lm\"]", "\"lx\"", None),
        (
            "[\"grey\"]",
            "\"lx\"",
            Some("lamps.toml:1:9: the bands of this file are not those of the other files"),
        ),
        (
            "[\"lm\"]",
            "\"W\"",
            Some("lamps.toml:2:8: the units of this file are not those of the other files"),
        ),
    ] {
        let source = Source::new("room.toml", &format!("bands = [\"lm\"]\nunit = \"lx\"\n{ROOM}"))
            .including("parts/lamps.toml", &format!("bands = {bands}\nunit = {unit}\n{LAMPS}"))
            .including("white.toml", WHITE);
        match (radiosity::language::read(&source), told) {
            (Ok(scene), None) => {
                assert_eq!((scene.bands, scene.unit.as_str()), (vec!["lm".to_owned()], "lx"))
            }
            (Err(error), Some(told)) => {
                assert!(error.to_string().contains(told), "{error}");
                assert!(error.cure().unwrap_or_default().starts_with("state it in one of the files only"));
            }
            (scene, _) => panic!("{scene:?}"),
        }
    }
}

#[test]
fn files_are_nested_to_a_depth() {
    let chain = |length: usize| {
        let text = |k: usize| format!("include = \"{}.toml\"\n", k + 1);
        let first = Source::new("0.toml", &text(0));
        let all = (1..length).fold(first, |source, k| source.including(&format!("{k}.toml"), &text(k)));
        radiosity::language::read(&all.including(&format!("{length}.toml"), WHITE)).unwrap_err().to_string()
    };
    assert!(chain(32).contains("the scene has no surface"), "{}", chain(32));
    assert!(
        chain(33).starts_with("32.toml:1:11: include: files are nested more than 32 deep"),
        "{}",
        chain(33)
    );
}

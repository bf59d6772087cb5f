//! Luminaires on the command line: photometric files, what is refused, what looks wrong.

use radiosity_test_support::folders::folder;
use std::fs;
use std::path::Path;

use crate::program::{self, radiosity};

const ROOM: &str = r#"bands = ["lm"]
unit = "lx"
camera = { eye = [3.8, 0.3, 1.6], target = [1.5, 3, 1] }
[materials.wall]
reflectance = 0.5
[[surfaces]]
name = "room"
material = "wall"
box = { origin = [0, 0, 0], size = [4, 5, 3], inward = true }
[[luminaires]]
name = "lamp"
position = [2, 2, 2.5]
aim = [0, 0, -1]
flux = 1000
point = {}
"#;

/// 100 cd straight down, 50 cd at 90°, nothing above.
const TABLE: &str =
    "IESNA:LM-63-2002\n[TEST] 1\n[MANUFAC] none\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n100 50\n";

/// Runs a command on the scene; exit code, what it prints, what it complains of.
fn run(folder: &Path, scene: &str, args: &[&str]) -> (Option<i32>, String, String) {
    fs::write(folder.join("room.toml"), scene).unwrap();
    let output = radiosity(folder, args);
    let [out, error] = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    (output.status.code(), out, error)
}

/// Refused with all of these parts in the message.
#[track_caller]
fn refused(old: &str, new: &str, parts: &[&str]) {
    assert!(ROOM.contains(old), "{old}");
    let folder = folder(&[("room.toml", ROOM.replace(old, new))]);
    program::refused(folder.path(), &["solve", "room.toml", "-o", "out.json"], parts);
}

#[test]
fn wrong_luminaires_are_refused_at_their_place() {
    let lamp = "luminaire \"lamp\": ";
    refused("flux = 1000", "flux = -1", &["room.toml:14:8: ", lamp, "the flux is -1, outside flux ≥ 0"]);
    refused("flux = 1000\n", "", &[lamp, "the key \"flux\" is missing", "intensity"]);
    refused(
        "flux = 1000",
        "flux = 1\nintensity = 2",
        &["room.toml:15:13", "\"flux\" and \"intensity\" are both given"],
    );
    refused(
        "aim = [0, 0, -1]",
        "aim = [0, 0, 0]",
        &["room.toml:13:7: ", lamp, "`aim` gives no direction", "help: give a direction"],
    );
    refused(
        "aim = [0, 0, -1]",
        "along = [0, 0, 2]",
        &["room.toml:13:9: ", "`along` gives no direction", "across the aim"],
    );
    refused(
        "point = {}\n",
        "",
        &["room.toml:10:1: ", lamp, "nothing says how the light is spread", "help: add point = {}"],
    );
    refused(
        "point = {}",
        "point = {}\nspot = { angle = 3 }",
        &["room.toml:16:8: ", "\"point\" and \"spot\" are both given"],
    );
    refused(
        "point = {}",
        "spot = { angle = 400 }",
        &["room.toml:15:8: ", lamp, "the angle is 400, outside 0 < angle < 360"],
    );
    refused("point = {}", "spot = { angle = 30, edge = 40 }", &["the edge is 40"]);
    refused("point = {}", "point = {}\ndimming = -1", &["room.toml:16:11: ", "the dimming is -1"]);
    refused("position = [2, 2, 2.5]\n", "", &["the key \"position\" is missing", "three numbers"]);
    refused(
        "flux = 1000",
        "flux = [1, 2, 3]",
        &["the flux takes one number for all bands or 1, one per band"],
    );
    let twin = "point = {}\n[[luminaires]]\nname = \"lamp\"\nposition = [1, 1, 1]\nflux = 1\npoint = {}";
    refused("point = {}", twin, &["room.toml:17:8: ", "the name \"lamp\" is given twice", "line 11"]);
}

#[test]
fn wrong_photometric_files_are_refused() {
    refused(
        "point = {}",
        "photometry = \"none.ies\"",
        &["room.toml:15:14: ", "\"none.ies\" cannot be read", "help: check the path"],
    );
    let folder = folder(&[("lamp.ies", TABLE.replace("100 50", "100 x"))]);
    let scene = ROOM.replace("point = {}", "photometry = \"lamp.ies\"");
    let (code, _, error) = run(folder.path(), &scene, &["check", "room.toml"]);
    assert_eq!(code, Some(2), "{error}");
    for part in ["room.toml:15:14: luminaire \"lamp\": ", "lamp.ies:9: ", "help: "] {
        assert!(error.contains(part), "{part:?} is not in:\n{error}");
    }
}

/// A solution holds the photometric file; the table is read from the folder of the file that names it.
#[test]
fn photometric_files_are_read_and_kept() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("lamps")).unwrap();
    fs::write(folder.path().join("lamps/lamp.ies"), TABLE).unwrap();
    let lamps = "[[parts.pair.luminaires]]\nposition = [0, 0, 2]\nphotometry = \"lamp.ies\"\n";
    fs::write(folder.path().join("lamps/lamps.toml"), lamps).unwrap();
    let (room, _) = ROOM.split_once("[[luminaires]]").unwrap();
    let array = "[[instances]]\npart = \"pair\"\ntransform = { translate = [1, 1, 0] }\narray = { count = 2, step = [2, 0, 0] }\n";
    let scene = format!("include = \"lamps/lamps.toml\"\n{room}{array}");
    let (code, out, error) = run(folder.path(), &scene, &["check", "room.toml", "--format", "json"]);
    assert_eq!(code, Some(0), "{error}");
    let found: serde_json::Value = serde_json::from_str(&out).unwrap();
    let luminaires = found["luminaires"].as_array().unwrap();
    assert_eq!(luminaires.len(), 2);
    assert_eq!(luminaires[1]["position"], serde_json::json!([3.0, 1.0, 2.0]));
    let (code, _, error) = run(folder.path(), &scene, &["solve", "room.toml", "-o", "room.json"]);
    assert_eq!(code, Some(0), "{error}");
    fs::remove_dir_all(folder.path().join("lamps")).unwrap();
    fs::write(folder.path().join("points.csv"), "x,y,z,nx,ny,nz\n1,1,0,0,0,1\n").unwrap();
    let args = ["probe", "room.json", "--points", "points.csv", "--read", "direct", "-q"];
    let (code, out, error) = run(folder.path(), &scene, &args);
    assert_eq!(code, Some(0), "{error}");
    // 100 cd from 2 m above, and 100 − 50 γ/90° cd at γ = 45° from 2 m aside; reflected light comes on top.
    let found: f64 = out.lines().nth(1).unwrap().split(',').nth(6).unwrap().parse().unwrap();
    let direct = 100.0 / 4.0 + 75.0 / 8.0 * 0.5_f64.sqrt();
    assert!(found > direct && found < 1.5 * direct, "{found} {direct}");
}

#[test]
fn what_cannot_carry_their_light_is_refused() {
    for (option, parts) in [
        (
            &["--method", "hierarchical"][..],
            ["luminaire 'lamp'", "hierarchical radiosity", "solve by the usual method, --method galerkin"],
        ),
        (
            &["--shadows", "mask"][..],
            ["luminaire 'lamp'", "shadow masks", "choose another kind of --shadows"],
        ),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let args = [&["solve", "room.toml", "-o", "out.json"], option].concat();
        let (code, _, error) = run(folder.path(), ROOM, &args);
        assert_eq!(code, Some(2), "{error}");
        parts.iter().for_each(|part| assert!(error.contains(part), "{part:?} is not in:\n{error}"));
    }
}

#[test]
fn check_warns_of_luminaires_that_light_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let warned = |scene: &str| run(folder.path(), scene, &["check", "room.toml"]).1;
    let inside = warned(ROOM);
    assert!(inside.contains("nothing looks wrong") && inside.contains("1000"), "{inside}");
    for mounted in ["[2, 2, 3]", "[0, 2, 2]", "[0, 0, 3]"] {
        let mounted = warned(&ROOM.replace("[2, 2, 2.5]", mounted));
        assert!(mounted.contains("nothing looks wrong"), "{mounted}");
    }
    let above = warned(&ROOM.replace("[2, 2, 2.5]", "[2, 2, 3.5]"));
    assert!(above.contains("luminaire \"lamp\" lights no front"), "{above}");
    // A sun that is far off, from where no ray of a few hundred all around meets the room.
    let open = ROOM.replace("inward = true", "inward = true, open = [\"top\"]");
    let far = warned(&open.replace("[2, 2, 2.5]", "[2, 2, 1e4]"));
    assert!(!far.contains("lights no front"), "{far}");
    let below = warned(&open.replace("[2, 2, 2.5]", "[2, 2, -1e4]"));
    assert!(below.contains("luminaire \"lamp\" lights no front"), "{below}");
    fs::write(folder.path().join("lamp.ies"), TABLE).unwrap();
    let table = ROOM.replace("point = {}", "photometry = \"lamp.ies\"").replace("unit = \"lx\"\n", "");
    assert!(warned(&table).contains("state unit = \"lx\""), "{}", warned(&table));
}

/// A sky and an opening in the place of the lamp.
const SKY: &str = r#"bands = ["lm"]
[sky]
model = "overcast"
illuminance = 10000
[materials.glass]
reflectance = 0.1
[[surfaces]]
name = "window"
material = "glass"
opening = true
quad = { vertices = [[0, 1, 1], [0, 2, 1], [0, 2, 2], [0, 1, 2]] }
"#;

#[test]
fn wrong_skies_are_refused_at_their_place() {
    let refused = |old: &str, new: &str, parts: &[&str]| {
        assert!(SKY.contains(old), "{old}");
        let folder = tempfile::tempdir().unwrap();
        let (code, _, error) = run(folder.path(), &SKY.replace(old, new), &["check", "room.toml"]);
        assert_eq!(code, Some(2), "{error}");
        parts.iter().for_each(|part| assert!(error.contains(part), "{part:?} is not in:\n{error}"));
    };
    refused("opening = true\n", "", &["room.toml:2:1: sky: no surface is an opening", "help: give a window"]);
    let (sky, window) = ("[sky]\nmodel = \"overcast\"\nilluminance = 10000\n", "surface \"window\": ");
    refused(sky, "", &["room.toml:7:11: ", window, "there is no sky", "help: add [sky]"]);
    refused(
        "overcast",
        "cloudy",
        &["room.toml:3:9: sky: there is no sky \"cloudy\"", "uniform, overcast, clear"],
    );
    refused("overcast", "clear", &["sky: the key \"sun\" is missing", "elevation"]);
    refused("10000", "-1", &["room.toml:4:15: sky: the illuminance is -1"]);
    refused("10000", "0", &["sky: the illuminance of the sky is 0", "without the sun"]);
    let sun = |elevation: &str| format!("10000\nsun = {{ elevation = {elevation}, azimuth = 180 }}");
    refused(
        "10000",
        &sun("-5"),
        &["room.toml:5:21: sky: the elevation of the sun is -5, outside 0 < elevation", "help: choose"],
    );
    refused("10000", &sun("0"), &["the elevation of the sun is 0,", "leave it out"]);
    refused("10000", &sun("95"), &["the elevation of the sun is 95,", "≤ 90 degrees"]);
    // Multiples of a vector round apart.
    for north in ["[3, 6, 9]", "[7.7, 15.4, 23.1]", "[1e-12, 2e-12, 3e-12]", "[0, 0, 0]"] {
        let sky = format!("{}\nup = [0.1, 0.2, 0.3]\nnorth = {north}", sun("40"));
        let north = "room.toml:5:7: sky: the vector `north` gives no direction";
        refused("10000", &sky, &[north, "help: give a direction that is not along `up`, e.g. [0, 1, 0]"]);
    }
    let sky = format!("{}\nup = [0, 0, 0]", sun("40"));
    refused("10000", &sky, &["`up` gives no direction", "the zenith, e.g. [0, 0, 1]"]);
    refused("10000", "10000\nground = 1", &["the reflectance is 1"]);
    refused(
        "opening = true",
        "glass = { panes = 9 }",
        &["room.toml:10:9: ", window, "the number of panes is 9"],
    );
    refused(
        "opening = true",
        "glass = { transmittance = 0.95 }",
        &[window, "the transmittance is", "0.918 of one pane"],
    );
    refused(
        "opening = true",
        "opening = true\ntwo_sided = true",
        &["room.toml:10:11: ", window, "it has two sides"],
    );
    refused("reflectance = 0.1", "reflectance = 0.1\nemission = 1", &[window, "its material emits"]);
    let quad = "quad = { vertices = [[0, 1, 1], [0, 2, 1], [0, 2, 2], [0, 1, 2]] }";
    refused(
        quad,
        "sphere = { center = [0, 0, 0], radius = 1 }",
        &[window, "it is curved", "help: make it of flat"],
    );
}

#[test]
fn what_takes_light_for_diffuse_refuses_a_sky() {
    for (option, what) in [
        (["--method", "hierarchical"], "hierarchical radiosity carries diffuse light only"),
        (["--direct", "projected"], "--direct projected takes all emitted light for diffuse"),
        (["--shadows", "mask"], "--shadows mask takes all emitted light for diffuse"),
        (["--kernel", "paper-hybrid"], "--kernel with the rules of 1993 takes all emitted light for diffuse"),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let args = [&["solve", "room.toml", "-o", "out.json"], &option[..]].concat();
        let (code, _, error) = run(folder.path(), SKY, &args);
        assert_eq!(code, Some(2), "{error}");
        let refusal = format!("surface 'window' is an opening to a sky: {what}");
        assert!(error.contains(&refusal), "{option:?}: {error}");
    }
}

#[test]
fn power_that_elements_miss_of_direct_light_has_a_cure_of_its_own() {
    // A beam of 5 cm on a floor of 4 m, and a room that reflects all but a ten-thousandth.
    let beam = r#"
        bands = ["lm"]
        materials.wall = { reflectance = 0.5 }
        surfaces = [{ name = "room", material = "wall", box = { origin = [0, 0, 0], size = [4, 5, 2.7], inward = true } }]
        luminaires = [{ position = [1.93, 2.07, 2.69], spot = { angle = 1, edge = 0.2 }, flux = 900 }]
    "#;
    let bright = r#"
        bands = ["grey"]
        materials.wall = { reflectance = 0.9999, emission = 1 }
        [[surfaces]]
        name = "room"
        material = "wall"
        flip = true
        sphere = { center = [0, 0, 0], radius = 1 }
        [[surfaces]]
        name = "body"
        material = "wall"
        box = { origin = [-0.3, -0.3, -0.3], size = [0.6, 0.6, 0.6] }
    "#;
    let folder = tempfile::tempdir().unwrap();
    let cure = |scene: &str| {
        let (_, _, told) =
            run(folder.path(), scene, &["solve", "room.toml", "-o", "out.json", "--eps", "1e-2"]);
        let line = told.lines().find(|line| line.contains("of the power") || line.contains("more power"));
        line.unwrap_or_else(|| panic!("no warning in:\n{told}")).to_owned()
    };
    let direct = cure(beam);
    assert!(direct.contains("subdivide = [n, n]") && !direct.contains("--eps"), "{direct}");
    let transfers = cure(bright);
    assert!(transfers.contains("--eps") && !transfers.contains("subdivide"), "{transfers}");
}

#[test]
fn wrong_extents_are_refused_at_their_place() {
    let lamp = "luminaire \"lamp\": ";
    let extent =
        |new: &str, parts: &[&str]| refused("point = {}", &format!("point = {{}}\nextent = {new}"), parts);
    extent("0", &["room.toml:16:10: ", lamp, "the diameter of the extent is 0, outside diameter > 0"]);
    extent("-0.2", &[lamp, "the diameter of the extent is -0.2"]);
    extent("[0, 0]", &["room.toml:16:10: ", lamp, "both sides are 0", "leave the extent out for a point"]);
    extent("[1, -1]", &[lamp, "the side of the extent is -1, outside side ≥ 0"]);
    extent("[1, 1, 1]", &[lamp, "an extent takes 2 sides, found 3"]);
    extent("\"file\"", &[lamp, "there is no photometric file", "give its sides"]);
    extent("\"area\"", &[lamp, "unknown key \"area\"", "file"]);
    extent("true", &[lamp, "expected a number"]);
    refused(
        "point = {}",
        "spot = { angle = 30 }\nextent = [1, 1]",
        &["room.toml:16:10: ", lamp, "within half a degree", "give the spot an edge"],
    );
    // An area is a surface, and surfaces have names of their own.
    refused(
        "name = \"lamp\"",
        "name = \"room-top\"\nextent = 0.2",
        &["room.toml:11:8: ", "the name \"room-top\" is given twice"],
    );
    // A disk in the plane of a ceiling.
    refused(
        "position = [2, 2, 2.5]",
        "position = [2, 2, 3]\nextent = 0.2",
        &["coincides with", "move them apart"],
    );
}

/// Of the openings that files state, flat ones and lines are taken, others refused with a cure.
#[test]
fn extents_of_files_are_those_of_their_openings() {
    let folder = tempfile::tempdir().unwrap();
    let scene = ROOM.replace("point = {}", "photometry = \"lamp.ies\"\nextent = \"file\"");
    let checked = |opening: &str, args: &[&str]| {
        let table = TABLE.replace(" 2 0 0 0\n", &format!(" 2 {opening}\n"));
        fs::write(folder.path().join("lamp.ies"), table).unwrap();
        run(folder.path(), &scene, &[&["check", "room.toml"], args].concat())
    };
    for (opening, told) in [
        ("0.3 1.2 0", "1.2 × 0.3"),
        ("-0.2 -0.2 0", "disk of 0.2"),
        ("0 1.5 0", "line of 1.5"),
        ("-0.03 1.5 -0.03", "line of 1.5"),
    ] {
        let (code, out, error) = checked(opening, &[]);
        assert!(code == Some(0) && out.contains(told), "{opening}: {out}{error}");
    }
    let (_, out, _) = checked("0.3 1.2 0.05", &[]);
    assert!(out.contains("an opening 0.05 m high"), "{out}");
    for (opening, problem) in [
        ("0 0 0", "the file states a point"),
        ("0.3 0 1.2", "the opening of the file is upright"),
        ("-0.3 -0.2 0", "the opening of the file is an ellipse"),
        ("-0.3 -0.3 -0.3", "the opening of the file is a ball"),
    ] {
        let (code, _, error) = checked(opening, &[]);
        assert!(
            code == Some(2) && error.contains(problem) && error.contains("help: give"),
            "{opening}: {error}"
        );
    }
}

/// A disk of the diameter w errs as a point by (w/2r)² at the distance r.
#[test]
fn check_tells_where_points_err() {
    let folder = folder(&[("lamp.ies", TABLE.replace(" 2 0 0 0\n", " 2 -0.8 -0.8 0\n"))]);
    let point = ROOM.replace("point = {}", "photometry = \"lamp.ies\"");
    let near = |scene: &str| {
        let (code, out, error) = run(folder.path(), scene, &["check", "room.toml", "--format", "json"]);
        assert_eq!(code, Some(0), "{error}");
        serde_json::from_str::<serde_json::Value>(&out).unwrap()["near_points"].clone()
    };
    let found = near(&point);
    // Walls are nearer than the floor, for the lamp hangs 2.5 m above it and 2 m beside them.
    let [distance, error] = ["distance", "error"].map(|key| found[0][key].as_f64().unwrap());
    assert!((2.0..2.1).contains(&distance), "{found}");
    assert!((error - (0.4 / distance).powi(2)).abs() < 1e-9, "{found}");
    let text = run(folder.path(), &point, &["check", "room.toml"]).1;
    assert!(
        text.contains("as a point: lamp errs by up to about") && text.contains("extent = \"file\""),
        "{text}"
    );
    assert_eq!(near(&format!("{point}extent = \"file\"\n")), serde_json::json!([]));
    assert_eq!(
        near(&ROOM.replace("position = [2, 2, 2.5]", "position = [2, 2, 2.4]")),
        serde_json::json!([])
    );
}

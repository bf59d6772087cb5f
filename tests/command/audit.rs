//! `audit`: what a referee says of light that is right, of light that is wrong, and what is refused.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use radiosity_test_support::data::number;
use radiosity_test_support::folders::{folder, json};
use serde_json::Value;

use crate::program::{self, done, radiosity};

/// A closed room of reflectance ½ that emits 1 everywhere, of which one wall belongs to a light group, and a
/// plane of sensors in it. Light of the reflectance ρ = ½ sums to 1/(1 − ρ) = 2 at all points.
const FURNACE: &str = "
    bands = [\"lm\"]
    unit = \"lx\"
    [camera]
    eye = [0.9, 0.1, 0.9]
    target = [0, 1, 0]
    fov = 90
    width = 60
    height = 40
    [planes.desk]
    origin = [0.2, 0.2, 0.5]
    edges = [[0.6, 0, 0], [0, 0.6, 0]]
    spacing = 0.1
    [materials]
    wall = { reflectance = 0.5, emission = 1 }
    window = { reflectance = 0.5, emission = 1, group = \"window\" }
    [[surfaces]]
    name = \"low\"
    material = \"wall\"
    quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }
    [[surfaces]]
    name = \"high\"
    material = \"window\"
    quad = { vertices = [[0,0,1],[0,1,1],[1,1,1],[1,0,1]] }
    [[surfaces]]
    name = \"left\"
    material = \"wall\"
    quad = { vertices = [[0,0,0],[0,1,0],[0,1,1],[0,0,1]] }
    [[surfaces]]
    name = \"right\"
    material = \"wall\"
    quad = { vertices = [[1,0,0],[1,0,1],[1,1,1],[1,1,0]] }
    [[surfaces]]
    name = \"near\"
    material = \"wall\"
    quad = { vertices = [[0,0,0],[0,0,1],[1,0,1],[1,0,0]] }
    [[surfaces]]
    name = \"far\"
    material = \"wall\"
    quad = { vertices = [[0,1,0],[1,1,0],[1,1,1],[0,1,1]] }";

/// The document of a judged run that succeeds.
#[track_caller]
fn judged(folder: &Path, args: &[&str]) -> Value {
    let all = [&["audit"], args, &["--seconds", "0.3", "--format", "json", "-o", "audit.json"]].concat();
    program::done(folder, &all);
    json(&folder.join("audit.json"))
}

fn list<'a>(document: &'a Value, key: &str) -> &'a [Value] {
    document[key].as_array().expect("it is a list")
}

/// In the furnace both find 2 at all points of surfaces and of the plane, and nothing is told to be wrong.
#[test]
fn furnaces_are_right() {
    let folder = folder(&[("room.toml", FURNACE)]);
    let document = judged(folder.path(), &["room.toml", "--strict", "--readings", "48"]);
    assert_eq!(document["finds_more"], false, "{document}");
    let points = list(&document, "points");
    assert_eq!((points.len(), number(&document["readings"])), (48, 48.0));
    assert_eq!(points.iter().filter(|point| point["of"] == "desk").count(), 16, "a third are sensors");
    for point in points {
        let [printed, found, s] = ["printed", "found", "s"].map(|key| number(&point[key][0]));
        assert!((printed - 2.0).abs() < 4e-3, "{point}");
        assert!((found - 2.0).abs() < 6.0 * s + 1e-9, "{point}");
    }
    let visible = number(&document["visible"]);
    assert!((1e-5..1e-2).contains(&visible), "{visible}");
}

/// At the factor 3 of the window's group, one wall of six emits 3: neither the whole nor a group is told to be
/// wrong, and there is 8/6 of the light, in the mean over all walls by symmetry.
#[test]
fn light_groups_of_solutions_are_judged_at_their_factors() {
    let folder = folder(&[("room.toml", FURNACE)]);
    program::done(folder.path(), &["solve", "room.toml", "-o", "room.solution.json"]);
    let document = judged(folder.path(), &["room.solution.json", "--strict", "--set", "window=3"]);
    let signed = list(&document, "signed");
    for group in ["group window", "group (none)"] {
        let own = signed.iter().find(|own| own["of"] == group).expect("the group is judged");
        assert!(number(&own["relative"]).abs() < 5.0 * number(&own["error"]) + 2e-3, "{own}");
        assert_eq!(number(&own["readings"]), number(&document["readings"]));
    }
    let [dim, lit] = ["1", "3"].map(|factor| {
        let set = format!("window={factor}");
        let document = judged(folder.path(), &["room.solution.json", "--set", &set]);
        let points = list(&document, "points").iter().filter(|point| point["of"] != "desk");
        let found: Vec<f64> = points.map(|point| number(&point["found"][0])).collect();
        found.iter().sum::<f64>() / found.len() as f64
    });
    assert!((lit / dim - (5.0 + 3.0) / 6.0).abs() < 0.05, "{lit} {dim}");
}

/// Without shadows, light goes through the blocks of the room: a strict run ends with 3, has written its figures
/// all the same, and names what is off.
#[test]
fn light_without_shadows_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let args = ["audit", "two-boxes", "--shadows", "off", "--seconds", "0.3", "--strict"];
    let output = radiosity(folder.path(), &args);
    let told = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(3), "{told}");
    assert!(told.contains("error: the light is off by more than the"), "{told}");
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.starts_with("checked at 64 readings by path tracing: off by "), "{text}");
    for part in ["million rays", "\nmore than the run tells, ", "stands out", "exceeds chance"] {
        assert!(text.contains(part), "{part:?} is missing in:\n{text}");
    }
    let loose = radiosity(folder.path(), &args[..args.len() - 1]);
    assert_eq!(loose.status.code(), Some(0), "only strict runs fail");
}

#[test]
fn threads_change_no_byte() {
    let folder = tempfile::tempdir().unwrap();
    let by = |threads: &str| {
        let args = ["audit", "cornell-box", "--seconds", "0.1", "--readings", "24", "-q", "--format", "json"];
        program::done(folder.path(), &[&args[..], &["--threads", threads]].concat())
    };
    let one = by("1");
    assert!(one[0].contains("\"points\""));
    assert_eq!(by("2"), one);
    assert_eq!(by("3"), one);
}

/// Other seeds read other places; the same one reads the same.
#[test]
fn seeds_choose_the_places() {
    let folder = folder(&[("room.toml", FURNACE)]);
    let places = |seed: &str| {
        let document = judged(folder.path(), &["room.toml", "--seed", seed, "--readings", "12"]);
        list(&document, "points").iter().map(|point| point["position"].to_string()).collect::<Vec<_>>()
    };
    let first = places("1");
    assert_eq!(places("1"), first);
    let other = places("2");
    assert!(first.iter().zip(&other).filter(|(a, b)| a == b).count() < 3, "{first:?} {other:?}");
}

/// Polynomials have no value in the air: sensors are left out and counted.
#[test]
fn what_cannot_be_read_is_counted() {
    let folder = folder(&[("room.toml", FURNACE)]);
    let document = judged(folder.path(), &["room.toml", "--read", "basis", "--readings", "30"]);
    assert_eq!((number(&document["readings"]), number(&document["unread"])), (20.0, 10.0));
}

#[test]
fn tables_have_a_row_for_each_reading() {
    let folder = folder(&[("room.toml", FURNACE)]);
    let args = ["audit", "room.toml", "--seconds", "0.1", "--readings", "12", "--format", "csv"];
    let [table, told] = program::done(folder.path(), &args);
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines[0], "x,y,z,nx,ny,nz,of,E_lm,F_lm,s_lm,difference,in_s");
    assert_eq!(lines.len(), 1 + 12);
    for line in &lines[1..] {
        let fields: Vec<&str> = line.split(',').collect();
        let [printed, found, s, difference, in_s] =
            [7, 8, 9, 10, 11].map(|k: usize| fields[k].parse::<f64>().expect("a number"));
        assert!((difference - (printed - found) / found).abs() < 1e-12, "{line}");
        assert!((in_s - (printed - found) / s).abs() < 1e-6 * in_s.abs().max(1.0), "{line}");
    }
    assert!(told.contains("checked at 12 readings by path tracing: no error above "), "{told}");
}

/// All readings are drawn, as disks or as rings where something hides them, on grey.
#[test]
fn the_picture_has_the_readings() {
    let folder = folder(&[("room.toml", FURNACE)]);
    let args =
        ["audit", "room.toml", "--seconds", "0.1", "--picture", "where.png", "-q", "--size", "300x200"];
    program::done(folder.path(), &args);
    let file = BufReader::new(File::open(folder.path().join("where.png")).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert!(info.width > 300 && info.height == 200, "the legend stands beside it");
    let view = pixels.chunks(3 * info.width as usize).flat_map(|row| row[..900].chunks(3));
    let coloured = view.filter(|pixel| pixel[0] != pixel[1] || pixel[1] != pixel[2]).count();
    assert!((50..30_000).contains(&coloured), "{coloured} pixels have a colour");
}

#[test]
fn wrong_inputs_are_refused() {
    let dark = FURNACE.replace("emission = 1", "emission = 0");
    let polygons = "name,x,y,z\na,0,0,0\na,1,0,0\na,0,1,0\n";
    let folder = folder(&[("room.toml", FURNACE), ("dark.toml", &dark), ("polygons.csv", polygons)]);
    let refused = |args: &[&str], parts: &[&str]| program::refused(folder.path(), args, parts);
    refused(&["audit", "room.toml", "--seconds", "-1"], &["--seconds", "expected seconds, above 0"]);
    refused(&["audit", "room.toml", "--seconds", "nan"], &["--seconds", "expected seconds, above 0"]);
    for readings in ["0", "1", "2.5", "-3"] {
        refused(
            &["audit", "room.toml", "--readings", readings],
            &["--readings", "expected a whole number from 2"],
        );
    }
    refused(&["audit", "room.toml", "--seed", "-1"], &["--seed", "expected a whole number from 0"]);
    refused(&["audit", "dark.toml"], &["dark.toml: nothing emits light"]);
    refused(&["audit", "polygons.csv"], &["a list of polygons carries no materials", "view-factors"]);
    refused(
        &["audit", "room.toml", "--bounces", "1"],
        &["--bounces 1: the referee judges all light", "leave out --bounces"],
    );
    refused(&["audit", "room.toml", "-o", "table.txt"], &["table.txt: the ending names no format", "csv"]);
    refused(&["audit", "room.toml", "--picture", "where.jpg"], &["where.jpg", ".png"]);
    refused(&["audit", "room.toml", "--size", "30x20"], &["--picture"]);
    let same = ["audit", "room.toml", "-o", "a.csv", "--report", "a.csv"];
    refused(&same, &["a.csv"]);
}

#[test]
fn a_view_is_chosen_for_a_picture_of_readings() {
    let folder = folder(&[("blind.toml", without_camera())]);
    let audit = ["audit", "blind.toml", "--seconds", "0.1", "--readings", "8", "--picture", "where.png"];
    let [_, told] = done(folder.path(), &audit);
    assert!(told.contains("where.png; no camera in the scene: seen from eye "), "{told}");
}

fn without_camera() -> String {
    let (head, rest) = FURNACE.split_once("[camera]").expect("it has one");
    let (_, rest) = rest.split_once("[planes.desk]").expect("it has a plane");
    format!("{head}[planes.desk]{rest}")
}

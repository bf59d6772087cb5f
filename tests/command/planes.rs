//! Planes of sensors: against closed forms, in tables, reports and plans; and what is refused.

use std::fs::{self, File};
use std::io::BufReader;
use std::path::Path;

use radiosity_test_support::data::number;
use radiosity_test_support::folders::{folder, json};
use serde_json::Value;

use crate::program::{self, radiosity};

/// Output of a command that succeeds: its table, standard error and report.
struct Done {
    lines: Vec<Vec<String>>,
    told: String,
    report: Value,
}

#[track_caller]
fn done(folder: &Path, args: &[&str]) -> Done {
    let [table, told] = program::done(folder, &[args, &["--report", "report.json"]].concat());
    Done {
        lines: table.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect(),
        told,
        report: json(&folder.join("report.json")),
    }
}

#[test]
fn furnaces_are_uniform() {
    let folder = tempfile::tempdir().unwrap();
    // Five cells of 0.18 are the fewest of at most 0.2 along 0.9.
    let plane = "0.05,0.05,0.3; 0.9,0,0; 0,0.8,0.1; 0.2,0.3";
    let done = done(folder.path(), &["probe", "furnace-cube", "--plane", plane, "--read-eps", "1e-5"]);
    assert_eq!(done.lines[0].join(","), "x,y,z,nx,ny,nz,E_grey,error,surface,u,v,B_grey");
    assert_eq!(done.lines.len(), 1 + 5 * 3);
    let figures = &done.report["planes"][0];
    assert_eq!((figures["name"].as_str(), number(&figures["points"])), (Some("plane-1"), 15.0));
    for (key, expected) in [("mean", 2.0), ("min", 2.0), ("max", 2.0), ("u0", 1.0), ("ud", 1.0)] {
        assert!((number(&figures[key]) / expected - 1.0).abs() < 1e-3, "{key}: {}", figures[key]);
    }
    assert!(
        done.told.contains("plane plane-1: 15 points, mean 2.00 W/m², min 2.00, max 2.00, U0 1.00, Ud 1.00")
    );
}

/// Of four sensors in a row two stand in the cube, where E = 2, and two outside, where nothing shines.
#[test]
fn sensors_outside_of_the_room_are_left_out_and_told() {
    let folder = tempfile::tempdir().unwrap();
    let plane = "-0.5,0.25,0.5; 2,0,0; 0,0.5,0; 0.5";
    let done = done(folder.path(), &["probe", "furnace-cube", "--plane", plane]);
    let figures = &done.report["planes"][0];
    assert_eq!(counts(figures), [2.0, 2.0, 0.0]);
    assert!((number(&figures["mean"]) / 2.0 - 1.0).abs() < 2e-3, "{figures}");
    assert!((number(&figures["u0"]) - 1.0).abs() < 2e-3, "{figures}");
    assert!(done.told.contains("; without 2 outside of the room or in solids"), "{}", done.told);
    assert_eq!(done.lines.len(), 1 + 4, "all stay in the table");
}

/// Points that count, points that are left out, and dark ones among the first.
fn counts(figures: &Value) -> [f64; 3] {
    ["points", "left_out", "dark"].map(|key| number(&figures[key]))
}

/// A scene of grey surfaces that emit 1 W/m² and reflect half: in a closed room E = 2 W/m² everywhere.
fn furnace(plane: &str, surfaces: &[&str]) -> String {
    let surface = |shape: &&str| format!("[[surfaces]]\nmaterial = \"wall\"\n{shape}\n");
    let surfaces: String = surfaces.iter().map(surface).collect();
    format!(
        "[planes.all]\n{plane}\nspacing = 0.5\n[materials.wall]\nreflectance = 0.5\nemission = 1\n{surfaces}"
    )
}

#[track_caller]
fn assert_counts(scene: &str, expected: [f64; 3], mean: Option<f64>) {
    let folder = folder(&[("room.toml", scene)]);
    let done = done(folder.path(), &["probe", "room.toml", "--planes"]);
    let figures = &done.report["planes"][0];
    assert_eq!(counts(figures), expected, "{}", done.told);
    if let Some(mean) = mean {
        assert!((number(&figures["mean"]) / mean - 1.0).abs() < 2e-3, "{figures}");
        assert!((number(&figures["u0"]) - 1.0).abs() < 5e-3, "{figures}");
    }
}

/// Of 12 × 12 sensors over a room of 6 m × 6 m the 6 × 6 in the corner that is cut out do not count.
#[test]
fn sensors_beyond_the_walls_of_a_room_of_l_shape_are_left_out() {
    let scene = furnace(
        "origin = [0, 0, 0.75]\nedges = [[6, 0, 0], [0, 6, 0]]",
        &[
            "polygon = { vertices = [[0,0,0], [6,0,0], [6,3,0], [3,3,0], [3,6,0], [0,6,0]] }",
            "polygon = { vertices = [[0,6,3], [3,6,3], [3,3,3], [6,3,3], [6,0,3], [0,0,3]] }",
            "quad = { vertices = [[6,0,0], [0,0,0], [0,0,3], [6,0,3]] }",
            "quad = { vertices = [[6,3,0], [6,0,0], [6,0,3], [6,3,3]] }",
            "quad = { vertices = [[3,3,0], [6,3,0], [6,3,3], [3,3,3]] }",
            "quad = { vertices = [[3,6,0], [3,3,0], [3,3,3], [3,6,3]] }",
            "quad = { vertices = [[0,6,0], [3,6,0], [3,6,3], [0,6,3]] }",
            "quad = { vertices = [[0,0,0], [0,6,0], [0,6,3], [0,0,3]] }",
        ],
    );
    assert_counts(&scene, [108.0, 36.0, 0.0], Some(2.0));
}

/// A box of 1 m × 1.5 m takes the places of 2 × 3 of 8 × 8 sensors, with a bottom or open on the floor.
#[test]
fn sensors_in_a_solid_are_left_out() {
    let plane = "origin = [0, 0, 0.5]\nedges = [[4, 0, 0], [0, 4, 0]]";
    let room = "box = { origin = [0, 0, 0], size = [4, 4, 3], inward = true }";
    for open in ["", ", open = [\"bottom\"]"] {
        let solid = format!("box = {{ origin = [1, 1, 0], size = [1, 1.5, 1]{open} }}");
        assert_counts(&furnace(plane, &[room, &solid]), [58.0, 6.0, 0.0], Some(2.0));
        // A table of one side, and a room without a ceiling: what sees some backs, or the open, counts.
        let table = "quad = { vertices = [[2.5,2.5,0.6], [3.5,2.5,0.6], [3.5,3.5,0.6], [2.5,3.5,0.6]] }";
        assert_counts(&furnace(plane, &[room, &solid, table]), [58.0, 6.0, 0.0], None);
        let roofless = room.replace("inward = true", "inward = true, open = [\"top\"]");
        assert_counts(&furnace(plane, &[&roofless, &solid]), [58.0, 6.0, 0.0], None);
    }
}

/// Between a floor and a lamp over it, under the one and above the other, nothing is closed: of 8 × 4 sensors all count
/// but those in the dark behind the floor.
#[test]
fn in_the_open_sensors_count_that_are_lit() {
    let scene = furnace(
        "origin = [-1, 1, -0.5]\nedges = [[0, 0, 2], [4, 0, 0]]",
        &[
            "quad = { vertices = [[0,0,0], [2,0,0], [2,2,0], [0,2,0]] }",
            "quad = { vertices = [[0,0,1], [0,2,1], [2,2,1], [2,0,1]] }",
        ],
    );
    let folder = folder(&[("open.toml", &scene)]);
    let figures = &done(folder.path(), &["probe", "open.toml", "--planes"]).report["planes"][0];
    assert_eq!(counts(figures)[..2], [24.0, 8.0]);
}

/// Under a floor nothing shines: a plane that no sensor sees a front from keeps them, with a warning.
#[test]
fn dark_sensors_in_the_open_are_told() {
    let scene = furnace(
        "origin = [0.5, 0.5, -1]\nedges = [[1, 0, 0], [0, 1, 0]]",
        &["quad = { vertices = [[0,0,0], [2,0,0], [2,2,0], [0,2,0]] }"],
    );
    let folder = folder(&[("open.toml", &scene)]);
    let done = done(folder.path(), &["probe", "open.toml", "--planes"]);
    assert_eq!(counts(&done.report["planes"][0]), [4.0, 0.0, 4.0]);
    assert!(done.told.contains("warning: 4 of the 4 sensors of plane \"all\" get no light"), "{}", done.told);
    assert_eq!(done.report["warnings"][0]["code"], "dark-sensors");
}

#[test]
fn points_outside_of_the_room_are_told() {
    let points = "0.5,0.5,0.5,0,0,1\n9,0,0,0,0,1\n0.2,0.2,0,0,0,1\n";
    let folder = folder(&[("p.csv", points)]);
    let done = done(folder.path(), &["probe", "furnace-cube", "--points", "p.csv"]);
    let told = "warning: 1 of the 3 points lie outside of the room or in solids: move them";
    assert!(done.told.contains(told), "{}", done.told);
}

/// A disk of 8000 lm/m² and radius 0.2 that shines down from 1.5 on a plane at 0.75, and nothing else.
const LAMP: &str = "
    bands = [\"lm\"]
    unit = \"lx\"
    [planes.desk]
    origin = [-0.8, -0.4, 0.75]
    edges = [[1.6, 0, 0], [0, 0.8, 0]]
    spacing = 0.2
    [planes.shelf]
    origin = [0, 0, 1]
    edges = [[0.4, 0, 0], [0, 0.4, 0]]
    spacing = [0.4, 0.2]
    [materials.lamp]
    reflectance = 0
    emission = 8000
    [[surfaces]]
    name = \"lamp\"
    material = \"lamp\"
    flip = true
    disk = { center = [0, 0, 1.5], normal = [0, 0, 1], radius = 0.2 }
";

/// E = M/2 (1 − (d² + h² − r²) / √((d² + h² + r²)² − 4 r² d²)) on a plane parallel to a disk, at the height h
/// below it and the distance d from its axis: Naylor and Smith's disk of constant radiance; M r² / (r² + h²)
/// on the axis.
fn below_the_lamp([x, y, z]: [f64; 3]) -> f64 {
    let (d2, h2, r2) = (x * x + y * y, (1.5 - z) * (1.5 - z), 0.04);
    4000.0 * (1.0 - (d2 + h2 - r2) / ((d2 + h2 + r2).powi(2) - 4.0 * r2 * d2).sqrt())
}

#[test]
fn a_plane_below_a_lamp_has_the_illuminance_and_uniformity_of_its_closed_form() {
    let folder = folder(&[("lamp.toml", LAMP)]);
    let done = done(folder.path(), &["probe", "lamp.toml", "--plane", "desk"]);
    let rows = done.lines[1..]
        .iter()
        .map(|line| -> Vec<f64> { line[..7].iter().map(|cell| cell.parse().expect("a number")).collect() });
    let mut expected = Vec::new();
    for row in rows {
        let illuminance = below_the_lamp([row[0], row[1], row[2]]);
        assert!((row[6] / illuminance - 1.0).abs() < 2e-3, "{} at {row:?}", illuminance);
        assert_eq!(row[3..6], [0.0, 0.0, 1.0]);
        expected.push(illuminance);
    }
    assert_eq!(expected.len(), 8 * 4);
    let mean = expected.iter().sum::<f64>() / 32.0;
    let min = expected.iter().copied().fold(f64::INFINITY, f64::min);
    let max = expected.iter().copied().fold(0.0, f64::max);
    let figures = &done.report["planes"][0];
    for (key, expected) in [("mean", mean), ("min", min), ("max", max), ("u0", min / mean), ("ud", min / max)]
    {
        assert!((number(&figures[key]) / expected - 1.0).abs() < 2e-3, "{key}: {}", figures[key]);
    }
    assert_eq!(done.report["unit"], "lx");
    assert!(
        done.told.contains("plane desk: 32 points, mean ") && done.told.contains(" lx, min "),
        "{}",
        done.told
    );
}

#[test]
fn several_planes_stand_in_one_table_with_their_names() {
    let folder = folder(&[("lamp.toml", LAMP)]);
    let typed = "-0.1,0,1.2; 0.2,0,0; 0,0.1,0; 1";
    for args in [
        ["--plane", "desk", "--plane", "shelf", "--plane", typed].as_slice(),
        &["--planes", "--plane", typed],
    ] {
        let done = done(folder.path(), &[&["probe", "lamp.toml"], args].concat());
        assert_eq!(done.lines[0].join(","), "plane,x,y,z,nx,ny,nz,E_lm,error,surface,u,v,B_lm");
        let names: Vec<&str> = done.lines[1..].iter().map(|line| line[0].as_str()).collect();
        let last = if args.len() == 6 { "plane-3" } else { "plane-1" };
        assert_eq!(names, [vec!["desk"; 32], vec!["shelf"; 2], vec![last]].concat());
        let planes = done.report["planes"].as_array().expect("a list");
        let points: Vec<f64> = planes.iter().map(|plane| number(&plane["points"])).collect();
        assert_eq!(points, [32.0, 2.0, 1.0]);
        // One sensor is as uniform as can be: 0.05 off the axis, and 0.3 below the lamp.
        assert_eq!((number(&planes[2]["u0"]), number(&planes[2]["ud"])), (1.0, 1.0));
        let illuminance = below_the_lamp([0.0, 0.05, 1.2]);
        assert!((number(&planes[2]["mean"]) / illuminance - 1.0).abs() < 2e-3);
    }
    let output = radiosity(folder.path(), &["probe", "lamp.toml", "--planes", "--format", "json"]);
    let json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(json["points"][33]["plane"], "shelf");
}

#[test]
fn several_bands_have_figures_each() {
    let folder = tempfile::tempdir().unwrap();
    let plane = "100,400,100; 0,0,300; 300,0,0; 150";
    let done = done(folder.path(), &["probe", "cornell-box", "--order", "1", "--plane", plane]);
    let bands = done.report["planes"][0]["bands"].as_array().expect("a list of bands");
    let names: Vec<&str> = bands.iter().filter_map(|band| band["band"].as_str()).collect();
    assert_eq!(names, ["R_620nm", "G_540nm", "B_460nm"]);
    for (k, band) in bands.iter().enumerate() {
        let values = done.lines[1..].iter().map(|line| line[6 + k].parse::<f64>().expect("a number"));
        let mean = values.clone().sum::<f64>() / 4.0;
        let min = values.fold(f64::INFINITY, f64::min);
        assert!((number(&band["mean"]) / mean - 1.0).abs() < 1e-12);
        assert!((number(&band["u0"]) * mean / min - 1.0).abs() < 1e-12);
    }
    assert!(done.told.contains("plane plane-1, band G_540nm: 4 points, mean "), "{}", done.told);
}

#[test]
fn solutions_keep_planes_and_unit() {
    let folder = folder(&[("lamp.toml", LAMP)]);
    done(folder.path(), &["solve", "lamp.toml", "-o", "lamp.json"]);
    let [first, second] =
        ["lamp.toml", "lamp.json"].map(|scene| done(folder.path(), &["probe", scene, "--plane", "shelf"]));
    assert_eq!(first.lines, second.lines);
    assert_eq!(second.report["unit"], "lx");
}

#[test]
fn planes_are_drawn_as_plans() {
    let folder = folder(&[("lamp.toml", LAMP)]);
    let mut pictures = Vec::new();
    for style in [&[][..], &["--isolines=500,1000"], &["--log", "--range", "10,2000"]] {
        let at = ["probe", "lamp.toml", "--plane", "desk", "--picture", "desk.png"];
        let told = done(folder.path(), &[&at, style].concat()).told;
        assert!(told.contains("wrote desk.png"), "{told}");
        let file = BufReader::new(File::open(folder.path().join("desk.png")).unwrap());
        let mut reader = png::Decoder::new(file).read_info().expect("it is a PNG");
        let mut pixels = vec![0; reader.output_buffer_size().expect("it fits")];
        let info = reader.next_frame(&mut pixels).expect("a picture");
        assert!(info.width > 640 && info.height > 320, "{} × {}", info.width, info.height);
        pictures.push(pixels);
    }
    assert!(pictures[0] != pictures[1] && pictures[0] != pictures[2]);
}

#[track_caller]
fn refused(args: &[&str], parts: &[&str]) {
    let folder = folder(&[("lamp.toml", LAMP), ("p.csv", "0,0,0,0,0,1\n")]);
    program::refused(folder.path(), &[&["probe", "lamp.toml"], args].concat(), parts);
}

#[test]
fn places_are_given_in_one_way() {
    refused(&[], &["nothing says where to read", "help: add --points FILE.csv, --plane NAME"]);
    refused(&["--points", "p.csv", "--plane", "desk"], &["--points and --plane both say", "help: leave one"]);
    refused(&["--points", "p.csv", "--planes"], &["--points and --plane both say"]);
}

#[test]
fn unknown_planes_are_told_the_known_ones() {
    refused(
        &["--plane", "dsk"],
        &["unknown plane \"dsk\"", "did you mean \"desk\"? planes of this scene: desk, shelf"],
    );
    let folder = tempfile::tempdir().unwrap();
    for (args, part) in
        [(["--plane", "desk"].as_slice(), "[planes.desk]"), (&["--planes"], "there are no planes")]
    {
        let output = radiosity(folder.path(), &[&["probe", "furnace-cube"], args].concat());
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2));
        assert!(message.contains(part) && message.contains("help: define"), "{message}");
    }
}

#[test]
fn planes_that_are_typed_wrongly_are_refused() {
    for (plane, fault) in [
        ("0,0,0; 1,0,0; 0,1,0", "there are 3 parts instead of 4"),
        ("0,0; 1,0,0; 0,1,0; 0.1", "the origin '0,0' is not three numbers"),
        ("0,0,0; 1,0,x; 0,1,0; 0.1", "the first edge '1,0,x' is not three numbers"),
        ("0,0,0; 1,0,0; 0,1,0; 1,1,1", "the spacing '1,1,1' is not one number or two"),
        ("0,0,0; 1,0,0; -2,0,0; 0.1", "the edges are parallel"),
        ("0,0,0; 0,0,0; 0,1,0; 0.1", "the first edge has no length"),
        ("0,0,0; 1,0,0; 0,1,0; 0", "the spacing is 0, outside spacing > 0"),
        ("0,0,0; 1,0,0; 0,1,0; -1", "the spacing is -1, outside spacing > 0"),
        ("0,0,0; 1,0,0; 0,1,0; nan", "NaN is not a finite number"),
        ("0,inf,0; 1,0,0; 0,1,0; 1", "inf is not a finite number"),
        ("0,0,0; 1,0,0; 0,1e31,0; 1", "the number is 1e31, outside"),
        ("0,0,0; 1,0,0; 0,1,0; 1e-4", "there are 1.0e8 sensors, more than 10⁷"),
    ] {
        refused(&["--plane", plane], &[&format!("--plane \"{plane}\": {fault}"), "help: "]);
    }
}

#[test]
fn plans_that_cannot_be_drawn_are_refused() {
    refused(
        &["--plane", "desk", "--picture", "desk.jpg"],
        &["desk.jpg: the ending names no kind of plan", ".png"],
    );
    refused(
        &["--planes", "--picture", "a.png"],
        &["--picture draws one plane, 2 are read", "help: choose one"],
    );
    refused(&["--points", "p.csv", "--picture", "a.png"], &["--picture draws one plane, 0 are read"]);
    refused(&["--plane", "desk", "--log"], &["--log speaks of a picture", "help: add --picture"]);
    let drawn = ["--plane", "desk", "--picture", "a.png"];
    refused(
        &[&drawn[..], &["--log", "--range", "0,5"]].concat(),
        &["no logarithm of 0", "lower end above 0"],
    );
    refused(&[&drawn[..], &["--band", "r"]].concat(), &["no band \"r\"", "bands of this scene: lm"]);
    refused(&[&drawn[..], &["--isolines", "p.csv"]].concat(), &["'p.csv' for '--isolines", "goes before"]);
    refused(
        &["--plane", "desk", "--read", "basis"],
        &["plane \"desk\": the sensor at (-0.7", "choose --read gather"],
    );
}

#[test]
fn cells_of_grids_have_their_middles() {
    let folder = tempfile::tempdir().unwrap();
    let lines = done(folder.path(), &["grid", "furnace-cube", "--cells", "2x4"]).lines;
    assert_eq!(lines[0].join(","), "surface,i,j,E_grey,B_grey,error,area,x,y,z");
    assert_eq!(lines[1][..3].join(","), "floor,0,0");
    assert_eq!(lines[1][7..].join(","), "0.25,0.125,0");
    // A scene far from the origin is computed about its own middle, and told where it is.
    fs::write(folder.path().join("far.toml"), LAMP.replace("[0, 0, 1.5]", "[5e5, 0, 1.5]")).unwrap();
    let lines = done(folder.path(), &["grid", "far.toml", "--cells", "1x1"]).lines;
    let place: Vec<f64> = lines[1][7..].iter().map(|cell| cell.parse().expect("a number")).collect();
    // u runs along the radius, v around: the middle is half-way out.
    assert!(((place[0] - 5e5).hypot(place[1]) - 0.1).abs() < 1e-6 && place[2] == 1.5, "{place:?}");
}

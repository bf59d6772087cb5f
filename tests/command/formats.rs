//! Scenes of other programs on the command line: read, repaired, told, written and read again.

use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use radiosity::geom::DVec3;
use radiosity_core::gauss;
use radiosity_test_support::folders::folder;
use serde_json::Value;

use crate::program::{done, radiosity, refused};

/// The matrix that `view-factors` prints: names and rows.
fn factors(text: &str) -> (Vec<String>, Vec<Vec<f64>>) {
    let mut lines = text.lines();
    let names = lines.next().expect("a header").split(',').skip(1).map(str::to_owned).collect();
    let row = |line: &str| line.split(',').skip(1).map(|number| number.parse().expect("a number")).collect();
    (names, lines.map(row).collect())
}

/// The corners of the faces of a unit cube, counter-clockwise as seen from within.
pub(crate) fn cube() -> Vec<[DVec3; 4]> {
    let mut faces = Vec::new();
    for axis in 0..3 {
        let [n, u, v] = [0, 1, 2].map(|k| DVec3::AXES[(axis + k) % 3]);
        faces.push([DVec3::ZERO, u, u + v, v]);
        faces.push([n, n + v, n + u + v, n + u]);
    }
    faces
}

/// The two triangles of a face.
fn triangles([a, b, c, d]: [DVec3; 4]) -> [[DVec3; 3]; 2] {
    [[a, b, c], [a, c, d]]
}

fn words(point: DVec3) -> String {
    format!("{} {} {}", point.x, point.y, point.z)
}

/// Faces or triangles as a list of texts, one for each.
pub(crate) fn each<const N: usize>(
    faces: &[[DVec3; N]],
    text: impl Fn(usize, &[String; N]) -> String,
) -> String {
    faces.iter().enumerate().map(|(index, face)| text(index, &face.map(words))).collect()
}

/// The triangles of the cube as a glTF with a buffer beside it, cube.bin.
pub(crate) fn gltf() -> (String, Vec<u8>) {
    let positions: Vec<DVec3> = cube().into_iter().flat_map(triangles).flatten().collect();
    let bytes: Vec<u8> =
        positions.iter().flat_map(|p| p.to_array()).flat_map(|x| (x as f32).to_le_bytes()).collect();
    let text = serde_json::json!({
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": bytes.len(), "uri": "cube.bin"}],
        "bufferViews": [{"buffer": 0, "byteLength": bytes.len()}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": positions.len(), "type": "VEC3",
            "min": [0, 0, 0], "max": [1, 1, 1]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "nodes": [{"mesh": 0}],
        "scenes": [{"nodes": [0]}],
        "scene": 0
    });
    (text.to_string(), bytes)
}

/// The cube in every format that is read.
fn cubes() -> Vec<(&'static str, String)> {
    let faces = cube();
    let halves: Vec<[DVec3; 3]> = faces.iter().copied().flat_map(triangles).collect();
    let obj = each(&faces, |_, [a, b, c, d]| format!("v {a}\nv {b}\nv {c}\nv {d}\nf -4 -3 -2 -1\n"));
    let stl = each(&halves, |_, [a, b, c]| {
        format!("facet normal 0 0 0\nouter loop\nvertex {a}\nvertex {b}\nvertex {c}\nendloop\nendfacet\n")
    });
    let ply = each(&faces, |_, corners| corners.join("\n") + "\n");
    let ply_faces = each(&faces, |k, _| {
        let k = 4 * k;
        format!("4 {k} {} {} {}\n", k + 1, k + 2, k + 3)
    });
    let mgf = each(&faces, |_, [a, b, c, d]| {
        format!("v a =\np {a}\nv b =\np {b}\nv c =\np {c}\nv d =\np {d}\nf a b c d\n")
    });
    let rad = each(&faces, |k, corners| format!("wall polygon face{k}\n0\n0\n12 {}\n", corners.join(" ")));
    let vertices = each(&faces, |k, [a, b, c, d]| {
        let k = 4 * k;
        format!("V {} {a}\nV {} {b}\nV {} {c}\nV {} {d}\n", k + 1, k + 2, k + 3, k + 4)
    });
    let surfaces = each(&faces, |k, _| {
        let v = 4 * k;
        format!("S {} {} {} {} {} 0 0 0.5 face{k}\n", k + 1, v + 1, v + 2, v + 3, v + 4)
    });
    let xml = "<scene version=\"3.0.0\"><shape type=\"cube\"><boolean name=\"flip_normals\" value=\"true\"/></shape></scene>";
    vec![
        ("cube.mgf", mgf),
        ("cube.obj", obj),
        ("cube.gltf", gltf().0),
        ("cube.stl", format!("solid cube\n{stl}endsolid cube\n")),
        (
            "cube.ply",
            format!(
                "ply\nformat ascii 1.0\nelement vertex 24\nproperty float x\nproperty float y\nproperty float z\n\
                 element face 6\nproperty list uchar int vertex_indices\nend_header\n{ply}{ply_faces}"
            ),
        ),
        ("cube.xml", xml.to_owned()),
        ("cube.rad", format!("void plastic wall\n0\n0\n5 .5 .5 .5 0 0\n{rad}")),
        ("cube.vs3", format!("T cube\nF 3\n{vertices}{surfaces}E\n")),
    ]
}

/// The view factor between opposite faces of the unit cube (Hamilton and Morgan 1952, configuration P-1 with
/// X = Y = 1).
fn opposite() -> f64 {
    let root = 2f64.sqrt();
    2.0 / PI * ((4.0f64 / 3.0).sqrt().ln() + 2.0 * root * (1.0 / root).atan() - PI / 2.0)
}

#[test]
fn a_cube_in_each_format_has_the_factors_of_a_cube() {
    let adjacent = (1.0 - opposite()) / 4.0;
    for (name, text) in cubes() {
        let folder = folder(&[(name, text.as_bytes()), ("cube.bin", &gltf().1)]);
        let [table, _] = done(folder.path(), &["view-factors", name, "--one-sided", "-q"]);
        let (names, rows) = factors(&table);
        assert_eq!(names.len(), 6, "{name}: {names:?}");
        for row in rows {
            let mut row = row;
            row.sort_by(f64::total_cmp);
            let exact = [0.0, opposite(), adjacent, adjacent, adjacent, adjacent];
            row.iter().zip(exact).for_each(|(found, exact)| {
                assert!((found - exact).abs() < 1e-12, "{name}: {found} instead of {exact}");
            });
        }
    }
}

/// The exact factor from the rectangle `from` to the rectangle `to`, [[x, x], [y, y]], in parallel planes at
/// a distance. Source: Howell, catalogue of configuration factors, C-13.
fn parallel(from: [[f64; 2]; 2], to: [[f64; 2]; 2], distance: f64) -> f64 {
    let term = |x: f64, y: f64| {
        let leg = |a: f64, b: f64| {
            let root = b.hypot(distance);
            a * root * (a / root).atan()
        };
        leg(y, x) + leg(x, y) - 0.5 * distance.powi(2) * (x * x + y * y + distance.powi(2)).ln()
    };
    let mut sum = 0.0;
    for k in 0..16 {
        let bit = |n: usize| (k >> n) & 1;
        let sign = if (0..4).map(bit).sum::<usize>() % 2 == 0 { 1.0 } else { -1.0 };
        sum += sign * term(from[0][bit(0)] - to[0][bit(1)], from[1][bit(2)] - to[1][bit(3)]);
    }
    let area = (from[0][1] - from[0][0]) * (from[1][1] - from[1][0]);
    sum / (2.0 * PI * area)
}

/// The exact factor between the end of a leg of the L-shaped room and the wall 3 away, which the inner corner
/// hides in part: from the height y > 1 on the wall, y′ < 3 − 2y of the end is seen. Both parts are smooth:
/// Gauss rules. Of the heights z only the difference s counts.
fn past_the_corner() -> f64 {
    let rule = |from: f64, to: f64| {
        let (mut nodes, mut weights) = ([0.0; 24], [0.0; 24]);
        gauss::legendre(&mut nodes, &mut weights).expect("slices are equal and not empty");
        let half = 0.5 * (to - from);
        let place = |(x, w): (f64, f64)| (from + half * (x + 1.0), half * w);
        nodes.into_iter().zip(weights).map(place).collect::<Vec<_>>()
    };
    let heights = |dy: f64| -> f64 {
        let kernel = |s: f64| 9.0 / (PI * (9.0 + dy * dy + s * s).powi(2));
        rule(0.0, 3.0).iter().map(|(s, w)| w * 2.0 * (3.0 - s) * kernel(*s)).sum()
    };
    let part = |from: f64, to: f64, seen: fn(f64) -> f64| -> f64 {
        let across = |y: f64| rule(0.0, seen(y)).iter().map(|(z, w)| w * heights(y - z)).sum::<f64>();
        rule(from, to).iter().map(|(y, w)| w * across(*y)).sum()
    };
    (part(0.0, 1.0, |_| 1.0) + part(1.0, 1.5, |y| 3.0 - 2.0 * y)) / 3.0
}

#[test]
fn examples_of_view3d_have_their_closed_forms() {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("crates/formats/tests/fixtures");
    let table = |name: &str| {
        let [table, _] = done(&fixtures, &["view-factors", name, "--eps", "1e-11", "-q"]);
        let (names, rows) = factors(&table);
        move |from: &str, to: &str| {
            let index =
                |name: &str| names.iter().position(|own| own == name).expect("a surface of this name");
            rows[index(from)][index(to)]
        }
    };
    let between = table("square-between.vs3");
    let bare = opposite();
    assert!((parallel([[0.0, 1.0]; 2], [[0.0, 1.0]; 2], 1.0) - bare).abs() < 1e-12);
    assert!((between("bottom", "top") - 0.75 * bare).abs() < 1e-9);
    // View3D prints 0.149869.
    assert!((between("bottom", "top") - 0.149_868_671_8).abs() < 1e-9);
    for name in ["l-room.vs3", "l-room-3a.vs3"] {
        let room = table(name);
        // Seen from within its leg, the inner wall has the whole outer one before it.
        let exact = parallel([[1.0, 3.0], [0.0, 3.0]], [[0.0, 3.0]; 2], 1.0);
        for (from, to) in [("inner-east", "west"), ("inner-north", "south")] {
            assert!((room(from, to) - exact).abs() < 1e-9, "{name}: {}", room(from, to));
        }
        // The room is its own mirror image across its diagonal.
        for (from, to) in [("east-end", "west"), ("north-end", "south")] {
            assert!((room(from, to) - past_the_corner()).abs() < 1e-9, "{name}: {}", room(from, to));
        }
        assert_eq!(room("east-end", "north-end"), 0.0);
    }
}

/// The columns of a table of readings that hold numbers, by name.
fn columns(table: &str) -> Vec<(String, Vec<f64>)> {
    let mut lines = table.lines();
    let names = lines.next().expect("a header").split(',');
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    let column = |index: usize| rows.iter().map(|row| row[index].parse().ok()).collect::<Option<Vec<f64>>>();
    names.enumerate().filter_map(|(index, name)| Some((name.to_owned(), column(index)?))).collect()
}

/// The radiosities of a table, of all bands.
#[track_caller]
fn radiosities(columns: &[(String, Vec<f64>)]) -> Vec<f64> {
    let own: Vec<f64> = columns
        .iter()
        .filter(|(name, _)| name.starts_with("B_"))
        .flat_map(|(_, values)| values.clone())
        .collect();
    assert!(!own.is_empty());
    own
}

#[test]
fn built_in_scenes_come_back_from_each_format_that_has_their_shapes() {
    let scenes: [(&str, &[&str]); 10] = [
        ("cornell-box", &["toml", "json", "mgf", "obj"]),
        ("empty-box", &["toml", "json", "mgf", "obj"]),
        ("furnace-cube", &["toml", "json", "mgf", "obj"]),
        ("furnace-sphere", &["toml", "json", "mgf"]),
        ("hinge-squares", &["toml", "json", "mgf", "obj"]),
        ("occluder-box", &["toml", "json", "mgf", "obj"]),
        ("parallel-squares", &["toml", "json", "mgf", "obj"]),
        ("two-boxes", &["toml", "json", "mgf", "obj"]),
        ("teapot", &["json"]),
        ("temple", &["toml"]),
    ];
    let folder = folder::<&str>(&[]);
    let here = folder.path();
    for (scene, endings) in scenes {
        let grid = |source: &str| {
            let few_rays = ["--order", "0", "--read", "basis", "--rays", "20000"];
            let cheap: &[&str] = if endings.len() == 1 { &few_rays } else { &[] };
            // Errors that are told are not compared.
            let usual = ["grid", source, "--cells", "1x1", "-q", "--audit", "0.001"];
            columns(&done(here, &[&usual[..], cheap].concat())[0])
        };
        let expected = grid(scene);
        let greatest = |values: &[f64]| values.iter().copied().map(f64::abs).fold(0.0, f64::max);
        let is_place = |name: &str| ["x", "y", "z"].contains(&name);
        let places = expected.iter().filter(|(name, _)| is_place(name));
        let extent = places.map(|(_, values)| greatest(values)).fold(0.0, f64::max);
        assert!(radiosities(&expected).iter().any(|value| *value > 0.0), "{scene}");
        for ending in endings {
            let file = format!("{scene}.{ending}");
            done(here, &["convert", scene, &file]);
            let found = grid(&file);
            assert_eq!(found.len(), expected.len(), "{file}");
            // Bands lose their names on the way.
            // Errors are found by rays of which roundings make others.
            let told = found.iter().zip(&expected).filter(|(_, (name, _))| name != "error");
            for ((_, found), (name, expected)) in told {
                assert_eq!(found.len(), expected.len(), "{file}: {name}");
                let largest = if is_place(name) { extent } else { greatest(expected) };
                let worst = found.iter().zip(expected).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
                assert!(worst <= 1e-10 * largest, "{file}: {name}: {worst:e} of {largest:e}");
            }
        }
    }
    // View3D has no emission: its factors are compared, where no hole cuts a surface in pieces.
    let table = |source: &str| factors(&done(here, &["view-factors", source, "-q"])[0]);
    for scene in ["empty-box", "furnace-cube", "hinge-squares", "parallel-squares"] {
        let file = format!("{scene}.vs3");
        done(here, &["convert", scene, &file]);
        let ((_, expected), (_, found)) = (table(scene), table(&file));
        let pairs = expected.iter().flatten().zip(found.iter().flatten());
        assert_eq!(expected.len(), found.len(), "{scene}");
        pairs.for_each(|(x, y)| assert!((x - y).abs() < 1e-12, "{scene}: {x} {y}"));
    }
}

#[test]
fn shapes_that_a_format_lacks_are_named() {
    let folder = folder::<&str>(&[]);
    refused(folder.path(), &["convert", "teapot", "pot.mgf"], &["\"pot\" (patches)", ".toml or .json"]);
    refused(folder.path(), &["convert", "furnace-sphere", "sphere.obj"], &["sphere", "OBJ"]);
    refused(folder.path(), &["convert", "cornell-box", "box.stl"], &["names no format", "toml, json, mgf"]);
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0);
}

/// Two squares in the same place and a bridged outline; a lamp above.
const DIRTY: &str = "m wall =
    sides 1
    rd 0.5
m glow =
    sides 1
    ed 100
v a = 
    p 0 0 0
v b = 
    p 1 0 0
v c = 
    p 1 1 0
v d = 
    p 0 1 0
v e =
    p 0 0 2
v f =
    p 0 1 2
v g =
    p 1 1 2
v h =
    p 1 0 2
m wall
o floor
f a b c d
f b c d a
o
m glow
o lamp
f e f g h
o
";

#[test]
fn repairs_are_told_reported_and_refused_if_strict() {
    let folder = folder(&[("room.mgf", DIRTY.as_bytes())]);
    let here = folder.path();
    let [_, told] = done(here, &["solve", "room.mgf", "--report", "report.json"]);
    let line = "room.mgf:25: \"floor\" and \"floor-2\" ";
    assert!(told.contains(line), "{told}");
    let report: Value =
        serde_json::from_slice(&fs::read(here.join("report.json")).expect("a report")).expect("JSON");
    assert_eq!(report["imported"]["format"], "mgf");
    assert!(report["imported"]["remarks"][0].as_str().expect("a remark").starts_with(line));
    let [listed, _] = done(here, &["check", "room.mgf"]);
    assert!(listed.contains(line), "{listed}");
    refused(here, &["solve", "room.mgf", "--strict"], &["room.mgf:25: \"floor\"", "leaving out --strict"]);
    let strict = radiosity(here, &["check", "room.mgf", "--strict"]);
    assert_eq!(strict.status.code(), Some(1));
    // A solution stands for itself.
    fs::remove_file(here.join("room.mgf")).expect("it is there");
    done(here, &["grid", "room.solution.json", "--cells", "1x1"]);
}

#[test]
fn standard_input_is_read_in_a_format_that_is_named() {
    let folder = folder(&[("room.mgf", DIRTY.as_bytes())]);
    let file = fs::File::open(folder.path().join("room.mgf")).expect("it is there");
    let mut command = Command::new(env!("CARGO_BIN_EXE_radiosity"));
    let output = command.args(["check", "-", "--from", "mgf"]).stdin(file).output().expect("the binary runs");
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("<stdin>:25: ") && text.contains("lamp"), "{text}");
}

#[test]
fn units_and_materials_come_from_outside() {
    let mm: String = cubes().swap_remove(3).1;
    let stl: String = mm
        .lines()
        .map(|line| match line.strip_prefix("vertex ") {
            Some(numbers) => {
                let scaled: Vec<String> = numbers
                    .split(' ')
                    .map(|x| (1000.0 * x.parse::<f64>().expect("a number")).to_string())
                    .collect();
                format!("vertex {}\n", scaled.join(" "))
            }
            None => format!("{line}\n"),
        })
        .collect();
    let paint = "[materials.\"*\"]\nreflectance = 0.5\n[materials.glow]\nemission = 1\n[surfaces]\n\"cube-3\" = \"glow\"\n";
    let folder = folder(&[("cube.stl", stl.as_bytes()), ("paint.toml", paint.as_bytes())]);
    let here = folder.path();
    refused(here, &["solve", "cube.stl"], &["no materials", "--materials"]);
    let args = ["check", "cube.stl", "--unit", "mm", "--materials", "paint.toml", "--format", "json"];
    let [found, _] = done(here, &args);
    let found: Value = serde_json::from_str(&found).expect("JSON");
    let areas: f64 = found["surfaces"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|own| own["area"].as_f64().expect("a number"))
        .sum();
    assert!((areas - 6.0).abs() < 1e-12, "{areas}");
    let [table, _] = done(
        here,
        &["grid", "cube.stl", "--cells", "1x1", "--unit", "mm", "--materials", "paint.toml", "-q"],
    );
    let lit = radiosities(&columns(&table));
    assert!(lit.len() == 6 && lit.iter().all(|value| *value > 0.0), "{table}");
}

#[test]
fn options_that_make_no_sense_are_refused_with_a_cure() {
    let folder =
        folder(&[("room.mgf", DIRTY.as_bytes()), ("broken.obj", b"v 0 0\nf 1 2 3\n"), ("room.skp", b"x")]);
    let here = folder.path();
    refused(here, &["solve", "cornell-box", "--one-sided"], &["--one-sided", "cornell-box", "--from"]);
    refused(here, &["check", "room.mgf", "--one-sided", "--two-sided"], &["cannot be used with"]);
    refused(here, &["check", "room.mgf", "--unit", "furlong"], &["mm, cm"]);
    refused(here, &["check", "room.mgf", "--from", "skp"], &["mgf", "obj"]);
    refused(here, &["check", "room.mgf", "--materials", "none.toml"], &["none.toml", "check the path"]);
    refused(here, &["check", "none.mgf"], &["none.mgf: cannot be read"]);
    refused(here, &["check", "broken.obj"], &["broken.obj:1: ", "help: "]);
    refused(here, &["convert", "room.mgf", "room.mgf"], &["the file of the scene"]);
}

/// A room of the folder `shared`, where that is beside the repository.
fn shared(name: &str) -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/scenes/mgf").join(name);
    path.exists().then_some(path)
}

/// Holds that light in a real room agrees with that of path tracing; not where the room is not beside the repository.
fn agrees_with_path_traced_points(room: &str) {
    let (Some(scene), Some(reference)) =
        (shared(&format!("{room}.mgf")), shared(&format!("{room}_reference.json")))
    else {
        return;
    };
    let reference: Value = serde_json::from_slice(&fs::read(reference).expect("it is there")).expect("JSON");
    let points = reference["points"].as_array().expect("points");
    let list = |value: &Value| -> Vec<f64> {
        value.as_array().expect("a list").iter().map(|x| x.as_f64().expect("a number")).collect()
    };
    let row = |point: &Value| {
        let numbers = [list(&point["p"]), list(&point["n"])].concat();
        numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(",") + "\n"
    };
    let folder = folder(&[("p.csv", points.iter().map(row).collect::<String>().as_bytes())]);
    let scene = scene.to_str().expect("a path in Unicode");
    let args = ["probe", scene, "--one-sided", "--grey", "--points", "p.csv", "--accuracy", "3e-2", "-q"];
    let [table, _] = done(folder.path(), &args);
    let column = table.lines().next().expect("a header").split(',').position(|name| name == "E_grey");
    let column = column.expect("an irradiance");
    let found = table
        .lines()
        .skip(1)
        .map(|line| line.split(',').nth(column).expect("a field").parse::<f64>().expect("a number"));
    let exact: Vec<f64> = points.iter().map(|point| point["E"].as_f64().expect("a number")).collect();
    let missed: f64 = found.zip(&exact).map(|(x, y)| (x - y).powi(2)).sum();
    let error = (missed / exact.iter().map(|x| x * x).sum::<f64>()).sqrt();
    assert!(error < 3e-2, "{room}: {error}");
}

#[test]
fn a_real_room_agrees_with_path_traced_points() {
    agrees_with_path_traced_points("soda");
}

#[test]
#[ignore = "half a minute of CPU"]
fn a_classroom_agrees_with_path_traced_points() {
    agrees_with_path_traced_points("classroom");
}

/// A lamp in the plane of a ceiling cuts its hole itself: the light is that of a ceiling with a hole.
#[test]
fn a_lamp_in_the_plane_of_a_ceiling_shines_as_in_a_hole() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let office = fs::read_to_string(examples.join("office.toml")).expect("the office is there");
    let (before, rest) = office.split_once("holes = [").expect("the ceiling has holes");
    let (_, after) = rest.split_once("\n]\n").expect("their list ends");
    let flush = format!("{before}{after}");
    let folder = folder(&[("office.toml", office.as_bytes()), ("flush.toml", flush.as_bytes())]);
    let sensors = examples.join("sensors.csv");
    let probe = |scene: &str| {
        let points = sensors.to_str().expect("a path of letters");
        let [table, _] = done(folder.path(), &["probe", scene, "--points", points, "-q"]);
        let column = |line: &str| line.split(',').nth(6).and_then(|field| field.parse::<f64>().ok());
        table.lines().skip(1).map(|line| column(line).expect("an irradiance")).collect::<Vec<_>>()
    };
    let (cut, flush) = (probe("office.toml"), probe("flush.toml"));
    assert!(cut.len() == 4 && cut.iter().all(|x| *x > 10.0), "{cut:?}");
    cut.iter().zip(&flush).for_each(|(x, y)| assert!((x / y - 1.0).abs() < 3e-4, "{x} {y}"));
    let [findings, _] = done(folder.path(), &["check", "flush.toml"]);
    assert!(findings.contains("set apart: panel-left lies on ceiling"), "{findings}");
    assert!(findings.contains("nothing looks wrong"), "{findings}");
}

/// The room of the README: what was typed as triangles, whole boxes and flush lamps needs no word but its
/// unit and its light.
#[test]
fn a_room_from_a_drawing_program_is_read_and_lit() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let [findings, _] = done(
        &examples,
        &["check", "meeting-room.obj", "--unit", "mm", "--materials", "meeting-room-materials.toml"],
    );
    assert!(findings.contains("88 coplanar triangles were merged to 44 polygons"), "{findings}");
    let warnings: Vec<&str> = findings.lines().filter(|line| line.starts_with("warning")).collect();
    assert!(warnings.iter().all(|line| line.contains("no camera")), "{warnings:?}");
}

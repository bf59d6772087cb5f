//! The command `heat`: its outputs, and what it refuses.

use std::fs;
use std::path::Path;

use radiosity_test_support::data::number;
use radiosity_test_support::scenes::NEAR_PLATES;
use serde_json::Value;

use crate::program::{done, radiosity, refused};

/// Standard output and standard error of `heat`, which succeeds.
#[track_caller]
fn heat(folder: &Path, args: &[&str]) -> [String; 2] {
    done(folder, &[&["heat"], args].concat())
}

#[test]
fn the_oven_is_in_balance_in_every_format() {
    let folder = tempfile::tempdir().unwrap();
    let [table, told] = heat(folder.path(), &[]);
    assert!(table.starts_with("surface ") && table.contains("slab"), "{table}");
    assert!(told.contains("the scene is closed"), "{told}");
    let [csv, _] = heat(folder.path(), &["oven", "--format", "csv", "-q"]);
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let flows: Vec<f64> = rows.iter().map(|row| row[6].parse().unwrap()).collect();
    let given: f64 = flows.iter().filter(|flow| **flow > 0.0).sum();
    assert!(flows.iter().sum::<f64>().abs() < 1e-4 * given, "{flows:?}");
    heat(folder.path(), &["oven", "-o", "oven.json", "-q"]);
    let json: Value = serde_json::from_slice(&fs::read(folder.path().join("oven.json")).unwrap()).unwrap();
    let own = &json["surfaces"][6];
    assert_eq!((own["name"].as_str(), own["temperature"].as_f64()), (Some("slab"), Some(900.0)));
    assert_eq!(own["flow"].as_f64(), Some(flows[6]));
}

/// Where nothing flows, errors that are parts of it tell nothing.
#[test]
fn no_relative_error_is_told_of_flows_of_0() {
    let room = "bands = [\"grey\"]\n[materials.m]\nemissivity = 0.5\ntemperature = 300\n[[surfaces]]\nname = \"room\"\n\
                material = \"m\"\nflip = true\nbox = { origin = [0, 0, 0], size = [1, 1, 1] }\n";
    let folder = radiosity_test_support::folders::folder(&[("room.toml", room)]);
    let [_, told] = heat(folder.path(), &["room.toml", "-o", "room.json"]);
    assert!(told.contains("all are 0 as far as walks tell"), "{told}");
    let json: Value = serde_json::from_slice(&fs::read(folder.path().join("room.json")).unwrap()).unwrap();
    for key in ["error", "error_sd", "visible", "own_error"] {
        assert!(json[key].as_f64().is_none_or(|error| error < 1.0), "{key}: {}", json[key]);
    }
}

#[test]
fn every_solver_finds_the_same_heat() {
    let folder = tempfile::tempdir().unwrap();
    let flows = |solver: &str| -> Vec<f64> {
        let args = ["oven", "--format", "csv", "-q", "--eps", "1e-3", "--order", "1", "--solver", solver];
        let [csv, _] = heat(folder.path(), &args);
        let mut reader = csv::Reader::from_reader(csv.as_bytes());
        reader.records().map(|row| row.unwrap()[6].parse().unwrap()).collect()
    };
    let expected = flows("lu");
    let largest = expected.iter().fold(0.0, |largest: f64, flow| largest.max(flow.abs()));
    for solver in
        ["cholesky", "cg", "gmres", "gauss-seidel", "jacobi", "richardson", "progressive", "shooting"]
    {
        for (found, expected) in flows(solver).iter().zip(&expected) {
            // Systems of heat are solved to 1e-12.
            assert!((found - expected).abs() < 1e-10 * largest, "{solver}: {found} for {expected}");
        }
    }
    let wrong = ["heat", "oven", "--solver", "shoting"];
    refused(folder.path(), &wrong, &["'shoting'", "southwell"]);
}

#[test]
fn conductances_of_a_surface_sum_to_what_it_emits() {
    let folder = tempfile::tempdir().unwrap();
    for file in ["C.csv", "C.json", "C.npy"] {
        heat(folder.path(), &["oven", "--conductances", file, "-q"]);
    }
    let json: Value = serde_json::from_slice(&fs::read(folder.path().join("C.json")).unwrap()).unwrap();
    let rows = json["conductances"].as_array().unwrap();
    let bytes = fs::read(folder.path().join("C.npy")).unwrap();
    assert_eq!(&bytes[..6], b"\x93NUMPY");
    let numbers = &bytes[bytes.len() - 8 * rows.len() * rows.len()..];
    let numbers: Vec<f64> =
        numbers.chunks_exact(8).map(|eight| f64::from_le_bytes(eight.try_into().unwrap())).collect();
    let slab: f64 = rows[6].as_array().unwrap().iter().map(number).sum();
    // 4.8 m² of emissivity 0.8.
    assert!((slab + number(&json["surroundings"][6]) - 3.84).abs() < 1e-12);
    assert!((slab - 3.84).abs() < 1e-3, "{slab}");
    for (i, row) in rows.iter().enumerate() {
        for (j, conductance) in row.as_array().unwrap().iter().enumerate() {
            assert_eq!(number(conductance), number(&rows[j][i]));
            assert_eq!(number(conductance), numbers[i * rows.len() + j]);
        }
    }
    let csv = fs::read_to_string(folder.path().join("C.csv")).unwrap();
    assert!(csv.lines().next().unwrap().ends_with("slab,(surroundings)"), "{csv}");
}

#[test]
fn a_room_at_rest_is_told_to_be_closed() {
    let folder = tempfile::tempdir().unwrap();
    let [_, told] = heat(folder.path(), &["oven", "--set", "heater=900", "--order", "1"]);
    assert!(told.contains("the scene is closed"), "{told}");
}

/// The rows of CSV.
fn rows(text: &str) -> Vec<csv::StringRecord> {
    csv::Reader::from_reader(text.as_bytes()).records().map(Result::unwrap).collect()
}

#[test]
fn a_sweep_tells_what_single_runs_tell() {
    let folder = tempfile::tempdir().unwrap();
    let [swept, told] = heat(folder.path(), &["oven", "--sweep", "brick.emissivity=0.9..0.3/3"]);
    assert!(
        told.contains("3 values of brick.emissivity")
            && told.contains("flows are largest at brick.emissivity = "),
        "{told}"
    );
    let swept = rows(&swept);
    assert_eq!(swept.len(), 21);
    for (point, emissivity) in ["0.9", "0.6", "0.3"].iter().enumerate() {
        let setting = format!("brick.emissivity={emissivity}");
        let [alone, _] = heat(folder.path(), &["oven", "--set", &setting, "--format", "csv", "-q"]);
        for (own, other) in swept[7 * point..7 * point + 7].iter().zip(rows(&alone)) {
            assert_eq!(&own[0], *emissivity);
            assert_eq!((&own[1], &own[3]), (&other[0], &other[2]));
            for column in [3, 5, 6] {
                let [own, other] = [&own[column + 1], &other[column]].map(|own| own.parse::<f64>().unwrap());
                assert!((own - other).abs() < 1e-9 * other.abs().max(1e4), "{own} for {other}");
            }
        }
    }
    heat(folder.path(), &["oven", "--sweep", "panel.temperature=1000..1500/2", "-o", "T.json", "-q"]);
    let json: Value = serde_json::from_slice(&fs::read(folder.path().join("T.json")).unwrap()).unwrap();
    assert_eq!(json["swept"], "panel.temperature");
    let points = json["points"].as_array().unwrap();
    assert_eq!((points.len(), number(&points[1]["value"])), (2, 1500.0));
    assert_eq!(number(&points[1]["surfaces"][5]["temperature"]), 1500.0);
    assert!(points[1]["audit"].is_object() && points[0]["audit"].is_null());
}

#[test]
fn a_picture_shows_temperatures_with_a_legend() {
    let folder = tempfile::tempdir().unwrap();
    let args = ["oven", "--picture", "oven.png", "--size", "64x48", "--range", "800,1500", "-q"];
    heat(folder.path(), &args);
    let decoder =
        png::Decoder::new(std::io::BufReader::new(fs::File::open(folder.path().join("oven.png")).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    assert!(info.width > 64 && info.height >= 48);
    let pixel = |x: usize, y: usize| {
        let start = y * info.line_size + 3 * x;
        [bytes[start], bytes[start + 1], bytes[start + 2]]
    };
    // The panels at 1400 K stand above, the slab at 900 K below: each is even.
    assert_eq!(pixel(10, 1), pixel(50, 3));
    assert_eq!(pixel(30, 47), pixel(34, 40));
    assert_ne!(pixel(10, 1), pixel(30, 47));
    heat(folder.path(), &["oven", "--picture", "level.png", "--show", "exitance", "--size", "64x48", "-q"]);
    assert_ne!(
        fs::read(folder.path().join("level.png")).unwrap(),
        fs::read(folder.path().join("oven.png")).unwrap()
    );
}

#[test]
fn wrong_use_is_refused_before_the_work() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |args: &[&str], parts: &[&str]| refused(folder.path(), &[&["heat"], args].concat(), parts);
    refused(&["cornell-box"], &["neither a temperature nor a flux", "adiabatic = true"]);
    refused(&["oven", "-o", "oven.xlsx"], &["oven.xlsx", ".csv"]);
    refused(&["oven", "--conductances", "C.txt"], &["C.txt", ".npy"]);
    refused(&["oven", "-o", "a.csv", "--conductances", "a.csv"], &["a.csv"]);
    refused(&["oven", "--shadows", "mask"], &["'mask'", "auto, off, rays, exact"]);
    refused(&["oven", "--set", "heater=-5"], &["heater"]);
    refused(&["oven", "--order", "21"], &["21"]);
    refused(&["oven", "--set", "panels.emissivity=0.5"], &["panels", "did you mean \"panel\"?"]);
    refused(&["oven", "--set", "panel.emisivity=0.5"], &["emisivity", "did you mean \"emissivity\"?"]);
    refused(&["oven", "--set", "wall.emissivity=0.5"], &["\"wall-*\"", "begin with \"wall-\""]);
    refused(&["oven", "--sweep", "panel=0.5..2/3"], &["\"panel\" has no key", "panel.KEY"]);
    refused(&["oven", "--sweep", "panel.temperature=300...500/2"], &["more than two points", "300..500"]);
    refused(&["oven", "--sweep", "panel.emissivity=0.5..2/3"], &["panel.emissivity", "0 < ε ≤ 1"]);
    refused(&["oven", "--sweep", "panel.emissivity=0.5..0.9"], &["panel.emissivity=0.1..0.9/17"]);
    let sweep = ["oven", "--sweep", "panel.emissivity=0.5..0.9/3"];
    refused(&[&sweep[..], &["--format", "text"]].concat(), &["--format text", "--format csv or json"]);
    for file in ["x.txt", "x.text"] {
        refused(&[&sweep[..], &["-o", file]].concat(), &[file, ".csv or .json, or add --format csv or json"]);
    }
    refused(&[&sweep[..], &["--conductances", "C.csv"]].concat(), &["--sweep", "--conductances"]);
    refused(&["oven", "-o", "x.png", "--format", "csv", "--picture", "x.png"], &["x.png", "figures"]);
    refused(&["oven", "--isolines"], &["--isolines speaks of a picture", "--picture FILE.png"]);
    refused(&["oven", "--picture", "a.jpg"], &["a.jpg", ".png"]);
    refused(&["oven", "--picture", "a.png", "--band", "grey"], &["--band", "leave it out"]);
    refused(&["oven", "--conductances", "C.csv", "--memory", "1M"], &["conductances between 7", "--memory"]);
    assert!(fs::read_dir(folder.path()).unwrap().next().is_none());
}

#[test]
fn the_error_of_even_fluxes_is_told_where_memory_allows() {
    let folder = tempfile::tempdir().unwrap();
    // Step by step from what even order 0 does not fit into.
    let tell = |kilobytes: usize| {
        let memory = format!("{kilobytes}k");
        let output = radiosity(folder.path(), &["heat", "oven", "--order", "0", "--memory", &memory]);
        output.status.success().then(|| String::from_utf8(output.stderr).unwrap())
    };
    let told: Vec<String> = (10_000..14_000).step_by(160).filter_map(tell).collect();
    let is_warned = |told: &String| told.contains("no memory or no time to cut elements");
    assert!(told.len() < 25 && is_warned(&told[0]) && !is_warned(&told[told.len() - 1]), "{told:?}");
}

/// At 900 K all of the oven is at rest, and a panel that hardly emits tells no more.
#[test]
fn a_sweep_from_rest_is_checked_where_heat_flows() {
    let folder = tempfile::tempdir().unwrap();
    let few = ["heat", "oven", "--transport", "sampled", "--rays", "200", "--audit", "0.5", "--strict"];
    for sweep in ["panel.temperature=900..1400/2", "panel.emissivity=1e-6..0.9/2"] {
        let strict = radiosity(folder.path(), &[&few[..], &["--sweep", sweep]].concat());
        let told = String::from_utf8(strict.stderr).unwrap();
        assert_eq!(strict.status.code(), Some(3), "{sweep}: {told}");
        assert!(told.contains("path tracing finds more"), "{told}");
    }
}

#[test]
fn what_path_tracing_finds_is_told() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("plates.toml"), NEAR_PLATES).unwrap();
    // Whole plates are too wide for their gap.
    for order in ["0", "1", "3"] {
        let whole = ["plates.toml", "--subdivide", "1", "--order", order, "-o", "plates.json"];
        let [_, told] = heat(folder.path(), &whole);
        assert!(told.contains("checked at 2 surfaces by path tracing: off by"), "{told}");
        let json: Value =
            serde_json::from_slice(&fs::read(folder.path().join("plates.json")).unwrap()).unwrap();
        let body = &json["surfaces"][0];
        let ratio = number(&body["flow_error"]) / (number(&body["flow"]) - 44.34);
        assert!((0.5..2.0).contains(&ratio), "order {order}: {ratio} of the true error is told");
        assert!(number(&json["error_factor"]) >= 1.0 && number(&json["audit"]["readings"]) == 2.0);
        assert!(number(&json["error"]) > 3.0 * number(&json["error_sd"]), "{json}");
    }
    let even = ["heat", "plates.toml", "--subdivide", "1", "--order", "0", "--strict"];
    let strict = radiosity(folder.path(), &even);
    let told = String::from_utf8(strict.stderr).unwrap();
    assert_eq!(strict.status.code(), Some(3), "{told}");
    assert!(told.contains("path tracing finds more") && told.contains("\"body\""), "{told}");
    assert!(String::from_utf8(strict.stdout).unwrap().contains("48.37"), "what there is was written");
}

//! The command `heat`: its outputs, and what it refuses.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

fn heat(folder: &Path, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_radiosity"));
    command.current_dir(folder).arg("heat").args(args).output().expect("the binary runs")
}

#[track_caller]
fn done(output: &Output) -> (String, String) {
    let [out, told] = [&output.stdout, &output.stderr].map(|text| String::from_utf8(text.clone()).unwrap());
    assert!(output.status.success(), "{told}");
    (out, told)
}

#[track_caller]
fn refused(output: &Output, parts: &[&str]) {
    let told = String::from_utf8(output.stderr.clone()).unwrap();
    assert_eq!(output.status.code(), Some(2), "{told}");
    assert!(parts.iter().all(|part| told.contains(part)), "{told}");
}

#[test]
fn the_oven_is_in_balance_in_every_format() {
    let folder = tempfile::tempdir().unwrap();
    let (table, told) = done(&heat(folder.path(), &[]));
    assert!(table.starts_with("surface ") && table.contains("slab"), "{table}");
    assert!(told.contains("the scene is closed"), "{told}");
    let (csv, _) = done(&heat(folder.path(), &["oven", "--format", "csv", "-q"]));
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let flows: Vec<f64> = rows.iter().map(|row| row[6].parse().unwrap()).collect();
    let given: f64 = flows.iter().filter(|flow| **flow > 0.0).sum();
    assert!(flows.iter().sum::<f64>().abs() < 1e-4 * given, "{flows:?}");
    done(&heat(folder.path(), &["oven", "-o", "oven.json", "-q"]));
    let json: Value = serde_json::from_slice(&fs::read(folder.path().join("oven.json")).unwrap()).unwrap();
    let own = &json["surfaces"][6];
    assert_eq!((own["name"].as_str(), own["temperature"].as_f64()), (Some("slab"), Some(900.0)));
    assert_eq!(own["flow"].as_f64(), Some(flows[6]));
}

#[test]
fn conductances_of_a_surface_sum_to_what_it_emits() {
    let folder = tempfile::tempdir().unwrap();
    for file in ["C.csv", "C.json", "C.npy"] {
        done(&heat(folder.path(), &["oven", "--conductances", file, "-q"]));
    }
    let json: Value = serde_json::from_slice(&fs::read(folder.path().join("C.json")).unwrap()).unwrap();
    let rows = json["conductances"].as_array().unwrap();
    let number = |value: &Value| value.as_f64().unwrap();
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
    let (_, told) = done(&heat(folder.path(), &["oven", "--set", "heater=900", "--order", "1"]));
    assert!(told.contains("the scene is closed"), "{told}");
}

#[test]
fn a_picture_shows_temperatures_with_a_legend() {
    let folder = tempfile::tempdir().unwrap();
    let args = ["oven", "--picture", "oven.png", "--size", "64x48", "--range", "800,1500", "-q"];
    done(&heat(folder.path(), &args));
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
    let level = heat(
        folder.path(),
        &["oven", "--picture", "level.png", "--show", "exitance", "--size", "64x48", "-q"],
    );
    done(&level);
    assert_ne!(
        fs::read(folder.path().join("level.png")).unwrap(),
        fs::read(folder.path().join("oven.png")).unwrap()
    );
}

#[test]
fn wrong_use_is_refused_before_the_work() {
    let folder = tempfile::tempdir().unwrap();
    let run = |args: &[&str]| heat(folder.path(), args);
    refused(&run(&["cornell-box"]), &["neither a temperature nor a flux", "adiabatic = true"]);
    refused(&run(&["oven", "-o", "oven.xlsx"]), &["oven.xlsx", ".csv"]);
    refused(&run(&["oven", "--conductances", "C.txt"]), &["C.txt", ".npy"]);
    refused(&run(&["oven", "-o", "a.csv", "--conductances", "a.csv"]), &["a.csv"]);
    refused(&run(&["oven", "--shadows", "mask"]), &["masks"]);
    refused(&run(&["oven", "--set", "heater=-5"]), &["heater"]);
    refused(&run(&["oven", "--order", "21"]), &["21"]);
    refused(&run(&["oven", "-o", "x.png", "--format", "csv", "--picture", "x.png"]), &["x.png", "figures"]);
    refused(&run(&["oven", "--isolines"]), &["--isolines speaks of a picture", "--picture FILE.png"]);
    refused(&run(&["oven", "--picture", "a.jpg"]), &["a.jpg", ".png"]);
    refused(&run(&["oven", "--picture", "a.png", "--band", "grey"]), &["--band", "leave it out"]);
    assert!(fs::read_dir(folder.path()).unwrap().next().is_none());
}

//! The `probe` and `grid` verbs: tables out, clear refusals of bad points.

use radiosity_test_support::data::number;
use radiosity_test_support::folders::{folder, json, names};
use std::process::Output;

use crate::program::{self, fed};

/// Runs the binary in a folder with `points` in `points.csv` and on standard input.
fn radiosity(points: &str, args: &[&str]) -> (Output, Vec<String>) {
    let folder = folder(&[("points.csv", points)]);
    let output = fed(folder.path(), args, points);
    let mut files = names(folder.path());
    files.retain(|file| file != "points.csv");
    (output, files)
}

fn lines(output: &Output) -> Vec<Vec<String>> {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

#[track_caller]
fn assert_two(text: &str) {
    let value: f64 = text.parse().expect("a number");
    assert!((value - 2.0).abs() < 4e-3, "{value}");
}

const POINTS: &str = "0.5,0.5,0.5,0,0,3\n0.25,1,0,0,0,1\n";

/// Points in the furnace and on its floor, of which the last lies on an edge, where light is a limit: it is not judged.
const INSIDE: &str = "0.5,0.5,0.5,0,0,3\n0.25,0.5,0,0,0,1\n0.25,1,0,0,0,1\n";

#[test]
fn a_probe_prints_irradiance_and_what_is_on_a_surface() {
    for source in ["points.csv", "-"] {
        let (output, _) = radiosity(POINTS, &["probe", "furnace-cube", "--points", source]);
        let lines = lines(&output);
        assert_eq!(lines[0].join(","), "x,y,z,nx,ny,nz,E_grey,error,surface,u,v,B_grey");
        assert_eq!(lines[1][..6].join(","), "0.5,0.5,0.5,0,0,1");
        assert_two(&lines[1][6]);
        assert_eq!(lines[1][8..], ["", "", "", ""]);
        assert_eq!(lines[2][8], "floor");
        assert_eq!(lines[2][9..11], ["-0.5", "1"]);
        assert_two(&lines[2][6]);
        assert_two(&lines[2][11]);
    }
}

/// In the furnace all light is 2: what is told of each row covers what it is off by, and is not much more.
#[test]
fn the_error_of_each_row_is_told_and_the_run_is_checked_once() {
    let folder = folder(&[("points.csv", INSIDE)]);
    for args in [
        ["probe", "furnace-cube", "--points", "points.csv"].as_slice(),
        &["grid", "furnace-cube", "--cells", "4x4"],
    ] {
        let more = ["--format", "json", "-o", "table.json", "--report", "report.json"];
        let [_, told] = program::done(folder.path(), &[args, &more].concat());
        let [table, report] = ["table.json", "report.json"].map(|name| json(&folder.path().join(name)));
        let rows = table["points"].as_array().or(table["cells"].as_array()).expect("rows");
        for row in rows {
            let [light, error] = [number(&row["irradiance"][0]), number(&row["error"])];
            assert!((light - 2.0).abs() <= error && error < 0.02, "{row}");
        }
        let judged = if rows.len() == 3 { 2 } else { 64 };
        let line = format!("checked at {judged} readings by path tracing: no error above ");
        assert!(told.contains(&line), "{told}");
        assert_eq!(number(&report["audit"]["readings"]), judged as f64);
        assert!(number(&report["audit"]["rays"]) > 1e4 && number(&report["visible"]) < 0.02, "{report}");
        let keys = ["error", "error_sd", "own_error", "error_factor"].map(|key| number(&report[key]));
        assert!(keys[0] < 5e-3 && keys[2] < 5e-3 && (1.0..8.0).contains(&keys[3]), "{keys:?}");
    }
}

/// After three sweeps of Jacobi's iteration the furnace has 2 (1 − 2⁻⁴) = 1.875 of light, where 2 is right: the
/// run says so, names its walls, tells errors as large, and fails where it is strict, after all is written.
#[test]
fn wrong_light_is_told_with_its_places() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let early = ["--read", "basis", "--solver", "jacobi", "--tolerance", "0.2"];
    let grid = ["grid", "furnace-cube", "--cells", "2x2", "--report", "report.json", "-o", "table.csv"];
    let loose = [&grid[..], &early, &["--audit", "0.1"]].concat();
    let output = program::radiosity(folder, &[&loose[..], &["--strict"]].concat());
    let told = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(3), "{told}");
    let off = ["checked at 24 readings by path tracing: off by 6", "warning: the method tells an error of"];
    for part in
        [off[0], off[1], "\"floor\" by -6.", "wrote table.csv", "error: the light is off by more than"]
    {
        assert!(told.contains(part), "{part:?} is missing in:\n{told}");
    }
    let report = json(&folder.join("report.json"));
    assert_eq!(report["warnings"][0]["code"], "error-underestimated", "{report}");
    assert!((number(&report["error"]) - 0.0625).abs() < 0.005, "{report}");
    let table = std::fs::read_to_string(folder.join("table.csv")).expect("it was written");
    for line in table.lines().skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let [light, error] = [3, 5].map(|column: usize| fields[column].parse::<f64>().expect("a number"));
        assert!((light - 1.875).abs() < 1e-3 && (error - 0.125).abs() < 0.02, "{line}");
    }
    program::done(folder, &loose);
}

/// Light of another kind is not checked, and a check of it that is typed is refused.
#[test]
fn light_that_a_referee_does_not_know_is_not_checked() {
    let limits: [(&[&str], &str); 4] = [
        (&["--bounces", "2"], "--bounces 2"),
        (&["--shadows", "off"], "--shadows off"),
        (&["--shots", "3"], "--shots 3"),
        (&["--kernel", "paper-legendre"], "--kernel with the rules of 1993"),
    ];
    for (options, named) in limits {
        let args = [&["grid", "furnace-cube", "--cells", "1x1", "--report", "r.json"], options].concat();
        let folder = tempfile::tempdir().expect("a folder");
        let [_, told] = program::done(folder.path(), &args);
        assert!(!told.contains("checked at"), "{told}");
        assert!(json(&folder.path().join("r.json")).get("audit").is_none());
        let typed = [&args[..], &["--audit", "1"]].concat();
        program::refused(folder.path(), &typed, &[named, "--audit", "leave out"]);
    }
    let folder = tempfile::tempdir().expect("a folder");
    program::refused(folder.path(), &["audit", "furnace-cube", "--audit", "1"], &["--audit", "--seconds"]);
}

#[test]
fn tables_are_json_if_asked() {
    let (output, _) =
        radiosity(POINTS, &["probe", "furnace-cube", "--points", "points.csv", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(json["bands"][0], "grey");
    assert_eq!(json["points"][0]["surface"], serde_json::Value::Null);
    assert_eq!(json["points"][1]["surface"], "floor");
    assert_two(&json["points"][1]["radiosity"][0].to_string());
    let (output, _) = radiosity("", &["grid", "furnace-cube", "--cells", "2x3", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(json["cells"].as_array().map(Vec::len), Some(36));
    assert_two(&json["cells"][7]["irradiance"][0].to_string());
}

#[test]
fn grids_read_all_three_ways() {
    for read in ["basis", "direct", "gather"] {
        let (output, _) = radiosity("", &["grid", "furnace-cube", "--cells", "1x1", "--read", read]);
        let lines = lines(&output);
        assert_eq!(lines[0].join(","), "surface,i,j,E_grey,B_grey,error,area,x,y,z");
        lines[1..].iter().for_each(|line| assert_two(&line[3]));
    }
}

#[track_caller]
fn assert_refused(points: &str, more: &[&str], parts: &[&str]) {
    let args = ["probe", "furnace-cube", "--points", "points.csv", "-o", "out.csv"];
    let (output, files) = radiosity(points, &[&args, more].concat());
    program::assert_refused(&output, parts);
    assert!(files.is_empty(), "{files:?} were written");
}

#[test]
fn bad_points_are_refused_with_line_column_and_cure() {
    assert_refused("0,0,0,0,0,1\n0,0,0,x,0,1\n", &[], &["points.csv:2: column 4 (nx)", "'x'", "help: "]);
    assert_refused("0,0,0,0,0,0\n", &[], &["points.csv:1: ", "normal is zero", "help: "]);
    assert_refused("0,0,0,0,0,1,7\n", &[], &["points.csv:1: ", "7 columns instead of 6", "help: "]);
    assert_refused("\n", &[], &["points.csv: ", "no points", "help: "]);
    let free = "0.5,0.5,0,0,0,1\n0.5,0.5,0.5,0,0,1\n";
    for read in ["basis", "direct"] {
        assert_refused(free, &["--read", read], &["points.csv:2: ", "on no surface", "--read gather"]);
    }
    let tilted = "0.5,0.5,0,0,1,1\n";
    assert_refused(
        tilted,
        &["--read", "basis"],
        &["points.csv:1: ", "not that of the surface", "--read gather"],
    );
}

#[test]
fn scene_and_points_cannot_share_standard_input() {
    let (output, _) = radiosity(POINTS, &["probe", "-", "--points", "-"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("both"));
}

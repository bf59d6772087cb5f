//! The `probe` and `grid` verbs: tables out, clear refusals of bad points.

use radiosity_test_support::folders::{folder, names};
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

#[test]
fn a_probe_prints_irradiance_and_what_is_on_a_surface() {
    for source in ["points.csv", "-"] {
        let (output, _) = radiosity(POINTS, &["probe", "furnace-cube", "--points", source]);
        let lines = lines(&output);
        assert_eq!(lines[0].join(","), "x,y,z,nx,ny,nz,E_grey,surface,u,v,B_grey");
        assert_eq!(lines[1][..6].join(","), "0.5,0.5,0.5,0,0,1");
        assert_two(&lines[1][6]);
        assert_eq!(lines[1][7..], ["", "", "", ""]);
        assert_eq!(lines[2][7], "floor");
        assert_eq!(lines[2][8..10], ["-0.5", "1"]);
        assert_two(&lines[2][6]);
        assert_two(&lines[2][10]);
    }
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
        assert_eq!(lines[0].join(","), "surface,i,j,E_grey,B_grey,area,x,y,z");
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

//! Runs whose time is limited: they end with the best so far, and say what they left out.

use std::path::Path;

use crate::program::done;

/// The summary of a run that succeeds.
fn told(here: &Path, args: &[&str]) -> String {
    let [_, told] = done(here, args);
    told
}

#[test]
fn readings_end_in_time_and_tell_their_error() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let grid = |more: &[&str]| {
        told(here, &[&["grid", "cornell-box", "--cells", "2x2", "-o", "cells.csv"], more].concat())
    };
    let hurried = grid(&["--read-by", "rays", "--read-eps", "1e-3", "--time-limit", "1e-3"]);
    assert!(hurried.contains("time was up before all was read as accurately as asked for"), "{hurried}");
    assert!(hurried.contains("allow more with --time-limit"), "{hurried}");
    let unhurried = grid(&["--time-limit", "1000"]);
    assert!(!unhurried.contains("time was"), "{unhurried}");
}

#[test]
fn pictures_take_what_is_done_in_time() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let render = |seconds: &str| {
        told(here, &["render", "cornell-box", "--size", "16x16", "-o", "p.png", "--time-limit", seconds])
    };
    let hurried = render("1e-3");
    assert!(hurried.contains("time was short: light as polynomials"), "{hurried}");
    assert!(!render("1000").contains("time was"));
}

/// The carrier of the light is chosen by the time that is left.
#[test]
fn exact_blocks_that_take_too_long_give_way_to_rays() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let solve = |more: &[&str]| told(here, &[&["solve", "cornell-box", "-o", "box.json"], more].concat());
    assert!(solve(&["--time-limit", "1000"]).contains("kernel samples"));
    assert!(solve(&["--time-limit", "0.1"]).contains("rays leave an error of"));
}

/// A cathedral takes a referee, and the readings that it judges, far longer than this: they end with the run.
#[test]
fn a_check_takes_what_is_left_of_the_time() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let solve = |seconds: &str| {
        let files = ["-o", "c.json", "--report", "r.json"];
        let told = told(here, &[&["solve", "cathedral", "--time-limit", seconds], &files[..]].concat());
        let report: serde_json::Value =
            serde_json::from_slice(&std::fs::read(here.join("r.json")).unwrap()).unwrap();
        (told, report["seconds"]["referee"].as_f64().unwrap_or(0.0))
    };
    let (told, referee) = solve("2");
    assert!(referee < 2.0, "{told}");
    let (told, referee) = solve("1e-3");
    assert!(told.contains("not checked by path tracing: time was up"), "{told}");
    assert!(referee < 0.1, "{told}");
}

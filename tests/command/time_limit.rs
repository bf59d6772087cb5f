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

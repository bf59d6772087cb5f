//! Methods of the papers, by their options.

use radiosity::Options;
use radiosity::published::zatz1993::transfers::{HybridReading, PaperRules};
use radiosity_test_support::scenes::builtin;
use radiosity_test_support::solved::outcome_of;

use crate::program::{done, refused};

/// A solution that was read back shows the same bytes.
#[test]
fn masks_come_back_from_a_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = |args: &[&str]| done(folder.path(), args)[0].clone();
    let masks = ["--shadows", "mask", "--mask-cells", "10", "--order", "2"];
    let read = ["--read", "basis", "--cells", "4x4"];
    run(&[&["solve", "occluder-box", "-o", "saved.json"][..], &masks].concat());
    let direct = run(&[&["grid", "occluder-box"][..], &masks, &read].concat());
    let saved = run(&[&["grid", "saved.json"][..], &read].concat());
    assert_eq!(direct, saved);
}

#[test]
fn kernels_of_1993_know_total_degrees_only() {
    let folder = tempfile::tempdir().expect("a folder");
    let args = ["grid", "cornell-box", "--kernel", "paper-hybrid", "--tensor"];
    refused(folder.path(), &args, &["--kernel", "--tensor", "leave one of them out"]);
}

#[test]
fn collocation_knows_no_rays_and_no_estimates() {
    let folder = tempfile::tempdir().expect("a folder");
    let others = ["--accuracy=1e-2", "--rays=1000", "--kernel=paper-hybrid", "--basis=linear"];
    for other in others {
        let args = ["grid", "empty-box", "--method", "collocation", other];
        let name = &other[..other.find('=').expect("a value")];
        refused(folder.path(), &args, &["collocation", name, "leave one of them out"]);
    }
}

#[test]
fn kernels_are_the_rules_and_readings_that_their_names_say() {
    let folder = tempfile::tempdir().expect("a folder");
    let args = ["grid", "empty-box", "--cells", "1x1", "--read", "basis", "--order", "4", "--kernel"];
    let scene = builtin("empty-box");
    let rules = [
        ("default", None),
        ("paper-legendre", Some(PaperRules::Legendre)),
        ("paper-hybrid", Some(PaperRules::Hybrid(HybridReading::H1))),
        ("paper-hybrid-h2", Some(PaperRules::Hybrid(HybridReading::H2))),
        ("paper-hybrid-h3", Some(PaperRules::Hybrid(HybridReading::H3))),
        ("paper-printed", Some(PaperRules::Hybrid(HybridReading::Literal))),
    ];
    for (name, kernel) in rules {
        let outcome = outcome_of(&scene, &Options { order: 4, kernel, ..Options::default() });
        // The mean irradiance of the floor, the first row.
        let mean = outcome.solution.bands()[0].coefficients.irradiance[0];
        let [table, _] = done(folder.path(), &[&args[..], &[name]].concat());
        let floor = table.lines().find(|line| line.starts_with("floor")).expect("the floor has a row");
        let printed: f64 = floor.split(',').nth(3).expect("four columns").parse().expect("a number");
        assert!((printed - mean).abs() < 1e-9, "{name}: {printed} {mean}");
    }
}

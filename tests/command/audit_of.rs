//! `audit --of heat` and `--of view-factors`: what is right, what is wrong, and what is refused.

use std::path::Path;

use radiosity_test_support::data::number;
use radiosity_test_support::folders::{folder, json};
use serde_json::Value;

use crate::program::{self, radiosity};

/// The Stefan–Boltzmann constant (W m⁻² K⁻⁴).
const SIGMA: f64 = 5.670_374_419e-8;

/// View factors of a cube: between walls that face each other, and between neighbours. From Howell's catalogue, C-11
/// and C-14 at equal sides.
const FACING: f64 = 0.199_824_895_698_387_46;
const BESIDE: f64 = 0.200_043_776_075_403_16;

/// A cube of black walls at 300 K over a floor at 600 K.
const CUBE: &str = "
    [materials]
    wall = { emissivity = 1, temperature = 300 }
    floor = { emissivity = 1, temperature = 600 }
    [[surfaces]]
    name = \"room\"
    material = \"wall\"
    box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true, open = [\"bottom\"] }
    [[surfaces]]
    name = \"floor\"
    material = \"floor\"
    quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }";

/// A block at 300 K in the middle of the cube, which hides much of the ceiling from the floor.
const BLOCK: &str = "
    [[surfaces]]
    name = \"block\"
    material = \"wall\"
    box = { origin = [0.2, 0.2, 0.4], size = [0.6, 0.6, 0.2] }";

/// A thin sheet in the middle of the cube, both sides of one temperature that is unknown.
const SHEET: &str = "
    [materials.foil]
    emissivity = 0.1
    adiabatic = true
    [[surfaces]]
    name = \"sheet\"
    material = \"foil\"
    two_sided = true
    quad = { vertices = [[0.3,0.3,0.5],[0.7,0.3,0.5],[0.7,0.7,0.5],[0.3,0.7,0.5]] }";

/// The document of a strict audit that succeeds.
#[track_caller]
fn judged(folder: &Path, scene: &str, of: &str) -> Value {
    let args = ["audit", scene, "--of", of, "--strict", "--seconds", "0.5", "-o", "audit.json"];
    let [_, told] = program::done(folder, &args);
    assert!(told.contains(" by path tracing: ") && told.contains("wrote audit.json"), "{told}");
    let document = json(&folder.join("audit.json"));
    assert_eq!(document["finds_more"], false, "{document}");
    document
}

fn points(document: &Value) -> &[Value] {
    document["points"].as_array().expect("it is a list")
}

/// Black walls exchange F σ (T⁴ − T₀⁴): printed and found.
#[test]
fn flows_in_a_black_cube_are_right() {
    let folder = folder(&[("cube.toml", CUBE)]);
    let document = judged(folder.path(), "cube.toml", "heat");
    let full = SIGMA * (600f64.powi(4) - 300f64.powi(4));
    assert_eq!(points(&document).len(), 6);
    for point in points(&document) {
        let exact = match point["surface"].as_str().expect("a name") {
            "floor" => full,
            "room-top" => -FACING * full,
            _ => -BESIDE * full,
        };
        let [printed, found, s, difference] =
            ["printed", "found", "s", "difference"].map(|key| number(&point[key]));
        assert_eq!(point["what"], "flow W");
        assert!((printed - exact).abs() < 1e-3 * exact.abs(), "{point}");
        assert!((found - exact).abs() < 6.0 * s + 1e-9 * full, "{point}");
        assert!((difference - (printed - found) / found.abs()).abs() < 1e-9, "{point}");
    }
}

/// The oven sends back by its bricks what they receive: their temperatures are judged, flows of panel and slab.
#[test]
fn the_oven_is_right() {
    let folder = tempfile::tempdir().unwrap();
    let document = judged(folder.path(), "oven", "heat");
    assert_eq!(points(&document).len(), 7);
    for point in points(&document) {
        let is_known = point["surface"] == "panel" || point["surface"] == "slab";
        assert_eq!(point["what"], if is_known { "flow W" } else { "temperature K" });
        let [printed, told, found, s] = ["printed", "told", "found", "s"].map(|key| number(&point[key]));
        assert!((printed - found).abs() < 2.0 * told + 6.0 * s, "{point}");
    }
}

/// Both sides of a sheet have one temperature, which is judged once.
#[test]
fn sheets_are_judged_once() {
    let folder = folder(&[("cube.toml", &format!("{CUBE}{SHEET}"))]);
    let document = judged(folder.path(), "cube.toml", "heat");
    assert_eq!(points(&document).len(), 7);
    let sheets = points(&document).iter().filter(|point| point["what"] == "temperature K");
    let sheets: Vec<f64> = sheets.map(|point| number(&point["found"])).collect();
    assert_eq!(sheets.len(), 1);
    // The level of a black body that sees the floor with half of its area or less, and walls else.
    let most = (0.5 * (600f64.powi(4) + 300f64.powi(4))).powf(0.25);
    assert!((300.0..most).contains(&sheets[0]), "{sheets:?}");
}

/// All of one temperature: nothing flows, and rounding is nothing that is found.
#[test]
fn where_nothing_flows_nothing_is_found() {
    let folder = folder(&[("cube.toml", &CUBE.replace("600", "300"))]);
    judged(folder.path(), "cube.toml", "heat");
}

/// Factors of the cube: printed and found.
#[test]
fn factors_of_a_cube_are_right() {
    let folder = folder(&[("cube.toml", CUBE)]);
    let document = judged(folder.path(), "cube.toml", "view-factors");
    assert_eq!(points(&document).len(), 6 * 5);
    let opposite = [["room-top", "floor"], ["room-left", "room-right"], ["room-front", "room-back"]];
    for point in points(&document) {
        let names = ["from", "to"].map(|key| point[key].as_str().expect("a name"));
        let faces = opposite.iter().any(|own| *own == names || [own[1], own[0]] == names);
        let exact = if faces { FACING } else { BESIDE };
        let [printed, found, s] = ["printed", "found", "s"].map(|key| number(&point[key]));
        assert!((printed - exact).abs() < 1e-3 * exact, "{point}");
        assert!((found - exact).abs() < 6.0 * s, "{point}");
    }
    assert!(number(&document["rays"]) > 6.0 * 1e4);
}

/// Without shadows the ceiling sees the floor through the block: a strict run ends with 3 and says where.
#[test]
fn blocks_that_are_left_out_are_found() {
    let folder = folder(&[("cube.toml", &format!("{CUBE}{BLOCK}"))]);
    for (of, parts) in [
        ("heat", ["surfaces by path tracing: off by ", "\"room-top\" by -", "the heat is off by more than"]),
        (
            "view-factors",
            ["view factors by path tracing: off by ", "room-top", "the view factors are off by more"],
        ),
    ] {
        judged(folder.path(), "cube.toml", of);
        let args = ["audit", "cube.toml", "--of", of, "--shadows", "off", "--seconds", "0.3", "--strict"];
        let output = radiosity(folder.path(), &args);
        let [text, told] =
            [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).expect("text"));
        assert_eq!(output.status.code(), Some(3), "{told}");
        assert!(text.contains("\nmore than the run tells, ") && text.contains("stands out"), "{text}");
        parts
            .iter()
            .for_each(|part| assert!(format!("{text}{told}").contains(part), "{part:?}: {text}{told}"));
    }
}

/// `audit` tells the own estimates that the check beside a run tells, of the same numbers over what is found.
#[test]
fn own_errors_are_those_of_the_check_beside_a_run() {
    let folder = folder(&[("cube.toml", &format!("{CUBE}{BLOCK}"))]);
    for (verb, of) in [("heat", "heat"), ("view-factors", "view-factors")] {
        let args = [verb, "cube.toml", "--audit", "0.5", "--format", "json", "-o", "run.json"];
        program::done(folder.path(), &args);
        let own = number(&json(&folder.path().join("run.json"))["own_error"]);
        let told = number(&judged(folder.path(), "cube.toml", of)["told"]);
        assert!(
            own > 0.0 && (told / own - 1.0).abs() < 0.02,
            "{of}: {told} told by the audit, {own} beside the run"
        );
    }
}

/// Fewer readings than surfaces: so many are judged, others with another seed.
#[test]
fn some_of_the_surfaces_are_chosen() {
    let folder = folder(&[("cube.toml", CUBE)]);
    let names = |seed: &str| {
        let args =
            ["audit", "cube.toml", "--of", "heat", "--readings", "2", "--seconds", "0.1", "--seed", seed];
        let [table, told] = program::done(folder.path(), &[&args[..], &["--format", "csv"]].concat());
        assert!(told.contains("checked at 2 surfaces by path tracing: "), "{told}");
        let mut lines = table.lines();
        assert_eq!(lines.next(), Some("surface,what,printed,told,found,s,difference,in_s"));
        lines.map(|line| line.split(',').next().unwrap_or_default().to_owned()).collect::<Vec<_>>()
    };
    let first = names("0");
    assert_eq!((first.len(), names("0") == first), (2, true));
    assert!((1..6).any(|seed| names(&seed.to_string()) != first), "{first:?}");
}

#[test]
fn wrong_inputs_are_refused() {
    let quad = "name,x,y,z\na,0,0,0\na,1,0,0\na,0,1,0\n";
    let folder = folder(&[("cube.toml", CUBE), ("one.csv", quad)]);
    program::done(folder.path(), &["solve", "empty-box", "--order", "0", "-o", "box.solution.json"]);
    let refused =
        |args: &[&str], parts: &[&str]| program::refused(folder.path(), &[&["audit"], args].concat(), parts);
    refused(&["cube.toml"], &["cube.toml: nothing emits light, but temperatures", "add --of heat"]);
    refused(&["cube.toml", "--of", "sound"], &["sound", "view-factors"]);
    let idle: [&[&str]; 7] = [
        &["--picture", "where.png"],
        &["--read", "basis"],
        &["--method", "collocation"],
        &["--quality", "fine"],
        &["--bounces", "1"],
        &["--report", "report.json"],
        &["--time-limit", "3"],
    ];
    for option in idle {
        for of in ["heat", "view-factors"] {
            let parts = [&format!("{} does nothing with --of {of}", option[0]), "leave it out"];
            refused(&[&["cube.toml", "--of", of], option].concat(), &parts);
        }
    }
    let heat_only = ["cube.toml", "--of", "view-factors", "--order", "2"];
    refused(&heat_only, &["--order does nothing with --of view-factors"]);
    refused(&["cube.toml", "--of", "heat", "--order", "auto"], &["--order auto", "take a degree"]);
    refused(&["cube.toml", "--of", "heat", "--shadows", "mask"], &["--shadows mask", "leave --shadows out"]);
    refused(&["box.solution.json", "--of", "heat"], &["this is a solution already"]);
    refused(&["empty-box", "--of", "heat"], &["neither a temperature nor a flux", "temperature = "]);
    refused(&["one.csv", "--of", "view-factors"], &["no view factor is large enough", "--readings"]);
}

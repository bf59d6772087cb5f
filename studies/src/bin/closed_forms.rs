//! View factors that have closed forms: relative error and CPU time against the accuracy that is asked.
//!
//! The rows are handed-over factors (`tests/data/view_factors.json`; the coaxial cylinders of
//! `../shared/scenes/view_factors_coaxial.json`, where that is), and rooms whose factors follow from that of
//! two coaxial discs (Howell, C-41) and from what is left in a closed room: cans, frusta, domes and pipes. A
//! case is left once a run takes longer than a limit.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::error::Error;
use std::f64::consts::PI;
use std::fs;

use cpu_time::ProcessTime;
use radiosity::kernel::Accuracy;
use radiosity::scene::Source;
use radiosity::solve::view_factors::Options;
use radiosity::{ViewFactors, Work, language};
use radiosity_test_support::data::{list, number, path, table};
use serde_json::{Value, json};

const ASKED: [f64; 5] = [1e-2, 1e-3, 1e-6, 1e-9, 1e-10];

/// Seconds of CPU after which a case is asked for no more.
const LONGEST: f64 = 5.0;

/// Multiple of what is asked, and of what is told, that an error may reach.
const ALLOWED: f64 = 3.0;

/// Relative rounding of the exact values.
const EXACT_TO: f64 = 3e-15;

/// A scene with some of its factors.
struct Case {
    name: String,
    /// A scene file.
    scene: Value,
    factors: Vec<Factor>,
    /// Whether its surfaces see each other freely: nothing stands between them, and none ends another's
    /// sight.
    is_free: bool,
}

#[derive(Clone, Copy)]
struct Factor {
    from: usize,
    to: usize,
    exact: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let coaxial = coaxial_cylinders()?;
    if coaxial.is_none() {
        println!(
            "Without the coaxial cylinders of ../shared/scenes/view_factors_coaxial.json, which is not there.\n"
        );
    }
    let cases: Vec<Case> =
        handed_over().into_iter().chain(rooms()).chain(coaxial.unwrap_or_default()).collect();
    let count: usize = cases.iter().map(|case| case.factors.len()).sum();
    println!(
        "{count} factors; the worst relative error of each scene and the seconds of CPU, by what is asked.\n"
    );
    for (title, is_free) in [("sees freely", true), ("does not see freely", false)] {
        let asked: Vec<String> = ASKED.iter().map(|eps| format!("{eps:.0e}")).collect();
        println!("| {title} | {} |\n| --- | {} |", asked.join(" | "), ["---"; ASKED.len()].join(" | "));
        for case in cases.iter().filter(|case| case.is_free == is_free) {
            println!("| {} | {} |", case.name, row(case)?.join(" | "));
        }
        println!();
    }
    println!(
        "Bold: more than {ALLOWED} times what is asked, or by rays; †: more than {ALLOWED} times what is told; –: the \
         run before took longer than {LONGEST} s."
    );
    Ok(())
}

/// Error and time of a case for all that is asked.
fn row(case: &Case) -> Result<Vec<String>, Box<dyn Error>> {
    let scene = language::read(&Source::new("scene.json", &case.scene.to_string()))?;
    let mut is_slow = false;
    let mut cells = Vec::new();
    for eps in ASKED {
        if is_slow {
            cells.push("–".to_owned());
            continue;
        }
        let accuracy = Accuracy { eps, shadow_eps: eps };
        let options = Options { accuracy, threads: 1, ..Options::default() };
        let wanted = |i: usize, j: usize| {
            case.factors.iter().any(|factor| [(i, j), (j, i)].contains(&(factor.from, factor.to)))
        };
        let start = ProcessTime::now();
        let found = ViewFactors::of_pairs(&scene, &wanted, &options, &Work::alone())?;
        let seconds = start.elapsed().as_secs_f64();
        let off = |Factor { from, to, exact }: &Factor| (found.factor(*from, *to) / exact - 1.0).abs();
        let error = case.factors.iter().map(off).fold(0.0, f64::max);
        let misses = error > ALLOWED * eps + EXACT_TO || found.rays > 0;
        let mark = if misses { "**" } else { "" };
        let is_beyond_told =
            |factor: &Factor| off(factor) > ALLOWED * found.errors[factor.from] / factor.exact + EXACT_TO;
        let beyond = if case.factors.iter().any(is_beyond_told) { "†" } else { "" };
        cells.push(format!("{mark}{error:.1e}{mark}{beyond} in {seconds:.2}"));
        is_slow = seconds > LONGEST;
    }
    Ok(cells)
}

/// The scenes of the data.
fn handed_over() -> Vec<Case> {
    let case = |scene: &Value| {
        let rows = list(&scene["factors"]);
        let index = |value: &Value| number(value) as usize;
        let factor =
            |row: &Value| Factor { from: index(&row[1]), to: index(&row[2]), exact: number(&row[3]) };
        let name = rows[0][0].as_str().expect("a name").to_owned();
        let is_free = !name.starts_with("concentric") && !name.starts_with("sphere_to");
        let surfaces = scene["surfaces"].clone();
        Case {
            name,
            scene: json!({ "surfaces": surfaces }),
            factors: rows.iter().map(factor).collect(),
            is_free,
        }
    };
    list(&table("view_factors.json")["scenes"]).iter().map(case).collect()
}

/// The coaxial cylinders that were handed over, where they are.
fn coaxial_cylinders() -> Result<Option<Vec<Case>>, Box<dyn Error>> {
    let file = path("../shared/scenes/view_factors_coaxial.json");
    if !file.exists() {
        return Ok(None);
    }
    let data: Value = serde_json::from_str(&fs::read_to_string(file)?)?;
    let surface = |given: &Value| match given["type"].as_str() {
        Some("cylinder_lateral") => json!({
            "flip": given["side"] == "inside",
            "cylinder": {
                "base": given["base_center"], "axis": [0, 0, given["height"]], "radius": given["radius"],
            },
        }),
        _ => json!({ "disk": {
            "center": given["center"], "normal": given["normal"], "radius": given["radius"],
            "inner_radius": given["inner_radius"],
        } }),
    };
    let case = |given: &Value| {
        let mut shapes = vec![&given["surface1"]];
        let is_own = given["surface1"] == given["surface2"];
        shapes.extend((!is_own).then_some(&given["surface2"]));
        let ends = [&given["surface1"], &given["surface2"]];
        shapes.extend(list(&given["occluders"]).iter().filter(|shape| !ends.contains(shape)));
        let surfaces: Vec<Value> = shapes.into_iter().map(surface).collect();
        Case {
            name: given["id"].as_str().expect("a name").to_owned(),
            scene: json!({ "surfaces": surfaces }),
            factors: vec![Factor { from: 0, to: usize::from(!is_own), exact: number(&given["F12"]) }],
            is_free: false,
        }
    };
    Ok(Some(list(&data["cases"]).iter().map(case).collect()))
}

/// Cans, frusta, domes and pipes.
fn rooms() -> Vec<Case> {
    let frusta = [
        [1.0, 1.0, 2.0],
        [1.0, 1.0, 0.2],
        [1.0, 1.0, 10.0],
        [1.0, 0.5, 2.0],
        [1.0, 0.5, 0.5],
        [1.0, 0.05, 1.0],
        [1.0, 2.0, 0.1],
    ];
    let mut cases: Vec<Case> = frusta.into_iter().map(frustum).collect();
    cases.extend([0.5, 0.9, -0.5, -0.9].map(dome));
    cases.extend([2.0, 20.0].map(pipe));
    cases
}

/// F between two coaxial discs.
fn coaxial([from, to]: [f64; 2], distance: f64) -> f64 {
    let [a, b] = [from, to].map(|radius| radius / distance);
    let s = 1.0 + (1.0 + b * b) / (a * a);
    let four = 4.0 * (to / from).powi(2);
    0.5 * four / (s + (s * s - four).sqrt())
}

fn disk(height: f64, radius: f64, side: f64) -> Value {
    json!({ "disk": { "center": [0, 0, height], "normal": [0, 0, side], "radius": radius } })
}

/// A frustum of these radii and this height: bottom, lid and wall.
fn frustum([below, above, height]: [f64; 3]) -> Case {
    let wall = match below == above {
        true => {
            json!({ "flip": true, "cylinder": { "base": [0, 0, 0], "axis": [0, 0, height], "radius": below } })
        }
        false => json!({ "flip": true, "cone": {
            "base": [0, 0, 0], "axis": [0, 0, height], "radius1": below, "radius2": above,
        } }),
    };
    let surfaces = [disk(0.0, below, 1.0), disk(height, above, -1.0), wall];
    let areas = [PI * below * below, PI * above * above, PI * (below + above) * height.hypot(above - below)];
    let up = coaxial([below, above], height);
    let down = up * areas[0] / areas[1];
    let back = [areas[0] * (1.0 - up) / areas[2], areas[1] * (1.0 - down) / areas[2]];
    let factor = |from, to, exact| Factor { from, to, exact };
    let factors = vec![
        factor(0, 1, up),
        factor(0, 2, 1.0 - up),
        factor(1, 2, 1.0 - down),
        factor(2, 0, back[0]),
        factor(2, 2, 1.0 - back[0] - back[1]),
    ];
    let name = format!("frustum of radii {below} and {above}, height {height}");
    Case { name, scene: json!({ "surfaces": surfaces }), factors, is_free: true }
}

/// The part of a unit ball over the height `low`, and its floor.
fn dome(low: f64) -> Case {
    let radius = (1.0 - low * low).sqrt();
    let cap = json!({ "flip": true, "sphere": {
        "center": [0, 0, 0], "radius": 1, "axis": [0, 0, 1], "z": [low, 1],
    } });
    let to_floor = 0.5 * (1.0 + low);
    let factors = vec![
        Factor { from: 0, to: 1, exact: 1.0 },
        Factor { from: 1, to: 0, exact: to_floor },
        Factor { from: 1, to: 1, exact: 1.0 - to_floor },
    ];
    let surfaces = [disk(low, radius, 1.0), cap];
    Case { name: format!("dome over {low}"), scene: json!({ "surfaces": surfaces }), factors, is_free: true }
}

/// A pipe of radius 1, open at both ends.
fn pipe(length: f64) -> Case {
    let wall =
        json!({ "flip": true, "cylinder": { "base": [0, 0, 0], "axis": [0, 0, length], "radius": 1 } });
    let exact = 1.0 - (1.0 - coaxial([1.0; 2], length)) / length;
    let factors = vec![Factor { from: 0, to: 0, exact }];
    Case {
        name: format!("pipe of length {length}"),
        scene: json!({ "surfaces": [wall] }),
        factors,
        is_free: true,
    }
}

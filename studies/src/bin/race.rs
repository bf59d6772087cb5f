//! Error against time of irradiance, beside a path tracer: the table of `studies/mitsuba/race.py`.
//!
//! `cargo run --release -p radiosity-studies --bin race -- FILE.csv FILE.svg`
//!
//! Prints our runs with the times that the others take to the errors of these, over ours: on the line between
//! their runs in the logarithms of both. Draws a panel for each scene.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::error::Error;
use std::{env, fs};

use radiosity::output::drawings::diagram::{COLOURS, Curve, Diagram, Dot, Panel, Spacing};
use serde::Deserialize;

/// The program that the others race against.
const OURS: &str = "radiosity";

/// Panels beside each other.
const COLUMNS: usize = 3;

/// One run.
#[derive(Clone, Debug, Deserialize)]
struct Run {
    scene: String,
    program: String,
    setting: String,
    /// Time on a wall clock (s).
    seconds: f64,
    /// L2, relative.
    error: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let files: Vec<String> = env::args().skip(1).collect();
    let [table, drawing] = files.as_slice() else { return Err("name the table and the drawing".into()) };
    let runs: Vec<Run> = csv::Reader::from_path(table)?.deserialize().collect::<Result<_, _>>()?;
    let scenes = distinct(&runs, |own| &own.scene);
    let others: Vec<&str> =
        distinct(&runs, |own| &own.program).into_iter().filter(|own| *own != OURS).collect();
    println!("| scene | | error, % | s | {} |", others.join(", times | ") + ", times");
    println!("| --- | --- | --- | ---: |{}", " ---: |".repeat(others.len()));
    for own in runs.iter().filter(|own| own.program == OURS) {
        let times = others.iter().map(|other| {
            let theirs = seconds(&curve(&runs, &own.scene, other), own.error);
            theirs.map_or("–".to_owned(), |theirs| format!("{:.1}", theirs / own.seconds))
        });
        let times: Vec<String> = times.collect();
        let (error, seconds) = (100.0 * own.error, own.seconds);
        println!("| {} | {} | {error:.2} | {seconds:.2} | {} |", own.scene, own.setting, times.join(" | "));
    }
    let panels = scenes.iter().map(|scene| panel(&runs, scene)).collect();
    let title = "error against time".to_owned();
    let caption = "relative L2; two threads".to_owned();
    let diagram = Diagram { title, caption, columns: COLUMNS.min(scenes.len()), panels };
    Ok(fs::write(drawing, diagram.drawing().svg())?)
}

/// The different texts of runs, in order of their first.
fn distinct(runs: &[Run], of: fn(&Run) -> &String) -> Vec<&str> {
    let mut found: Vec<&str> = Vec::new();
    for run in runs {
        let own = of(run).as_str();
        if !found.contains(&own) {
            found.push(own);
        }
    }
    found
}

/// Runs of a program in a scene, the fastest first.
fn curve(runs: &[Run], scene: &str, program: &str) -> Vec<Run> {
    let is_own = |own: &&Run| own.scene == scene && own.program == program && own.error > 0.0;
    let mut own: Vec<Run> = runs.iter().filter(is_own).cloned().collect();
    own.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
    own
}

/// Time at which a curve has this error: between two runs, or beyond the last one, as 1/√t there.
fn seconds(curve: &[Run], error: f64) -> Option<f64> {
    let between = curve.windows(2).find(|pair| pair[0].error >= error && error >= pair[1].error);
    match (between, curve.last()) {
        (Some([a, b]), _) => {
            let part = (a.error / error).ln() / (a.error / b.error).ln().max(f64::MIN_POSITIVE);
            Some(a.seconds * (b.seconds / a.seconds).powf(part))
        }
        (None, Some(last)) if last.error > error => Some(last.seconds * (last.error / error).powi(2)),
        _ => None,
    }
}

fn panel(runs: &[Run], scene: &str) -> Panel {
    let dot = |own: &Run| Dot { place: [own.seconds, own.error], text: String::new() };
    let line = |(k, program): (usize, &&str)| Curve {
        label: (*program).to_owned(),
        colour: COLOURS[k % COLOURS.len()],
        dots: curve(runs, scene, program).iter().map(dot).collect(),
        others: Vec::new(),
    };
    Panel {
        title: scene.to_owned(),
        axes: ["seconds".to_owned(), "relative error".to_owned()],
        along: Spacing::Logarithmic,
        curves: distinct(runs, |own| &own.program).iter().enumerate().map(line).collect(),
    }
}

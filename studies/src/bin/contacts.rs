//! Curved surfaces that touch others, or nearly do: errors against evaluations, as more is asked.
//!
//! `cargo run --release -p radiosity-studies --bin contacts > contacts.md`
//!
//! Draws the errors, with those that are told beside them, in docs/contacts.svg. The right values: a ball
//! sends to a polygon before which it lies as much as its centre does, Ω/(4π); all that leaves a convex body
//! in a closed room arrives; long pipes side by side exchange ½ − 1/π less what their ends lose (Hottel's
//! strings); coaxial disks have a closed form (Howell, C-41).

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::error::Error;
use std::f64::consts::PI;
use std::fs;

use cpu_time::ProcessTime;
use radiosity::kernel::Accuracy;
use radiosity::output::drawings::diagram::{COLOURS, Curve, Diagram, Dot, Panel, Spacing};
use radiosity::scene::Source;
use radiosity::solve::Transport;
use radiosity::solve::view_factors::Options;
use radiosity::{Scene, ViewFactors, Work, language};
use serde_json::{Value, json};

const ASKED: [f64; 9] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];

/// Errors below this are drawn as this, relative: rounding.
const LEAST: f64 = 1e-15;

/// Panels beside each other.
const COLUMNS: usize = 3;

/// A number of view factors whose value is known.
#[derive(Clone, Copy, Debug)]
enum Reading {
    /// From the second surface to the first.
    Factor,
    /// The sum of the last row.
    Sum,
}

/// Scenes with a sum over readings of them whose value is known.
struct Case {
    name: &'static str,
    reading: Reading,
    /// The factor of each scene in the sum.
    scenes: Vec<(f64, Value)>,
    right: f64,
}

/// A sum by rules.
struct Run {
    eps: f64,
    /// Relative errors.
    off: f64,
    told: f64,
    /// Evaluations of the kernel.
    samples: u64,
    /// Processor time (s).
    seconds: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| contact | asked | off | told | evaluations | CPU s |\n| --- | --- | --- | --- | ---: | ---: |"
    );
    let mut panels = Vec::new();
    for case in cases() {
        let runs: Vec<Run> = case.reading.accuracies().map(|eps| case.run(eps)).collect::<Result<_, _>>()?;
        for Run { eps, off, told, samples, seconds } in &runs {
            println!("| {} | {eps:.0e} | {off:.1e} | {told:.1e} | {samples} | {seconds:.3} |", case.name);
        }
        panels.push(panel(case.name, &runs));
    }
    let title = "Contacts by rule".to_owned();
    let caption = "relative error, and the error that is told, as 1e-1 to 1e-9 is asked".to_owned();
    let diagram = Diagram { title, caption, columns: COLUMNS, panels };
    Ok(fs::write("docs/contacts.svg", diagram.drawing().svg())?)
}

impl Case {
    fn run(&self, eps: f64) -> Result<Run, Box<dyn Error>> {
        let options = Options {
            accuracy: Accuracy { eps, shadow_eps: eps },
            transport: Transport::Exact,
            subdivide: Some(1),
            threads: 1,
            ..Options::default()
        };
        let start = ProcessTime::now();
        let (mut sum, mut told, mut samples) = (0.0, 0.0, 0);
        for (factor, scene) in &self.scenes {
            let scene = language::read(&Source::new("scene.json", &scene.to_string()))?;
            let found = self.reading.asked(&scene, &options)?;
            let [value, error] = self.reading.of(&found);
            (sum, told) = (sum + factor * value, told + factor.abs() * error);
            samples += found.samples;
        }
        let seconds = start.elapsed().as_secs_f64();
        let off = (sum - self.right).abs() / self.right;
        Ok(Run { eps, off, told: told / self.right, samples, seconds })
    }
}

impl Reading {
    /// Accuracies that are asked: of the sums of rooms those that rules reach at all pairs.
    fn accuracies(self) -> impl Iterator<Item = f64> {
        let finest = match self {
            Self::Factor => 1e-9,
            Self::Sum => 1e-6,
        };
        ASKED.into_iter().filter(move |eps| *eps > 0.5 * finest)
    }

    /// View factors as far as they are read.
    fn asked(self, scene: &Scene, options: &Options) -> Result<ViewFactors, Box<dyn Error>> {
        let last = scene.surfaces.len() - 1;
        let wanted = move |i: usize, j: usize| match self {
            Self::Factor => i.max(j) == 1 && i != j,
            Self::Sum => i.max(j) == last && i != j,
        };
        Ok(ViewFactors::of_pairs(scene, &wanted, options, &Work::alone())?)
    }

    /// Its value and the error that is told of it.
    fn of(self, found: &ViewFactors) -> [f64; 2] {
        match self {
            Self::Factor => [found.factor(1, 0), found.errors[1]],
            Self::Sum => {
                let sums = found.row_sums();
                [sums[sums.len() - 1], found.errors[sums.len() - 1]]
            }
        }
    }
}

fn panel(name: &str, runs: &[Run]) -> Panel {
    let curve = |label: &str, colour: usize, error: fn(&Run) -> f64| Curve {
        label: label.to_owned(),
        colour: COLOURS[colour],
        dots: runs
            .iter()
            .map(|run| Dot { place: [run.samples as f64, error(run).max(LEAST)], text: String::new() })
            .collect(),
        others: Vec::new(),
    };
    Panel {
        title: name.to_owned(),
        axes: ["evaluations".to_owned(), "relative error".to_owned()],
        along: Spacing::Logarithmic,
        curves: vec![curve("told", 4, |run| run.told), curve("true", 1, |run| run.off)],
    }
}

fn cases() -> Vec<Case> {
    let amid = [-2.0, 2.0];
    let in_room = |name, body| Case {
        name,
        reading: Reading::Sum,
        scenes: vec![(1.0, scene(room().into_iter().chain([body])))],
        right: 1.0,
    };
    vec![
        Case {
            name: "ball on a floor",
            reading: Reading::Factor,
            scenes: vec![(1.0, scene([floor(amid), ball([0.0, 0.0, 1.0])]))],
            right: solid_angle(amid) / (4.0 * PI),
        },
        Case {
            name: "ball in a corner",
            reading: Reading::Factor,
            scenes: vec![(
                1.0,
                scene([
                    floor([0.0, 4.0]),
                    ball([1.0; 3]),
                    plate([0.0; 3], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]),
                    plate([0.0; 3], [0.0, 0.0, 4.0], [4.0, 0.0, 0.0]),
                ]),
            )],
            right: solid_angle([-1.0, 3.0]) / (4.0 * PI),
        },
        in_room("can that lies on a floor", tube([-0.4, 0.1, -0.7], [0.5, 0.2, 0.0], 0.3)),
        in_room(
            "cone on its tip",
            json!({ "cone": { "base": [0.2, 0.1, -1], "axis": [0.2, 0.3, 0.5], "radius1": 0, "radius2": 0.3 } }),
        ),
        Case {
            name: "pipes side by side",
            reading: Reading::Factor,
            scenes: vec![(2.0, pipes(400.0)), (-1.0, pipes(200.0))],
            right: 0.5 - 1.0 / PI,
        },
        Case {
            name: "disks 1e-4 of their radius apart",
            reading: Reading::Factor,
            scenes: vec![(1.0, scene([disk(0.0, 1.0), disk(1e-4, -1.0)]))],
            right: of_disks(1e-4),
        },
    ]
}

/// A scene of surfaces.
fn scene(surfaces: impl IntoIterator<Item = Value>) -> Value {
    json!({ "surfaces": surfaces.into_iter().collect::<Vec<Value>>() })
}

/// A parallelogram, its front along the cross product of its edges.
fn plate(origin: [f64; 3], edge1: [f64; 3], edge2: [f64; 3]) -> Value {
    json!({ "parallelogram": { "origin": origin, "edge1": edge1, "edge2": edge2 } })
}

/// A square in z = 0 of these ends along x and y.
fn floor([low, high]: [f64; 2]) -> Value {
    plate([low, low, 0.0], [high - low, 0.0, 0.0], [0.0, high - low, 0.0])
}

/// The cube of the side 2 about the origin, fronts inside.
fn room() -> Vec<Value> {
    let edges = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]];
    let face = |k: usize| {
        let [across, a, b] = [0, 1, 2].map(|step| edges[(k / 2 + step) % 3]);
        match k % 2 {
            0 => plate([-1.0; 3], a, b),
            _ => plate(across.map(|own| own - 1.0), b, a),
        }
    };
    (0..6).map(face).collect()
}

fn ball(center: [f64; 3]) -> Value {
    json!({ "sphere": { "center": center, "radius": 1 } })
}

fn tube(base: [f64; 3], axis: [f64; 3], radius: f64) -> Value {
    json!({ "cylinder": { "base": base, "axis": axis, "radius": radius } })
}

fn disk(height: f64, up: f64) -> Value {
    json!({ "disk": { "center": [0, 0, height], "normal": [0, 0, up], "radius": 1 } })
}

/// Two pipes of radius 1 and this length, side by side.
fn pipes(length: f64) -> Value {
    scene([-1.0, 1.0].map(|x| tube([x, 0.0, 0.0], [0.0, 0.0, length], 1.0)))
}

/// Solid angle of a square floor from a height of 1.
fn solid_angle([low, high]: [f64; 2]) -> f64 {
    let quarter = |a: f64, b: f64| (a * b / (a * a + b * b + 1.0).sqrt()).atan();
    quarter(high, high) - 2.0 * quarter(low, high) + quarter(low, low)
}

/// F between coaxial disks of radius 1 this far apart: 1 + h²/2 − h √(1 + h²/4).
fn of_disks(gap: f64) -> f64 {
    1.0 + 0.5 * gap * gap - gap * (1.0 + 0.25 * gap * gap).sqrt()
}

//! Ways to follow moving things: seconds of CPU by stages, how far the light is from that of frames alone, and
//! how far it is in truth.
//!
//! `cargo run --release -p radiosity-studies --bin animation -- [--frames N] [--order N] [--split] [--auto]
//! [--no-shadows] [--ways a,b] [SCENE...]`
//!
//! All ways solve the same frames of a scene with the same options, on one thread. `fresh` solves each by
//! itself, ten of them at most, spread over the path; `selective` one after the other, to the bit;
//! `incremental` solves for what has changed; `path` interpolates light; `series` sums blocks of power series.
//! Times are for one frame: `transport` is direct light and blocks, `solve` the linear systems, `all` all that
//! is done before anything is read. `off` is the largest difference of any frame that was also solved fresh:
//! the relative L2 of the coefficients of irradiance; `told` is what the way says of it. `error` is the
//! relative L2, over surfaces, of their mean irradiance, against frames of a tenth of the accuracies, or ten
//! times the rays, of three frames. `gain` is the time of fresh frames over that of this way, for transport and
//! solution, and for all.
//!
//! Without a scene: a lamp that slides along a ceiling and one that swings over a table, each without
//! shadows, as the source has them, and with, beside the two tables of the source: D. Arquès, V. Biri, S.
//! Michelin (2001), whose light passes through all bodies. A minute or two.

#![expect(clippy::print_stdout, reason = "tables for people")]

use std::time::Duration;

use cpu_time::ProcessTime;

use radiosity::Work;
use radiosity::scene::{Scene, Source};
use radiosity::solve::animation::follower::{FollowMode, Follower};
use radiosity::solve::animation::frame::Frame;
use radiosity::solve::{Direct, Options, Stages, Transport};
use radiosity::visibility::Shadows;

/// Most frames that are solved fresh, and frames that are solved to a tenth of the error.
const FRESH: usize = 10;
const REFERENCES: usize = 3;

/// Relative error of interpolation, and of blocks by series.
const TOLERANCE: f64 = 1e-4;

/// Accuracy of reference frames over that of the others.
const FINER: f64 = 0.1;

/// Rays of reference frames: ten times those of the others.
const REFERENCE_RAYS: u64 = 4_000_000;

const WAYS: [(FollowMode, &str); 4] = [
    (FollowMode::Selective, "selective"),
    (FollowMode::Incremental, "incremental"),
    (FollowMode::Path { tolerance: TOLERANCE }, "path"),
    (FollowMode::Series { tolerance: TOLERANCE }, "series"),
];

/// A room with a table, and over it a lamp in a box that swings without turning.
const SWING: &str = r#"
frames = 100
materials.wall = { reflectance = 0.6 }
materials.cloth = { reflectance = 0.3 }
materials.lamp = { reflectance = 0, emission = 40 }
[[surfaces]]
name = "room"
material = "wall"
box = { origin = [0, 0, 0], size = [5, 4, 3], inward = true }
[[surfaces]]
name = "table"
material = "cloth"
box = { origin = [1.3, 1.2, 0.5], size = [2.4, 1.4, 0.3] }
[[surfaces]]
name = "lamp"
material = "lamp"
quad = { vertices = [[1.8, 1.7, 1.9], [1.8, 2.1, 1.9], [2.4, 2.1, 1.9], [2.4, 1.7, 1.9]] }
[[surfaces]]
name = "shade"
material = "wall"
box = { origin = [1.8, 1.7, 1.9], size = [0.6, 0.4, 0.1], open = ["bottom"] }
[[motion]]
surfaces = ["lamp", "shade"]
translate = { points = [[0, 0, 0.05], [0.4, 0, 0], [0.8, 0, 0.05]] }
"#;

/// A table of the source.
struct Printed {
    title: &'static str,
    /// Time of the set-up (s).
    set_up: f64,
    /// Time of a frame (s).
    each: f64,
    /// Time of a frame that is solved anew (s).
    alone: f64,
    frames: usize,
}

/// Table 2 counts the shadows, which are drawn afterwards, in both columns. The source prints 185 s for the
/// sum of its numbers.
const SOURCE: [Printed; 2] = [
    Printed {
        title: "table 1, room with a sliding light",
        set_up: 18.59,
        each: 1.41,
        alone: 4.02,
        frames: 100,
    },
    Printed { title: "table 2, billiard", set_up: 18.59, each: 1.13, alone: 2.93, frames: 160 },
];

struct Asked {
    frames: Option<usize>,
    options: Options,
    ways: Option<String>,
    scenes: Vec<String>,
}

fn main() {
    let asked = asked();
    println!(
        "| scene | way | frames | solved | transport CPU s | solve CPU s | all CPU s | off | told | error | rays traced | gain of both | gain of all |"
    );
    println!("|{}{}{}{}", " --- |".repeat(4), " ---: |".repeat(3), " --- |".repeat(4), " ---: |".repeat(2));
    for name in &asked.scenes {
        asked.compare(name, &radiosity::load(name).expect("a scene with motions"), &asked.options);
    }
    if asked.scenes.is_empty() {
        let sliding = radiosity::builtin("sliding-light").expect("it is built in");
        let swinging = radiosity::language::read(&Source::new("swinging.toml", SWING)).expect("it is valid");
        for (name, scene) in [("sliding light", &sliding), ("swinging lamp", &swinging)] {
            let without = Options { shadows: Shadows::Off, ..asked.options };
            asked.compare(&format!("{name}, no shadows"), scene, &without);
            asked.compare(name, scene, &asked.options);
        }
        SOURCE.iter().for_each(print_source);
    }
}

fn asked() -> Asked {
    let mut asked = Asked {
        frames: None,
        options: Options {
            transport: Transport::Exact,
            direct: Direct::Projected,
            threads: 1,
            ..Options::default()
        },
        ways: None,
        scenes: Vec::new(),
    };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut number = || words.next().and_then(|text| text.parse().ok()).expect("a number");
        match word.as_str() {
            "--frames" => asked.frames = Some(number()),
            "--order" => asked.options.order = number(),
            "--split" => asked.options.direct = Direct::Auto,
            "--auto" => asked.options.transport = Transport::Auto,
            "--no-shadows" => asked.options.shadows = Shadows::Off,
            "--ways" => asked.ways = words.next(),
            _ => asked.scenes.push(word),
        }
    }
    asked
}

/// A row from what the source prints: seconds on its machine, so that only ratios compare.
fn print_source(&Printed { title, set_up, each, alone, frames }: &Printed) {
    let count = frames as f64;
    let (total, fresh) = (set_up + count * each, count * alone);
    println!("| {title} | fresh | {frames} | | | | {alone} | | | | | 1 | 1 |");
    println!("| {title} | series | {frames} | | | | {:.2} | | | | | | {:.1} |", total / count, fresh / total);
}

/// Frames that are solved fresh, and their times.
struct Fresh {
    numbers: Vec<usize>,
    frames: Vec<Frame>,
    times: Times,
}

/// Seconds of CPU for a frame.
#[derive(Clone, Copy)]
struct Times {
    transport: f64,
    solve: f64,
    all: f64,
}

impl Times {
    /// The times of a frame, where so many took so much in these stages and in all.
    fn of(Stages { blocks, direct, solve, .. }: Stages, all: Duration, frames: usize) -> Self {
        let each = |time: Duration| time.as_secs_f64() / frames as f64;
        Self { transport: each(blocks + direct), solve: each(solve), all: each(all) }
    }

    fn both(&self) -> f64 {
        self.transport + self.solve
    }
}

impl Fresh {
    /// So many frames, spread over all of `count`.
    fn of(scene: &Scene, options: &Options, frames: usize, count: usize) -> Self {
        let (frames, last) = (frames.min(count), count - 1);
        let numbers: Vec<usize> = (0..frames).map(|k| k * last / (frames - 1).max(1)).collect();
        let mut follower = Follower::new(scene, options, FollowMode::Fresh, [0, last]);
        let begun = ProcessTime::now();
        let frames: Vec<Frame> = numbers.iter().map(|frame| frame_of(&mut follower, *frame)).collect();
        let times = Times::of(follower.report().seconds, begun.elapsed(), frames.len());
        Self { numbers, frames, times }
    }

    /// The largest difference of `frame`, if it is one of these, by this measure.
    fn off(&self, number: usize, frame: &Frame, apart: fn(&Frame, &Frame) -> f64) -> f64 {
        let place = self.numbers.binary_search(&number);
        place.map_or(0.0, |place| apart(frame, &self.frames[place]))
    }
}

impl Asked {
    fn compare(&self, name: &str, scene: &Scene, options: &Options) {
        let count = self.frames.unwrap_or(scene.frames()).min(scene.frames());
        let fresh = Fresh::of(scene, options, FRESH, count);
        let references = Fresh::of(scene, &finer(options, &fresh.frames[0]), REFERENCES, count);
        let Times { transport, solve, all } = fresh.times;
        let error = fresh.numbers.iter().zip(&fresh.frames);
        let error =
            error.fold(0.0f64, |most, (number, own)| most.max(references.off(*number, own, by_surfaces)));
        println!(
            "| {name} | fresh | {} | | {transport:.4} | {solve:.4} | {all:.4} | | | {error:.1e} | | 1 | 1 |",
            fresh.numbers.len()
        );
        for (way, title) in WAYS {
            if self.ways.as_ref().is_none_or(|ways| ways.split(',').any(|own| own == title)) {
                follow(&format!("{name} | {title}"), [&fresh, &references], way, (scene, options, count));
            }
        }
    }
}

/// Prints the row of a way.
fn follow(title: &str, [fresh, references]: [&Fresh; 2], way: FollowMode, what: (&Scene, &Options, usize)) {
    let (scene, options, count) = what;
    let mut follower = Follower::new(scene, options, way, [0, count - 1]);
    let (mut off, mut error, mut spent, mut first) = (0.0f64, 0.0f64, Duration::ZERO, 0);
    for number in 0..count {
        let begun = ProcessTime::now();
        let Ok(frame) = follower.frame(number, &Work::alone()) else {
            return println!("| {title} | | | | | | | | | by rays | | |");
        };
        spent += begun.elapsed();
        if number == 0 {
            first = follower.report().rays.traced;
        }
        off = off.max(fresh.off(number, &frame, by_coefficients));
        error = error.max(references.off(number, &frame, by_surfaces));
    }
    let report = follower.report();
    let times @ Times { transport, solve, all } = Times::of(report.seconds, spent, count);
    let sent = report.rays.traced + report.rays.recalled - first;
    let traced = match sent {
        0 => String::new(),
        sent => format!("{:.1} %", 100.0 * (report.rays.traced - first) as f64 / sent as f64),
    };
    println!(
        "| {title} | {count} | {} | {transport:.4} | {solve:.4} | {all:.4} | {off:.1e} | {} | {error:.1e} | {traced} | {:.1} | {:.1} |",
        follower.solved(),
        follower.error().map_or(String::new(), |told| format!("{told:.1e}")),
        fresh.times.both() / times.both(),
        fresh.times.all / all,
    );
}

/// Options of a tenth of the error, as frames by these options were solved.
fn finer(options: &Options, frames: &Frame) -> Options {
    let by_rays = frames.rays > 0.0;
    Options {
        eps: FINER * options.eps,
        shadow_eps: FINER * options.shadow_eps,
        transport: if by_rays { Transport::Sampled } else { Transport::Exact },
        rays: by_rays.then_some(REFERENCE_RAYS),
        ..*options
    }
}

fn frame_of(follower: &mut Follower<'_>, frame: usize) -> Frame {
    follower.frame(frame, &Work::alone()).expect("the frame can be solved")
}

/// Relative L2 difference of the coefficients of irradiance, largest of the bands.
fn by_coefficients(frame: &Frame, right: &Frame) -> f64 {
    let pairs = frame.solution.bands().iter().zip(right.solution.bands());
    let relative = pairs.map(|(own, other)| {
        let [own, other] = [own, other].map(|band| &band.coefficients.irradiance);
        relative_difference(own, other, &vec![1.0; own.len()])
    });
    relative.fold(0.0, f64::max)
}

/// Relative L2 difference, over surfaces, of their mean irradiance, largest of the bands.
fn by_surfaces(frame: &Frame, right: &Frame) -> f64 {
    let surfaces = 0..frame.scene.surfaces.len();
    let areas: Vec<f64> = surfaces.clone().map(|own| frame.scene.surfaces[own].shape.area()).collect();
    let of_band = |band: usize| {
        let means = |frame: &Frame| -> Vec<f64> {
            surfaces.clone().map(|own| frame.solution.mean_irradiance(band, own)).collect()
        };
        relative_difference(&means(frame), &means(right), &areas)
    };
    (0..frame.solution.bands().len()).map(of_band).fold(0.0, f64::max)
}

fn relative_difference(own: &[f64], other: &[f64], weights: &[f64]) -> f64 {
    let terms = own.iter().zip(other).zip(weights);
    let difference: f64 = terms.map(|((a, b), weight)| weight * (a - b).powi(2)).sum();
    let size: f64 = other.iter().zip(weights).map(|(h, weight)| weight * h * h).sum();
    if difference == 0.0 { 0.0 } else { (difference / size).sqrt() }
}

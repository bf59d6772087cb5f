//! Ways to follow moving things: seconds of CPU, frames a second, when the set-up is repaid, and how far the
//! light is from that of a fresh solution.
//!
//! `cargo run --release -p radiosity-studies --bin animation -- [--frames N] [--order N]
//! [--split] [--auto] [--no-shadows] [SCENE...]`
//!
//! All ways solve the same frames of a scene with the same options, on one thread. `fresh` solves each by
//! itself, ten of them at most, spread over the path; `selective` one after the other; `path` interpolates
//! light; `series` sums blocks of power series. The error is the largest of any frame that was solved fresh:
//! the relative L2 of the coefficients of irradiance. Of the rays between elements, where these carry the
//! pairs (`--auto`), it is told which part was traced for frames after the first. `gain` is the time of fresh
//! frames over that of this way, for all frames together; `afterwards` that for one frame more when all is
//! set up. `repaid` is the number of frames from which on all together take less CPU than fresh ones, in
//! brackets the same counted in blocks.
//!
//! Without a scene: a lamp that slides along a ceiling and one that swings over a table, each without
//! shadows, as the source has them, and with, beside the two tables of the source: D. Arquès, V. Biri, S.
//! Michelin (2001), whose light passes through all bodies. About a minute.

#![expect(clippy::print_stdout, reason = "tables for people")]

use cpu_time::ProcessTime;

use radiosity::Work;
use radiosity::scene::{Scene, Source};
use radiosity::solve::animation::follower::{FollowMode, Follower};
use radiosity::solve::animation::frame::Frame;
use radiosity::solve::{Direct, Options, Transport};
use radiosity::transport::RayCounts;
use radiosity::visibility::Shadows;

/// Most frames that are solved fresh.
const FRESH: usize = 10;

/// Relative error of interpolation, and of blocks by series.
const TOLERANCE: f64 = 1e-4;

const WAYS: [(FollowMode, &str); 3] = [
    (FollowMode::Selective, "selective"),
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
    scenes: Vec<String>,
}

fn main() {
    let Asked { frames, options, scenes } = asked();
    println!(
        "| scene | way | frames | solved | CPU s | CPU s a frame | frames/s | error | told | bits | rays traced | gain | afterwards | repaid |"
    );
    println!("|{}{}{}{}", " --- |".repeat(4), " ---: |".repeat(3), " --- |".repeat(4), " ---: |".repeat(3));
    let compared = |name: &str, scene: &Scene, options: &Options| {
        let count = frames.unwrap_or(scene.frames()).min(scene.frames());
        compare(name, scene, options, count);
    };
    for name in &scenes {
        compared(name, &radiosity::load(name).expect("a scene with motions"), &options);
    }
    if scenes.is_empty() {
        let sliding = radiosity::builtin("sliding-light").expect("it is built in");
        let swinging = radiosity::language::read(&Source::new("swinging.toml", SWING)).expect("it is valid");
        for (name, scene) in [("sliding light", &sliding), ("swinging lamp", &swinging)] {
            let without = Options { shadows: Shadows::Off, ..options };
            compared(&format!("{name}, no shadows"), scene, &without);
            compared(name, scene, &options);
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
            _ => asked.scenes.push(word),
        }
    }
    asked
}

/// A row from what the source prints: seconds on its machine, so that only ratios compare.
fn print_source(&Printed { title, set_up, each, alone, frames }: &Printed) {
    let count = frames as f64;
    let (total, fresh) = (set_up + count * each, count * alone);
    println!("| {title} | fresh | {frames} | | {fresh:.0} | {alone} | {:.2} | | | | | 1 | | |", 1.0 / alone);
    println!(
        "| {title} | series | {frames} | | {total:.0} | {:.2} | {:.2} | | | | | {:.1} | {:.1} | {:.0} |",
        total / count,
        count / total,
        fresh / total,
        alone / each,
        (set_up / (alone - each)).ceil()
    );
}

/// The frames that are solved fresh, and seconds of CPU for one.
struct Fresh {
    numbers: Vec<usize>,
    frames: Vec<Frame>,
    each: f64,
}

impl Fresh {
    fn of(scene: &Scene, options: &Options, count: usize) -> Self {
        let last = count - 1;
        let numbers: Vec<usize> =
            (0..FRESH.min(count)).map(|k| k * last / (FRESH.min(count) - 1).max(1)).collect();
        let mut follower = Follower::new(scene, options, FollowMode::Fresh, [0, last]);
        let begun = ProcessTime::now();
        let frames: Vec<Frame> = numbers.iter().map(|frame| frame_of(&mut follower, *frame)).collect();
        let each = begun.elapsed().as_secs_f64() / numbers.len() as f64;
        Self { numbers, frames, each }
    }
}

fn compare(name: &str, scene: &Scene, options: &Options, count: usize) {
    let fresh = Fresh::of(scene, options, count);
    let (solved, alone) = (fresh.numbers.len(), fresh.each);
    println!("| {name} | fresh | {solved} | {solved} | | {alone:.4} | {:.0} | | | | | 1 | | |", 1.0 / alone);
    for (way, title) in WAYS {
        let mut follower = Follower::new(scene, options, way, [0, count - 1]);
        let (mut error, mut same, mut spent) = (0.0f64, true, 0.0);
        let mut first = RayCounts::default();
        let mut repaid = None;
        for frame in 0..count {
            let begun = ProcessTime::now();
            let now = frame_of(&mut follower, frame);
            spent += begun.elapsed().as_secs_f64();
            if frame == 0 {
                first = follower.report().rays;
            }
            let is_less = spent < (frame + 1) as f64 * alone;
            repaid = is_less.then(|| repaid.unwrap_or(frame + 1));
            if let Ok(place) = fresh.numbers.binary_search(&frame) {
                error = error.max(apart(&now, &fresh.frames[place]));
                same &= bits(&now) == bits(&fresh.frames[place]);
            }
        }
        let in_blocks = follower.repaid();
        let rays = follower.report().rays;
        let (solved, told) = (follower.solved(), follower.error());
        // Path: all frames again. Else: the last one and the one before it by turns, as the last one alone is
        // known to the bit.
        let again: Vec<usize> = match way {
            FollowMode::Path { .. } => (0..count).collect(),
            _ => [count - 2, count - 1].repeat(3),
        };
        let begun = ProcessTime::now();
        again.iter().for_each(|frame| drop(frame_of(&mut follower, *frame)));
        let afterwards = begun.elapsed().as_secs_f64() / again.len() as f64;
        let each = spent / count as f64;
        println!(
            "| {name} | {title} | {count} | {solved} | {spent:.2} | {each:.4} | {:.0} | {error:.1e} | {} | {} | {} | {:.1} | {:.1} | {} ({}) |",
            1.0 / each,
            told.map_or("-".to_owned(), |told| format!("{told:.1e}")),
            if same { "same" } else { "other" },
            traced(&first, &rays),
            alone / each,
            alone / afterwards,
            frames_or_never(repaid),
            frames_or_never(in_blocks)
        );
    }
}

/// The part of the rays after the first ones that was traced.
fn traced(first: &RayCounts, all: &RayCounts) -> String {
    let (traced, recalled) = (all.traced - first.traced, all.recalled - first.recalled);
    match traced + recalled {
        0 => String::new(),
        sent => format!("{:.1} %", 100.0 * traced as f64 / sent as f64),
    }
}

fn frames_or_never(frames: Option<usize>) -> String {
    frames.map_or("never".to_owned(), |frames| frames.to_string())
}

fn frame_of(follower: &mut Follower<'_>, frame: usize) -> Frame {
    follower.frame(frame, &Work::alone()).expect("the frame can be solved")
}

fn bits(frame: &Frame) -> Vec<u64> {
    let bands = frame.solution.bands().iter();
    bands.flat_map(|band| &band.coefficients.irradiance).map(|h| h.to_bits()).collect()
}

fn apart(frame: &Frame, right: &Frame) -> f64 {
    let pairs = frame.solution.bands().iter().zip(right.solution.bands());
    let relative = pairs.map(|(own, other)| {
        let [own, other] = [own, other].map(|band| &band.coefficients.irradiance);
        let difference: f64 = own.iter().zip(other).map(|(a, b)| (a - b).powi(2)).sum();
        (difference / other.iter().map(|h| h * h).sum::<f64>()).sqrt()
    });
    relative.fold(0.0, f64::max)
}

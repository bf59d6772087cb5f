//! Ways to follow moving things: seconds of CPU for a frame, and how far the light is from that of a fresh solution.
//!
//! `cargo run --release --example animation -- [--frames N] [--order N] [--projected] [--auto] SCENE...`
//!
//! All ways solve the same frames of a scene with the same options. `fresh` solves each by itself, ten of them at most, spread
//! over the path; `selective` one after the other; `path` interpolates. The error is the largest of any frame that was solved
//! fresh: the relative L2 of the coefficients of irradiance. Of the rays between elements, where these carry the pairs (`--auto`),
//! it is told which part was traced for frames after the first. The last columns are the times of fresh frames over those of this
//! way, for all frames together, and for one more after all segments are known.

#![expect(clippy::print_stdout, reason = "a table for people")]

use cpu_time::ProcessTime;

use radiosity::animation::follower::{Follower, Way};
use radiosity::animation::frame::Frame;
use radiosity::scene::Scene;
use radiosity::solve::{Direct, Options, Transport};
use radiosity::transport::RayCounts;

/// Fresh solutions.
const FRESH: usize = 10;

/// Relative error of interpolation.
const TOLERANCE: f64 = 1e-4;

struct Asked {
    frames: Option<usize>,
    options: Options,
    scenes: Vec<String>,
}

fn main() {
    let Asked { frames, options, scenes } = asked();
    println!(
        "| scene | way | frames | solved | CPU s a frame | error | bits | rays traced | fresh over it | afterwards |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    for name in &scenes {
        let scene = Scene::load(name).expect("a scene with motions");
        let count = frames.unwrap_or(scene.frames()).min(scene.frames());
        compare(name, &scene, &options, count);
    }
}

fn asked() -> Asked {
    let mut asked = Asked {
        frames: None,
        options: Options { transport: Transport::Exact, ..Options::default() },
        scenes: Vec::new(),
    };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut number = || words.next().and_then(|text| text.parse().ok()).expect("a number");
        match word.as_str() {
            "--frames" => asked.frames = Some(number()),
            "--order" => asked.options.order = number(),
            "--projected" => asked.options.direct = Direct::Projected,
            "--auto" => asked.options.transport = Transport::Auto,
            _ => asked.scenes.push(word),
        }
    }
    asked
}

fn compare(name: &str, scene: &Scene, options: &Options, count: usize) {
    let last = count - 1;
    let sample: Vec<usize> =
        (0..FRESH.min(count)).map(|k| k * last / (FRESH.min(count) - 1).max(1)).collect();
    let mut follower = Follower::new(scene, options, Way::Fresh, [0, last]);
    let begun = ProcessTime::now();
    let fresh: Vec<Frame> = sample.iter().map(|frame| frame_of(&mut follower, *frame)).collect();
    let alone = begun.elapsed().as_secs_f64() / sample.len() as f64;
    println!("| {name} | fresh | {} | {} | {alone:.4} | | | | 1 | |", sample.len(), sample.len());
    for (way, title) in [(Way::Selective, "selective"), (Way::Path { tolerance: TOLERANCE }, "path")] {
        let mut follower = Follower::new(scene, options, way, [0, last]);
        let begun = ProcessTime::now();
        let (mut error, mut same) = (0.0f64, true);
        let (mut lost, mut first) = (0.0, RayCounts::default());
        for frame in 0..count {
            let now = frame_of(&mut follower, frame);
            let compared = ProcessTime::now();
            if frame == 0 {
                first = follower.account().rays;
            }
            if let Ok(place) = sample.binary_search(&frame) {
                error = error.max(apart(&now, &fresh[place]));
                same &= bits(&now) == bits(&fresh[place]);
            }
            lost += compared.elapsed().as_secs_f64();
        }
        let each = (begun.elapsed().as_secs_f64() - lost) / count as f64;
        let rays = follower.account().rays;
        let begun = ProcessTime::now();
        let again = if title == "path" { count } else { 1 };
        (0..again).for_each(|frame| drop(frame_of(&mut follower, frame)));
        let afterwards = begun.elapsed().as_secs_f64() / again as f64;
        println!(
            "| {name} | {title} | {count} | {} | {each:.4} | {error:.1e} | {} | {} | {:.1} | {:.0} |",
            follower.solved(),
            if same { "same" } else { "other" },
            traced(&first, &rays),
            alone / each,
            alone / afterwards
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

fn frame_of(follower: &mut Follower<'_>, frame: usize) -> Frame {
    follower.frame(frame, &|_| ()).expect("the frame can be solved")
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

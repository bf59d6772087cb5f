//! Steadiness of the light of a film: first and second differences in time of pixels that see a thing at
//! rest.
//!
//! `cargo run --release -p radiosity-studies --bin flicker -- [--frames A..B] [--size WxH]
//! [--read basis|direct|gather] SCENE...`
//!
//! A pixel counts where it and the eight around it see the same place of the same surface in three frames one
//! after the other, luminous things left out: what moves, and its outline, are not looked at. With the
//! radiosity f(t) of such a pixel, mean over the bands,
//!
//! ```text
//! d₁ = f(t + 1) − f(t) ,     d₂ = f(t + 1) − 2 f(t) + f(t − 1) ,
//! ```
//!
//! in % of the mean of the frame: root mean squares over the pixels of all frames, and the largest. Light
//! that follows what moves smoothly has d₂ ≪ d₁; noise that is drawn anew for each frame has d₂ = √3 d₁, and
//! so has a light that pops. Times are CPU seconds a frame, of the light and of the picture.

#![expect(clippy::print_stdout, reason = "a table for people")]

use cpu_time::ProcessTime;

use radiosity::Work;
use radiosity::geom::Encounter;
use radiosity::reading::pictures::pinhole::Pinhole;
use radiosity::reading::pictures::render::PictureRequest;
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::ReadMode;
use radiosity::scene::{Camera, Scene};
use radiosity::solve::Options;
use radiosity::solve::animation::follower::{FollowMode, Follower};

/// The films that the command line asks for.
struct Asked {
    frames: Option<[usize; 2]>,
    size: [u32; 2],
    read: ReadMode,
    scenes: Vec<String>,
}

/// A picture, with what its pixels see.
struct Shot {
    values: Vec<f64>,
    seen: Vec<Option<Encounter>>,
    /// Whether each pixel sees something luminous.
    shines: Vec<bool>,
}

/// Sums over the pixels of a film.
#[derive(Default)]
struct Sums {
    count: f64,
    first: f64,
    second: f64,
    largest: f64,
}

fn main() {
    let asked = asked();
    println!("| scene | frames | size | read | light s | picture s | d₁ % | d₂ % | largest d₂ % |");
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    for name in &asked.scenes {
        println!("{}", row(name, &asked));
    }
}

fn row(name: &str, asked: &Asked) -> String {
    let scene = radiosity::load(name).expect("a scene with motions");
    let options = Options::default();
    let [first, last] = asked.frames.unwrap_or([0, scene.frames() - 1]);
    let [width, height] = asked.size;
    let camera = Camera { width, height, ..scene.camera.clone().expect("it has a camera") };
    let mut follower = Follower::new(&scene, &options, FollowMode::Selective, [first, last]);
    let (mut light, mut picture) = (0.0, 0.0);
    let mut shots: Vec<Shot> = Vec::new();
    let mut sums = Sums::default();
    for number in first..=last {
        let start = ProcessTime::now();
        let frame = follower.frame(number, &Work::alone()).expect("it is solved");
        light += start.elapsed().as_secs_f64();
        let start = ProcessTime::now();
        let visibility = options.visibility(&frame.scene);
        let raster = PictureRequest {
            solution: &frame.solution,
            visibility: &visibility,
            camera: &camera,
            samples: 3,
            read: asked.read,
            shown: Quantity::Radiosity,
            is_preview: false,
        }
        .picture(&Work::alone());
        picture += start.elapsed().as_secs_f64();
        let view = Pinhole::new(&camera);
        let pixels = 0..(width * height) as usize;
        let at = |pixel: usize| [pixel % width as usize, pixel / width as usize].map(|at| at as f64 + 0.5);
        let seen: Vec<Option<Encounter>> =
            pixels.map(|pixel| visibility.nearest(&view.ray(at(pixel)[0], at(pixel)[1]))).collect();
        let luminous = |surface: usize| (0..3).any(|band| emits(&frame.scene, surface, band));
        shots.push(Shot {
            values: raster.pixels().map(|pixel| pixel.iter().sum::<f64>() / pixel.len() as f64).collect(),
            shines: seen.iter().map(|seen| seen.is_some_and(|seen| luminous(seen.surface))).collect(),
            seen,
        });
        if let [.., before, now, after] = &shots[..] {
            sums.add([before, now, after], width as usize);
            shots.remove(0);
        }
    }
    let frames = (last - first + 1) as f64;
    let [d1, d2] = [sums.first, sums.second].map(|sum| 100.0 * (sum / sums.count).sqrt());
    format!(
        "| {name} | {first}..{last} | {width} × {height} | {:?} | {:.2} | {:.2} | {d1:.2} | {d2:.2} | {:.1} |",
        asked.read,
        light / frames,
        picture / frames,
        100.0 * sums.largest
    )
}

fn emits(scene: &Scene, surface: usize, band: usize) -> bool {
    band < scene.bands.len() && scene.surfaces[surface].exitance(band) > 0.0
}

impl Sums {
    /// Takes the pixels at rest of three pictures.
    fn add(&mut self, [before, now, after]: [&Shot; 3], width: usize) {
        let mean = now.values.iter().sum::<f64>() / now.values.len() as f64;
        for pixel in (0..now.values.len()).filter(|pixel| is_at_rest([before, now, after], *pixel, width)) {
            let [a, b, c] = [before, now, after].map(|shot| shot.values[pixel] / mean);
            let bend = c - 2.0 * b + a;
            self.count += 1.0;
            self.first += (c - b).powi(2);
            self.second += bend * bend;
            self.largest = self.largest.max(bend.abs());
        }
    }
}

/// Whether a pixel and those around it see the same in all pictures, on one surface.
fn is_at_rest(shots: [&Shot; 3], pixel: usize, width: usize) -> bool {
    let height = shots[0].values.len() / width;
    let [column, row] = [pixel % width, pixel / width];
    if column == 0 || row == 0 || column + 1 == width || row + 1 == height {
        return false;
    }
    let around =
        (row - 1..=row + 1).flat_map(|row| (column - 1..=column + 1).map(move |at| row * width + at));
    let surface = shots[1].seen[pixel].map(|seen| seen.surface);
    around.into_iter().all(|place| {
        let seen = shots.map(|shot| shot.seen[place]);
        seen[0] == seen[1]
            && seen[1] == seen[2]
            && seen[1].map(|seen| seen.surface) == surface
            && !shots[1].shines[place]
    })
}

fn asked() -> Asked {
    let mut asked = Asked { frames: None, size: [240, 170], read: ReadMode::Direct, scenes: Vec::new() };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut next = || words.next().expect("a value follows");
        match word.as_str() {
            "--frames" => asked.frames = Some(pair(&next(), "..")),
            "--size" => asked.size = pair(&next(), "x").map(|side| side as u32),
            "--read" => {
                asked.read = match next().as_str() {
                    "basis" => ReadMode::Basis,
                    "gather" => ReadMode::Gather,
                    _ => ReadMode::Direct,
                }
            }
            _ => asked.scenes.push(word),
        }
    }
    asked
}

/// Two numbers with a mark between them.
fn pair(text: &str, mark: &str) -> [usize; 2] {
    let mut numbers = text.split(mark).map(|number| number.parse().expect("a number"));
    std::array::from_fn(|_| numbers.next().expect("two numbers"))
}

//! Cost and error of pictures: seconds, error against light computed anew, and the largest joint between
//! elements.
//!
//! `cargo run --release -p radiosity-studies --bin pictures [-- SCENE...]`
//!
//! Each scene is solved and taken as `radiosity render SCENE` does, in its own size, the temple in a smaller
//! one, in which it is gathered too. The error is that of the radiosity at 1000 pixels, evenly chosen, lamps
//! left out, over the root mean square of the radiosity: against light gathered to 1e-4 by cells in flat
//! scenes, to 1e-3 by rays at the teapot, to 3e-3 in the temple. A joint is what the error changes by, over
//! the mean radiosity, from pixels to the next where these see different elements of one surface: the mean
//! over sixteen pixels along a joint, since a step shows where it runs on; the largest of fifty such runs,
//! evenly chosen. The largest step between two single pixels stands beside it: it has the noise of both
//! pixels and of the light that they are compared with.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::time::Instant;

use radiosity::Work;
use radiosity::geom::{DVec3, Encounter};
use radiosity::reading::pictures::pinhole::Pinhole;
use radiosity::reading::pictures::render::{render, usual_read};
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::Camera;
use radiosity::solve::gather::gather_method::GatherMethod;
use radiosity::solve::solution::{Solution, SurfacePlace};
use radiosity::solve::{Options, solve};
use radiosity::visibility::Visibility;

const SCENES: [&str; 6] = ["cornell-box", "two-boxes", "occluder-box", "empty-box", "teapot", "temple"];
const PIXELS: usize = 1000;
const RUN: usize = 16;
const RUNS: usize = 50;

fn main() {
    let asked: Vec<String> = std::env::args().skip(1).collect();
    println!(
        "| scene | pixels | read | solve s | picture s | rms error % | largest joint % | largest step % |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    for name in SCENES.iter().filter(|name| asked.is_empty() || asked.iter().any(|other| other == **name)) {
        println!("{}", row(name));
    }
}

fn row(name: &str) -> String {
    let scene = radiosity::builtin(name).expect("built in");
    let camera = scene.camera.clone().expect("it has one");
    let camera = if name == "temple" { Camera { width: 240, height: 192, ..camera } } else { camera };
    let options = Options::default();
    let start = Instant::now();
    let solution = solve(&scene, &options, &Work::alone()).expect("it is solved").solution;
    let solved = start.elapsed().as_secs_f64();
    let visibility = options.visibility(&scene);
    let pixels = u64::from(camera.width) * u64::from(camera.height);
    let read = usual_read(&solution, &visibility, pixels, None);
    let start = Instant::now();
    let _ = render(&solution, &visibility, &camera, 3, read, Quantity::Radiosity, &Work::alone());
    let taken = start.elapsed().as_secs_f64();
    let errors = Errors::of(name, &solution, &visibility, &camera, read);
    let [width, height] = [camera.width, camera.height];
    let Joints { joint, step } = errors.joints();
    let [rms, joint, step] = [errors.rms(), joint, step].map(|part| 100.0 * part);
    format!(
        "| {name} | {width} × {height} | {read:?} | {solved:.2} | {taken:.2} | {rms:.2} | {joint:.2} | {step:.2} |"
    )
}

/// The place that the middle of a pixel sees.
#[derive(Clone, Copy)]
struct Seen {
    element: usize,
    place: SurfacePlace,
    normal: DVec3,
}

/// The pixels of a picture beside light computed anew.
struct Errors<'a> {
    solution: &'a Solution,
    reader: Reader<'a>,
    width: usize,
    seen: Vec<Option<Seen>>,
    /// Radiosity of the picture, all bands together (W m⁻²).
    picture: Vec<f64>,
}

impl<'a> Errors<'a> {
    fn of(
        name: &str,
        solution: &'a Solution,
        visibility: &'a Visibility,
        camera: &Camera,
        read: ReadMode,
    ) -> Self {
        let raster = render(solution, visibility, camera, 1, read, Quantity::Radiosity, &Work::alone());
        let reader = |by: GatherMethod, eps: f64| Reader::by(by, solution, visibility, ReadMode::Gather, eps);
        let view = Pinhole::new(camera);
        let width = camera.width as usize;
        let look = |pixel: usize| {
            let ray = view.ray((pixel % width) as f64 + 0.5, (pixel / width) as f64 + 0.5);
            let Encounter { surface, hit, .. } = visibility.nearest(&ray).filter(|met| met.front)?;
            let element = solution.elements().at(surface, [hit.u, hit.v])?;
            let jet = solution.elements().shape(surface).jet(hit.u, hit.v);
            let place = SurfacePlace { surface, parameters: [hit.u, hit.v], position: jet.position };
            let emits = solution.bands().iter().any(|band| band.coating.exitance[element] > 0.0);
            (!emits).then_some(Seen { element, place, normal: jet.normal })
        };
        Self {
            solution,
            reader: match name {
                "teapot" => reader(GatherMethod::Rays, 1e-3),
                "temple" => reader(GatherMethod::Rays, 3e-3),
                _ => reader(GatherMethod::Cells, 1e-4),
            },
            width,
            seen: (0..width * camera.height as usize).map(look).collect(),
            picture: raster.pixels().map(|bands| bands.iter().sum()).collect(),
        }
    }

    /// The radiosity of a pixel computed anew, all bands together.
    fn exact(&self, seen: &Seen) -> f64 {
        let irradiance = self.reader.irradiance(seen.element, &seen.place, seen.normal).irradiance;
        let bands = self.solution.bands().iter().zip(irradiance);
        bands.map(|(band, e)| band.coating.radiosity(seen.element, seen.place.parameters, e, 0.0)).sum()
    }

    fn error(&self, pixel: usize) -> Option<f64> {
        Some(self.picture[pixel] - self.exact(self.seen[pixel].as_ref()?))
    }

    fn rms(&self) -> f64 {
        let step = (self.seen.len() / PIXELS) | 1;
        let pixels = (0..self.seen.len()).step_by(step);
        let (mut squares, mut all) = (0.0, 0.0);
        for (pixel, error) in pixels.filter_map(|pixel| Some((pixel, self.error(pixel)?))) {
            squares += error * error;
            all += self.picture[pixel].powi(2);
        }
        f64::sqrt(squares / all)
    }

    fn joints(&self) -> Joints {
        let runs: Vec<Vec<Pair>> = self.runs();
        let step = runs.len() / RUNS + 1;
        let mut largest = Joints { joint: 0.0, step: 0.0 };
        for run in runs.iter().step_by(step) {
            let jumps =
                run.iter().filter_map(|pair| Some(self.error(pair.pixels[1])? - self.error(pair.pixels[0])?));
            let jumps: Vec<f64> = jumps.collect();
            let mean = jumps.iter().sum::<f64>() / jumps.len() as f64;
            largest.joint = largest.joint.max(mean.abs());
            largest.step = jumps.iter().fold(largest.step, |step, jump| step.max(jump.abs()));
        }
        let lit = (0..self.seen.len()).filter(|pixel| self.seen[*pixel].is_some());
        let lit: Vec<f64> = lit.map(|pixel| self.picture[pixel]).collect();
        let mean = lit.iter().sum::<f64>() / lit.len() as f64;
        Joints { joint: largest.joint / mean, step: largest.step / mean }
    }

    /// Pairs of pixels across the joints, those along one joint together.
    fn runs(&self) -> Vec<Vec<Pair>> {
        let mut pairs: Vec<Pair> = (0..self.seen.len())
            .flat_map(|pixel| [(pixel, 1), (pixel, self.width)])
            .filter_map(|(pixel, step)| self.pair(pixel, step))
            .collect();
        pairs.sort_by_key(|pair| (pair.elements, pair.step));
        let runs = pairs.chunk_by(|a, b| (a.elements, a.step) == (b.elements, b.step));
        runs.flat_map(|along| along.chunks_exact(RUN).map(<[Pair]>::to_vec)).collect()
    }

    /// A pixel and the one a step after it, if a joint lies between them; that of the lower element first.
    fn pair(&self, pixel: usize, step: usize) -> Option<Pair> {
        let other = pixel + step;
        let is_beside = step > 1 || !other.is_multiple_of(self.width);
        let [a, b] = [pixel, other].map(|pixel| self.seen.get(pixel).copied().flatten());
        let (a, b) =
            a.zip(b).filter(|(a, b)| a.place.surface == b.place.surface && a.element != b.element)?;
        let pixels = if a.element < b.element { [pixel, other] } else { [other, pixel] };
        let elements = [a.element.min(b.element), a.element.max(b.element)];
        is_beside.then_some(Pair { pixels, elements, step })
    }
}

/// Two pixels beside each other that see two elements of one surface.
#[derive(Clone, Copy)]
struct Pair {
    pixels: [usize; 2],
    elements: [usize; 2],
    /// Pixels from the one to the other.
    step: usize,
}

/// Largest steps of the error, over the mean radiosity.
struct Joints {
    /// Mean of those along a part of a joint.
    joint: f64,
    /// Between two pixels.
    step: f64,
}

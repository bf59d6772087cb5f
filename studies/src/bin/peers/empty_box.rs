//! The irradiance of the floor of an empty box.

use std::error::Error;
use std::io::Write;

use radiosity::Work;
use radiosity::elements::cells::Layers;
use radiosity::reading::probe::{Probe, probe};
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::Scene;
use radiosity::solve::{Direct, Options, in_threads, solve};
use radiosity_geom::DVec3;

use crate::timed;

/// Cells along each side of the floor.
const CELLS: usize = 16;

/// Mean of the irradiance at the cells' centres, and of the floor, by point-to-quad factors on 6 × 48² cells,
/// extrapolated; good to 2e-5. The mean of the floor to 12 digits is twice its radiosity in
/// tests/data/box_radiosity.json.
const MEASURED_MEANS: [f64; 2] = [0.342683, 0.342438];
const EXACT_MEAN: f64 = 2.0 * 0.1712160424482545;

/// A way to solve the box and to read it.
struct Way {
    order: usize,
    layers: usize,
    ratio: f64,
    eps: f64,
    /// Accuracy of gathered light; polynomials are read where there is none.
    gather: Option<f64>,
}

const WAYS: [Way; 9] = [
    polynomials(2, 0, 0.25, 1e-3),
    polynomials(4, 0, 0.25, 1e-3),
    polynomials(6, 0, 0.25, 1e-3),
    polynomials(8, 0, 0.25, 1e-3),
    Way { gather: Some(1e-6), ..polynomials(7, 0, 0.25, 1e-6) },
    polynomials(4, 1, 0.25, 1e-4),
    polynomials(6, 1, 0.25, 1e-4),
    polynomials(8, 2, 0.25, 1e-6),
    polynomials(8, 3, 0.3, 1e-7),
];
const TRUTH: Way = polynomials(8, 3, 0.35, 1e-7);

const fn polynomials(order: usize, layers: usize, ratio: f64, eps: f64) -> Way {
    Way { order, layers, ratio, eps, gather: None }
}

/// Program, settings, error, seconds, as measured elsewhere.
const PEERS: [[&str; 4]; 9] = [
    ["RenderPark, constant", "link threshold 1e-7", "8.2e-3", "6.7"],
    ["RenderPark, linear", "link threshold 1e-6", "5.6e-3", "0.6"],
    ["RenderPark, linear", "link threshold 1e-7", "2.0e-3", "2.6"],
    ["RenderPark, cubic", "link threshold 1e-6, stalls", "1.1e-2", "0.45"],
    ["Mitsuba 3.9.1, path tracing", "1024 samples a cell", "1.0e-2", "0.31"],
    ["Mitsuba 3.9.1, path tracing", "8192 samples a cell", "4.0e-3", "1.9"],
    ["Mitsuba 3.9.1, path tracing", "by its 1/√n law", "1e-3", "30"],
    ["Radiance (pyradiance 1.3.1)", "-ad 4096, ceiling reflects nothing", "4.0e-3", "6.5"],
    ["Cycles 5.0.1, baked, 2 threads", "4096 samples a texel", "1.1e-2", "2.1"],
];

/// Prints the table.
pub(crate) fn print(out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    let scene = radiosity::builtin("empty-box")?;
    let truth = floor(&scene, &TRUTH)?;
    writeln!(out, "| program | settings | unknowns | error | seconds | |")?;
    writeln!(out, "| --- | --- | --- | --- | --- | --- |")?;
    for way in WAYS {
        let (seconds, found) = timed(|| floor(&scene, &way));
        let found = found?;
        let error = rms(&found.centres, &truth.centres);
        let unknowns = found.unknowns;
        writeln!(
            out,
            "| this | {} | {unknowns} | {error:.1e} | {} | here |",
            settings(&way),
            digits(seconds)
        )?;
    }
    for [program, settings, error, seconds] in PEERS {
        writeln!(out, "| {program} | {settings} | | {error} | {seconds} | measured elsewhere |")?;
    }
    let centres = truth.centres.iter().sum::<f64>() / truth.centres.len() as f64;
    let [measured_centres, measured_mean] = MEASURED_MEANS;
    writeln!(
        out,
        "\nThe truth is {}: mean at the centres {centres:.6} (others: {measured_centres}, to 2e-5), over the floor {:.9} \
         (others: {measured_mean}; exact {EXACT_MEAN:.9}).",
        settings(&TRUTH),
        truth.mean
    )?;
    Ok(())
}

/// Irradiance of the floor.
struct Floor {
    centres: Vec<f64>,
    mean: f64,
    unknowns: usize,
}

fn floor(scene: &Scene, way: &Way) -> Result<Floor, Box<dyn Error>> {
    let options = Options {
        order: way.order,
        subdivide: Some(1),
        layers: Layers { count: way.layers, ratio: way.ratio },
        eps: way.eps,
        tolerance: 1e-3 * way.eps,
        direct: Direct::Projected,
        threads: 1,
        ..Options::default()
    };
    let solution = solve(scene, &options, &Work::alone())?.solution;
    let visibility = options.visibility(scene);
    let read = if way.gather.is_some() { ReadMode::Gather } else { ReadMode::Basis };
    let readings = in_threads(1, || {
        let reader = Reader::new(&solution, &visibility, read, way.gather.unwrap_or(way.eps));
        probe(&reader, &centres(), scene.middle, &Work::alone())
    })?;
    let readings = readings.map_err(|(_, fault)| fault)?;
    Ok(Floor {
        centres: readings.iter().map(|reading| reading.irradiance[0]).collect(),
        mean: solution.mean_irradiance(0, scene.surface_named("floor")?),
        unknowns: solution.elements().coefficients(),
    })
}

/// Centres of the cells of the floor.
fn centres() -> Vec<Probe> {
    let centre = |k: usize| (k as f64 + 0.5) / CELLS as f64;
    let at = |k: usize| DVec3::new(centre(k / CELLS), centre(k % CELLS), 0.0);
    (0..CELLS * CELLS).map(|k| Probe { position: at(k), normal: DVec3::Z }).collect()
}

fn rms(found: &[f64], truth: &[f64]) -> f64 {
    let squares: f64 = found.iter().zip(truth).map(|(a, b)| (a / b - 1.0).powi(2)).sum();
    (squares / truth.len() as f64).sqrt()
}

/// The value with two digits, as text.
fn digits(value: f64) -> String {
    format!("{value:.0$}", (1.0 - value.log10().floor()).max(0.0) as usize)
}

fn settings(way: &Way) -> String {
    let mesh = match way.layers {
        0 => "whole walls".to_owned(),
        1 => format!("1 layer, ratio {}", way.ratio),
        layers => format!("{layers} layers, ratio {}", way.ratio),
    };
    let read = way.gather.map_or(String::new(), |eps| format!(", gathered to {eps:e}"));
    format!("order {}, {mesh}, ε {:e}{read}", way.order, way.eps)
}

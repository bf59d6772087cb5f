//! The furnace at every sensor, and every row of view factors.

use std::fs;
use std::path::Path;

use radiosity::Work;
use radiosity::kernel::Accuracy;
use radiosity::reading::probe::{Probe, ProbeReading, probe};
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::{Scene, Source};
use radiosity::solve::view_factors::{self, ViewFactors};
use radiosity::solve::{Options, solve};
use radiosity_geom::{DVec3, Motion};

use crate::interiors::interior::Interior;
use crate::interiors::sensor::sensors;
use crate::interiors::surface::Surface;
use radiosity_test_support::random::Random;

/// The accuracy of everything, the usual one.
const EPS: f64 = 1e-3;

/// Interiors for each one that has curved things in it: these take ten times as long.
const CURVED: usize = 10;

/// Error that a row may have, over the accuracy asked: it is a sum of some fifty factors. One in two hundred
/// is off by more than once.
const ROW: f64 = 2.0;

/// Error that radiosity may have at a sensor beside three of its own standard deviations, over the accuracy asked.
const FURNACE: f64 = 10.0;

/// Errors that were found in one interior.
struct Found {
    /// Largest |B − 2| over the sensors, and where.
    furnace: f64,
    at: Option<Probe>,
    /// Largest |row − 1| of view factors that is not told, and which.
    row: f64,
    of: String,
}

/// Place of an interior, and rounding of its coordinates.
struct Writing {
    motion: Motion,
    /// Decimals of the coordinates, if they are rounded.
    decimals: Option<i32>,
}

impl Writing {
    fn draw(random: &mut Random) -> Self {
        let choices = [0.0, 0.0, random.between(0.0, 6.0)];
        let angle = random.pick(&choices);
        let axis = random.pick(&[DVec3::Z, DVec3::new(0.6, 0.64, 0.48)]);
        let shift = random.pick(&[DVec3::ZERO, DVec3::new(-3.0, 20.0, 1.0)]);
        let motion = Motion::new(shift, axis, angle, 1.0).expect("a motion");
        Self { motion, decimals: random.pick(&[None, None, Some(6)]) }
    }

    /// Least distance of a sensor from an edge at which it is not moved over it (metres).
    fn least(&self) -> f64 {
        self.decimals.map_or(1e-7, |_| 1e-4)
    }

    fn point(&self, x: DVec3) -> DVec3 {
        let x = self.motion.point(x);
        self.decimals.map_or(x, |decimals| {
            let grain = 10f64.powi(decimals);
            (grain * x).round() / grain
        })
    }

    fn surface(&self, surface: &Surface) -> Surface {
        surface.moved(|x| self.point(x), |x| self.motion.direction(x))
    }

    fn probe(&self, probe: &Probe) -> Probe {
        Probe { position: self.motion.point(probe.position), normal: self.motion.direction(probe.normal) }
    }
}

/// Draws an interior, and looks at it.
fn look(random: &mut Random, case: usize, curved: bool) -> Result<Found, String> {
    let interior = Interior::draw(random, curved);
    let writing = Writing::draw(random);
    let surfaces: Vec<Surface> = interior.surfaces.iter().map(|surface| writing.surface(surface)).collect();
    let text = Interior::text(&surfaces);
    let kept = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("interior-{case}.toml"));
    fs::write(&kept, &text).expect("the scene is kept");
    let scene =
        radiosity::language::read(&Source::new("interior", &text)).map_err(|error| error.to_string())?;
    let count = if curved { 4 } else { 30 };
    let sensors = sensors(random, &interior, count, writing.least());
    let (furnace, at) = furnace(&scene, &writing, &sensors)?;
    let (row, of) = rows(&scene)?;
    Ok(Found { furnace, at, row, of })
}

fn furnace(scene: &Scene, writing: &Writing, sensors: &[Probe]) -> Result<(f64, Option<Probe>), String> {
    let options = Options { eps: EPS, ..Options::default() };
    let outcome = solve(scene, &options, &Work::alone()).map_err(|error| error.to_string())?;
    let visibility = options.visibility(scene);
    let reader = Reader::new(&outcome.solution, &visibility, ReadMode::Gather, 1.25 * EPS);
    let probes: Vec<Probe> = sensors.iter().map(|sensor| writing.probe(sensor)).collect();
    let readings =
        probe(&reader, &probes, scene.middle, &Work::alone()).map_err(|(_, fault)| fault.to_string())?;
    // Readings that rays found anew tell their own standard deviation, which is above the accuracy asked.
    let told = |reading: &ProbeReading| reading.uncertainty.deviation.map_or(0.0, |own| 3.0 * own.relative);
    let off = |reading: &ProbeReading| (0.5 * (reading.irradiance[0] - 2.0).abs() - told(reading)).max(0.0);
    let offs = readings.iter().map(off);
    let worst = offs.zip(&probes).max_by(|a, b| a.0.total_cmp(&b.0));
    Ok(worst.map_or((0.0, None), |(off, probe)| (off, Some(*probe))))
}

fn rows(scene: &Scene) -> Result<(f64, String), String> {
    let options = view_factors::Options {
        accuracy: Accuracy { eps: EPS, shadow_eps: EPS },
        threads: 2,
        ..view_factors::Options::default()
    };
    let factors = ViewFactors::new(scene, &options, &Work::alone()).map_err(|error| error.to_string())?;
    let told = factors.left_in_blocks.max(EPS);
    let offs = factors.row_sums().into_iter().map(|sum| (sum - 1.0).abs() * EPS / told);
    let worst = offs.zip(&factors.names).max_by(|a, b| a.0.total_cmp(&b.0)).expect("a scene has surfaces");
    Ok((worst.0, worst.1.clone()))
}

fn hunt(seed: u64, count: usize) {
    let (mut refused, mut missed) = (0, 0);
    for case in 0..count {
        let mut random = Random(seed + 1_000_003 * case as u64);
        let curved = case % CURVED == CURVED - 1;
        let fault = match look(&mut random, case, curved) {
            Err(message) => {
                refused += 1;
                format!("refused: {message}")
            }
            Ok(Found { furnace, at, row, of }) if furnace > FURNACE * EPS || row > ROW * EPS => {
                missed += 1;
                format!("furnace {furnace:.1e} at {at:?}, row {row:.1e} of {of}")
            }
            Ok(_) => continue,
        };
        println!("interior {case}: {fault}");
    }
    println!("{count} interiors: {missed} missed, {refused} refused");
    assert_eq!((missed, refused), (0, 0));
}

#[test]
fn interiors_are_furnaces_at_every_sensor() {
    hunt(1, 10);
}

#[test]
#[ignore = "a thousand rooms"]
fn interiors_are_furnaces_at_every_sensor_by_the_thousand() {
    hunt(7, 1000);
}

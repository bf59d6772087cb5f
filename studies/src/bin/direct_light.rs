//! Cost and error of the three ways to direct light at sensors: by cells, by shadow volumes with rays where these are
//! too many, and by rays. Beside a sky, also of the light from each of its 145 patches.
//!
//! `cargo run --release -p radiosity-studies --bin direct_light -- studies/scenes/*.toml`
//!
//! The sensors are those of the planes of each scene outside of things; nothing is reflected. Seconds are those of
//! one core, tables once for all sensors included; the error is the root mean square over all sensors over that of
//! what is right: cells at 1e-4.
//!
//! The patches are those of Tregenza (Lighting Research and Technology 19, 1987, 13–14). As many rays go to each
//! part of an opening, and each brings its light to the patch that it comes from; the error is that of all 145
//! together, from two halves of them, over the light of all. By cells, and by shadow volumes, each patch is at least
//! one emitter more: so many seconds as the light of an opening takes, times the patches that a sensor sees, are a
//! lower bound.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::error::Error;

use cpu_time::ProcessTime;
use radiosity::light::direct::DirectLight;
use radiosity::light::penumbra::{Penumbra, RayEffort};
use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::scene::{Radiance, SceneSurface, SensorPlane};
use radiosity::solve::gather::ray_gather::{Beyond, RayGather};
use radiosity::solve::gather::receiver::Receiver;
use radiosity::solve::solution::Solution;
use radiosity::solve::{Options, Transport, solve};
use radiosity::visibility::Visibility;
use radiosity::{Scene, Work};
use radiosity_geom::Ray;

/// Accuracy of what counts as right.
const RIGHT: f64 = 1e-4;

const ACCURACIES: [f64; 3] = [3e-2, 1e-2, 3e-3];

/// A way to direct light.
#[derive(Clone, Copy)]
enum Way {
    Cells,
    ShadowVolumes,
    Rays,
}

impl Way {
    const ALL: [(Self, &'static str); 3] =
        [(Self::Cells, "cells"), (Self::ShadowVolumes, "shadow volumes"), (Self::Rays, "rays")];

    /// The light of the first band at each sensor, and the seconds it took.
    fn read(
        self,
        solution: &Solution,
        visibility: &Visibility,
        sensors: &[ReceiverPoint],
        eps: f64,
    ) -> Reading {
        let start = ProcessTime::now();
        let sources = solution.emitters();
        let light = match self {
            Self::Cells => {
                let light = DirectLight::within(&sources, visibility, eps);
                let at = |own: &ReceiverPoint| light.irradiance(own, &light.around(&own.site()))[0];
                sensors.iter().map(at).collect()
            }
            Self::ShadowVolumes => {
                let light = Penumbra::new(&sources, visibility, eps);
                let at = |own: &ReceiverPoint| {
                    let found = light.estimate(own, None, 0.0, RayEffort { error_factor: 1.0, sure: true });
                    let exitance = &sources.coatings[0].exitance;
                    let of_elements =
                        found.factors.iter().map(|factor| factor.value * exitance[factor.element]);
                    of_elements.sum::<f64>() + found.points[0]
                };
                sensors.iter().map(at).collect()
            }
            Self::Rays => {
                let light = RayGather::new(solution, visibility, eps, Beyond::Polynomials);
                let at = |own: &ReceiverPoint| light.read(&Receiver::Point(*own)).irradiance[0];
                sensors.iter().map(at).collect()
            }
        };
        Reading { light, seconds: start.elapsed().as_secs_f64() }
    }
}

/// Light at all sensors.
struct Reading {
    light: Vec<f64>,
    seconds: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| scene | sensors | way | ε | error % | s | ms a sensor |\n| --- | --- | --- | --- | --- | --- | --- |"
    );
    for name in std::env::args().skip(1) {
        let scene = radiosity::load(&name)?;
        let options = Options { bounces: Some(0), transport: Transport::Sampled, ..Options::default() };
        let solution = solve(&scene, &options, &Work::alone())?.solution;
        let visibility = options.visibility(&scene);
        let sensors = sensors(&scene, &visibility);
        let right = Way::Cells.read(&solution, &visibility, &sensors, RIGHT);
        row(&name, sensors.len(), "cells", RIGHT, 0.0, right.seconds);
        for (way, words) in Way::ALL {
            for eps in ACCURACIES {
                let found = way.read(&solution, &visibility, &sensors, eps);
                row(&name, sensors.len(), words, eps, error(&found.light, &right.light), found.seconds);
            }
        }
        let is_opening = |own: &SceneSurface| own.radiance.as_ref().is_some_and(Radiance::is_of_opening);
        if scene.surfaces.iter().any(is_opening) {
            patches::rows(&name, &solution, &visibility, &sensors);
        }
    }
    Ok(())
}

/// The sensors of all planes of a scene but those inside of things.
fn sensors(scene: &Scene, visibility: &Visibility) -> Vec<ReceiverPoint> {
    let is_outside = |own: &ReceiverPoint| {
        let met = visibility.nearest(&Ray::new(own.position, own.normal));
        met.is_none_or(|met| met.front)
    };
    let of_plane = |plane: &SensorPlane| {
        let normal = plane.normal();
        let at = |point| ReceiverPoint::free(point - scene.middle, normal);
        plane.sensors().map(at).filter(is_outside).collect::<Vec<_>>()
    };
    scene.planes.iter().flat_map(of_plane).collect()
}

/// Root mean square of the errors over that of the light.
fn error(found: &[f64], right: &[f64]) -> f64 {
    let square: f64 = found.iter().zip(right).map(|(found, right)| (found - right).powi(2)).sum();
    (square / right.iter().map(|right| right * right).sum::<f64>()).sqrt()
}

fn row(scene: &str, sensors: usize, way: &str, eps: f64, error: f64, seconds: f64) {
    let scene = std::path::Path::new(scene).file_stem().map_or(scene.into(), |stem| stem.to_string_lossy());
    let each = 1e3 * seconds / sensors as f64;
    println!("| {scene} | {sensors} | {way} | {eps:.0e} | {:.2} | {seconds:.2} | {each:.2} |", 100.0 * error);
}

/// Light of each patch of a sky.
mod patches {
    use std::f64::consts::PI;

    use cpu_time::ProcessTime;
    use radiosity::light::receiver_point::ReceiverPoint;
    use radiosity::solve::solution::Solution;
    use radiosity::visibility::Visibility;
    use radiosity_geom::DVec3;
    use radiosity_test_support::random::Random;

    /// Patches in the rows of 12°, from the horizon up.
    const ROWS: [usize; 8] = [30, 30, 24, 24, 18, 12, 6, 1];
    const PATCHES: usize = 145;

    /// Rays of a sensor in each half.
    const RAYS: [usize; 3] = [100, 1000, 10_000];

    /// The patch that a unit direction comes from; None below the horizon.
    fn patch(direction: DVec3) -> Option<usize> {
        let row = ((direction.z.asin().to_degrees() / 12.0).floor() as usize).min(7);
        let turn = (direction.y.atan2(direction.x) / (2.0 * PI)).rem_euclid(1.0);
        let own = (turn * ROWS[row] as f64) as usize;
        (direction.z > 0.0).then(|| ROWS[..row].iter().sum::<usize>() + own.min(ROWS[row] - 1))
    }

    /// Irradiance at a sensor from each patch of radiance 1, through the openings of a solution, by so many rays.
    fn light(
        solution: &Solution,
        visibility: &Visibility,
        sensor: &ReceiverPoint,
        rays: usize,
        random: &mut Random,
    ) -> Vec<f64> {
        let mut sums = vec![0.0; PATCHES];
        let emits = |index: &usize| solution.coatings()[0].exitance[*index] > 0.0;
        for element in (0..solution.elements().list().len())
            .filter(emits)
            .map(|index| &solution.elements().list()[index])
        {
            for patch_of in &element.patches {
                for ray in 0..rays {
                    let [s, t] =
                        [(ray as f64 + random.between(0.0, 1.0)) / rays as f64, random.between(0.0, 1.0)];
                    let node = patch_of.node(s, t);
                    let Some(kernel) = sensor.kernel_to(&node) else { continue };
                    let direction = (node.position - sensor.position).normalize();
                    let Some(patch) = patch(direction) else { continue };
                    if visibility.is_free(sensor.surface, sensor.position, node.position) {
                        sums[patch] += PI * kernel * node.area / rays as f64;
                    }
                }
            }
        }
        sums
    }

    /// Prints cost and error of the light of all patches through the openings.
    pub(super) fn rows(scene: &str, solution: &Solution, visibility: &Visibility, sensors: &[ReceiverPoint]) {
        let random = &mut Random(7);
        for rays in RAYS {
            let start = ProcessTime::now();
            let [mut off, mut all] = [0.0; 2];
            for sensor in sensors {
                let [a, b] = [(); 2].map(|()| light(solution, visibility, sensor, rays, random));
                off += a.iter().zip(&b).map(|(a, b)| (0.5 * (a - b)).powi(2)).sum::<f64>();
                all += (0.5 * (a.iter().sum::<f64>() + b.iter().sum::<f64>())).powi(2);
            }
            let seconds = start.elapsed().as_secs_f64();
            super::row(
                scene,
                sensors.len(),
                &format!("145 patches, {} rays", 2 * rays),
                0.0,
                (off / all).sqrt(),
                seconds,
            );
        }
    }
}

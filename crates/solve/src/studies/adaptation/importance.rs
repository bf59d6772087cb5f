//! Importance: how much light that leaves a place is worth to what is read.
//!
//! What is read is a weighted mean J = Σ_k w_k E(x_k), Σ_k w_k = 1, of the irradiance at sensors. It is
//! linear in the exitance E₀ of all surfaces,
//!
//! ```text
//! J = ∫ Ψ(y) E₀(y) dA_y ,     Ψ = G σ ,     σ = Σ_k w_k δ_{x_k} + ρ G σ        (Ψ in 1/area),
//! ```
//!
//! so that Ψ is the irradiance that there would be if the sensors were the lamps: G is symmetric (B. Smits,
//! J. Arvo, D. Salesin, *An importance-driven radiosity algorithm*, SIGGRAPH 1992).
//! [Walks](crate::gather::walks) from the sensors end with the density Ψ; its mean over an element is the sum
//! of the weights of the ends there over the area. Polynomials would oscillate beside sensors that are nearer
//! than an element is large.

use radiosity_elements::Elements;
use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::shift::{number_of, shift, shifted};
use radiosity_visibility::Visibility;
use radiosity_work::ranks::{PartName, Ranks};

use crate::driver::{Failure, in_threads};
use crate::gather::walks::Walks;
use crate::solution::{Band, Solution};
use crate::system::Coefficients;

use super::sensor::Sensor;
use crate::goal::Goal;

/// Walks in all, at the least, and fewest from each sensor. Chosen: 2 % of noise in the mean over a
/// thousandth of all surfaces.
const WALKS: u64 = 1 << 21;
const FEWEST: u64 = 16;

/// Parts of the sensors that are worked on beside each other; each has a sum of its own, so that threads
/// change no digit.
const PARTS: usize = 16;

/// The importance of light from each element for what `goal` reads, its mean as irradiance of a solution on
/// the same elements, in 1/area; nothing emits there. Of surfaces the mean is read over what they reflect,
/// weighted by the squares of reflectances.
///
/// # Errors
/// Threads that cannot be started.
pub fn importance(
    solution: &Solution,
    visibility: &Visibility,
    goal: &Goal,
    threads: usize,
    ranks: &Ranks,
) -> Result<Solution, Failure> {
    in_threads(ranks.threads(threads), || {
        let sensors = Sensor::of(goal, solution, visibility);
        of_sensors(solution, visibility, &sensors, WALKS, ranks)
    })
}

fn of_sensors(
    solution: &Solution,
    visibility: &Visibility,
    sensors: &[Sensor],
    walks: u64,
    ranks: &Ranks,
) -> Solution {
    let sizes: Vec<f64> = (0..solution.bands().len())
        .map(|band| sensors.iter().map(|sensor| sensor.weights[band]).sum())
        .collect();
    let each = walks.div_ceil(sensors.len().max(1) as u64).max(FEWEST);
    let ends = Ends { solution, walks: Walks::new(solution, visibility), sizes, each };
    let in_part = sensors.len().div_ceil(PARTS).max(1);
    let parts: Vec<&[Sensor]> = sensors.chunks(in_part).collect();
    let lengths: Vec<f64> = parts.iter().map(|part| part.len() as f64).collect();
    let parts = ranks.map(PartName::Importance, &lengths, |number| ends.of_part(number, parts[number]));
    let elements = solution.elements();
    let bands = solution.bands().iter().enumerate().map(|(index, band)| {
        let sum = |element: usize| parts.iter().map(|part| part[index][element]).sum();
        let sums: Vec<f64> = (0..elements.list().len()).map(sum).collect();
        unlit(band, elements, &sums)
    });
    solution.with_bands(bands.collect())
}

/// A band with the irradiance that has these integrals over the elements, constant on each, where nothing
/// emits.
fn unlit(band: &Band, elements: &Elements, integrals: &[f64]) -> Band {
    let mut irradiance = vec![0.0; elements.coefficients()];
    for ((element, start), integral) in elements.list().iter().zip(elements.starts()).zip(integrals) {
        // The first function of the basis is 1/√A.
        irradiance[start] = integral / element.area.sqrt();
    }
    let coating = band.coating.clone().unlit();
    let direct = vec![0.0; irradiance.len()];
    let coefficients = Coefficients::of_irradiance(elements.list(), &coating, irradiance, direct, 0.0);
    Band::new(band.name.clone(), elements, coating, coefficients)
}

/// The data with which the ends of walks are summed.
struct Ends<'a> {
    solution: &'a Solution,
    walks: Walks<'a>,
    /// Sum of the sensors' weights, per band.
    sizes: Vec<f64>,
    /// Walks from each sensor.
    each: u64,
}

impl Ends<'_> {
    /// Sums of weights over the ends of walks from some of the sensors, for each band element by element.
    fn of_part(&self, number: usize, sensors: &[Sensor]) -> Vec<Vec<f64>> {
        let mut sums = vec![vec![0.0; self.solution.elements().list().len()]; self.sizes.len()];
        for (index, sensor) in sensors.iter().enumerate() {
            let own = number_of([number as f64, index as f64]);
            let offset: [f64; 2] = shift(own);
            let shares = sensor.weights.iter().zip(&self.sizes);
            let shares: Vec<f64> = shares
                .map(|(weight, size)| weight / (size.max(f64::MIN_POSITIVE) * self.each as f64))
                .collect();
            for walk in 0..self.each {
                let direction = shifted(kronecker::point(walk), &offset);
                let chance = number_of([f64::from_bits(own), walk as f64]);
                self.walks.walk(sensor.point, direction, chance, &mut |end, weights| {
                    let found = weights.iter().zip(&shares).zip(&mut sums);
                    found.for_each(|((weight, share), sums)| sums[end.element] += weight * share);
                });
            }
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use radiosity_light::receiver_point::ReceiverPoint;
    use radiosity_scene::Scene;
    use radiosity_work::Work;

    use super::*;
    use crate::driver::{Options, solve};
    use crate::gather::Gather;
    use crate::gather::lune::Lune;
    use crate::gather::read_irradiance::ReadIrradiance;
    use crate::goal::Aim;

    /// J by importance and by reading, for some sensors of the Cornell box, upright and tilted.
    #[test]
    fn importance_times_exitance_is_what_is_read() {
        let scene = radiosity_language::builtin("cornell-box").expect("it is built in");
        let options = Options { order: 2, ..Options::default() };
        let solution = solve(&scene, &options, &Work::alone()).expect("a solution").solution;
        let visibility = options.visibility(&scene);
        let mut sensors = Sensor::of(&Goal::new(1e-2, Aim::Gathered), &solution, &visibility);
        sensors.retain(|sensor| sensor.point.position.z > 0.0);
        let tilted = |sensor: &Sensor| {
            let ReceiverPoint { position, normal, .. } = sensor.point;
            [position, (normal + 2.0 * normal.any_orthonormal_vector()).normalize()]
        };
        let points = sensors.iter().step_by(4).map(tilted).collect();
        let goal = Goal { points, ..Goal::new(1e-2, Aim::Points) };
        for sensors in [sensors, Sensor::of(&goal, &solution, &visibility)] {
            assert_equal(&scene, &solution, &visibility, &sensors);
        }
    }

    /// That the exitance of surfaces times its importance is the light that sensors read.
    fn assert_equal(scene: &Scene, solution: &Solution, visibility: &Visibility, sensors: &[Sensor]) {
        let worth = of_sensors(solution, visibility, sensors, 1 << 21, Ranks::alone());
        let gather = Gather::new(solution, visibility, 1e-3);
        let light = |sensor: &Sensor| {
            let own =
                Lune::of(&sensor.point, solution.elements()).map(|lune| lune.polynomial_light(solution));
            ReadIrradiance::from(gather.at(&sensor.point)).with(&own.unwrap_or_default()).irradiance
        };
        let light: Vec<Vec<f64>> = sensors.iter().map(light).collect();
        for band in 0..3 {
            let size: f64 = sensors.iter().map(|sensor| sensor.weights[band]).sum();
            let read = sensors.iter().zip(&light).map(|(sensor, light)| sensor.weights[band] * light[band]);
            let read = read.sum::<f64>() / size;
            let found: f64 = (0..scene.surfaces.len())
                .map(|surface| {
                    let own = &scene.surfaces[surface];
                    worth.mean_irradiance(band, surface) * own.shape.area() * own.exitance(band)
                })
                .sum();
            assert!((found / read - 1.0).abs() < 0.015, "band {band}: {found} and {read}");
        }
    }
}

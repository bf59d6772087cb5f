//! Error of gathered light.
//!
//! Light that is gathered from a solution with the polynomials S_h of its reflected light,
//!
//! ```text
//! E_g = D + G ρ (D + S_h) ,     (G f)(x) = ∫ κ(x, y) V(x, y) f(y) dA_y ,
//! ```
//!
//! D the direct light, misses the light E that would be right by e = E − E_g. Since E = D + Gρ E, and
//! S_g = E_g − D is gathered reflected light,
//!
//! ```text
//! e = d + G ρ e ,     d = G ρ r ,     r = S_g − S_h ,     so     e = G ρ r + G ρ G ρ r + … .
//! ```
//!
//! e is estimated at sensors by walks: cosine-distributed rays from the sensor and on from where they end,
//! with the probability of the largest reflectance there. Each end y adds r(y) times the reflectances so far
//! over these probabilities. r is gathered by cells ([`CellEnds`]). Two halves of the walks give e′ and e″,
//! independent of each other: the mean of their product is e², that of a square would have the noise of the
//! walks as well. With weights w_k of the sensors,
//!
//! ```text
//! ‖e‖² ≈ Σ_k w_k e′e″ + s ,     s² = Σ_k (w_k e′e″)² ,
//! ```
//!
//! s so that few sensors do not promise too much. Walks are doubled while their noise is much of the sum. The part
//! e_j of e that comes from ends on element j makes it responsible for ½ Σ_k w_k (e′e″_j + e′_j e″) of ‖e‖²: this is
//! the importance that light from j has for the sensors, all reflections included.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::shift::{number_of, shift, shifted};
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_visibility::Visibility;
use radiosity_work::ranks::{PartName, shares};
use radiosity_work::{Stage, Work};
use serde::{Deserialize, Serialize};

use super::sensor::Sensor;
use crate::gather::Gather;
use crate::gather::lune::Lune;
use crate::gather::read_irradiance::ReadIrradiance;
use crate::gather::walks::{SendingSide, WalkEnd, Walks};
use crate::solution::{Band, Solution};
use crate::solved::Solved;
use crate::tolerances::{LOOSEST_FOR_GATHERED, OF_ERROR};

/// Walks in all that are made first, and the most where the estimate is noisy; the fewest per half and sensor: of
/// one there is no noise to be seen. Chosen: with four times the first number the estimates of boxes changed by 5 %;
/// in small scenes a finer run costs less than many of these.
const FIRST: u64 = 1 << 12;
const MOST: u64 = 1 << 14;
const FEWEST: u64 = 2;

/// Rounds in which so many walks are made. Chosen: a deadline passes by a tenth of their time at the most.
const ROUNDS: u64 = 10;

/// Part of the estimate that the noise of walks may be: an error is then known to a factor of √1.5. With a
/// smaller value walks take longer than a run.
const NOISE: f64 = 0.5;

/// Ends of walks for each one that gathers to an accuracy that is finer by the part of light that the
/// surfaces absorb, since walks sum up their ends, while the others gather to a coarser one than was asked
/// for. Chosen: with 1 and 4 the Cornell box to 3e-3 took 1.8 times as long.
const ONE_IN: f64 = 8.0;
const COARSER: f64 = 3.0;
const LEAST_ABSORBED: f64 = 0.05;

/// An estimated error of gathered light.
#[derive(Debug)]
pub(super) struct ErrorEstimate {
    /// ‖e‖ / ‖E_g‖ over the sensors, all bands pooled; 0 without sensors, infinite where light is
    /// missed and none is gathered.
    pub error: f64,
    /// Part of the square of `error` that each element is responsible for; noise makes some negative.
    pub shares: Vec<f64>,
}

/// The light that walks from one sensor found.
struct SensorWalks<'a> {
    sensor: &'a Sensor,
    number: u64,
    light: SensorLight,
}

/// The light that was found at a sensor.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct SensorLight {
    /// Irradiance that was gathered at the sensor (W m⁻²), per band.
    gathered: Vec<f64>,
    /// Sum of the light that each half of the walks found at each element, per band (W m⁻²).
    parts: BTreeMap<usize, [Vec<f64>; 2]>,
}

/// Light gathered by cells where rays end: coarsely, and at one end in [`ONE_IN`] finely as well, whose
/// difference counts so many times. The mean is that of the fine values (Heinrich, Giles: multilevel Monte
/// Carlo).
struct CellEnds<'a> {
    solution: &'a Solution,
    gather: Gather<'a>,
    coarse: f64,
}

impl<'a> CellEnds<'a> {
    /// Gathering for sums over walks to about the relative accuracy `eps`.
    fn new(solution: &'a Solution, visibility: &'a Visibility, eps: f64) -> Self {
        let absorbed = (1.0 - mean_reflectance(solution)).max(LEAST_ABSORBED);
        Self { solution, gather: Gather::new(solution, visibility, absorbed * eps), coarse: COARSER * eps }
    }

    /// Light that a receiver gathers, that of the surface under a tilted one with it (W m⁻² per band).
    fn gathered(&self, receiver: &ReceiverPoint) -> Vec<f64> {
        let light = ReadIrradiance::from(self.gather.at(receiver));
        let solution = self.solution;
        let lune = Lune::of(receiver, solution.elements()).map(|lune| lune.polynomial_light(solution));
        light.with(&lune.unwrap_or_default()).irradiance
    }

    /// Reflected light per band where a walk ends, beside `other` light.
    fn reflected(&self, there: &ReceiverPoint, other: &[f64], chance: u64) -> Vec<f64> {
        let reflection = self.gather.reflection();
        let around = reflection.around(&there.site());
        let mut light = reflection.irradiance_within(self.coarse, there, &around, other);
        let [dice]: [f64; 1] = shift(number_of([f64::from_bits(chance), 3.0]));
        if dice * ONE_IN < 1.0 {
            let fine = reflection.irradiance(there, &around, other);
            light.iter_mut().zip(fine).for_each(|(light, fine)| *light += ONE_IN * (fine - *light));
        }
        light
    }
}

/// Mean over the surfaces, by area, of the largest reflectance of the bands.
fn mean_reflectance(solution: &Solution) -> f64 {
    let elements = solution.elements().list().iter();
    let largest = |index: usize| {
        let sent = |band: &Band| band.coating.reflectance[index] + band.coating.transmittance(index);
        solution.bands().iter().map(sent).fold(0.0, f64::max)
    };
    let [reflected, area] = elements.enumerate().fold([0.0; 2], |[reflected, area], (index, element)| {
        [reflected + largest(index) * element.area, area + element.area]
    });
    reflected / area
}

/// The solution that misses light, and how its light is gathered.
struct MissedLight<'a> {
    solution: &'a Solution,
    walks: Walks<'a>,
    ends: CellEnds<'a>,
}

/// The estimated error of what `sensors` read, of light gathered as an error of about `expected` needs it, until the
/// deadline.
pub(super) fn error_estimate(
    run: &Solved,
    sensors: &[Sensor],
    expected: f64,
    work: &Work<'_>,
) -> ErrorEstimate {
    let solution = &run.outcome.solution;
    let unknowns = solution.elements().coefficients();
    let missed_light = MissedLight::of(run, (OF_ERROR * expected).min(LOOSEST_FOR_GATHERED));
    let ranks = work.ranks;
    let makers = shares::by_cost(&vec![1.0; sensors.len()], ranks.count());
    let gathered = ranks
        .map_by(PartName::SensorLight, &makers, |place| missed_light.ends.gathered(&sensors[place].point));
    let mut found = SensorWalks::begun(sensors, gathered, unknowns);
    let per_half = |walks: u64| walks.div_ceil(2 * sensors.len().max(1) as u64);
    let (mut made, mut wanted) = (0, per_half(FIRST).max(FEWEST));
    loop {
        // A few at a time: what is late is found after each.
        let now = (wanted - made).min(wanted.div_ceil(ROUNDS)).max(FEWEST.min(wanted - made));
        let (done, is_late) = (AtomicUsize::new(0), AtomicBool::new(false));
        let light = ranks.map_by(PartName::SensorWalks, &makers, |place| {
            let light = missed_light.walked(&found[place], made..made + now);
            let new = (done.fetch_add(1, Ordering::Relaxed) + 1) * now as usize;
            let (walks, all) = (made as usize * sensors.len() + new, wanted as usize * sensors.len());
            work.report_done(Stage::Estimate, walks, all);
            if work.is_late_here() {
                is_late.store(true, Ordering::Relaxed);
            }
            light
        });
        found.iter_mut().zip(light).for_each(|(found, light)| found.light = light);
        let finishes = !ranks.any(is_late.into_inner());
        made += now;
        if finishes && made < wanted {
            continue;
        }
        let sums = SensorSums::of(&found, made, solution);
        if !finishes || !sums.is_noisy() || 2 * made > per_half(MOST) {
            return ErrorEstimate { error: sums.error(), shares: sums.shares(&found, made) };
        }
        wanted = 2 * made;
    }
}

impl<'a> MissedLight<'a> {
    fn of(run: &'a Solved, eps: f64) -> Self {
        let (solution, visibility) = (&run.outcome.solution, run.visibility());
        let ends = CellEnds::new(solution, visibility, eps);
        Self { solution, walks: Walks::new(solution, visibility), ends }
    }

    /// The light that was found at a sensor, and that of the walks of these numbers of each half.
    fn walked(&self, found: &SensorWalks, walks: Range<u64>) -> SensorLight {
        let mut light = found.light.clone();
        for half in 0..2 {
            let number = found.number.wrapping_add(half);
            let offset: [f64; 2] = shift(number);
            for walk in walks.clone() {
                let direction = shifted(kronecker::point(walk), &offset);
                let chance = number_of([f64::from_bits(number), walk as f64]);
                self.walk_once(found.sensor, &mut light, half as usize, direction, chance);
            }
        }
        light
    }

    /// Adds what one walk of this half finds.
    fn walk_once(
        &self,
        sensor: &Sensor,
        light: &mut SensorLight,
        half: usize,
        direction: [f64; 2],
        chance: u64,
    ) {
        self.walks.walk(sensor.point, direction, chance, &mut |end, weights| {
            if end.lit.brightest() == 0.0 {
                return;
            }
            let missed = self.missed(end);
            let none = || [vec![0.0; weights.len()], vec![0.0; weights.len()]];
            let sums = &mut light.parts.entry(end.lit.element).or_insert_with(none)[half];
            let reflected = weights.iter().zip(&end.lit.factors);
            sums.iter_mut()
                .zip(reflected)
                .zip(missed)
                .for_each(|((sum, (weight, factor)), missed)| *sum += weight * factor * missed);
        });
    }

    /// r per band of the light that is sent on where a walk ends.
    fn missed(&self, end: &WalkEnd) -> Vec<f64> {
        let SendingSide { element, ref place, ref there, .. } = end.lit;
        let mut held = vec![0.0; self.solution.bands().len()];
        self.solution.irradiance_bands(element, place, &mut held);
        let mut missed = self.ends.reflected(there, &held, end.chance);
        self.solution.indirect_bands(element, place, &mut held);
        missed.iter_mut().zip(held).for_each(|(missed, held)| *missed -= held.max(0.0));
        missed
    }
}

impl<'a> SensorWalks<'a> {
    /// The light of sensors before walks: irradiance `gathered` at each (W m⁻²), per band.
    fn begun(sensors: &'a [Sensor], gathered: Vec<Vec<f64>>, unknowns: usize) -> Vec<Self> {
        let begin = |(number, (sensor, gathered))| {
            Self::new(sensor, number_of([number as f64, unknowns as f64]), gathered)
        };
        sensors.iter().zip(gathered).enumerate().map(begin).collect()
    }

    fn new(sensor: &'a Sensor, number: u64, gathered: Vec<f64>) -> Self {
        Self { sensor, number, light: SensorLight { gathered, parts: BTreeMap::new() } }
    }

    /// e by each half of so many walks, per band.
    fn halves(&self, walks: u64) -> [Vec<f64>; 2] {
        [0, 1].map(|half| {
            let mut sums = vec![0.0; self.light.gathered.len()];
            for part in self.light.parts.values() {
                sums.iter_mut().zip(&part[half]).for_each(|(sum, own)| *sum += own / walks as f64);
            }
            sums
        })
    }
}

/// Sums over sensors and bands.
struct SensorSums {
    /// Σ w e′e″, and s.
    product: f64,
    deviation: f64,
    /// About the standard deviation of the former that is due to the walks.
    noise: f64,
    /// Σ w E_g².
    size: f64,
    elements: usize,
}

impl SensorSums {
    fn of(found: &[SensorWalks], walks: u64, solution: &Solution) -> Self {
        let mut sums = Self {
            product: 0.0,
            deviation: 0.0,
            noise: 0.0,
            size: 0.0,
            elements: solution.elements().list().len(),
        };
        for found in found {
            let [first, second] = found.halves(walks);
            let bands = first.iter().zip(&second).zip(&found.sensor.weights);
            let product: f64 = bands.clone().map(|((a, b), weight)| weight * a * b).sum();
            let noise: f64 = bands.map(|((a, b), weight)| 0.5 * weight * (a - b).powi(2)).sum();
            let light = found.light.gathered.iter().zip(&found.sensor.weights);
            sums.product += product;
            sums.deviation += product.powi(2);
            sums.noise += noise.powi(2);
            sums.size += light.map(|(light, weight)| weight * light.powi(2)).sum::<f64>();
        }
        Self { deviation: sums.deviation.sqrt(), noise: sums.noise.sqrt(), ..sums }
    }

    fn missed(&self) -> f64 {
        self.product.max(0.0) + self.deviation
    }

    fn error(&self) -> f64 {
        match self.size {
            size if size > 0.0 => (self.missed() / size).sqrt(),
            _ if self.missed() > 0.0 => f64::INFINITY,
            _ => 0.0,
        }
    }

    fn is_noisy(&self) -> bool {
        self.noise > NOISE * self.missed()
    }

    /// Part of the square of the error that each element is responsible for.
    fn shares(&self, found: &[SensorWalks], walks: u64) -> Vec<f64> {
        let mut shares = vec![0.0; self.elements];
        for found in found {
            let halves = found.halves(walks);
            for (element, parts) in &found.light.parts {
                for half in 0..2 {
                    let bands = halves[half].iter().zip(&parts[1 - half]).zip(&found.sensor.weights);
                    let own: f64 = bands.map(|((e, part), weight)| weight * e * part).sum();
                    shares[*element] += 0.5 * own / walks as f64 / self.size.max(f64::MIN_POSITIVE);
                }
            }
        }
        shares
    }
}

#[cfg(test)]
mod tests {
    use std::time::Instant;

    use radiosity_work::{Deadline, Progress};

    use super::*;
    use crate::driver::Options;
    use crate::goal::{Aim, Goal};

    /// The error of gathered light in the Cornell box, and the part of the walks that were made of those that were
    /// wanted first.
    fn estimated(run: &Solved, sensors: &[Sensor], deadline: Option<&Deadline>) -> (ErrorEstimate, f64) {
        let (made, wanted) = (AtomicUsize::new(0), AtomicUsize::new(usize::MAX));
        let observer = |progress: Progress| {
            if let Progress::Done { stage: Stage::Estimate, done, of } = progress {
                made.fetch_max(done, Ordering::Relaxed);
                wanted.fetch_min(of, Ordering::Relaxed);
            }
        };
        let work = Work { deadline, ..Work::alone().observed_by(&observer) };
        let found = error_estimate(run, sensors, 1e-2, &work);
        (found, made.into_inner() as f64 / wanted.into_inner() as f64)
    }

    #[test]
    fn an_estimate_whose_time_is_up_ends_after_its_first_walks() {
        let scene = radiosity_language::builtin("cornell-box").expect("it is built in");
        let options = Options { order: 1, ..Options::default() };
        let run = Solved::new(scene, options, &Work::alone()).expect("a solution");
        let mut sensors =
            Sensor::of(&Goal::new(1e-2, Aim::Gathered), &run.outcome.solution, run.visibility());
        // Of few sensors each has walks enough for all rounds.
        sensors.truncate(8);
        let (whole, all) = estimated(&run, &sensors, None);
        let past = Deadline::at(Some(Instant::now()));
        let (early, part) = estimated(&run, &sensors, Some(&past));
        assert!(all >= 1.0 && part > 0.0 && part < 2.0 / ROUNDS as f64, "{all} {part}");
        assert!(early.error.is_finite() && early.error > 0.0 && whole.error > 0.0, "{early:?}");
    }
}

//! Whether means lie about what is exact as their errors tell.
//!
//! With eight moves of the lattice t = (M − exact)/s has Student's distribution of 7 degrees of freedom, and
//! t² has F(1, 7): its mean is 7/5 and its variance 2 · 7² · 6 / (5² · 3) = 7.84. What is too large
//! everywhere shows in the mean of t times the sign of what is exact, whose variance is 7/5 for each.

use radiosity::Work;
use radiosity::audit::{Effort, HeatEstimate, HeatReferee, Mean};
use radiosity::scene::Scene;
use radiosity_test_support::scenes::typed;

/// Mean and standard deviation of F(1, 7).
const MEAN: f64 = 1.4;
const DEVIATION: f64 = 2.8;

/// |t| that is exceeded by chance once in 50 000.
const RARE: f64 = 10.0;

/// Part of the exact number, and of 1, below which a difference is rounding.
const ROUNDING: f64 = 1e-9;

/// Standard errors at which a fault counts as seen.
pub(super) const SEEN: f64 = 5.0;

/// Means beside what is exact.
#[derive(Default)]
pub(super) struct Scored {
    excesses: Vec<f64>,
}

impl Scored {
    pub(super) fn add(&mut self, name: &str, mean: &Mean, exact: f64) {
        let off = mean.value - exact;
        if off.abs() <= ROUNDING * exact.abs().max(1.0) {
            return;
        }
        let t = off / mean.error;
        assert!(t.abs() < RARE, "{name}: {} ± {} for {exact}, t = {t}", mean.value, mean.error);
        self.excesses.push(t * exact.signum());
    }

    /// Checks that at least `least` means have noise, and that this is what they tell: the mean of t² is 7/5
    /// within four of its standard deviations, and that of t is 0.
    #[track_caller]
    pub(super) fn check(&self, least: usize) {
        let count = self.excesses.len();
        assert!(count >= least, "{count} means have noise");
        let mean = |power: i32| self.excesses.iter().map(|t| t.powi(power)).sum::<f64>() / count as f64;
        let root = (count as f64).sqrt();
        let [one, two] = [4.0 * MEAN.sqrt() / root, 4.0 * DEVIATION / root];
        assert!(mean(1).abs() < one, "t of {count} means: {} for 0 ± {one}", mean(1));
        assert!((mean(2) - MEAN).abs() < two, "t² of {count} means: {} for {MEAN} ± {two}", mean(2));
    }
}

/// By how many standard errors a mean differs from a number.
pub(super) fn apart(mean: &Mean, number: f64) -> f64 {
    (mean.value - number).abs() / mean.error
}

/// The heat of all surfaces of a scene.
pub(super) fn heat(text: &str, walks: f64, seed: u64) -> Vec<(String, HeatEstimate)> {
    let scene = typed(text);
    let all: Vec<usize> = (0..scene.surfaces.len()).collect();
    let estimates = estimates(&scene, &all, walks, seed);
    estimates.into_iter().map(|own| (scene.surfaces[own.surface].name.clone(), own)).collect()
}

/// The heat of one surface of a scene.
pub(super) fn heat_of(name: &str, text: &str, walks: f64, seed: u64) -> HeatEstimate {
    let scene = typed(text);
    let surface = scene.surface_named(name).unwrap_or_else(|error| panic!("{error}"));
    estimates(&scene, &[surface], walks, seed)[0]
}

fn estimates(scene: &Scene, surfaces: &[usize], walks: f64, seed: u64) -> Vec<HeatEstimate> {
    let referee = HeatReferee::of(scene).unwrap_or_else(|fault| panic!("{fault}: {}", fault.cure()));
    referee.estimates(surfaces, &Effort::of_walks(walks).seeded(seed), &Work::alone())
}

/// The heat of the surface of that name.
#[track_caller]
pub(super) fn of<'a>(all: &'a [(String, HeatEstimate)], name: &str) -> &'a HeatEstimate {
    &all.iter().find(|(own, _)| own == name).unwrap_or_else(|| panic!("no surface {name}")).1
}

/// σ T⁴ (W m⁻²).
pub(super) fn level(kelvin: f64) -> f64 {
    5.670_374_419e-8 * kelvin.powi(4)
}

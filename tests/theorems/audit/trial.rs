//! Readings of the referee whose right values are known.

use radiosity::audit::{Effort, Estimate, Referee, Spot};
use radiosity::{Scene, Work};
use radiosity_geom::{DVec3, Rect};

/// Standard errors, relative to the right value, below which a reading has no noise: it must be right to
/// [`EXACT`].
const NOISELESS: f64 = 1e-9;

/// Relative error of readings without noise: where rays start is 1e-7 of the scene away.
const EXACT: f64 = 1e-6;

/// A scene with places that are read in it.
pub(super) struct Trial {
    name: String,
    pub(super) scene: Scene,
    pub(super) spots: Vec<Spot>,
    /// The right value of each place, in each band.
    pub(super) exact: Vec<Vec<f64>>,
}

impl Trial {
    pub(super) fn of(name: impl Into<String>, scene: Scene) -> Self {
        Self { name: name.into(), scene, spots: Vec::new(), exact: Vec::new() }
    }

    /// Adds a place.
    pub(super) fn spot(mut self, spot: Spot, exact: &[f64]) -> Self {
        self.spots.push(spot);
        self.exact.push(exact.to_vec());
        self
    }

    /// Adds a point, in the coordinates of the scene's text.
    pub(super) fn point(self, position: DVec3, normal: DVec3, exact: f64) -> Self {
        let position = position - self.scene.middle;
        self.spot(Spot::Point { position, normal: normal.normalize() }, &[exact])
    }

    /// Adds all surfaces, parts of them, and about so many points on them, which all receive `exact`.
    pub(super) fn everywhere(mut self, points: usize, exact: &[f64]) -> Self {
        let part = |u: [f64; 2], v: [f64; 2]| Rect { u, v };
        for surface in 0..self.scene.surfaces.len() {
            self = self.spot(Spot::Surface(surface), exact);
            for rect in [part([-0.9, -0.2], [-0.3, 0.5]), part([-0.1, 0.4], [-0.2, 0.9])] {
                self = self.spot(Spot::Cell { surface, rect }, exact);
            }
        }
        let sample = Referee::of_light(&self.scene).sample(points, 0);
        sample.into_iter().fold(self, |own, point| own.spot(point.spot, exact))
    }

    /// Estimates of the referee.
    pub(super) fn estimates(&self, walks: f64, seed: u64) -> Vec<Estimate> {
        let effort = Effort::of_walks(walks).seeded(seed);
        Referee::of_light(&self.scene).estimates(&self.spots, &effort, &Work::alone())
    }

    /// (M − exact)/s of the first band of each place; those without noise are checked and left out.
    #[track_caller]
    pub(super) fn quotients(&self, walks: f64, seed: u64) -> Vec<f64> {
        let mut quotients = Vec::new();
        for ((found, exact), spot) in self.estimates(walks, seed).iter().zip(&self.exact).zip(&self.spots) {
            let (mean, exact) = (found.bands[0], exact[0]);
            let off = mean.value - exact;
            if mean.error > NOISELESS * exact.abs() {
                let quotient = off / mean.error;
                if quotient.abs() > 6.0 {
                    println!("{}: {spot:?}: {mean:?}, not {exact}: {quotient:.1} s", self.name);
                }
                quotients.push(quotient);
            } else if off.abs() > EXACT * exact.abs() {
                println!("{}: {spot:?}: {mean:?}, not {exact}", self.name);
                quotients.push(f64::INFINITY);
            }
        }
        println!("{}: {} readings, {:.2}", self.name, quotients.len(), mean_square(&quotients));
        quotients
    }
}

fn mean_square(values: &[f64]) -> f64 {
    values.iter().map(|own| own * own).sum::<f64>() / values.len().max(1) as f64
}

/// The quotients of all trials, each with draws of its own.
#[track_caller]
pub(super) fn quotients(trials: &[Trial], walks: f64, seed: u64) -> Vec<f64> {
    (0..).zip(trials).flat_map(|(k, trial)| trial.quotients(walks, seed + k)).collect()
}

//! View factors by rays: which fronts the cosine rays of a surface meet first.
//!
//! ```text
//! F_ij = ⟨ 1 where the ray meets j ⟩ ,   rays from even points of what nothing stands on, by the cosine
//! ```
//!
//! Parts of n rays are multiples of 1/n. The moves of a lattice may all tell the nearest one, so that their
//! spread is less than what they err by: the variance 1/(12 n²) of rounding is added to that of each move.

use std::collections::{BTreeMap, BTreeSet};

use radiosity_scene::Scene;
use radiosity_work::Work;
use serde::{Deserialize, Serialize};

use crate::effort::Effort;
use crate::lattice::{Draws, Lattice};
use crate::random::{OF_ROWS, Random};
use crate::rays::Rays;
use crate::referee::{Mean, shifts};
use crate::spot::{Begin, Spot, Start};
use crate::walk::cosine_direction;

/// A scene, whose view factors are read by rays.
#[derive(Debug)]
pub struct ViewFactorReferee {
    rays: Rays,
}

/// The factors of one surface to all.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ViewFactorRow {
    /// Index of the surface.
    pub surface: usize,
    /// The factors to what its rays meet, by index; others are 0 as far as the rays tell.
    pub factors: Vec<ViewFactor>,
    /// The part that meets no front.
    pub lost: Mean,
    /// Rays that were traced for it.
    pub rays: u64,
}

/// The factor to one surface.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ViewFactor {
    /// Index of the surface that is met.
    pub to: usize,
    /// F.
    pub factor: Mean,
}

/// One move of the lattice: parts of the rays.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Parts {
    /// By the front that they meet.
    fronts: BTreeMap<usize, f64>,
    lost: f64,
    rays: u64,
}

impl ViewFactorReferee {
    /// The referee of the view factors of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self { rays: Rays::of(scene) }
    }

    /// The factors of these surfaces, by their indices in the scene, in order: the same on any number of
    /// threads and ranks. Those whose rays were not done when time was up are left out.
    pub fn rows(&self, surfaces: &[usize], effort: &Effort, work: &Work<'_>) -> Vec<ViewFactorRow> {
        let starts: Vec<Start<'_>> =
            surfaces.iter().map(|surface| Start::of(&Spot::Surface(*surface), &self.rays)).collect();
        let parts = shifts(surfaces.len(), work, |row, shift| {
            let random = Random::of(&[effort.seed, surfaces[row] as u64, shift as u64, OF_ROWS]);
            self.parts(&starts[row], effort.log, random)
        });
        let rows = surfaces.iter().zip(&parts);
        rows.filter_map(|(surface, parts)| Some(row(*surface, parts.as_deref()?))).collect()
    }

    /// The parts of 2^`log` rays from a start.
    fn parts(&self, start: &Start<'_>, log: u32, mut random: Random) -> Parts {
        let lattice = Lattice::moved(log, &mut random);
        let mut parts = Parts { fronts: BTreeMap::new(), lost: 0.0, rays: 0 };
        let mut weights = 0.0;
        for k in 0..1 << log {
            let mut draws = Draws::new(&lattice, k, random.clone());
            let Begin::At(vertex, weight) = start.begin(draws.pair()) else { continue };
            let along = cosine_direction(vertex.normal, draws.pair());
            weights += weight;
            parts.rays += 1;
            match self.rays.first(vertex.point, along) {
                Some(place) => *parts.fronts.entry(place.surface).or_default() += weight,
                None => parts.lost += weight,
            }
        }
        if weights > 0.0 {
            parts.fronts.values_mut().chain([&mut parts.lost]).for_each(|part| *part /= weights);
        }
        parts
    }
}

impl ViewFactorRow {
    /// The factor to a surface.
    pub fn to(&self, surface: usize) -> Mean {
        let found = self.factors.binary_search_by_key(&surface, |own| own.to);
        let unmet = || Mean { value: 0.0, error: rounding(self.rays / Effort::SHIFTS as u64) };
        found.map_or_else(|_| unmet(), |place| self.factors[place].factor)
    }
}

/// The error that rounding to parts of so many rays leaves in the mean of all moves.
fn rounding(rays: u64) -> f64 {
    (12.0 * Effort::SHIFTS as f64).sqrt().recip() / rays.max(1) as f64
}

/// The row that independent moves of the lattice tell.
fn row(surface: usize, all: &[Parts]) -> ViewFactorRow {
    let rounding = rounding(all[0].rays);
    let met: BTreeSet<usize> = all.iter().flat_map(|own| own.fronts.keys().copied()).collect();
    let mean = |part: &dyn Fn(&Parts) -> f64| {
        let Mean { value, error } = Mean::of(&all.iter().map(part).collect::<Vec<_>>());
        Mean { value, error: error.hypot(rounding) }
    };
    let factor = |to: usize| {
        let factor = mean(&|own| own.fronts.get(&to).copied().unwrap_or(0.0));
        ViewFactor { to, factor }
    };
    ViewFactorRow {
        surface,
        factors: met.into_iter().map(factor).collect(),
        lost: mean(&|own| own.lost),
        rays: all.iter().map(|own| own.rays).sum(),
    }
}

//! Direct light at a point, as it is, instead of its projection on polynomials.
//!
//! Polynomials smear shadow edges. Reading off with
//!
//! ```text
//! E(x) = D(x) + Σ_k (h − G e)_k φ_k(x)
//! ```
//!
//! recomputes the light D that comes straight from the emitters with its exact shadows, and takes only the rest
//! from the polynomials. D is exact ([`crate::visibility::exact`]) for planar emitters behind planar blockers; where a
//! blocker or the emitter is curved, the cells of [`crate::view`] are refined until D is good to [`ACCURACY`].

use radiosity_geom::DVec3;

use crate::elements::Element;
use crate::solution::{Band, Solution};
use crate::view::surroundings::{Site, Surroundings};
use crate::view::tree::Tree;
use crate::view::vantage::Vantage;
use crate::view::walk::Walk;
use crate::visibility::Visibility;

/// Error of the sampled light, about, relative to what all emitters would send with nothing between.
pub const ACCURACY: f64 = 1e-3;

/// Error allowed a cell of that.
const PER_CELL: f64 = 0.3;

/// Who emits, and what may stand between an emitter and each element.
#[derive(Debug)]
pub struct DirectLight<'a> {
    solution: &'a Solution,
    visibility: &'a Visibility,
    /// Indices of the emitting elements.
    emitters: Vec<usize>,
    trees: Vec<Tree>,
    /// Per receiving element.
    surroundings: Vec<Surroundings>,
    eps: f64,
}

impl<'a> DirectLight<'a> {
    /// The direct light of a solution's scene, good to [`ACCURACY`] where it is sampled.
    pub fn new(solution: &'a Solution, visibility: &'a Visibility) -> Self {
        Self::within(solution, visibility, ACCURACY)
    }

    /// The same, good to `eps` where it is sampled.
    pub fn within(solution: &'a Solution, visibility: &'a Visibility, eps: f64) -> Self {
        let list = solution.elements().list();
        let emits = |i: &usize| solution.bands().iter().any(|band| band.coating.exitance[*i] > 0.0);
        let emitters: Vec<usize> = (0..list.len()).filter(emits).collect();
        let power = |i: &usize| solution.bands().iter().map(|band| band.coating.exitance[*i]).sum::<f64>();
        let trees: Vec<Tree> =
            emitters.iter().map(|emitter| Tree::uniform(&list[*emitter], power(emitter))).collect();
        let around = |element: &Element| {
            let horizon = element.plane.map(|(_, normal)| normal);
            let site = Site { points: &element.hull, horizon, surface: Some(element.surface) };
            Surroundings::new(visibility, &trees, &site)
        };
        let surroundings = list.iter().map(around).collect();
        Self { solution, visibility, emitters, trees, surroundings, eps }
    }

    /// For each emitter: its index, and the irradiance at `x` on element `receiver` with unit normal `n` per unit of its
    /// exitance.
    pub fn factors(&self, receiver: usize, x: DVec3, n: DVec3) -> Vec<(usize, f64)> {
        let vantage = Vantage::on(self.solution.elements().list()[receiver].surface, x, n);
        self.from(&vantage, &self.surroundings[receiver])
    }

    /// Irradiance (W m⁻²) per band at `x` on element `receiver` with unit normal `n`.
    pub fn at(&self, receiver: usize, x: DVec3, n: DVec3) -> Vec<f64> {
        self.per_band(&self.factors(receiver, x, n))
    }

    /// What may stand between the emitters and a site.
    pub fn around(&self, site: &Site) -> Surroundings {
        Surroundings::new(self.visibility, &self.trees, site)
    }

    /// Irradiance (W m⁻²) per band straight from the emitters, at a point of a site.
    pub fn irradiance(&self, vantage: &Vantage, surroundings: &Surroundings) -> Vec<f64> {
        self.per_band(&self.from(vantage, surroundings))
    }

    fn from(&self, vantage: &Vantage, surroundings: &Surroundings) -> Vec<(usize, f64)> {
        let mut walk = Walk::new(vantage, self.visibility, surroundings);
        walk.to_share(&self.trees, PER_CELL * self.eps, 0.0, |walk, tolerance| {
            let (mut factors, mut level) = (Vec::with_capacity(self.trees.len()), 0.0);
            for (index, tree) in self.trees.iter().enumerate() {
                let mut factor = [0.0];
                walk.add(index, tree, tolerance, &mut factor);
                level += factor[0] / tree.scale()[0];
                factors.push((self.emitters[index], factor[0]));
            }
            (factors, level)
        })
    }

    fn per_band(&self, factors: &[(usize, f64)]) -> Vec<f64> {
        let lit = |band: &Band| {
            factors.iter().map(|(emitter, factor)| factor * band.coating.exitance[*emitter]).sum()
        };
        self.solution.bands().iter().map(lit).collect()
    }
}

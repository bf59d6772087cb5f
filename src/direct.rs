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
//! blocker or the emitter is curved, the emitter is sampled by a Gauss rule of 8 × 8 points a patch.

use radiosity_geom::DVec3;

use crate::elements::patch::{Node, Patch};
use crate::elements::rule::UnitRule;
use crate::elements::{Element, Elements};
use crate::kernel::kernel;
use crate::solution::Solution;
use crate::visibility::Visibility;
use crate::visibility::exact::{irradiance, visible_parts};

/// Points per direction where an emitter has to be sampled.
const SAMPLES: usize = 8;

/// Who emits towards each element, and what may stand between.
#[derive(Debug)]
pub struct DirectLight<'a> {
    elements: &'a Elements,
    visibility: &'a Visibility,
    /// Per receiving element: emitters with the surfaces that may block them.
    sources: Vec<Vec<Source>>,
}

#[derive(Debug)]
struct Source {
    emitter: usize,
    blockers: Vec<usize>,
}

impl<'a> DirectLight<'a> {
    /// The direct light of a solution's scene.
    pub fn new(solution: &'a Solution, visibility: &'a Visibility) -> Self {
        let elements = solution.elements();
        let emits = |i: usize| solution.bands().iter().any(|band| band.coating.exitance[i] > 0.0);
        let emitters: Vec<usize> = (0..elements.list().len()).filter(|i| emits(*i)).collect();
        let source = |receiver: &Element, emitter: usize| {
            let other = &elements.list()[emitter];
            let surfaces = [receiver.surface, other.surface];
            Source { emitter, blockers: visibility.candidates(&receiver.hull, &other.hull, surfaces) }
        };
        let sources = elements.list().iter().enumerate().map(|(i, receiver)| {
            emitters
                .iter()
                .filter(|emitter| **emitter != i)
                .map(|emitter| source(receiver, *emitter))
                .collect()
        });
        Self { elements, visibility, sources: sources.collect() }
    }

    /// For each emitter of element `receiver`: its index, and the irradiance at `x` with unit normal `n` per unit
    /// of its exitance.
    pub fn at(&self, receiver: usize, x: DVec3, n: DVec3) -> impl Iterator<Item = (usize, f64)> {
        self.sources[receiver].iter().map(move |source| (source.emitter, self.from(source, x, n)))
    }

    fn from(&self, source: &Source, x: DVec3, n: DVec3) -> f64 {
        let emitter = &self.elements.list()[source.emitter];
        let flat = source.blockers.iter().all(|blocker| self.visibility.pieces(*blocker).is_some());
        match emitter.plane {
            Some((point, normal)) if (x - point).dot(normal) <= 0.0 => 0.0,
            Some(_) if flat => emitter.patches.iter().map(|patch| self.exact(patch, source, x, n)).sum(),
            _ => emitter.patches.iter().map(|patch| self.sampled(patch, source, x, n)).sum(),
        }
    }

    fn exact(&self, patch: &Patch, source: &Source, x: DVec3, n: DVec3) -> f64 {
        let polygon = patch.polygon();
        // A piece wholly behind the horizon cannot stand before anything above it.
        let stands = |piece: &&[DVec3]| piece.iter().any(|corner| (corner - x).dot(n) > 0.0);
        let pieces = source.blockers.iter().filter_map(|blocker| self.visibility.pieces(*blocker)).flatten();
        let parts = visible_parts(x, &polygon, pieces.map(Vec::as_slice).filter(stands));
        parts.iter().map(|part| irradiance(x, n, part)).sum()
    }

    fn sampled(&self, patch: &Patch, source: &Source, x: DVec3, n: DVec3) -> f64 {
        let here = Node { position: x, normal: n, area: 1.0, parameters: Default::default() };
        let rule = UnitRule::of(SAMPLES);
        let points = rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t)));
        points
            .map(|((s, ws), (t, wt))| {
                let there = patch.node(s, t);
                let free = || self.visibility.free(&source.blockers, x, there.position);
                let value = kernel(&here, &there);
                if value > 0.0 && free() { ws * wt * there.area * value } else { 0.0 }
            })
            .sum()
    }
}

//! The blocks of a kernel that is a sum of terms, such as a power series: one block per term, from the same
//! samples.
//!
//! ```text
//! κ = Σ_n p_n κ_n ,     G_n^kl = ∫∫ φ_k(x) φ_l(y) κ_n(x, y) dA_x dA_y
//! ```
//!
//! Between flat patches that do not touch, by the rule of patches [far](crate::rules::far) apart; near pairs
//! are halved first. The kernel may move the emitter, which stays where it is for its functions.

use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_geom::{DVec3, Motion};

use crate::contact::gap::polygon_distance;
use crate::moments::Moments;
use crate::moments::tensor::Terms;
use crate::rules::far::{SMALLEST_RATIO, counts};
use crate::tolerances::MOST_HALVINGS_OF_TERMS;

/// A patch of the receiver and one of the emitter, and the points along and across of either.
#[derive(Debug)]
pub struct PatchPair {
    patches: [Patch; 2],
    points: [usize; 4],
}

impl PatchPair {
    /// Pairs of points.
    pub fn samples(&self) -> u64 {
        self.points.iter().map(|n| *n as u64).product()
    }
}

/// Accuracy that the rules have to reach, with the degrees and the place of the elements.
#[derive(Clone, Copy, Debug)]
pub struct Demand {
    /// Where the emitter is: a rigid motion of its patches.
    pub place: Motion,
    /// Total degrees of the receiver's and the emitter's functions.
    pub degrees: [usize; 2],
    /// The share of their distance that two patches may come to.
    pub nearest: f64,
    /// Error relative to the largest entry.
    pub eps: f64,
}

impl Demand {
    /// The pairs of parts of two flat patches that a rule covers; None where the patches touch or nearly do.
    pub fn divided(&self, p: &Patch, q: &Patch) -> Option<Vec<PatchPair>> {
        let mut pairs = Vec::new();
        self.divide(p, q, MOST_HALVINGS_OF_TERMS, &mut pairs).then_some(pairs)
    }

    /// The distance of two flat patches, the second one moved.
    pub fn distance(&self, p: &Patch, q: &Patch) -> f64 {
        moved_distance(p, q, &self.place)
    }

    fn divide(&self, p: &Patch, q: &Patch, levels: usize, pairs: &mut Vec<PatchPair>) -> bool {
        let nearest = self.nearest * self.distance(p, q);
        if nearest >= SMALLEST_RATIO * p.longest().1.max(q.longest().1) {
            let points = counts(p, q, self.degrees, nearest, self.eps);
            pairs.push(PatchPair { patches: [p.clone(), q.clone()], points });
            return true;
        }
        if levels == 0 {
            return false;
        }
        Patch::halve_longer(p, q).iter().all(|[p, q]| self.divide(p, q, levels - 1, pairs))
    }
}

/// The distance of two flat patches, the second one moved to `place`.
pub fn moved_distance(p: &Patch, q: &Patch, place: &Motion) -> f64 {
    let moved: Vec<DVec3> = q.polygon().iter().map(|y| place.point(*y)).collect();
    polygon_distance(&p.polygon(), &moved)
}

/// The block of every term of `kernel` between two elements, row-major, receiver's functions by emitter's,
/// and the number of samples.
pub fn blocks(
    [receiver, emitter]: [&Element; 2],
    pairs: &[PatchPair],
    kernel: &mut impl Terms,
) -> (Vec<Vec<f64>>, u64) {
    let mut sums: Vec<Moments> =
        (0..kernel.count()).map(|_| Moments::new(&receiver.basis, &emitter.basis)).collect();
    for PatchPair { patches: [p, q], points } in pairs {
        Moments::add_terms(&mut sums, [p, q], *points, kernel);
    }
    let samples = sums.first().map_or(0, |sum| sum.samples);
    (sums.into_iter().map(Moments::into_block).collect(), samples)
}

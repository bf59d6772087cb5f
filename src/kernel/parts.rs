//! The unit square or cube over which 1/r⁴ is integrated, r linear in each variable: cut into parts, each with its
//! number of points along every variable.
//!
//! A part is halved along the variable that needs most points, as long as its halves together take fewer.

use radiosity_geom::DVec3;

use crate::elements::rule::MOST_POINTS;

use super::analytic;

/// Places of the other variables at which the rate of convergence along one is looked at: coarser ones miss peaks.
const PLACES: [f64; 9] = [0.0, 0.05, 0.15, 0.3, 0.5, 0.7, 0.85, 0.95, 1.0];
/// Most parts.
const MOST_PARTS: usize = 512;

/// Parts, each with its points along every variable.
pub(super) type Parts<const D: usize> = Vec<(Part<D>, [usize; D])>;

/// A part of [0, 1]^D.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part<const D: usize> {
    /// Where it starts.
    pub low: [f64; D],
    /// Its sides.
    pub size: [f64; D],
}

impl<const D: usize> Part<D> {
    /// All of [0, 1]^D.
    pub(super) const WHOLE: Self = Self { low: [0.0; D], size: [1.0; D] };

    /// The coordinate of a place in [0, 1] of the part.
    pub(super) fn at(&self, direction: usize, place: f64) -> f64 {
        self.low[direction] + self.size[direction] * place
    }

    fn halves(&self, direction: usize) -> [Self; 2] {
        let mut halves = [*self; 2];
        halves[0].size[direction] *= 0.5;
        halves[1].size[direction] *= 0.5;
        halves[1].low[direction] += halves[1].size[direction];
        halves
    }
}

/// What has to be integrated: 1/|difference|⁴ with polynomials of degree `degree`.
pub(super) struct Multilinear<'a, const D: usize> {
    /// r, linear in each variable.
    pub difference: &'a dyn Fn([f64; D]) -> DVec3,
    /// Degree of the polynomials that counts.
    pub degree: usize,
    /// Accuracy relative to the largest value.
    pub eps: f64,
    /// Most halvings one inside the other.
    pub deepest: u32,
}

impl<const D: usize> Multilinear<'_, D> {
    /// The parts with their points.
    ///
    /// None where this takes too many: r vanishes, or as good as vanishes, somewhere.
    pub(super) fn parts(&self) -> Option<Parts<D>> {
        let mut parts = Vec::new();
        self.plan(Part::WHOLE, self.points(&Part::WHOLE), 0, &mut parts);
        parts.iter().all(|(_, points)| points.iter().all(|n| *n <= MOST_POINTS)).then_some(parts)
    }

    fn plan(&self, part: Part<D>, points: [usize; D], depth: u32, parts: &mut Parts<D>) {
        let cost = |points: &[usize; D]| points.iter().product::<usize>();
        if depth < self.deepest && parts.len() < MOST_PARTS {
            let direction = (0..D).fold(0, |most, k| if points[k] > points[most] { k } else { most });
            let halves = part.halves(direction).map(|half| (half, self.points(&half)));
            let too_many = points.iter().any(|n| *n > MOST_POINTS);
            if too_many || halves.iter().map(|(_, points)| cost(points)).sum::<usize>() < cost(&points) {
                return halves
                    .into_iter()
                    .for_each(|(half, points)| self.plan(half, points, depth + 1, parts));
            }
        }
        parts.push((part, points));
    }

    fn points(&self, part: &Part<D>) -> [usize; D] {
        std::array::from_fn(|direction| analytic::points(self.degree, self.eps, self.rate(part, direction)))
    }

    /// The slowest rate along one variable, over all combinations of places of the others.
    fn rate(&self, part: &Part<D>, direction: usize) -> f64 {
        let mut slowest = f64::INFINITY;
        for index in 0..PLACES.len().pow(D as u32 - 1) {
            let mut digits = index;
            let mut place = part.low;
            for other in (0..D).filter(|k| *k != direction) {
                place[other] = part.at(other, PLACES[digits % PLACES.len()]);
                digits /= PLACES.len();
            }
            let start = (self.difference)(place);
            place[direction] = part.at(direction, 1.0);
            slowest = slowest.min(analytic::rate(start, (self.difference)(place) - start));
        }
        slowest
    }
}

//! A square of two variables (a, b) over which 1/r⁴ is integrated, r linear in each: cut into parts, each with its number of
//! points along a and b.

use radiosity_geom::DVec3;

use crate::elements::rule::MOST_POINTS;

use super::analytic;

/// Places of the other variable at which the rate of convergence along one is looked at.
const PLACES: [f64; 9] = [0.0, 0.05, 0.15, 0.3, 0.5, 0.7, 0.85, 0.95, 1.0];
/// Most halvings.
const DEEPEST: u32 = 48;
/// Most parts.
const MOST_PARTS: usize = 512;

/// Parts of the square, each with its points along a and b.
pub(super) type Parts = Vec<(Part, [usize; 2])>;

/// A part of the square [0, 1]².
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// Where it starts.
    pub low: [f64; 2],
    /// Its sides.
    pub size: [f64; 2],
}

impl Part {
    const WHOLE: Self = Self { low: [0.0; 2], size: [1.0; 2] };

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

/// What has to be integrated: 1/|difference(a, b)|⁴ with polynomials of degree `degree`.
pub(super) struct Bilinear<'a> {
    /// r, linear in a and in b.
    pub difference: &'a dyn Fn(f64, f64) -> DVec3,
    /// Degree of the polynomials that counts.
    pub degree: usize,
    /// Accuracy relative to the largest value.
    pub eps: f64,
}

impl Bilinear<'_> {
    /// The parts, each with its points along a and b: halved as long as that takes fewer.
    ///
    /// None where this takes too many: r vanishes, or as good as vanishes, somewhere in the square.
    pub(super) fn parts(&self) -> Option<Parts> {
        let mut parts = Vec::new();
        self.plan(Part::WHOLE, 0, &mut parts);
        parts.iter().all(|(_, points)| points.iter().all(|n| *n <= MOST_POINTS)).then_some(parts)
    }

    fn plan(&self, part: Part, depth: u32, parts: &mut Parts) {
        let points = self.points(&part);
        let cost = |points: [usize; 2]| points[0] * points[1];
        let halves = part.halves(usize::from(points[1] > points[0]));
        let halved: usize = halves.iter().map(|half| cost(self.points(half))).sum();
        let too_many = points.iter().any(|n| *n > MOST_POINTS);
        let may = depth < DEEPEST && parts.len() < MOST_PARTS;
        if may && (too_many || halved < cost(points)) {
            halves.into_iter().for_each(|half| self.plan(half, depth + 1, parts));
        } else {
            parts.push((part, points));
        }
    }

    fn points(&self, part: &Part) -> [usize; 2] {
        let along_a = |b: f64| {
            let (low, high) = (part.at(0, 0.0), part.at(0, 1.0));
            let start = (self.difference)(low, b);
            analytic::rate(start, (self.difference)(high, b) - start)
        };
        let along_b = |a: f64| {
            let (low, high) = (part.at(1, 0.0), part.at(1, 1.0));
            let start = (self.difference)(a, low);
            analytic::rate(start, (self.difference)(a, high) - start)
        };
        let slowest = |rates: &mut dyn Iterator<Item = f64>| rates.fold(f64::INFINITY, f64::min);
        let rates = [
            slowest(&mut PLACES.iter().map(|place| along_a(part.at(1, *place)))),
            slowest(&mut PLACES.iter().map(|place| along_b(part.at(0, *place)))),
        ];
        rates.map(|rho| analytic::points(self.degree, self.eps, rho))
    }
}

//! Subdivision of the unit square or cube for the integral of 1/r⁴, r linear in each variable.
//!
//! A part is halved across the variable that needs most points, as long as the two halves together need fewer
//! points.

use radiosity_elements::rule::MOST_POINTS;
use radiosity_geom::DVec3;
use radiosity_work::interruption::check_interrupt;
use smallvec::SmallVec;

use crate::rules::orders::analyticity;

/// Values of the other variables at which the convergence rate along one is taken. Denser at the ends, where
/// peaks lie; coarser sets missed some.
const PLACES: [f64; 9] = [0.0, 0.05, 0.15, 0.3, 0.5, 0.7, 0.85, 0.95, 1.0];
/// Most parts before subdivision stops: a bound of the time of planning, where the kernel is nearly singular.
/// Such pairs are left to other rules if a part wants more points than there are.
const MOST_PARTS: usize = 512;

/// Corners of a cube: most corners of a part.
const CORNERS: usize = 8;

/// Lines, given by their ends.
type Lines = SmallVec<[[DVec3; 2]; CORNERS / 2]>;

/// A part of [0, 1]^D.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part<const D: usize> {
    /// The corner of least coordinates.
    pub low: [f64; D],
    /// The lengths of its sides.
    pub size: [f64; D],
}

/// A part with the numbers of points of its tensor rule, along each variable.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RuledPart<const D: usize> {
    pub part: Part<D>,
    pub points: [usize; D],
}

impl<const D: usize> Part<D> {
    pub(crate) const WHOLE: Self = Self { low: [0.0; D], size: [1.0; D] };

    /// The coordinate of a position in [0, 1] within the part.
    pub(crate) fn at(&self, direction: usize, place: f64) -> f64 {
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

/// The integrand: 1/|difference|⁴ times polynomials of degree `degree`.
pub(crate) struct Multilinear<'a, const D: usize> {
    /// r, linear in each variable.
    pub difference: &'a dyn Fn([f64; D]) -> DVec3,
    /// Degree of the polynomials, for the number of points.
    pub degree: usize,
    /// Accuracy relative to the integrand's largest value.
    pub eps: f64,
    pub deepest: u32,
}

impl<const D: usize> Multilinear<'_, D> {
    /// The parts with their numbers of points.
    ///
    /// None where a part needs more points than any rule has: r is zero, or nearly zero, somewhere.
    pub(crate) fn parts(&self) -> Option<Vec<RuledPart<D>>> {
        let mut parts = Vec::new();
        self.plan(self.ruled(Part::WHOLE), 0, &mut parts);
        parts.iter().all(|ruled| ruled.points.iter().all(|n| *n <= MOST_POINTS)).then_some(parts)
    }

    fn plan(&self, whole: RuledPart<D>, depth: u32, parts: &mut Vec<RuledPart<D>>) {
        check_interrupt();
        let RuledPart { part, points } = whole;
        let cost = |points: &[usize; D]| points.iter().product::<usize>();
        if depth < self.deepest && parts.len() < MOST_PARTS {
            let direction = (0..D).fold(0, |most, k| if points[k] > points[most] { k } else { most });
            let halves = part.halves(direction).map(|half| self.ruled(half));
            let too_many = points.iter().any(|n| *n > MOST_POINTS);
            if too_many || halves.iter().map(|half| cost(&half.points)).sum::<usize>() < cost(&points) {
                return halves.into_iter().for_each(|half| self.plan(half, depth + 1, parts));
            }
        }
        parts.push(whole);
    }

    fn ruled(&self, part: Part<D>) -> RuledPart<D> {
        let corners = self.corners(&part);
        let points = std::array::from_fn(|direction| {
            analyticity::points(self.degree, self.eps, Self::rate(&corners, direction))
        });
        RuledPart { part, points }
    }

    /// r at the corners of a part; bit k of a corner's index is its coordinate k.
    fn corners(&self, part: &Part<D>) -> [DVec3; CORNERS] {
        let place = |index: usize| std::array::from_fn(|k| part.at(k, (index >> k & 1) as f64));
        std::array::from_fn(
            |index| {
                if index < 1 << D { (self.difference)(place(index)) } else { DVec3::ZERO }
            },
        )
    }

    /// The slowest convergence rate along one variable, over all combinations of [`PLACES`] of the others.
    fn rate(corners: &[DVec3; CORNERS], direction: usize) -> f64 {
        let bit = 1 << direction;
        let low = (0..1 << D).filter(|index| index & bit == 0);
        let lines: Lines = low.map(|low| [corners[low], corners[low | bit]]).collect();
        analyticity::rate(least_half_axis(&lines))
    }
}

/// The least half axis ([`analyticity::half_axis`]) over lines between the given ones, which stand at the
/// corners of a square or the ends of an interval.
fn least_half_axis(lines: &[[DVec3; 2]]) -> f64 {
    if let [[start, end]] = lines {
        return analyticity::half_axis(*start, end - start);
    }
    let between = |a: &[DVec3; 2], b: &[DVec3; 2], place: f64| [0, 1].map(|end| a[end].lerp(b[end], place));
    let at = |place: &f64| match lines {
        [a, b, c, d] => least_half_axis(&[between(a, b, *place), between(c, d, *place)]),
        _ => least_half_axis(&[between(&lines[0], &lines[1], *place)]),
    };
    PLACES.iter().map(at).fold(f64::INFINITY, f64::min)
}

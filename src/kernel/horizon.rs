//! Patches apart of which some points do not see each other for their own horizons.
//!
//! The kernel is clipped where either of n_x·(y − x), n_y·(x − y) changes sign, and a tensor rule converges only like
//! 1/n² or so. Instead the integral is iterated: for every outer point x,
//!
//! ```text
//! W_l(x) = ∫_q κ(x, y) φ_l(y) dA_y
//! ```
//!
//! is computed on exactly the part of q that x sees ([`part`]).
//!
//! A ball that stands between is cut away in the same manner ([`view`]).
//!
//! W itself loses smoothness (of second order or higher) only where a horizon starts to leave q; there the outer
//! patch is halved until the halves together agree with the whole.

mod line;
mod part;
mod view;

use std::sync::Arc;

use crate::elements::basis::AreaBasis;
use crate::elements::patch::{Direction, Patch};
use crate::elements::rule::{MOST_POINTS, UnitRule};

pub(super) use part::DEEPEST;
use part::Part;
pub(super) use view::Ball;
use view::View;

/// Points of the rules that are tried on an outer patch, as parts of those that the kernel would take.
const RUNGS: [f64; 3] = [0.35, 0.55, 1.0];
/// Fewest points of these rules, and by how many each has more than the one before: the kernel may take few where W, clipped,
/// takes many, and a rule tells nothing beside itself.
const FEWEST: usize = 3;
const STEP: usize = 2;
/// Part of the tolerance within which two of them have to agree.
const CLIMB_SHARE: f64 = 0.5;
/// The error of the finer of two rules, as a part of their difference: r/(1 − r) with r = (3/5)³ at a kink of second order.
const FINER_RULE: f64 = 0.3;

/// By what at least the error of halves is smaller than that of the whole: a kink of second order gives 2⁻³.
const FINER: f64 = 0.125;

/// What a pair of patches gave.
#[derive(Debug)]
pub(super) struct Cut {
    /// Moments in the raw polynomials, row-major, outer functions by inner functions.
    pub moments: Vec<f64>,
    /// Estimate of their largest error.
    pub error: f64,
    /// Kernel and horizon evaluations.
    pub samples: u64,
}

/// An outer patch.
pub(super) struct Side<'a> {
    /// The patch.
    pub patch: &'a Patch,
    /// Its element's polynomials.
    pub basis: &'a AreaBasis,
    /// Points along and across.
    pub points: [usize; 2],
    /// What may stand between it and the inner patches; both lie outside it.
    pub ball: Option<Ball>,
}

/// The moments of an outer patch with inner ones apart from it, to `tolerance` in absolute terms, with about `budget`
/// evaluations. Inner patches come with their points along and across, and those of their parts by how often these
/// are quartered, which is done as often as points are given.
pub(super) fn integrate(
    outer: &Side,
    basis: &AreaBasis,
    inner: &[(Patch, Arc<[[usize; 2]]>)],
    tolerance: f64,
    budget: u64,
) -> Cut {
    let parts = inner.iter().map(|(patch, points)| Part::new(patch.clone(), basis, Arc::clone(points), 0));
    let mut job = Job {
        outer,
        columns: basis.len(),
        inner: parts.collect(),
        tolerance,
        budget,
        cut: Cut { moments: vec![0.0; outer.basis.len() * basis.len()], error: 0.0, samples: 0 },
    };
    match job.climb() {
        Ok(moments) => job.cut.moments = moments,
        Err(whole) => job.refine(outer.patch, &whole),
    }
    job.cut
}

struct Job<'a> {
    outer: &'a Side<'a>,
    columns: usize,
    inner: Vec<Part<'a>>,
    tolerance: f64,
    budget: u64,
    cut: Cut,
}

impl Job<'_> {
    /// Tries rules of few points on the outer patch, as W is often much smoother than the kernel: the moments of the
    /// first that agrees with the one before, or else of the last, which has all points at least.
    fn climb(&mut self) -> Result<Vec<f64>, Vec<f64>> {
        let mut before: Option<Vec<f64>> = None;
        for points in rungs(self.outer.points) {
            let moments = self.cell(self.outer.patch, points);
            let difference = before.map_or(f64::INFINITY, |coarse| largest_difference(&coarse, &moments));
            if difference <= CLIMB_SHARE * self.tolerance {
                self.cut.error += FINER_RULE * difference;
                return Ok(moments);
            }
            before = Some(moments);
        }
        Err(before.expect("there are rungs"))
    }

    /// Adds a part of the outer patch whose moments by one rule are `whole`.
    fn refine(&mut self, part: &Patch, whole: &[f64]) {
        let [along, across] = part.extents();
        let halves = part.halves(if along >= across { Direction::Along } else { Direction::Across });
        let points = self.outer.points.map(|n| n.max(FEWEST));
        let moments = [self.cell(&halves[0], points), self.cell(&halves[1], points)];
        let sum: Vec<f64> = moments[0].iter().zip(&moments[1]).map(|(a, b)| a + b).collect();
        let difference = largest_difference(&sum, whole);
        let spent = self.cut.samples > self.budget;
        if difference <= self.tolerance || spent {
            self.cut.moments.iter_mut().zip(&sum).for_each(|(m, s)| *m += s);
            self.cut.error += if spent { difference } else { FINER * difference };
            return;
        }
        for (half, moments) in halves.iter().zip(&moments) {
            self.refine(half, moments);
        }
    }

    /// Moments of a part of the outer patch by one tensor rule.
    fn cell(&mut self, part: &Patch, points: [usize; 2]) -> Vec<f64> {
        let (rows, columns) = (self.outer.basis.len(), self.columns);
        let [along, across] = points.map(UnitRule::of);
        let mut moments = vec![0.0; rows * columns];
        let (mut left, mut right) = (vec![0.0; rows], vec![0.0; columns]);
        for ((s, ws), (t, wt)) in along.iter().flat_map(|s| across.iter().map(move |t| (s, t))) {
            let x = part.node(s, t);
            right.fill(0.0);
            let x = View { node: x, ball: self.outer.ball };
            self.cut.samples += self.inner.iter_mut().map(|part| part.seen_from(&x, &mut right)).sum::<u64>();
            let x = x.node;
            self.outer.basis.raw(self.outer.basis.frame().coordinates(&x), &mut left);
            let weight = ws * wt * x.area;
            for (row, l) in moments.chunks_exact_mut(columns).zip(&left) {
                row.iter_mut().zip(&right).for_each(|(m, r)| *m += weight * l * r);
            }
        }
        moments
    }
}

/// Points along and across of the rules that are tried, each with more than the one before.
fn rungs(most: [usize; 2]) -> [[usize; 2]; RUNGS.len()] {
    std::array::from_fn(|k| {
        let points = |n: usize| ((RUNGS[k] * n as f64).ceil() as usize).max(FEWEST + STEP * k);
        most.map(|n| points(n).min(MOST_POINTS))
    })
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_rule_is_compared_with_itself() {
        for n in 1..=MOST_POINTS {
            let [first, second, last] = rungs([n, 1]);
            assert!((0..2).all(|k| first[k] < second[k] && second[k] < last[k]), "{n} points");
            assert!(last[0] >= n);
        }
    }
}

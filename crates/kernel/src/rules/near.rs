//! Near flat patches without contact: an iterated rule whose cost grows like a power of ln(1/gap).
//!
//! ```text
//! M_kl = ∫_P L_k(x) I_l(x) dA_x ,      I_l(x) = ∫_Q κ(x, y) L_l(y) dA_y .
//! ```
//!
//! The inner integral is taken in polar coordinates about the foot of x (`polar`). Its rays are exact, so
//! that their cost does not depend on the distance of x from the plane of Q; each edge costs more the nearer
//! x is to it. The outer integral runs over cells of P that follow the edges of Q (`plan`). Both are planned
//! before any kernel value is known.

mod ellipse;
mod radial;
mod samples;
mod stretch;
mod line;
mod polar;
mod emitter;
mod plan;

use radiosity_elements::basis::AreaBasis;
use radiosity_elements::patch::Patch;
use radiosity_elements::space::Space;
use radiosity_work::interruption::check_interrupt;

use crate::moments::{Moments, Side};
use crate::tolerances::SHARE_OF_NEAR;
use plan::{Leaf, Planner, Rule, split_cost};
pub(super) use polar::Polar;

/// Samples of a split below which no plan is made, since planning takes as long: an estimate of its time.
const CHEAP_SPLIT: f64 = 3e4;
/// Samples up to which those of a split are counted, to compare it with a plan: counting takes time too. A
/// split of more is taken to cost more than any plan.
const MOST_COUNTED: f64 = 1e6;

/// The rule of one pair.
pub struct Plan {
    outer: Side,
    leaves: Vec<Leaf>,
    /// Cost, in samples of a tensor rule.
    cost: f64,
    eps: f64,
}

impl Plan {
    /// As [`Plan::new`], or None where halving both patches until they are apart costs less.
    pub fn cheaper_than_split(moments: &Moments, p: &Patch, q: &Patch, eps: f64) -> Option<Self> {
        let degrees = moments.bases().map(|basis| basis.total_degree());
        if split_cost(p, q, degrees, eps, CHEAP_SPLIT).is_finite() {
            return None;
        }
        let plan = Self::new(moments, p, q, eps)?;
        let split = split_cost(p, q, degrees, eps, plan.cost.min(MOST_COUNTED));
        (plan.cost < split).then_some(plan)
    }

    /// For two flat convex patches in front of each other that see each other wholly. They may touch:
    /// distances have a floor.
    ///
    /// None if it would take too many cells, and for bases whose raw functions are not products of total
    /// degree.
    pub fn new(moments: &Moments, p: &Patch, q: &Patch, eps: f64) -> Option<Self> {
        let known = |basis: &AreaBasis| basis.is_product() && basis.space() == Space::Total;
        if !moments.bases().into_iter().all(known) {
            return None;
        }
        // The smaller patch is usually the better outer one, and is tried first.
        let size = |patch: &Patch| patch.extents().iter().sum::<f64>();
        let [first, other] = if size(p) <= size(q) {
            [Side::Receiver, Side::Emitter]
        } else {
            [Side::Emitter, Side::Receiver]
        };
        let first = Self::outside(first, moments, p, q, eps, f64::INFINITY);
        let other = Self::outside(other, moments, p, q, eps, first.cost);
        let plan = if other.cost < first.cost { other } else { first };
        plan.cost.is_finite().then_some(plan)
    }

    /// With the outer integral over the side `outer`; the cost is infinite if it exceeds `limit`.
    fn outside(outer: Side, moments: &Moments, p: &Patch, q: &Patch, eps: f64, limit: f64) -> Self {
        let [receiver, emitter] = moments.bases();
        let eps = SHARE_OF_NEAR * eps;
        let (mut planner, a, b) = match outer {
            Side::Receiver => (Planner::new(receiver, emitter, eps, limit), p, q),
            Side::Emitter => (Planner::new(emitter, receiver, eps, limit), q, p),
        };
        planner.pair(a, b);
        Self { outer, leaves: planner.leaves, cost: planner.cost, eps: planner.eps }
    }

    /// Adds the integrals of the plan.
    pub fn integrate(&self, moments: &mut Moments) {
        let [receiver, emitter] = moments.bases();
        let inner = match self.outer {
            Side::Receiver => emitter,
            Side::Emitter => receiver,
        };
        for leaf in &self.leaves {
            match leaf.rule {
                Rule::Polar([along, across]) => {
                    let mut polar = Polar::new(&leaf.emitter, inner, self.eps);
                    for (s, ws) in along.nodes() {
                        for (t, wt) in across.nodes() {
                            check_interrupt();
                            let x = leaf.cell.node(s, t);
                            let (column, samples) = polar.column(&x, self.eps);
                            moments.outer(self.outer, &x, ws * wt * x.area, column, samples);
                        }
                    }
                }
                Rule::Tensor(points) => match self.outer {
                    Side::Receiver => moments.tensor(&leaf.cell, &leaf.emitter, points, None),
                    Side::Emitter => {
                        let [a, b, c, d] = points;
                        moments.tensor(&leaf.emitter, &leaf.cell, [c, d, a, b], None);
                    }
                },
            }
        }
    }
}

#[cfg(test)]
mod tests;

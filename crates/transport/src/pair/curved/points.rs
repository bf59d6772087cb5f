//! Numbers of points for the rules of parts of curved elements.

use std::sync::Arc;

use radiosity_elements::patch::Patch;
use radiosity_elements::rule::MOST_POINTS;
use radiosity_kernel::rules::common_edge::{EdgePair, unequal_speed};
use radiosity_kernel::rules::orders::by_trial::Trial;
use radiosity_kernel::rules::orders::{by_trial, chart_orders};
use radiosity_kernel::rules::{common_edge, common_vertex, far};
use radiosity_kernel::tolerances::MOST_QUARTERINGS;

use crate::pair::job::Job;
use crate::tolerances::MOST_CORNER_POINTS;

/// The degrees and the accuracy that decide the numbers of points, with the shapes of the parts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Points {
    /// Degrees of receiver and emitter.
    pub degrees: [usize; 2],
    pub eps: f64,
}

impl Job<'_> {
    /// The data for the numbers of points of a pair of parts.
    pub(super) fn points(&self, p: &Patch, q: &Patch) -> Points {
        Points { degrees: self.degrees, eps: self.budget.part_eps(p, q) }
    }

    /// Whether contacts are refined no more.
    pub(super) fn spent(&self) -> bool {
        self.budget.spent(&self.moments)
    }
}

impl Points {
    /// Points of the tensor rule for two parts apart.
    pub(super) fn apart(&self, p: &Patch, q: &Patch, gap: f64) -> [usize; 4] {
        let counts = far::counts(p, q, self.degrees, gap, far::slant(p, q) * self.eps);
        let charts = [chart_orders::points(p, self.eps), chart_orders::points(q, self.eps)].concat();
        [0, 1, 2, 3].map(|k| (counts[k] + charts[k]).min(MOST_POINTS))
    }

    /// Points [x, y, angular] of the rule of a common edge: by trial, and no fewer than flat patches at this
    /// `edge_pair` need, as sums with few points may agree by chance.
    pub(super) fn edge(&self, p: &Patch, q: &Patch, matched: bool, edge_pair: &EdgePair) -> Trial<3> {
        let (eps, exact) = (self.eps, self.exact_degree());
        let Trial { points: [radial, along, angular], missed } = if matched {
            by_trial::edge(p, &|u, v| q.node(u, v), eps)
        } else {
            let seam = unequal_speed::UnequalSpeed::new(p, q);
            by_trial::edge(p, &|u, v| seam.node(u, v), eps)
        };
        let [_, _, flat] = common_edge::counts(p, q, edge_pair, self.degrees, eps);
        let angular = (angular + self.largest_degree().div_ceil(2)).max(flat + 1);
        let points = [exact + radial - 1, exact + along - 1, angular].map(|n| n.min(MOST_POINTS));
        Trial { points, missed }
    }

    /// Points [x, angular] of the rule of a common corner, as for an edge.
    pub(super) fn corner(&self, p: &Patch, q: &Patch) -> Trial<2> {
        let (eps, exact, degree) = (self.eps, self.exact_degree(), self.largest_degree());
        let Trial { points: [radial, angular], missed } = by_trial::vertex(p, q, MOST_CORNER_POINTS, eps);
        let [_, flat] = common_vertex::counts(p, q, self.degrees, eps);
        let points = [exact + radial - 1, (angular + degree.div_ceil(2)).max(flat + 1)]
            .map(|n| n.min(MOST_CORNER_POINTS));
        Trial { points, missed }
    }

    pub(super) fn largest_degree(&self) -> usize {
        self.degrees[0].max(self.degrees[1])
    }

    /// Points that integrate the polynomials of both sides and a linear area element exactly.
    fn exact_degree(&self) -> usize {
        far::exact(self.degrees)
    }
}

/// Points for the charts of two touching patches: half as many again as for patches apart, since between
/// touching patches the charts alone make the kernel vary. The half is an estimate, and errors of too few are
/// told by trials.
pub(super) fn contact_chart(p: &Patch, q: &Patch, eps: f64) -> usize {
    let most =
        [chart_orders::points(p, eps), chart_orders::points(q, eps)].concat().into_iter().max().unwrap_or(0);
    most + most.div_ceil(2)
}

/// Points of the tensor rule on an inner patch, its quarters, their quarters and so on: extents halve, and
/// charts take about a quarter less points each time, an estimate.
pub(super) fn quartered(patch: &Patch, degree: usize, gap: f64, eps: f64) -> Arc<[[usize; 2]]> {
    let charts = chart_orders::points(patch, eps);
    let extents = patch.extents();
    let count = |axis: usize, depth: usize| {
        let ratio = gap / extents[axis] * f64::from(1 << depth);
        let rho = 2.0 * ratio + (4.0 * ratio * ratio + 1.0).sqrt();
        let chart = (charts[axis] as f64 * 0.75f64.powi(depth as i32)).ceil() as usize;
        (far::points(degree, eps, rho) + chart).min(MOST_POINTS)
    };
    // A horizon tangent to a quarter's lines cuts off less of each smaller quarter: one level per two digits,
    // and one.
    let deepest = (1 + (-0.5 * eps.log10()).ceil() as usize).min(MOST_QUARTERINGS);
    (0..=deepest).map(|depth| [0, 1].map(|axis| count(axis, depth))).collect()
}

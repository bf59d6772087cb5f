//! Two parts apart that see each other wholly: tensor rules of growing numbers of points, until two of them
//! agree.
//!
//! With r = ϱ⁻² in the direction of the slowest convergence ([`far::ratio`]), a rule with a point more in
//! each direction errs by r times as much. The first rule has the points for 100 ε. Of two rules M and M′,
//! the second with j points more,
//!
//! ```text
//! error = max( r^j/(1 − r^j) , 1/10 ) ‖M′ − M‖ ,
//! ```
//!
//! and the next one has half as many more as that needs, until the error is at most
//!
//! ```text
//! ¼ ε ( ‖M′‖ + S A_p A_q / (A_i A_j) ) ,
//! ```
//!
//! of which the sum over all parts is ½ ε S.

use radiosity_elements::patch::Patch;
use radiosity_elements::rule::MOST_POINTS;
use radiosity_kernel::moments::Moments;
use radiosity_kernel::rules::far;

use crate::pair::curved::points::Points;
use crate::pair::job::Job;

/// Accuracy of the first rule over that which is asked, and the coarsest. Measured on random pairs: rules err
/// by a hundredth of what their formula allows, in the middle.
const FIRST: f64 = 100.0;
const COARSEST: f64 = 0.3;

/// Least error over the difference of two rules: errors of several directions may cancel in it.
const LEAST_SHARE: f64 = 0.1;

/// Share of the block's error for a part, of what it carries and of its part of all pairs of points: together
/// half of it, as horizons err beside them.
const SHARE: f64 = 0.25;

/// Most points more than the first rule has. What has not converged then is bent where the kernel is not.
const MOST_STEPS: usize = 10;

impl Job<'_> {
    /// Adds two parts apart that nothing hides from each other.
    pub(super) fn apart(&mut self, p: &Patch, q: &Patch, gap: f64) {
        let points = self.points(p, q);
        let first = Points { eps: (FIRST * points.eps).min(COARSEST), ..points }.apart(p, q, gap);
        let ratio = far::ratio(p, q, gap);
        let rule = |steps: usize| {
            let mut moments = Moments::new(&self.elements[0].basis, &self.elements[1].basis);
            moments.tensor(p, q, first.map(|n| (n + steps).min(MOST_POINTS)), None);
            moments
        };
        let share_of_scale = self.budget.scale * self.budget.part(p, q);
        let (mut coarse, mut steps, mut step) = (rule(0), 0, 1);
        let (fine, error, may_err) = loop {
            steps += step;
            let fine = rule(steps);
            let reached = ratio.powi(step as i32);
            let share = (reached / (1.0 - reached)).max(LEAST_SHARE);
            let error = share * self.norm.difference(fine.values(), coarse.values());
            let may_err =
                SHARE * self.budget.accuracy.eps * (self.norm.largest(fine.values()) + share_of_scale);
            self.moments.merge(&coarse, false);
            if error <= may_err || steps >= MOST_STEPS {
                break (fine, error, may_err);
            }
            // Half of it: the ratio is a bound.
            let missing = 0.5 * (may_err / error).ln() / ratio.ln();
            (coarse, step) = (fine, (missing.ceil() as usize).clamp(1, MOST_STEPS - steps));
        };
        self.moments.merge(&fine, true);
        self.told += self.first_entry(&fine);
        self.error += error;
        self.unresolved |= error > may_err;
    }
}

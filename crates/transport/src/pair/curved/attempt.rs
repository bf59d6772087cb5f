//! Parts that no rule covers: the best-suited rule with two numbers of points, whose difference is the error.

use radiosity_elements::measure::WeightedNode;
use radiosity_elements::patch::{Node, Patch};
use radiosity_kernel::contact::patches::Contact;
use radiosity_kernel::estimates::coarse::scale;
use radiosity_kernel::moments::integrand::{Sees, visible_kernel};
use radiosity_kernel::moments::{Moments, Side};
use radiosity_kernel::rules::common_edge::EdgePair;
use radiosity_kernel::rules::horizon::Front;
use radiosity_kernel::rules::{common_edge, common_vertex};

use crate::pair::job::{Job, State};
use crate::tolerances::{ABOVE_ESTIMATE, MISSED_BY_ATTEMPTS};

/// Points per direction for degree 0: the least whose difference from two more says something. With more each
/// attempt costs more, and more of them succeed.
const FEWEST_POINTS: usize = 4;
/// Points per direction for degree 0 of sampled shadows once the samples are spent: each sample takes a ray,
/// and 3⁴ = 81 of them are a third of 4⁴.
const POINTS_WHEN_SPENT: usize = 3;
/// Largest part, relative to the block's first entry, that is attempted: a horizon may pass large ones
/// unseen. With a larger value errors of large parts may go untold; with a smaller one parts are halved that
/// a rule would do for.
const LARGEST_ATTEMPT: f64 = 0.25;
/// Cosine of the dihedral angle below which an edge counts as smooth (172°). The kernel is bounded there, and
/// plain rules cost a small part of those for edges.
const SMOOTH: f64 = -0.99;
/// Share of the block's error for one attempt: some thirty spend all of it.
const ATTEMPT_SHARE: f64 = 0.03;
/// Power of digits/4 by which that share falls beyond four digits, to a 64th at eight: more parts are
/// attempted then.
const MORE_ATTEMPTS: i32 = 6;
/// Least error of an attempt that missed its accuracy, and of what is summed roughly in the end, as a share
/// of what it carries: both rules may miss one horizon alike. An arbitrary choice: a larger value leaves more
/// blocks to rays, with a smaller one errors may be told too small.
pub(super) const DOUBT: f64 = 0.1;

impl<'a> Job<'a> {
    /// Attempts a part that no rule covers: one cut by a horizon, or a contact of another kind. The error is
    /// the difference of the rule with n and n + 2 points. `contact` is None for a patch with itself. Returns
    /// whether the result is kept: because it is accurate enough, or because the samples are spent.
    pub(super) fn attempt(&mut self, p: &Patch, q: &Patch, contact: Option<&Contact>, state: &State) -> bool {
        let share = self.budget.share(p, q);
        if !self.spent() && self.carried(p, q, share) > LARGEST_ATTEMPT * self.budget.scale {
            return false;
        }
        let coarsest = self.spent() && !state.blockers.is_empty();
        let n = self.bends(share) + if coarsest { POINTS_WHEN_SPENT } else { FEWEST_POINTS };
        let [coarse, fine] = [n, n + 2].map(|n| self.tentative(p, q, contact, n, &state.blockers));
        let error = self.norm.difference(fine.values(), coarse.values());
        let may_err = ATTEMPT_SHARE / self.budget.beyond().powi(MORE_ATTEMPTS) * self.budget.may_err();
        let enough = error <= may_err;
        let kept = enough || self.spent();
        self.moments.merge(&coarse, false);
        self.moments.merge(&fine, kept);
        if kept {
            // Two rules may miss one horizon alike: an attempt that missed its accuracy has at least this
            // error.
            let doubt = if enough { 0.0 } else { DOUBT * self.first_entry(&fine) };
            let is_near = matches!(contact, Some(Contact::Apart(gap)) if Self::is_near(p, q, *gap));
            self.error += doubt.max(if is_near { MISSED_BY_ATTEMPTS * error } else { error });
            self.unresolved |= !enough;
        }
        kept
    }

    /// Upper bound of what a part carries: its `share`, or a multiple of a coarse estimate.
    fn carried(&self, p: &Patch, q: &Patch, share: f64) -> f64 {
        let rough = scale(std::slice::from_ref(p), std::slice::from_ref(q), self.budget.unit);
        share.min(ABOVE_ESTIMATE * rough)
    }

    /// Sums a part whose shadows are sampled although the rays are spent.
    pub(super) fn roughly(&mut self, p: &Patch, q: &Patch, contact: Option<&Contact>, state: &State) {
        let n = POINTS_WHEN_SPENT + self.bends(self.budget.share(p, q));
        let part = self.tentative(p, q, contact, n, &state.blockers);
        self.moments.merge(&part, true);
    }

    /// Points added for the polynomials, which on a small part are nearly of a lower degree.
    fn bends(&self, share: f64) -> usize {
        (0.5 * self.degrees[0].max(self.degrees[1]) as f64 * share.sqrt().min(1.0)).ceil() as usize
    }

    pub(super) fn tentative(
        &self,
        p: &Patch,
        q: &Patch,
        contact: Option<&Contact>,
        n: usize,
        blockers: &[usize],
    ) -> Moments<'a> {
        let mut moments = Moments::new(&self.elements[0].basis, &self.elements[1].basis);
        let free = self.sees(blockers);
        let sees: Option<Sees> = if blockers.is_empty() { None } else { Some(&free) };
        let plain = [n, n, n + 1, n + 1];
        match contact {
            None => {
                // Half of the moments of a patch with itself.
                moments.tensor(p, p, plain, sees);
                moments.scale(0.5);
            }
            Some(Contact::Edge { p, q, matched: true }) if EdgePair::of(p, q).cosine > SMOOTH => {
                common_edge::integrate(&mut moments, p, q, [n; 3], sees);
            }
            Some(Contact::Vertex(p, q)) => common_vertex::integrate(&mut moments, p, q, [n; 2], sees),
            Some(_) => match &self.fronts {
                Some(fronts) if fronts[0].cuts(p) || fronts[1].cuts(q) => {
                    before_planes(&mut moments, [p, q], fronts, n, sees);
                }
                _ => moments.tensor(p, q, plain, sees),
            },
        }
        moments
    }
}

/// Adds two planar patches by a product rule: n × n points on the part of the first that the second sees,
/// (n + 1)² on the part of the second that the first sees.
fn before_planes(
    moments: &mut Moments,
    [p, q]: [&Patch; 2],
    [first, second]: &[Front; 2],
    n: usize,
    sees: Option<Sees>,
) {
    let basis = moments.bases()[1];
    let row = |WeightedNode { node, weight }| {
        let mut row = vec![0.0; basis.len()];
        basis.raw(basis.frame().coordinates(&node), &mut row);
        row.iter_mut().for_each(|value| *value *= weight);
        (node, row)
    };
    let emitters: Vec<(Node, Vec<f64>)> = second.nodes(q, [n + 1; 2]).nodes.into_iter().map(row).collect();
    let mut column = vec![0.0; basis.len()];
    for WeightedNode { node: x, weight } in first.nodes(p, [n; 2]).nodes {
        column.fill(0.0);
        for (y, row) in &emitters {
            let value = visible_kernel(&x, y, sees, &mut moments.rays);
            column.iter_mut().zip(row).for_each(|(sum, l)| *sum += value * l);
        }
        moments.outer(Side::Receiver, &x, weight, &column, emitters.len() as u64);
    }
}

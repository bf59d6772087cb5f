//! The block of two flat elements ([`crate::pair::curved`] has the others).
//!
//! ```text
//! G_kl = ∫∫ φ_k(x) φ_l(y) κ(x, y) V(x, y) dA_x dA_y
//! ```
//!
//! Constants on elements without blockers go by [`contour`], exactly. All other pairs of flat patches are
//! clipped and cut until a rule covers their contact ([`radiosity_kernel::contact::clip`]):
//!
//! * a common edge → [`common_edge`], and a common corner → [`common_vertex`]; where visibility is sampled,
//!   slender patches (aspect > 2.5) are halved first;
//! * far apart, gap/extent ≥ ¼ → [`far`];
//! * near → [`radiosity_kernel::rules::near`] where that is cheaper than halving the longest extent.
//!
//! The part that planar blockers hide is subtracted afterwards by its outline ([`crate::occlusion::outlines`]). Where
//! rays are asked for, a pair that a blocker may cut is halved a few times first: free parts get the smooth
//! rule and hidden parts are dropped. The rest is sampled until it is accurate enough
//! ([`crate::occlusion::sampled`]), except where patches touch: there every sample of the contact rule gets a
//! ray.

use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_elements::rule::MOST_POINTS;
use radiosity_geom::polygon_area;
use radiosity_kernel::contact::clip::{Facet, match_contact};
use radiosity_kernel::contact::patches::Contact;
use radiosity_kernel::rules::common_edge::{EdgePair, LARGEST_ASPECT};
use radiosity_kernel::rules::far::SMALLEST_RATIO;
use radiosity_kernel::rules::near::Plan;
use radiosity_kernel::rules::{common_edge, common_vertex, contour, far};
use radiosity_kernel::{PairKind, blocks::block::Block};
use radiosity_visibility::Visibility;
use radiosity_work::interruption::check_interrupt;

use crate::occlusion::sampled::SummedPoints;
use crate::pair::job::{Job, State, patches};
use crate::pair::tolerance::Tolerance;
use crate::tolerances::{MOST_SLIVER_POINTS, NEGLIGIBLE};

/// Smallest extent of patches that may still be halved, relative to the larger element: a part of it is
/// 1/4096 of its area. What is not resolved then counts as error.
const SMALLEST_PART: f64 = 1.0 / 64.0;

/// The block between two elements. `blockers` are the surfaces that may stand between them.
pub(crate) fn block(
    receiver: &Element,
    emitter: &Element,
    blockers: &[usize],
    visibility: &Visibility,
    tolerance: Tolerance,
) -> Block {
    if let Some(block) = constant_block(receiver, emitter, blockers) {
        return block;
    }
    let mut job = Job::new([receiver, emitter], visibility, tolerance);
    let state =
        State { touching: true, levels: tolerance.accuracy.shadow_levels(), blockers: blockers.to_vec() };
    for p in &receiver.patches {
        for q in &emitter.patches {
            job.whole(&Facet::of(p), &Facet::of(q), &state);
        }
    }
    job.finish()
}

/// The block of constants on flat elements without blockers, exact; None for other pairs.
fn constant_block(receiver: &Element, emitter: &Element, blockers: &[usize]) -> Option<Block> {
    let constant = receiver.basis.len() == 1 && emitter.basis.len() == 1;
    if !constant || receiver.plane.is_none() || emitter.plane.is_none() || !blockers.is_empty() {
        return None;
    }
    let (mut sum, mut terms) = (0.0, 0);
    for p in &receiver.patches {
        for q in &emitter.patches {
            check_interrupt();
            let (value, count) = contour::patches(p, q);
            (sum, terms) = (sum + value, terms + count);
        }
    }
    let value = sum / (receiver.area * emitter.area).sqrt();
    Some(Block::exact(vec![value], PairKind::Contour, terms))
}

impl Job<'_> {
    /// Adds two whole patches: clips each by the plane of the other, and cuts them at their contact.
    fn whole(&mut self, p: &Facet, q: &Facet, state: &State) {
        let seen = p.in_front_of(q, self.tolerance);
        let seeing = q.in_front_of(p, self.tolerance);
        let (Some(seen), Some(seeing)) = (seen, seeing) else { return };
        let area = polygon_area(&seen.corners).min(polygon_area(&seeing.corners));
        if area < NEGLIGIBLE * self.budget.accuracy.eps * self.budget.unit {
            return self.lose(area);
        }
        let facets = match_contact(&seen, &seeing, self.tolerance);
        if facets.len() > 1 {
            self.kind = self.kind.max(PairKind::Contact);
        }
        self.put(patches(&facets), state);
        self.run();
    }

    /// A pair of parts: halves it or applies its rule.
    pub(in crate::pair) fn flat(&mut self, p: &Patch, q: &Patch, state: State) {
        let Some(mut state) = self.narrowed(p, q, state) else { return };
        let contact = self.contact(p, q, &mut state);
        if !state.blockers.is_empty() && state.levels > 0 {
            state.levels -= 1;
            return self.halve(p, q, &contact, &state);
        }
        self.kind = self.kind.max(match &contact {
            Contact::Edge { .. } => PairKind::Edge,
            Contact::Vertex(..) => PairKind::Vertex,
            _ if Self::is_near(p, q, contact.gap()) => PairKind::Split,
            _ => PairKind::Separated,
        });
        if state.blockers.is_empty() {
            return self.free(p, q, &contact, &state);
        }
        self.partly_hidden = true;
        self.sampled(p, q, &contact, &state);
    }

    /// A pair without blockers: rules that know the kernel's singularities.
    fn free(&mut self, p: &Patch, q: &Patch, contact: &Contact, state: &State) {
        let (degrees, eps) = (self.degrees, self.budget.accuracy.eps);
        let done = match contact {
            Contact::Edge { p: a, q: b, .. } => {
                match common_edge::integrate_flat(&mut self.moments, a, b, degrees, eps) {
                    Some(rest) => return self.put(rest, state),
                    None => false,
                }
            }
            Contact::Vertex(a, b) => common_vertex::integrate_flat(&mut self.moments, a, b, degrees, eps),
            _ if !Self::is_near(p, q, contact.gap()) => return self.tensor(p, q, contact.gap()),
            _ => match Plan::cheaper_than_split(&self.moments, p, q, eps) {
                Some(plan) => return plan.integrate(&mut self.moments),
                None if self.is_divisible(p, q) => return self.halve(p, q, contact, state),
                None => false,
            },
        };
        if done {
            return;
        }
        match Plan::new(&self.moments, p, q, eps) {
            Some(plan) => plan.integrate(&mut self.moments),
            None if self.is_divisible(p, q) => self.halve(p, q, contact, state),
            None => {
                self.note(true, p, q);
                self.tensor(p, q, SMALLEST_RATIO * p.longest().1.max(q.longest().1));
            }
        }
    }

    /// A pair whose visibility is sampled: rules that take any integrand.
    fn sampled(&mut self, p: &Patch, q: &Patch, contact: &Contact, state: &State) {
        let eps = self.budget.accuracy.eps;
        let sees = self.sees(&state.blockers);
        match contact {
            Contact::Edge { p: a, q: b, .. } => {
                let edge_pair = EdgePair::of(a, b);
                let is_sliver = edge_pair.aspect() > LARGEST_ASPECT;
                if is_sliver && self.is_divisible(p, q) {
                    return self.halve(p, q, contact, state);
                }
                let points = common_edge::counts(a, b, &edge_pair, self.degrees, eps);
                let most = if is_sliver { MOST_SLIVER_POINTS } else { MOST_POINTS };
                self.note(points[2] > most, p, q);
                common_edge::integrate(&mut self.moments, a, b, points.map(|n| n.min(most)), Some(&sees));
            }
            Contact::Vertex(a, b) => {
                if common_vertex::aspect(a, b) > LARGEST_ASPECT && self.is_divisible(p, q) {
                    return self.halve(p, q, contact, state);
                }
                let points = common_vertex::counts(a, b, self.degrees, eps);
                self.note(points[1] > MOST_SLIVER_POINTS, p, q);
                let points = points.map(|n| n.min(MOST_SLIVER_POINTS));
                common_vertex::integrate(&mut self.moments, a, b, points, Some(&sees));
            }
            _ if Self::is_near(p, q, contact.gap()) && self.is_divisible(p, q) => {
                self.halve(p, q, contact, state);
            }
            _ => {
                if self.scatter(p, q, SummedPoints::Rarer, &state.blockers) {
                    self.free(p, q, contact, state);
                }
            }
        }
    }

    fn tensor(&mut self, p: &Patch, q: &Patch, gap: f64) {
        let points = far::counts(p, q, self.degrees, gap, self.budget.accuracy.eps);
        self.moments.tensor(p, q, points, None);
    }

    /// Records that a part misses its accuracy: the most it can carry is its error.
    fn note(&mut self, missed: bool, p: &Patch, q: &Patch) {
        if missed {
            self.unresolved = true;
            self.lose(polygon_area(&p.polygon()).min(polygon_area(&q.polygon())));
        }
    }

    /// Adds the most that an area can carry to the error: ∫κ dA ≤ 1 on either side, relative to √(A_i A_j).
    fn lose(&mut self, area: f64) {
        self.error += area / self.budget.unit;
    }

    fn is_divisible(&self, p: &Patch, q: &Patch) -> bool {
        p.longest().1.max(q.longest().1) > SMALLEST_PART * self.size
    }
}

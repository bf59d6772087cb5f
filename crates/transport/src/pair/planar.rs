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
//! What planar blockers hide is subtracted afterwards by its outline ([`crate::occlusion::outlines`]). Where
//! rays are asked for, a pair that a blocker may cut is halved a few times first: free parts get the smooth
//! rule and hidden parts are dropped. The rest is sampled until it is accurate enough
//! ([`crate::occlusion::sampled`]), except where patches touch: there every sample of the contact rule gets a
//! ray.

use radiosity_elements::Element;
use radiosity_elements::patch::{Direction, Patch};
use radiosity_elements::rule::MOST_POINTS;
use radiosity_geom::{polygon_area, touching};
use radiosity_kernel::contact::clip::{Facet, match_contact};
use radiosity_kernel::contact::flat::{FlatContact, classify, gap};
use radiosity_kernel::moments::Moments;
use radiosity_kernel::moments::integrand::Sees;
use radiosity_kernel::rules::common_edge::{EdgePair, LARGEST_ASPECT};
use radiosity_kernel::rules::far::SMALLEST_RATIO;
use radiosity_kernel::rules::near::Plan;
use radiosity_kernel::rules::{common_edge, common_vertex, contour, far};
use radiosity_kernel::{Accuracy, PairKind, blocks::block::Block};
use radiosity_visibility::Visibility;
use radiosity_work::interruption::check_interrupt;

use crate::occlusion::sampled::{SampledVisibility, SummedPoints};
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
    let mut job = Job::new(receiver, emitter, visibility, tolerance);
    let state =
        State { touching: true, levels: tolerance.accuracy.shadow_levels(), blockers: blockers.to_vec() };
    for p in &receiver.patches {
        for q in &emitter.patches {
            job.whole(p, q, &state);
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
    Some(Block {
        values: vec![sum / (receiver.area * emitter.area).sqrt()],
        kind: PairKind::Contour,
        partly_hidden: false,
        unresolved: false,
        untried: false,
        error: 0.0,
        samples: terms,
        distinct: terms,
        rays: 0,
    })
}

struct Job<'a> {
    visibility: &'a Visibility,
    accuracy: Accuracy,
    degrees: [usize; 2],
    size: f64,
    /// Points nearer than this coincide (scene length).
    tolerance: f64,
    /// √(A_i A_j), the exchange over the entry of two constants (length²).
    unit: f64,
    /// Factor from raw moments to entries: about the largest φ_k φ_l over raw functions.
    scale: f64,
    /// Standard deviation of an entry that sampled shadows may make.
    shadow_error: f64,
    moments: Moments<'a>,
    kind: PairKind,
    partly_hidden: bool,
    unresolved: bool,
    error: f64,
}

#[derive(Clone)]
struct State {
    /// Whether the patches may touch.
    touching: bool,
    /// Halvings left before visibility is sampled.
    levels: u32,
    blockers: Vec<usize>,
}

impl<'a> Job<'a> {
    fn new(
        receiver: &'a Element,
        emitter: &'a Element,
        visibility: &'a Visibility,
        tolerance: Tolerance,
    ) -> Self {
        let Tolerance { accuracy, shadow_error, .. } = tolerance;
        let [small, size] = [f64::min, f64::max].map(|of| of(receiver.extent, emitter.extent));
        Self {
            visibility,
            accuracy,
            degrees: [receiver.basis.total_degree(), emitter.basis.total_degree()],
            size,
            tolerance: touching(small, size),
            unit: (receiver.area * emitter.area).sqrt(),
            scale: receiver.basis.transform()[0] * emitter.basis.transform()[0],
            shadow_error,
            moments: Moments::new(&receiver.basis, &emitter.basis),
            kind: PairKind::Separated,
            partly_hidden: false,
            unresolved: false,
            error: 0.0,
        }
    }

    fn finish(self) -> Block {
        let block = Block::of(self.moments, self.kind, self.partly_hidden);
        Block { unresolved: self.unresolved, error: self.error, ..block }
    }

    /// A pair of whole patches: flat ones are clipped by each other's plane.
    fn whole(&mut self, p: &Patch, q: &Patch, state: &State) {
        let (Some(facet_p), Some(facet_q)) = (facet(p), facet(q)) else {
            return self.visit(p, q, state.clone());
        };
        let seen = facet_p.in_front_of(&facet_q, self.tolerance);
        let seeing = facet_q.in_front_of(&facet_p, self.tolerance);
        let (Some(seen), Some(seeing)) = (seen, seeing) else { return };
        let area = polygon_area(&seen.corners).min(polygon_area(&seeing.corners));
        if area < NEGLIGIBLE * self.accuracy.eps * self.unit {
            return self.lose(area);
        }
        if self.facets(&seen, &seeing, state) > 1 {
            self.kind = self.kind.max(PairKind::Contact);
        }
    }

    /// A pair of facets in front of each other, cut at their contact. Returns the number of pairs of parts.
    fn facets(&mut self, p: &Facet, q: &Facet, state: &State) -> usize {
        let pairs = match_contact(p, q, self.tolerance);
        let count = pairs.len();
        for (a, b) in pairs {
            for patch_a in Patch::of_polygon(&a.corners, a.normal) {
                for patch_b in Patch::of_polygon(&b.corners, b.normal) {
                    self.visit(&patch_a, &patch_b, state.clone());
                }
            }
        }
        count
    }

    /// A pair of parts: halves it or applies its rule.
    fn visit(&mut self, p: &Patch, q: &Patch, mut state: State) {
        check_interrupt();
        if !state.blockers.is_empty() {
            let (hull_p, hull_q) = (p.hull(), q.hull());
            state.blockers = self.visibility.narrow(&state.blockers, &hull_p, &hull_q);
            if self.visibility.hidden(&state.blockers, &hull_p, &hull_q) {
                return;
            }
        }
        let contact =
            if state.touching { classify(p, q, self.tolerance) } else { FlatContact::Apart(gap(p, q)) };
        if !state.blockers.is_empty() && state.levels > 0 {
            state.levels -= 1;
            return self.halve(p, q, &contact, state);
        }
        self.apply(p, q, contact, state);
    }

    /// Applies the rule of a contact, or halves the pair where no rule is accurate.
    fn apply(&mut self, p: &Patch, q: &Patch, contact: FlatContact, state: State) {
        self.kind = self.kind.max(match &contact {
            FlatContact::Edge(..) => PairKind::Edge,
            FlatContact::Vertex(..) => PairKind::Vertex,
            FlatContact::Apart(gap) if self.is_near(p, q, *gap) => PairKind::Split,
            FlatContact::Apart(_) => PairKind::Separated,
        });
        if state.blockers.is_empty() {
            return self.free(p, q, &contact, state);
        }
        self.partly_hidden = true;
        let (visibility, blockers) = (self.visibility, state.blockers.clone());
        self.sampled(p, q, &contact, state, &|x, y| visibility.free(&blockers, x, y));
    }

    /// A pair without blockers: rules that know the kernel's singularities.
    fn free(&mut self, p: &Patch, q: &Patch, contact: &FlatContact, state: State) {
        let (degrees, eps) = (self.degrees, self.accuracy.eps);
        let done = match contact {
            FlatContact::Edge(a, b) => {
                match common_edge::integrate_flat(&mut self.moments, a, b, degrees, eps) {
                    Some(rest) => return rest.iter().for_each(|(a, b)| self.visit(a, b, state.clone())),
                    None => false,
                }
            }
            FlatContact::Vertex(a, b) => common_vertex::integrate_flat(&mut self.moments, a, b, degrees, eps),
            FlatContact::Apart(gap) if self.is_near(p, q, *gap) => {
                match Plan::cheaper_than_split(&self.moments, p, q, eps) {
                    Some(plan) => return plan.integrate(&mut self.moments),
                    None if self.is_divisible(p, q) => return self.halve(p, q, contact, state),
                    None => false,
                }
            }
            FlatContact::Apart(gap) => return self.tensor(p, q, *gap),
        };
        if done {
            return;
        }
        match Plan::new(&self.moments, p, q, eps) {
            Some(plan) => plan.integrate(&mut self.moments),
            None if self.is_divisible(p, q) => self.halve(p, q, contact, state),
            None => self.leave(p, q),
        }
    }

    /// A pair whose visibility is sampled: rules that take any integrand.
    fn sampled(&mut self, p: &Patch, q: &Patch, contact: &FlatContact, state: State, sees: Sees) {
        let eps = self.accuracy.eps;
        match contact {
            FlatContact::Edge(a, b) => {
                let edge_pair = EdgePair::of(a, b);
                if edge_pair.aspect() > LARGEST_ASPECT && self.is_divisible(p, q) {
                    return self.halve(p, q, contact, state);
                }
                let points = common_edge::counts(a, b, &edge_pair, self.degrees, eps);
                let most = if edge_pair.aspect() > LARGEST_ASPECT { MOST_SLIVER_POINTS } else { MOST_POINTS };
                self.note(points[2] > most, p, q);
                common_edge::integrate(&mut self.moments, a, b, points.map(|n| n.min(most)), Some(sees));
            }
            FlatContact::Vertex(a, b) => {
                if common_vertex::aspect(a, b) > LARGEST_ASPECT && self.is_divisible(p, q) {
                    return self.halve(p, q, contact, state);
                }
                let points = common_vertex::counts(a, b, self.degrees, eps);
                self.note(points[1] > MOST_SLIVER_POINTS, p, q);
                let points = points.map(|n| n.min(MOST_SLIVER_POINTS));
                common_vertex::integrate(&mut self.moments, a, b, points, Some(sees));
            }
            FlatContact::Apart(gap) if self.is_near(p, q, *gap) && self.is_divisible(p, q) => {
                self.halve(p, q, contact, state);
            }
            FlatContact::Apart(_) => self.scatter(p, q, contact, sees),
        }
    }

    /// A pair apart: adds what is seen, or all of it less what is hidden. Errors of parts have either sign,
    /// so that their variances add.
    fn scatter(&mut self, p: &Patch, q: &Patch, contact: &FlatContact, sees: Sees) {
        let volume = polygon_area(&p.polygon()) * polygon_area(&q.polygon());
        let limit = self.shadow_error / self.scale * volume.sqrt() / self.unit;
        let found = SampledVisibility::new([p, q], self.moments.bases(), sees, limit, SummedPoints::Rarer);
        found.add_to(&mut self.moments);
        self.error += self.scale * found.error;
        if found.hidden {
            let nothing = State { touching: false, levels: 0, blockers: Vec::new() };
            self.free(p, q, contact, nothing);
        }
    }

    fn tensor(&mut self, p: &Patch, q: &Patch, gap: f64) {
        let points = far::counts(p, q, self.degrees, gap, self.accuracy.eps);
        self.moments.tensor(p, q, points, None);
    }

    /// A near pair at the smallest size: summed roughly.
    fn leave(&mut self, p: &Patch, q: &Patch) {
        self.note(true, p, q);
        self.tensor(p, q, SMALLEST_RATIO * p.longest().1.max(q.longest().1));
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
        self.error += area / self.unit;
    }

    fn is_near(&self, p: &Patch, q: &Patch, gap: f64) -> bool {
        gap < SMALLEST_RATIO * p.longest().1.max(q.longest().1)
    }

    fn is_divisible(&self, p: &Patch, q: &Patch) -> bool {
        p.longest().1.max(q.longest().1) > SMALLEST_PART * self.size
    }

    /// Halves a pair across its longest extent; both sides together along a common edge if that is as long
    /// (0.999 allows for rounding).
    fn halve(&mut self, p: &Patch, q: &Patch, contact: &FlatContact, mut state: State) {
        if let FlatContact::Edge(a, b) = contact {
            let edge_pair = EdgePair::of(a, b);
            if edge_pair.length >= 0.999 * edge_pair.depths[0].max(edge_pair.depths[1]) {
                return self.product(&a.halves(Direction::Along), &b.halves(Direction::Along), &state);
            }
        }
        state.touching &= !matches!(contact, FlatContact::Apart(gap) if *gap > 0.0);
        let ((direction_p, extent_p), (direction_q, extent_q)) = (p.longest(), q.longest());
        if extent_p >= extent_q {
            self.product(&p.halves(direction_p), std::slice::from_ref(q), &state);
        } else {
            self.product(std::slice::from_ref(p), &q.halves(direction_q), &state);
        }
    }

    fn product(&mut self, receivers: &[Patch], emitters: &[Patch], state: &State) {
        for a in receivers {
            for b in emitters {
                match (facet(a), facet(b)) {
                    (Some(facet_a), Some(facet_b)) if state.touching => {
                        self.facets(&facet_a, &facet_b, state);
                    }
                    _ => self.visit(a, b, state.clone()),
                }
            }
        }
    }
}

fn facet(patch: &Patch) -> Option<Facet> {
    match patch {
        Patch::Flat { normal, .. } => Some(Facet { corners: patch.polygon(), normal: *normal }),
        Patch::Curved { .. } => None,
    }
}

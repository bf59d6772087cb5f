//! Two parts of curved elements in any position.

use radiosity_elements::patch::Patch;
use radiosity_kernel::PairKind;
use radiosity_kernel::contact::orientation::{Facing, facing};
use radiosity_kernel::contact::patches::Contact;
use radiosity_kernel::moments::Moments;
use radiosity_kernel::moments::integrand::Sees;
use radiosity_kernel::rules::common_edge::{EdgePair, LARGEST_ASPECT, unequal_speed};
use radiosity_kernel::rules::orders::by_trial::Trial;
use radiosity_kernel::rules::{common_edge, common_vertex};

use crate::occlusion::sampled::SummedPoints;
use crate::pair::curved::constant::constant;
use crate::pair::curved::fan::{InnerPart, SMALL_PART};
use crate::pair::job::{Job, State};
use crate::tolerances::MISSED_BY_TRIALS;

/// A pair of parts, and how they lie to each other.
struct Parts<'p> {
    p: &'p Patch,
    q: &'p Patch,
    contact: Contact,
    facing: Facing,
    /// Whether the pair carries little of the block.
    is_small: bool,
    /// Whether it is nearer than the tensor rule allows.
    is_near: bool,
}

impl Job<'_> {
    pub(in crate::pair) fn curved(&mut self, p: &Patch, q: &Patch, state: State) {
        let share = self.budget.share(p, q);
        if self.budget.neglects(share) {
            self.error += share;
            return;
        }
        let Some(mut state) = self.narrowed(p, q, state) else { return };
        let contact = self.contact(p, q, &mut state);
        let facing = facing(p, q, contact.touches(), self.budget.slight(share));
        if facing == Facing::Away {
            return;
        }
        let is_small = share <= SMALL_PART * self.budget.scale;
        let is_near = Self::is_near(p, q, contact.gap());
        let parts = Parts { p, q, contact, facing, is_small, is_near };
        if !state.blockers.is_empty() && self.is_shadowed(&parts, &mut state) {
            return;
        }
        if state.blockers.is_empty()
            && let Some(value) = constant(p, q)
        {
            return self.constant(p, q, value);
        }
        let is_doubtful = is_near || facing == Facing::Partly;
        let is_apart = parts.contact.gap() > 0.0;
        if is_apart && is_small && is_doubtful && self.attempt(p, q, Some(&parts.contact), &state) {
            return;
        }
        match facing {
            Facing::Partly if state.blockers.is_empty() => self.clipped(&parts, &state),
            _ => self.smooth(&parts, &state),
        }
    }

    /// Whether a pair with blockers is done: halved, or summed with its shadows. Where only what they hide was
    /// subtracted, the state is left without blockers.
    fn is_shadowed(&mut self, parts: &Parts, state: &mut State) -> bool {
        let Parts { p, q, contact, facing, is_small, is_near } = parts;
        let spent = self.budget.shadows_spent(&self.moments);
        // The rules of horizons already leave out what a ball hides: it must not be subtracted twice.
        let is_scattered = !is_small && !is_near && self.ball.is_none();
        if state.levels > 0 && !spent && !is_scattered {
            state.levels -= 1;
            self.halve(p, q, contact, state);
            return true;
        }
        self.partly_hidden = true;
        if is_scattered {
            let summed = if *facing == Facing::Wholly { SummedPoints::Rarer } else { SummedPoints::Seen };
            let is_hidden = self.scatter(p, q, summed, &state.blockers);
            state.blockers.clear();
            return !is_hidden;
        }
        let is_rough = spent && (*is_small || !is_near);
        if is_rough {
            self.roughly(p, q, Some(contact), state);
        }
        is_rough
    }

    /// A pair that a horizon may cut.
    fn clipped(&mut self, parts: &Parts, state: &State) {
        let Parts { p, q, contact, .. } = parts;
        let gap = contact.gap();
        if !parts.is_near {
            if self.budget.horizons_spent() && self.attempt(p, q, Some(contact), state) {
                return;
            }
            return self.horizon(p, &[InnerPart { part: Patch::clone(q), gap }]);
        }
        self.kind = self.kind.max(if gap > 0.0 { PairKind::Split } else { PairKind::Contact });
        if !self.attempt(p, q, Some(contact), state) {
            self.halve(p, q, contact, state);
        }
    }

    /// Adds what a rule sums, which a trial found to miss so much of it.
    fn by_rule(&mut self, missed: f64, rule: impl FnOnce(&mut Moments)) {
        let before = self.first_entry(&self.moments);
        rule(&mut self.moments);
        if missed > 0.0 {
            let carried = self.first_entry(&self.moments) - before;
            self.error += MISSED_BY_TRIALS * missed.min(1.0) * carried.abs();
            self.unresolved = true;
        }
    }

    /// A pair that faces each other wholly, or whose horizons are left to the rays.
    fn smooth(&mut self, parts: &Parts, state: &State) {
        let Parts { p, q, contact, .. } = parts;
        let free = self.sees(&state.blockers);
        let sees: Option<Sees> = if state.blockers.is_empty() { None } else { Some(&free) };
        match contact {
            Contact::Edge { p: a, q: b, matched } => {
                self.kind = self.kind.max(PairKind::Edge);
                let edge_pair = EdgePair::of(a, b);
                if edge_pair.aspect() > LARGEST_ASPECT && !self.spent() {
                    return self.halve(p, q, contact, state);
                }
                let Trial { points, missed } = self.points(a, b).edge(a, b, *matched, &edge_pair);
                let rule = if *matched { common_edge::integrate } else { unequal_speed::integrate };
                self.by_rule(missed, |moments| rule(moments, a, b, points, sees));
            }
            Contact::Vertex(a, b) => {
                self.kind = self.kind.max(PairKind::Vertex);
                if common_vertex::aspect(a, b) > LARGEST_ASPECT && !self.spent() {
                    return self.halve(p, q, contact, state);
                }
                let Trial { points, missed } = self.points(a, b).corner(a, b);
                self.by_rule(missed, |moments| common_vertex::integrate(moments, a, b, points, sees));
            }
            Contact::Apart(gap) if !parts.is_near => {
                match sees {
                    None => self.apart(p, q, *gap),
                    // Rays make steps that no number of points resolves.
                    Some(_) => {
                        let points = self.points(p, q).apart(p, q, *gap);
                        self.moments.tensor(p, q, points, sees);
                    }
                }
            }
            _ => {
                let is_apart = contact.gap() > 0.0;
                self.kind = self.kind.max(if is_apart { PairKind::Split } else { PairKind::Contact });
                let by_halving = is_apart || matches!(contact, Contact::Cut(_) | Contact::Tip(_));
                if by_halving && !self.spent() || !self.attempt(p, q, Some(contact), state) {
                    self.halve(p, q, contact, state);
                }
            }
        }
    }
}

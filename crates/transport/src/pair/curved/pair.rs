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

impl Job<'_> {
    pub(in crate::pair) fn curved(&mut self, p: &Patch, q: &Patch, state: State) {
        let share = self.budget.share(p, q);
        if self.budget.neglects(share) {
            self.error += share;
            return;
        }
        let Some(mut state) = self.narrowed(p, q, state) else { return };
        let contact = self.contact(p, q, &mut state);
        let gap = contact.gap();
        let facing = facing(p, q, contact.touches(), self.budget.slight(share));
        if facing == Facing::Away {
            return;
        }
        let is_small = share <= SMALL_PART * self.budget.scale;
        let is_near = Self::is_near(p, q, gap);
        if !state.blockers.is_empty() {
            let spent = self.budget.shadows_spent(&self.moments);
            // The rules of horizons already leave out what a ball hides: it must not be subtracted twice.
            let is_scattered = !is_small && !is_near && self.ball.is_none();
            if state.levels > 0 && !spent && !is_scattered {
                state.levels -= 1;
                return self.halve(p, q, &contact, &state);
            }
            self.partly_hidden = true;
            if is_scattered {
                let all = if facing == Facing::Wholly { SummedPoints::Rarer } else { SummedPoints::Seen };
                if !self.scatter(p, q, all, &state.blockers) {
                    return;
                }
                state.blockers.clear();
            } else if spent && (is_small || !is_near) {
                return self.roughly(p, q, Some(&contact), &state);
            }
        }
        if state.blockers.is_empty()
            && let Some(value) = constant(p, q)
        {
            return self.constant(p, q, value);
        }
        let is_doubtful = is_near || facing == Facing::Partly;
        if gap > 0.0 && is_small && is_doubtful && self.attempt(p, q, Some(&contact), &state) {
            return;
        }
        match facing {
            Facing::Partly if state.blockers.is_empty() => self.clipped(p, q, &contact, gap, &state),
            _ => self.smooth(p, q, &contact, gap, &state),
        }
    }

    /// A pair that a horizon may cut.
    fn clipped(&mut self, p: &Patch, q: &Patch, contact: &Contact, gap: f64, state: &State) {
        if !Self::is_near(p, q, gap) {
            if self.budget.horizons_spent() && self.attempt(p, q, Some(contact), state) {
                return;
            }
            return self.horizon(p, &[InnerPart { part: q.clone(), gap }]);
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
    fn smooth(&mut self, p: &Patch, q: &Patch, contact: &Contact, gap: f64, state: &State) {
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
            Contact::Apart(_) if !Self::is_near(p, q, gap) => {
                let points = self.points(p, q).apart(p, q, gap);
                self.moments.tensor(p, q, points, sees);
            }
            _ => {
                self.kind = self.kind.max(if gap > 0.0 { PairKind::Split } else { PairKind::Contact });
                let by_halving = gap > 0.0 || matches!(contact, Contact::Cut(_) | Contact::Tip(_));
                if by_halving && !self.spent() || !self.attempt(p, q, Some(contact), state) {
                    self.halve(p, q, contact, state);
                }
            }
        }
    }
}

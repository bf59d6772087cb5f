//! Parts apart with something in between.

use crate::elements::patch::Patch;
use crate::transport::contact::orientation::Facing;
use crate::transport::occlusion::sampled::{Choice, SampledVisibility};

use crate::transport::pair::curved::job::Job;
use crate::transport::pair::curved::size::area;

impl Job<'_> {
    /// What two parts see of each other, sampled at scattered points; whether what is hidden was taken off instead, so that all
    /// there is has yet to be added. Errors of parts have either sign, so that their squares add up: each gets its part of the
    /// block's.
    pub(super) fn scatter(&mut self, p: &Patch, q: &Patch, facing: Facing, blockers: &[usize]) -> bool {
        let own = self.surfaces();
        let free = |x, y| self.visibility.free_between(own, blockers, x, y);
        let choice = if facing == Facing::Wholly { Choice::Rarer } else { Choice::Seen };
        let scale = self.yardstick.first();
        let limit = self.budget.shadow_error / scale * (area(p) * area(q)).sqrt() / self.budget.unit;
        let found = SampledVisibility::new([p, q], self.moments.bases(), &free, limit, choice);
        found.add_to(&mut self.moments);
        self.error += scale * found.error;
        found.hidden
    }
}

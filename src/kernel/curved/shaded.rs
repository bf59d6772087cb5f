//! Parts apart with something in between.

use crate::elements::patch::Patch;
use crate::kernel::facing::Facing;
use crate::kernel::scatter::{Choice, Scatter};

use super::job::Job;
use super::size::area;

impl Job<'_> {
    /// What two parts see of each other, sampled at scattered points. Errors of parts have either sign, so that their squares
    /// add up: each gets its part of the block's.
    pub(super) fn scatter(&mut self, p: &Patch, q: &Patch, gap: f64, facing: Facing, blockers: &[usize]) {
        let own = self.surfaces();
        let free = |x, y| self.visibility.free_between(own, blockers, x, y);
        // A plain rule over all there is follows no horizon.
        let choice = if facing == Facing::Wholly { Choice::Rarer } else { Choice::Seen };
        let scale = self.yardstick.first();
        let limit = self.budget.shadow_error / scale * (area(p) * area(q)).sqrt() / self.budget.unit;
        let found = Scatter::new([p, q], self.moments.bases(), &free, limit, choice);
        found.add_to(&mut self.moments);
        self.error += scale * found.error;
        if found.hidden {
            let points = self.points(p, q).apart(p, q, gap);
            self.moments.tensor(p, q, points, None);
        }
    }
}

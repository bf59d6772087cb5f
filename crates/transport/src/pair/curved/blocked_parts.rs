//! Parts apart with blockers in between.

use radiosity_elements::patch::Patch;
use radiosity_kernel::contact::orientation::Facing;

use crate::occlusion::sampled::{SampledVisibility, SummedPoints};
use crate::pair::curved::job::Job;
use crate::pair::curved::size::area;

impl Job<'_> {
    /// Samples what two parts see of each other. Returns true if what is hidden was subtracted, so that the
    /// unobstructed part has yet to be added. Errors of parts have either sign, so that their variances add:
    /// each part gets its share.
    pub(super) fn scatter(&mut self, p: &Patch, q: &Patch, facing: Facing, blockers: &[usize]) -> bool {
        let own = self.surfaces();
        let free = |x, y| self.visibility.free_between(own, blockers, x, y);
        let summed = if facing == Facing::Wholly { SummedPoints::Rarer } else { SummedPoints::Seen };
        let scale = self.norm.first();
        let limit = self.budget.shadow_error / scale * (area(p) * area(q)).sqrt() / self.budget.unit;
        let found = SampledVisibility::new([p, q], self.moments.bases(), &free, limit, summed);
        found.add_to(&mut self.moments);
        self.error += scale * found.error;
        found.hidden
    }
}

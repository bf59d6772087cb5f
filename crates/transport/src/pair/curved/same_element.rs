//! A part of a curved element with itself.

use radiosity_elements::patch::{Direction, Patch};
use radiosity_kernel::contact::orientation;
use radiosity_kernel::contact::orientation::Facing;
use radiosity_kernel::contact::patches::collapsed;
use radiosity_kernel::moments::integrand::Sees;
use radiosity_kernel::rules::common_edge::LARGEST_ASPECT;
use radiosity_kernel::rules::identical;

use crate::pair::curved::constant::constant;
use crate::pair::curved::points::contact_chart;
use crate::pair::job::{Job, State, Task};
use crate::pair::size::area;

impl Job<'_> {
    pub(in crate::pair) fn same(&mut self, patch: &Patch, mut state: State) {
        let share = area(patch) / self.budget.unit;
        let facing = orientation::own(patch);
        if facing == Facing::Away {
            return;
        }
        if self.budget.neglects(share) {
            self.error += share;
            return;
        }
        let mut doubtful = facing == Facing::Partly;
        if !state.blockers.is_empty() {
            let hull = patch.hull();
            state.blockers = self.visibility.narrow(&state.blockers, &hull, &hull);
            self.partly_hidden |= !state.blockers.is_empty();
            if !state.blockers.is_empty() && self.budget.shadows_spent(&self.moments) {
                if !doubtful && collapsed(patch).is_empty() {
                    return self.roughly(patch, patch, None, &state);
                }
                state.levels = 0;
            }
            doubtful |= !state.blockers.is_empty() && state.levels > 0;
            state.levels = state.levels.saturating_sub(1);
        }
        if state.blockers.is_empty()
            && let Some(value) = constant(patch, patch)
        {
            return self.constant(patch, patch, 0.5 * value);
        }
        let tips = collapsed(patch);
        let direction = cut_of(patch, &tips, doubtful);
        let Some(direction) = direction else { return self.identical(patch, share, &state) };
        let is_ready = (doubtful || self.spent()) && tips.is_empty();
        if is_ready && self.attempt(patch, patch, None, &state) {
            return;
        }
        let [a, b] = patch.halves(direction);
        self.product(std::slice::from_ref(&a), std::slice::from_ref(&b), &state);
        self.tasks.extend([Task::Same(a, state.clone()), Task::Same(b, state)]);
    }

    /// A patch with itself that its rule covers.
    fn identical(&mut self, patch: &Patch, share: f64, state: &State) {
        let eps = self.budget.eps(share);
        let points = identical::counts(patch, self.degrees[0], contact_chart(patch, patch, eps), eps);
        let free = self.sees(&state.blockers);
        let sees: Option<Sees> = if state.blockers.is_empty() { None } else { Some(&free) };
        identical::integrate(&mut self.moments, patch, points, sees);
    }
}

/// The direction in which to halve a patch: towards its tips, where it is slender, or where it is doubtful;
/// None where its rule covers it.
fn cut_of(patch: &Patch, tips: &[usize], doubtful: bool) -> Option<Direction> {
    let ([along, across], [thin, low]) = (patch.extents(), patch.narrowest());
    match tips.first() {
        Some(side) => Some(if side % 2 == 0 { Direction::Across } else { Direction::Along }),
        _ if along.max(across) > LARGEST_ASPECT * thin.min(low) || doubtful => Some(patch.longest().0),
        _ => None,
    }
}

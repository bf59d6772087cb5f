//! The accuracy that each block has to reach.
//!
//! A block that is small compared with the largest of its row needs few digits
//! ([`radiosity_kernel::estimates::entry_bounds`]). The error of its shadows is measured against its row too,
//! and against the largest of the view factors F_ij = √(A_j/A_i) G_ij of either element: a small error of a
//! block can be a large one of the view factors from a small element to a large one.

use radiosity_elements::Element;
use radiosity_kernel::Accuracy;
use radiosity_kernel::estimates::entry_bounds::{ROW_SHARE, relaxed};
use radiosity_visibility::Visibility;
use radiosity_visibility::frustum::Frustum;
use radiosity_work::interruption::check_interrupt;

use crate::kept_blocks::Request;
use crate::occlusion::beside_frusta::{are_apart, have_frusta, outer_sides};
use crate::occlusion::outlines::{Limit, share_sphere};
use crate::occlusion::outside_ball::lies_outside;
use crate::pair::tolerance::Tolerance;
use crate::schedule::task::{Schedule, Task};
use crate::tolerances::{ABOVE_ESTIMATE, SHADOWS_IN_FACTORS, SHADOWS_IN_ROW};

/// Floor of the shadow tolerance, as a factor on the upper bound of the entry and on ε_shadow; view factors,
/// and hence the bound, are at most 1. With a larger value small elements lose digits of their shadows; with
/// a smaller one blocks are sampled that carry nothing.
const SLIGHT: f64 = 1e-3;

/// Largest factor by which the accuracy of a near pair is loosened for its shadows, as what it carries is
/// known to [`ABOVE_ESTIMATE`] only. With a larger value such pairs, which carry much of a row, may err too
/// much; with a smaller one they take more samples.
const LARGEST_NEAR_FACTOR: f64 = 8.0;

/// The accuracy that the block of a task has to reach.
#[derive(Clone, Copy)]
pub(super) struct Goal {
    /// Relative to the block's largest entry.
    pub(super) accuracy: Accuracy,
    /// Accuracy relative to the block's largest entry where surfaces of the pair hide part of it themselves.
    pub(super) bent: Accuracy,
    /// [`ROW_SHARE`] times a lower bound of the row's largest entry: the scale of the error where the block
    /// is smaller.
    pub(super) least: f64,
    /// About the largest entry of its row.
    pub(super) row: f64,
    /// Light (as an entry) that may pass unnoticed where all probing rays are hidden, or be hidden where none
    /// is.
    pub(super) unseen: f64,
    /// Standard deviation allowed for sampled shadows if both elements are flat. Smaller than for curved
    /// ones, because flat pairs have fewer parts, whose errors balance less.
    pub(super) flat: f64,
    /// Standard deviation allowed for sampled shadows if an element is curved.
    pub(super) sampled: f64,
    /// The error of shadows by outlines, where these are used.
    pub(super) outlined: Option<Limit>,
}

impl Goal {
    /// The tolerance of the block of two flat elements.
    pub(super) fn tolerance(&self) -> Tolerance {
        Tolerance { accuracy: self.accuracy, shadow_error: self.flat, least: self.least, row: self.row }
    }

    /// The tolerance of the block of a pair with a curved element that has these blockers.
    pub(super) fn tolerance_of_curved(&self, blockers: &[usize]) -> Tolerance {
        let accuracy = if blockers.is_empty() { self.accuracy } else { self.bent };
        Tolerance { accuracy, shadow_error: self.sampled, ..self.tolerance() }
    }

    /// The request for the block of a task with this goal, as kept blocks are compared by.
    pub(super) fn request(&self, task: &Task, visibility: &Visibility) -> Request {
        let lid = |surface| visibility.frustum(surface).and_then(Frustum::lid);
        let faces = |surface| visibility.faces(surface).iter().copied().chain(lid(*surface));
        let surfaces = task.blockers.iter().chain(&task.own).flat_map(faces).collect();
        let mut numbers = self.bits();
        numbers.extend([task.blockers.len() as u64, task.estimate.to_bits()]);
        Request { row: task.row, column: task.column, surfaces, numbers }
    }

    /// All its numbers, as bits.
    fn bits(&self) -> Vec<u64> {
        let Self { accuracy, bent, least, row, unseen, flat, sampled, outlined } = *self;
        let mut numbers = vec![
            accuracy.eps,
            accuracy.shadow_eps,
            bent.eps,
            bent.shadow_eps,
            least,
            row,
            unseen,
            flat,
            sampled,
        ];
        numbers.extend(outlined.iter().flat_map(|limit| [limit.error, limit.entry]));
        numbers.into_iter().map(f64::to_bits).collect()
    }
}

/// The largest entries in the row of each element.
struct Largest {
    /// Lower bounds of the entries.
    least: Vec<f64>,
    /// Coarse estimates of the first entries, without blockers.
    estimates: Vec<f64>,
    /// View factors from these estimates.
    factors: Vec<f64>,
}

impl Schedule<'_> {
    /// The accuracy that each task has to reach.
    pub(super) fn goals(&self, tasks: &[Task]) -> Vec<Goal> {
        let largest = Largest {
            least: self.largest(tasks, |task, _| task.entries[0]),
            estimates: self.largest(tasks, |task, _| task.estimate),
            factors: self.largest(tasks, |task, pair| task.estimate * self.factor_scale(pair)),
        };
        tasks.iter().map(|task| self.goal(task, &largest)).collect()
    }

    fn goal(&self, task: &Task, largest: &Largest) -> Goal {
        check_interrupt();
        let of_rows = |rows: &[f64]| rows[task.row as usize].min(rows[task.column as usize]);
        let least = ROW_SHARE * of_rows(&largest.least);
        let eps = relaxed(self.accuracy.eps, least, task.entries[1]);
        let accuracy = Accuracy { eps, ..self.accuracy };
        let row = of_rows(&largest.estimates);
        let [unseen, flat, sampled] = [0.0; 3];
        let free = Goal { accuracy, bent: accuracy, least, row, unseen, flat, sampled, outlined: None };
        if task.blockers.is_empty() && task.own.is_empty() {
            return free;
        }
        let tolerable = self.tolerable(task, &largest.factors);
        // A coarse estimate may miss all that two elements of a row see of each other: the tolerance is never
        // zero.
        let floor = SLIGHT * task.entries[1].min(1.0);
        let of_factors = |share: f64| accuracy.shadow_eps * row.min(share * tolerable).max(floor);
        let shadowed = SHADOWS_IN_ROW * row;
        let is_near = self.bounds[task.row as usize].is_near(&self.bounds[task.column as usize]);
        let [roughness, most] =
            if is_near { [ABOVE_ESTIMATE, LARGEST_NEAR_FACTOR] } else { [1.0, f64::INFINITY] };
        let unseen = accuracy.shadow_eps * shadowed.max(task.estimate).max(floor) / roughness;
        let error = of_factors(SHADOWS_IN_FACTORS);
        // Sampled shadows err to either side, unlike what all probing rays miss.
        let shaded = Goal { unseen, flat: unseen.min(error), sampled: of_factors(1.0), ..free };
        if self.has_outlines(task) {
            return Goal { outlined: Some(Limit { error, entry: task.estimate.max(floor) }), ..shaded };
        }
        let bent = accuracy.loosened((shadowed / (roughness * task.estimate)).min(most));
        let accuracy = if task.blockers.is_empty() { accuracy } else { bent };
        Goal { accuracy, bent, ..shaded }
    }

    /// Whether shadows are found by outlines: all blockers are planar, or balls outside which both elements lie, and at
    /// least one element is planar, or both lie on the inside of one sphere that holds all blockers, and neither hides
    /// part of itself (its light would be taken off twice). Where cans, cones and disks are among the blockers, one
    /// element is [beside](crate::occlusion::beside_frusta) them all, and their shadows have closed forms.
    pub(super) fn has_outlines(&self, task: &Task) -> bool {
        let elements = task.pair().map(|index| &self.list[index]);
        let is_outside = |blocker: &usize| {
            let ball = self.visibility.ball(*blocker);
            ball.is_none_or(|(center, radius)| {
                elements.iter().all(|element| lies_outside(element, center, radius))
            })
        };
        // Beyond a sphere what sticks out of it hides nothing of it.
        let are_within = || {
            let sphere = elements[0].surface;
            task.blockers.iter().all(|blocker| self.visibility.encloses(sphere, *blocker))
        };
        let has_outer_side = || outer_sides(elements, &task.blockers, self.visibility).contains(&true);
        task.own.is_empty()
            && self.visibility.has_outlines(&task.blockers)
            && task.blockers.iter().all(is_outside)
            && match have_frusta(&task.blockers, self.visibility) {
                true => has_outer_side() && self.have_closed_forms(elements, &task.blockers),
                false => has_outer_side() || are_within() && share_sphere(elements),
            }
    }

    /// Whether shadows of all cans, cones and disks among the blockers have closed forms: those of constants, where
    /// no line from either element meets two blockers. Kites that stand for their arcs tell no error, and miss up
    /// to a third of what is seen past two disks.
    fn have_closed_forms(&self, pair: [&Element; 2], blockers: &[usize]) -> bool {
        let bodies = self.visibility.one_of_each_body(blockers);
        pair.iter().all(|own| own.basis.len() == 1 && are_apart(&own.hull, &bodies, self.visibility))
    }

    /// The largest `entry(task, [element of the row, other element])` of each row, rounded down: where things
    /// move and the largest entry of a row changes a little, the goals of its other blocks mostly stay, and
    /// so do these ([`crate::kept_blocks`]).
    fn largest(&self, tasks: &[Task], entry: impl Fn(&Task, [usize; 2]) -> f64) -> Vec<f64> {
        let mut rows = vec![0.0f64; self.list.len()];
        for task in tasks {
            let [row, column] = task.pair();
            for pair in [[row, column], [column, row]] {
                rows[pair[0]] = rows[pair[0]].max(entry(task, pair));
            }
        }
        rows.into_iter().map(cut_short).collect()
    }

    /// √(A_j / A_i): the factor from an entry of G between constants to the view factor F_ij.
    fn factor_scale(&self, [own, other]: [usize; 2]) -> f64 {
        (self.list[other].area / self.list[own].area).sqrt()
    }

    /// The first entry at which a view factor of the task would reach the largest of its row in `factors`;
    /// the smaller of the two rows.
    fn tolerable(&self, task: &Task, factors: &[f64]) -> f64 {
        let [row, column] = task.pair();
        let entry = |pair: [usize; 2]| factors[pair[0]] / self.factor_scale(pair);
        entry([row, column]).min(entry([column, row]))
    }
}

/// Binary digits that are kept after the first. Chosen: with none exact blocks took 15 % longer.
const DIGITS: u32 = 3;

/// `x` ≥ 0 rounded down to so few digits; 0 for numbers that are not normal.
fn cut_short(x: f64) -> f64 {
    let dropped = f64::MANTISSA_DIGITS - 1 - DIGITS;
    if x.is_normal() { f64::from_bits(x.to_bits() >> dropped << dropped) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::cut_short;

    #[test]
    fn numbers_are_rounded_down_to_few_digits() {
        for (x, short) in [(0.0, 0.0), (1.0, 1.0), (1.99, 1.875), (0.3, 0.28125), (6.0, 6.0), (1e-310, 0.0)] {
            assert_eq!(cut_short(x), short, "{x}");
        }
    }
}

//! What the block of each pair has to reach.
//!
//! A block that is small beside the largest of its row needs few digits ([`crate::transport::estimates::entry_bounds`]). What its shadows may err
//! is measured by its row likewise, and by the largest of the view factors F_ij = √(A_j/A_i) G_ij from either of its elements:
//! a small error of a block is a large one of the view factors from a small element to a large one.

use crate::transport::blocks::block::Accuracy;
use crate::transport::estimates::entry_bounds::{ROW_SHARE, relaxed};
use crate::transport::occlusion::outlines::Limit;
use crate::transport::schedule::task::{Scene, Task};

/// A block that something may stand in may be wrong by the accuracy of shadows times this part of the largest entry of
/// its row: what samples of shadows miss has either sign and weighs little in the sum of many blocks.
const SHADOWED_ROW_SHARE: f64 = 0.25;

/// A block whose shadows are found by outlines, or sampled between flat elements, may be wrong by their accuracy times this
/// part of the largest view factor from either element: errors of few blocks of a row, or few parts of one, may add up.
const FACTOR_SHARE: f64 = 0.5;

/// Part of the largest that an entry can be, 1 at the most since no view factor exceeds it, that shadows need not tell from
/// nothing.
const SLIGHT: f64 = 1e-3;

/// By how much more than by a rough rule a near pair may exchange, and the most by which it is loosened for its shadows.
const NEAR_ROUGHNESS: f64 = 3.0;
const LARGEST_NEAR_FACTOR: f64 = 8.0;

/// What the block of a task has to reach.
#[derive(Clone, Copy)]
pub(super) struct Goal {
    /// Relative to its own largest entry.
    pub(super) accuracy: Accuracy,
    /// The same where surfaces of the pair hide a part of it themselves.
    pub(super) bent: Accuracy,
    /// Lower bound of the part of its row's largest entry that counts instead of its own where that is smaller.
    pub(super) least: f64,
    /// About the largest entry of its row.
    pub(super) row: f64,
    /// What may pass unseen between two elements if no ray of a few does.
    pub(super) unseen: f64,
    /// What samples of shadows may err if both elements are flat, a standard deviation: such pairs are cut into fewer parts than
    /// curved ones, whose errors balance each other.
    pub(super) flat: f64,
    /// What samples of shadows may err if an element is curved, a standard deviation.
    pub(super) sampled: f64,
    /// Where shadows are found by outlines.
    pub(super) outlined: Option<Limit>,
}

/// The largest of all pairs in the row of each element.
struct Largest {
    /// Lower bounds of the largest entries.
    least: Vec<f64>,
    /// First entries, about, were nothing in between.
    rough: Vec<f64>,
    /// View factors, likewise.
    factors: Vec<f64>,
}

impl Scene<'_> {
    /// What each task has to reach.
    pub(super) fn goals(&self, tasks: &[Task]) -> Vec<Goal> {
        let largest = Largest {
            least: self.largest(tasks, |task, _| task.entries[0]),
            rough: self.largest(tasks, |task, _| task.rough),
            factors: self.largest(tasks, |task, pair| task.rough * self.factor_scale(pair)),
        };
        tasks.iter().map(|task| self.goal(task, &largest)).collect()
    }

    fn goal(&self, task: &Task, largest: &Largest) -> Goal {
        let of_rows = |rows: &[f64]| rows[task.row as usize].min(rows[task.column as usize]);
        let least = ROW_SHARE * of_rows(&largest.least);
        let eps = relaxed(self.accuracy.eps, least, task.entries[1]);
        let accuracy = Accuracy { eps, ..self.accuracy };
        let row = of_rows(&largest.rough);
        let [unseen, flat, sampled] = [0.0; 3];
        let free = Goal { accuracy, bent: accuracy, least, row, unseen, flat, sampled, outlined: None };
        if task.blockers.is_empty() && task.own.is_empty() {
            return free;
        }
        let tolerable = self.tolerable(task, &largest.factors);
        // A rough sum may pass by all that is seen of each other in a row: nothing is asked for no error at all.
        let floor = SLIGHT * task.entries[1].min(1.0);
        let of_factors = |share: f64| accuracy.shadow_eps * row.min(share * tolerable).max(floor);
        let shadowed = SHADOWED_ROW_SHARE * row;
        let is_near = self.reaches[task.row as usize].is_near(&self.reaches[task.column as usize]);
        let [roughness, most] =
            if is_near { [NEAR_ROUGHNESS, LARGEST_NEAR_FACTOR] } else { [1.0, f64::INFINITY] };
        let unseen = accuracy.shadow_eps * shadowed.max(task.rough).max(floor) / roughness;
        let error = of_factors(FACTOR_SHARE);
        // What is sampled errs to either side, unlike what passes unseen.
        let shaded = Goal { unseen, flat: unseen.min(error), sampled: of_factors(1.0), ..free };
        if self.has_outlines(task) {
            return Goal { outlined: Some(Limit { error, entry: task.rough.max(floor) }), ..shaded };
        }
        let bent = accuracy.loosened((shadowed / (roughness * task.rough)).min(most));
        let accuracy = if task.blockers.is_empty() { accuracy } else { bent };
        Goal { accuracy, bent, ..shaded }
    }

    /// Whether at least one element of a task and all its blockers are planar, and shadows found by outlines. Not where one hides
    /// a part of itself: the light it takes must not be taken twice.
    fn has_outlines(&self, task: &Task) -> bool {
        let is_planar = |index: u32| self.list[index as usize].plane.is_some();
        (is_planar(task.row) || is_planar(task.column))
            && task.own.is_empty()
            && self.visibility.has_outlines(&task.blockers)
    }

    /// The largest `entry` of the tasks in each row, of a task and the pair (element of the row, other element).
    fn largest(&self, tasks: &[Task], entry: impl Fn(&Task, [usize; 2]) -> f64) -> Vec<f64> {
        let mut rows = vec![0.0f64; self.list.len()];
        for task in tasks {
            let [row, column] = [task.row, task.column].map(|index| index as usize);
            for pair in [[row, column], [column, row]] {
                rows[pair[0]] = rows[pair[0]].max(entry(task, pair));
            }
        }
        rows
    }

    /// √(A_j / A_i): what an entry of G between constants counts in the view factor F_ij.
    fn factor_scale(&self, [own, other]: [usize; 2]) -> f64 {
        (self.list[other].area / self.list[own].area).sqrt()
    }

    /// The largest that the first entry of a task may be for no view factor in either row to exceed the largest of that row, as
    /// `factors` has them: a small error of a block is a large one of the view factors from a small element to a large one.
    fn tolerable(&self, task: &Task, factors: &[f64]) -> f64 {
        let [row, column] = [task.row, task.column].map(|index| index as usize);
        let entry = |pair: [usize; 2]| factors[pair[0]] / self.factor_scale(pair);
        entry([row, column]).min(entry([column, row]))
    }
}

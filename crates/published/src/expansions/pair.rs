//! A pair of elements as it was seen last, with its expansion.

use radiosity_geom::Motion;

use super::course::Course;
use super::ends::Ends;
use super::expansion::Expansion;

/// Most frames on one course that are waited for after series that were not repaid. Chosen: the worst that
/// expansions can cost is then a fifth of the integrals.
const MOST_PATIENCE: usize = 32;

/// A pair of elements as it was seen last.
#[derive(Debug)]
pub(super) struct Pair {
    /// Number of times that each element was seen anew.
    pub changes: [u32; 2],
    /// The place of the second element relative to the first, since both were seen anew.
    pub place: Motion,
    /// Whether the kept block was integrated, at this place.
    pub is_integrated: bool,
    /// Samples of the last integral, if they are known.
    pub integral: Option<u64>,
    course: Option<Course>,
    /// Frames on this course.
    steady: usize,
    /// Frames on one course after which the pair is expanded.
    patience: usize,
    pub expansion: Option<Expansion>,
}

impl Pair {
    /// A pair that is seen for the first time.
    pub(super) fn seen(changes: [u32; 2], place: Motion) -> Self {
        let (course, expansion) = (None, None);
        Self {
            changes,
            place,
            is_integrated: true,
            integral: None,
            course,
            steady: 0,
            patience: 1,
            expansion,
        }
    }

    /// Takes note of the place of the pair; returns the change of p on its course.
    pub(super) fn move_to(&mut self, place: Motion, ends: &Ends) -> Option<f64> {
        let before = std::mem::replace(&mut self.place, place);
        if ends.rests(&before, &place) {
            return None;
        }
        let on = |course: &Course, place: &Motion| ends.parameter(course, place);
        let step = self.course.and_then(|course| Some(on(&course, &place)? - on(&course, &before)?));
        if step.is_some() {
            self.steady += 1;
            return step;
        }
        // Screw motions are on no course.
        self.course = Course::between(&before, &place).filter(|course| on(course, &place).is_some());
        self.steady = 1;
        on(self.course.as_ref()?, &place)
    }

    /// The series that holds where the pair is, expanded anew if that is worth while.
    pub(super) fn expand(&mut self, step: Option<f64>, ends: &Ends) -> Option<&mut Expansion> {
        if let Some(old) = self.expansion.take() {
            self.patience = if old.is_repaid() { 1 } else { (2 * self.patience).min(MOST_PATIENCE) };
        }
        let (step, course) = (step?, self.course?);
        if self.steady < self.patience {
            return None;
        }
        self.expansion = Expansion::ahead(ends, Course { start: self.place, ..course }, step);
        self.expansion.as_mut()
    }
}

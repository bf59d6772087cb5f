//! A part of an outer patch, as far as it is known how well one rule does on it.
//!
//! W may be bent along a line that runs along either direction of the chart, where halves of the other direction agree with
//! the whole though all are wrong. So both directions are looked at; what was seen of one is kept when the other is
//! halved, half of it a half.

use std::cmp::Ordering;

use crate::elements::patch::{Direction, Patch};
use crate::transport::estimates::entry_norm::EntryNorm;

/// The error of halves as a part of their difference from the whole: a kink of second order gives 2⁻³, and may lie twice as
/// badly.
const FINER: f64 = 0.25;
/// Points that halves take along the direction of halving, as a part of those of the whole.
const HALF_POINTS: f64 = 0.75;

/// The directions in their order.
pub(super) const DIRECTIONS: [Direction; 2] = [Direction::Along, Direction::Across];

/// A patch with its moments by one rule.
#[derive(Debug)]
pub(super) struct Whole {
    /// The patch.
    pub patch: Patch,
    /// Points along and across of the rule.
    pub points: [usize; 2],
    /// Moments in the raw polynomials.
    pub moments: Vec<f64>,
    /// Whether no point of the rule sees anything.
    pub is_dark: bool,
}

/// A part of the outer patch under way.
#[derive(Debug)]
pub(super) struct Cell {
    whole: Whole,
    /// Along and across, where they were looked at.
    halves: [Option<[Whole; 2]>; 2],
    /// By how much halves of either direction differ from the whole; if they were not looked at, as it was with a larger part.
    errors: [f64; 2],
    /// Which of them are its own.
    own: [bool; 2],
    /// What part of the outer patch it is, by its parameters.
    share: f64,
    /// What its corners see that no rule does.
    missed: f64,
}

impl Cell {
    /// One of which nothing else is known.
    pub(super) fn new(whole: Whole) -> Self {
        Self {
            whole,
            halves: [None, None],
            errors: [f64::INFINITY; 2],
            own: [false; 2],
            share: 1.0,
            missed: 0.0,
        }
    }

    /// The halves of a direction, each with the points of its rule.
    pub(super) fn halves(&self, direction: usize, fewest: usize) -> [(Patch, [usize; 2]); 2] {
        let mut points = self.whole.points;
        points[direction] = ((HALF_POINTS * points[direction] as f64).ceil() as usize).max(fewest);
        self.whole.patch.halves(DIRECTIONS[direction]).map(|half| (half, points))
    }

    /// Notes the halves of a direction.
    pub(super) fn look(&mut self, direction: usize, halves: [Whole; 2], yardstick: &EntryNorm) {
        self.errors[direction] = yardstick.difference(&sum(&halves), &self.whole.moments);
        self.halves[direction] = Some(halves);
        self.own[direction] = true;
    }

    /// The direction of the larger error, and whether its halves are known.
    pub(super) fn worse(&self) -> (usize, bool) {
        let [along, across] = self.whole.patch.extents();
        let direction = match self.errors[0].total_cmp(&self.errors[1]) {
            Ordering::Greater => 0,
            Ordering::Less => 1,
            Ordering::Equal => usize::from(across > along),
        };
        (direction, self.halves[direction].is_some())
    }

    /// Estimate of the error of [`Self::moments`].
    pub(super) fn error(&self) -> f64 {
        match self.better() {
            Some(direction) => FINER * self.errors[direction] + self.errors[1 - direction] + self.missed,
            None => f64::INFINITY,
        }
    }

    /// A direction in which only a larger part was looked at.
    pub(super) fn told_by_larger(&self) -> Option<usize> {
        (0..2).find(|direction| !self.own[*direction])
    }

    /// Whether no point of any rule sees anything.
    pub(super) fn is_dark(&self) -> bool {
        self.whole.is_dark && self.halves.iter().flatten().flatten().all(|half| half.is_dark)
    }

    /// Its patch.
    pub(super) fn patch(&self) -> &Patch {
        &self.whole.patch
    }

    /// Notes what its corners see that no rule does.
    pub(super) fn miss(&mut self, missed: f64) {
        self.missed = missed;
    }

    /// What part of the outer patch it is, by its parameters.
    pub(super) fn share(&self) -> f64 {
        self.share
    }

    /// Its moments, by halves where they are known.
    pub(super) fn moments(self) -> Vec<f64> {
        let better = self.better();
        better.and_then(|direction| self.halves[direction].as_ref().map(sum)).unwrap_or(self.whole.moments)
    }

    /// Cut in a direction whose halves are known.
    pub(super) fn cut(mut self, direction: usize) -> Vec<Self> {
        let mut errors = [f64::INFINITY; 2];
        errors[1 - direction] = 0.5 * self.errors[1 - direction];
        let (halves, share) = (self.halves[direction].take().into_iter().flatten(), 0.5 * self.share);
        halves
            .map(|whole| Self { whole, halves: [None, None], errors, own: [false; 2], share, missed: 0.0 })
            .collect()
    }

    /// The known direction of the larger error.
    fn better(&self) -> Option<usize> {
        let known = |direction: &usize| self.halves[*direction].is_some();
        [0, 1].into_iter().filter(known).max_by(|a, b| self.errors[*a].total_cmp(&self.errors[*b]))
    }
}

fn sum(halves: &[Whole; 2]) -> Vec<f64> {
    halves[0].moments.iter().zip(&halves[1].moments).map(|(a, b)| a + b).collect()
}

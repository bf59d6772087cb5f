//! A cell of an outer patch with the errors of its rule in both directions.
//!
//! W may be bent along a line in either direction of the chart. Halves in the other direction then agree with
//! the whole although all are wrong. Hence both directions are tested. In the direction d,
//!
//! ```text
//! e_d = ‖ M(first half) + M(second half) − M(whole) ‖ ,     error = ¼ e_d + e_d′ + m + missed ,
//! ```
//!
//! where the halves have ⌈¾ n⌉ points in the direction d, 3 at least, and the moments of the cell are those
//! of its halves in the direction d of the larger e among those that were halved. ¼ is 2⁻³, the ratio at a
//! kink of second order, doubled for the position of the kink. The error known in one direction is kept when
//! the other is halved: each half inherits half of it, and computes it anew before it is halved if it is that of
//! a cell eight times as large. m is what both halves miss in their margins (`margin`), or where W begins.
//! `missed` is 0 unless no point of any rule sees anything; then it is 0.05 of the largest
//! entry that the cell would have if all its points saw as much as its best corner.

use std::cmp::Ordering;

use radiosity_elements::basis::AreaBasis;
use radiosity_elements::patch::{Direction, Patch};

use crate::estimates::entry_norm::EntryNorm;
use crate::rules::horizon::carried::Carried;
use crate::tolerances::ERROR_OF_HALVES;

/// Points that halves take in the direction of halving, relative to those of the whole: with ½ the halves
/// would resolve what is smooth no better than the whole, with 1 they would take twice its points.
const HALF_POINTS: f64 = 0.75;

/// Halvings in one direction after which the error of the other one is computed anew, before a cell is halved again. A
/// whole and its halves may agree by chance, and all parts would inherit that. With 1 most of these errors would be
/// computed in vain.
const OLDEST: u32 = 3;

/// The two directions, in order.
pub(super) const DIRECTIONS: [Direction; 2] = [Direction::Along, Direction::Across];

/// A patch with its moments by one rule.
#[derive(Debug)]
pub(super) struct Whole {
    pub patch: Patch,
    /// Points along and across of the rule.
    pub points: [usize; 2],
    pub carried: Carried,
    pub is_dark: bool,
    /// Estimates of what the rule misses in the margins across either direction.
    pub missed: [f64; 2],
}

/// A part of the outer patch.
#[derive(Debug)]
pub(super) struct Cell {
    whole: Whole,
    /// The halves along and across, where they were computed.
    halves: [Option<[Whole; 2]>; 2],
    /// Difference of the halves from the whole in either direction; inherited where the halves were not
    /// computed.
    errors: [f64; 2],
    /// Which errors are not inherited.
    own: [bool; 2],
    /// Halvings since the inherited error was computed.
    age: u32,
    /// Share of the cell in the outer patch, by parameters.
    share: f64,
    /// Error estimated from its corners, where no point of a rule sees anything.
    missed: f64,
}

impl Cell {
    /// The first cell, without known errors.
    pub(super) fn new(whole: Whole) -> Self {
        Self {
            whole,
            halves: [None, None],
            errors: [f64::INFINITY; 2],
            own: [false; 2],
            age: 0,
            share: 1.0,
            missed: 0.0,
        }
    }

    /// The halves in a direction, each with the points of its rule.
    pub(super) fn halves(&self, direction: usize, fewest: usize) -> [(Patch, [usize; 2]); 2] {
        let mut points = self.whole.points;
        points[direction] = ((HALF_POINTS * points[direction] as f64).ceil() as usize).max(fewest);
        self.whole.patch.halves(DIRECTIONS[direction]).map(|half| (half, points))
    }

    /// Stores the halves of a direction.
    pub(super) fn look(&mut self, direction: usize, halves: [Whole; 2], basis: &AreaBasis, norm: &EntryNorm) {
        let Whole { patch, carried, .. } = &self.whole;
        self.errors[direction] = sum(&halves).difference(carried, patch, basis, norm);
        self.halves[direction] = Some(halves);
        self.own[direction] = true;
    }

    /// The direction of the larger error, and whether its halves are known.
    pub(super) fn worse(&self) -> (usize, bool) {
        let [along, across] = self.whole.patch.extents();
        let direction = match self.worth(0).total_cmp(&self.worth(1)) {
            Ordering::Greater => 0,
            Ordering::Less => 1,
            Ordering::Equal => usize::from(across > along),
        };
        (direction, self.halves[direction].is_some())
    }

    /// Estimate of the error of [`Self::moments`].
    pub(super) fn error(&self) -> f64 {
        match self.better() {
            Some(direction) => {
                let differences = ERROR_OF_HALVES * self.errors[direction] + self.errors[1 - direction];
                differences + self.halves[direction].as_ref().map_or(0.0, beyond_points) + self.missed
            }
            None => f64::INFINITY,
        }
    }

    /// Error that halving in a direction may take away.
    fn worth(&self, direction: usize) -> f64 {
        self.errors[direction] + self.whole.missed[direction]
    }

    /// A direction whose error is inherited.
    pub(super) fn told_by_larger(&self) -> Option<usize> {
        (0..2).find(|direction| !self.own[*direction])
    }

    /// A direction whose error is inherited from a cell that was much larger.
    pub(super) fn told_by_much_larger(&self) -> Option<usize> {
        self.told_by_larger().filter(|_| self.age >= OLDEST)
    }

    /// Whether no point of any rule sees anything.
    pub(super) fn is_dark(&self) -> bool {
        self.whole.is_dark && self.halves.iter().flatten().flatten().all(|half| half.is_dark)
    }

    pub(super) fn patch(&self) -> &Patch {
        &self.whole.patch
    }

    /// Sets the error estimated from its corners.
    pub(super) fn miss(&mut self, missed: f64) {
        self.missed = missed;
    }

    /// Share of the cell in the outer patch, by parameters.
    pub(super) fn share(&self) -> f64 {
        self.share
    }

    /// Moments of the cell, by halves where these are known.
    pub(super) fn moments(self) -> Vec<f64> {
        let better = self.better();
        better
            .and_then(|direction| self.halves[direction].as_ref().map(sum))
            .unwrap_or(self.whole.carried)
            .moments
    }

    /// Its two halves in a direction where they are known.
    pub(super) fn cut(mut self, direction: usize) -> Vec<Self> {
        let mut errors = [f64::INFINITY; 2];
        errors[1 - direction] = 0.5 * self.errors[1 - direction];
        let age = if self.own[1 - direction] { 1 } else { self.age + 1 };
        let (halves, share) = (self.halves[direction].take().into_iter().flatten(), 0.5 * self.share);
        halves
            .map(|whole| Self {
                whole,
                halves: [None, None],
                errors,
                own: [false; 2],
                age,
                share,
                missed: 0.0,
            })
            .collect()
    }

    /// The known direction of the larger error.
    fn better(&self) -> Option<usize> {
        let known = |direction: &usize| self.halves[*direction].is_some();
        [0, 1].into_iter().filter(known).max_by(|a, b| self.errors[*a].total_cmp(&self.errors[*b]))
    }
}

fn beyond_points(halves: &[Whole; 2]) -> f64 {
    halves.iter().flat_map(|half| half.missed).sum()
}

fn sum(halves: &[Whole; 2]) -> Carried {
    Carried::sum(halves.each_ref().map(|half| &half.carried))
}

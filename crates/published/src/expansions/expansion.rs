//! The series of a pair along its course.

use crate::series::{BlockSeries, Facing, MovedBlock, MovedPair, Settings};

use super::course::Course;
use super::ends::Ends;

/// N. Chosen: from four to twelve orders reach from a tenth to four tenths of the distance at 1e-4 and are
/// repaid after three to twelve displacements (`docs/theory/animation.md`).
pub const ORDERS: usize = 8;

/// Cost of a sample and term of an expansion, over that of a sample of an integral. Measured: 0.2 to 0.3
/// between patches that are far apart.
const TERM: f64 = 0.25;

/// Least cost of an expansion (integrals), to tell beforehand where it cannot pay.
const LEAST_COST: f64 = 3.0;

/// Cost of an expansion (integrals) where that of the integral is not known. Measured: 4.5 to 7.
const USUAL_COST: f64 = 5.0;

/// Frames within the range for which a pair is expanded, over its cost (integrals). Chosen: more than one, as
/// not all of the range may be used.
const PAYS: f64 = 1.5;

/// Part of the tolerance of a block to which it is expanded: its entries may be so much smaller somewhere in
/// the range than at the centre. Chosen: the range is shorter by a tenth.
const AT_CENTRE: f64 = 0.4;

/// Part of the range from where the pair is to the centre, so that most of the range lies ahead. Chosen.
const AHEAD: f64 = 0.6;

/// The series of a pair along its course.
#[derive(Debug)]
pub(super) struct Expansion {
    series: BlockSeries,
    course: Course,
    /// About its cost (integrals).
    cost: f64,
    /// Blocks that were summed.
    sums: usize,
}

impl Expansion {
    /// For a pair on a course, p = 0 where it is, which went on by `step` in the last frame. None where there
    /// is no series, or where it would not be repaid if the pair goes on like this.
    pub(super) fn ahead(ends: &Ends, course: Course, step: f64) -> Option<Self> {
        let Ends { elements: [receiver, emitter], tolerance, integral, .. } = *ends;
        let pair = MovedPair::new(receiver, emitter, course.motion).ok()?.starting(course.start);
        let settings = Settings { orders: ORDERS, tolerance: AT_CENTRE * tolerance };
        let reach = pair.reach(settings.reach());
        if (1.0 + AHEAD) * reach < PAYS * LEAST_COST * step.abs() {
            return None;
        }
        let about = |centre: f64| {
            let facing = Facing::of(&pair, centre, settings).ok()?;
            let cost = cost(facing.samples(), integral);
            let pays = facing.range().ahead(step)? >= PAYS * cost * step.abs();
            pays.then(|| Self { series: BlockSeries::of(&facing), course, cost, sums: 0 })
        };
        let ahead = about((AHEAD * reach).copysign(step));
        ahead.filter(|expansion| expansion.series.range().contains(0.0)).or_else(|| about(0.0))
    }

    /// The course, p = 0 where the pair was expanded.
    pub(super) fn course(&self) -> &Course {
        &self.course
    }

    /// The block at p; None where it is out of range or less accurate than `tolerance`.
    pub(super) fn at(&mut self, p: f64, tolerance: f64) -> Option<MovedBlock> {
        let block = self.series.at(p).ok()?;
        let largest = block.values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let is_found = block.error <= tolerance * largest;
        self.sums += usize::from(is_found);
        is_found.then_some(block)
    }

    /// Whether the blocks that were summed cost less than their integrals.
    pub(super) fn is_repaid(&self) -> bool {
        self.sums as f64 >= self.cost
    }

    /// Pairs of points at which the kernel was expanded.
    pub(super) fn samples(&self) -> u64 {
        self.series.samples()
    }
}

/// Cost of an expansion with so many samples (integrals of so many).
fn cost(samples: u64, integral: Option<u64>) -> f64 {
    let of = |integral: u64| TERM * (ORDERS + 2) as f64 * samples as f64 / integral.max(1) as f64;
    integral.map_or(USUAL_COST, of).max(LEAST_COST)
}

//! The series of a pair along its course.

use crate::series::{BlockSeries, Facing, MovedBlock, MovedPair, Settings};

use super::course::Course;
use super::ends::Ends;

/// N. Chosen: from four to twelve orders reach from a tenth to four tenths of the distance at 1e-4 and are
/// repaid after three to twelve displacements (`docs/theory/animation.md`).
pub const ORDERS: usize = 8;

/// Frames within the range for which a pair is expanded. Chosen: an expansion costs about five integrals.
const PAYS: f64 = 8.0;

/// Part of the range from where the pair is to the centre, so that most of the range lies ahead. Chosen.
const AHEAD: f64 = 0.6;

/// The series of a pair along its course.
#[derive(Debug)]
pub(super) struct Expansion {
    series: BlockSeries,
    course: Course,
    /// Blocks that were summed.
    sums: usize,
}

impl Expansion {
    /// For a pair on a course, p = 0 where it is, which went on by `step` in the last frame. None where there
    /// is no series, or where it would not be repaid if the pair goes on like this.
    pub(super) fn ahead(ends: &Ends, course: Course, step: f64) -> Option<Self> {
        let Ends { elements: [receiver, emitter], tolerance, .. } = *ends;
        let pair = MovedPair::new(receiver, emitter, course.motion).ok()?.starting(course.start);
        let settings = Settings { orders: ORDERS, tolerance };
        let reach = pair.reach(settings.reach());
        let least = PAYS * step.abs();
        if (1.0 + AHEAD) * reach < least {
            return None;
        }
        let about = |centre: f64, least: f64| {
            let facing = Facing::of(&pair, centre, settings).ok()?;
            let ahead = facing.range().ahead(step)?;
            (ahead >= least).then(|| BlockSeries::of(&facing))
        };
        let series = match about((AHEAD * reach).copysign(step), least) {
            Some(series) if series.range().contains(0.0) => series,
            // The bound is larger than was thought.
            Some(_) => about(0.0, 0.0)?,
            None => about(0.0, least)?,
        };
        Some(Self { series, course, sums: 0 })
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
        self.sums as f64 >= PAYS
    }

    /// Pairs of points at which the kernel was expanded.
    pub(super) fn samples(&self) -> u64 {
        self.series.samples()
    }
}

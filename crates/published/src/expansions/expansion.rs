//! The series of a pair along the line on which it moves.

use radiosity_elements::Element;
use radiosity_geom::DVec3;

use crate::series::{BlockSeries, MovedBlock, Settings, TranslatedPair};

/// N. Chosen: from four to twelve orders reach from a tenth to four tenths of the distance at 1e-4 and are
/// repaid after three to twelve displacements (`docs/theory/animation.md`).
pub const ORDERS: usize = 8;

/// Displacements within the range for which a pair is expanded. Chosen: an expansion costs about five
/// integrals.
const PAYS: f64 = 8.0;

/// Part of the range from where the pair is to the centre, so that most of the range lies ahead. Chosen.
const AHEAD: f64 = 0.6;

/// Distance from the line, over the distance of the elements, that is rounding.
const ROUNDED: f64 = 1e-13;

/// The series of a pair along a line.
#[derive(Debug)]
pub(super) struct Expansion {
    series: BlockSeries,
    /// A displacement on the line, where p = 0.
    start: DVec3,
    /// Unit vector.
    direction: DVec3,
    /// Distance from the line that is rounding (scene length).
    aside: f64,
}

impl Expansion {
    /// For a pair displaced by `now`, which was displaced by `step` less before; None where there is no
    /// series, or where it would not be repaid if the pair goes on like this.
    pub(super) fn ahead(
        [receiver, emitter]: [&Element; 2],
        now: DVec3,
        step: DVec3,
        tolerance: f64,
    ) -> Option<Self> {
        let direction = step.try_normalize()?;
        let pair = TranslatedPair::new(receiver, emitter, direction).ok()?.displaced(now);
        let settings = Settings { orders: ORDERS, tolerance };
        let distance = pair.distance();
        let reach = settings.reach() * distance;
        if (1.0 + AHEAD) * reach < PAYS * step.length() {
            return None;
        }
        let about = |centre: f64| BlockSeries::new(&pair, centre, settings).ok();
        let ahead = about(AHEAD * reach);
        let series = ahead.filter(|series| series.range().contains(0.0)).or_else(|| about(0.0))?;
        Some(Self { series, start: now, direction, aside: ROUNDED * distance })
    }

    /// The block at a displacement; None where it is out of range or less accurate than `tolerance`.
    pub(super) fn at(&self, displacement: DVec3, tolerance: f64) -> Option<MovedBlock> {
        let offset = displacement - self.start;
        let p = offset.dot(self.direction);
        if (offset - p * self.direction).length() > self.aside {
            return None;
        }
        let block = self.series.at(p).ok()?;
        let largest = block.values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        (block.error <= tolerance * largest).then_some(block)
    }

    /// Pairs of points at which the kernel was expanded.
    pub(super) fn samples(&self) -> u64 {
        self.series.samples()
    }
}

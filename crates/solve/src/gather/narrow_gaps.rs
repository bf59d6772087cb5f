//! Narrow gaps under sheets, where light is gathered by walks.
//!
//! In a gap of height h between surfaces of the diagonal d about (h/d)² of the light outside comes to its middle.
//! What is met from there is the light of the gap itself, of which polynomials on elements that reach out of it know
//! nothing. Walks (`super::walked_light`) need none.

use radiosity_geom::Rect;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_visibility::Visibility;

use crate::gather::ray_gather::{Beyond, RayGather};
use crate::gather::read_irradiance::ReadIrradiance;
use crate::gather::receiver::Receiver;
use crate::solution::Solution;

/// Height of a gap over the diagonals of both surfaces up to which it is narrow: then about its square of the light
/// outside comes to its middle. Chosen.
const NARROW: f64 = 0.03;

/// Height of a gap over the diagonal of the scene up to which it is narrow: mats lie closer, and storeys, however wide,
/// are higher. Chosen.
const NARROW_IN_SCENE: f64 = 0.01;

/// Finest accuracy that is asked of walks there, relative to the light of the whole scene where less arrives. Chosen:
/// a point takes a second at the most.
const IN_GAPS: f64 = 5e-3;

/// The narrow gaps of a scene whose surfaces cast shadows.
#[derive(Debug)]
pub(super) struct NarrowGaps<'a> {
    solution: &'a Solution,
    visibility: &'a Visibility,
    eps: f64,
}

impl<'a> NarrowGaps<'a> {
    /// The gaps of a solution that is read to about the relative accuracy `eps`; None where rays meet nothing, or
    /// masks or the number of reflections tell what is read.
    pub(super) fn of(solution: &'a Solution, visibility: &'a Visibility, eps: f64) -> Option<Self> {
        let is_plain = visibility.casts() && solution.masked().is_none() && !solution.is_truncated();
        is_plain.then(|| Self { solution, visibility, eps: eps.max(IN_GAPS) })
    }

    /// All light of a point in a gap; None elsewhere.
    pub(super) fn read(&self, receiver: &ReceiverPoint) -> Option<ReadIrradiance> {
        if !self.holds(receiver) {
            return None;
        }
        let walks = RayGather::new(self.solution, self.visibility, self.eps, Beyond::Walked);
        let ReadIrradiance { irradiance, deviation } = walks.read(&Receiver::Point(*receiver));
        // What is dark beside the scene is as well known as was asked, whatever its relative error.
        Some(ReadIrradiance { irradiance, deviation: deviation.filter(|deviation| !deviation.is_dark) })
    }

    /// Whether a point of a surface lies in a narrow gap under another one.
    fn holds(&self, receiver: &ReceiverPoint) -> bool {
        let up = receiver.ground.unwrap_or(receiver.normal);
        let extent = |surface: usize| self.solution.elements().shape(surface).bounds(&Rect::FULL).diagonal();
        let most = NARROW_IN_SCENE * self.visibility.bounds().diagonal();
        receiver.surface.is_some_and(|surface| {
            self.visibility.nearest_from(surface, receiver.position, up).is_some_and(|met| {
                let narrow = NARROW * extent(surface).min(extent(met.surface));
                met.surface != surface && met.hit.t <= most.min(narrow)
            })
        })
    }
}

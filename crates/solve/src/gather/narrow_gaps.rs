//! Narrow gaps between surfaces.
//!
//! In a *gap* of height h between surfaces of the diagonal d about (h/d)² of the light outside comes to its middle.
//! What is met from there is the light of the gap itself, of which polynomials on elements that reach out of it know
//! nothing.

use radiosity_elements::Element;
use radiosity_geom::{COINCIDENT, Rect};
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_visibility::Visibility;
use radiosity_visibility::tolerances::{NARROW_GAP, NARROW_GAP_IN_SCENE};

use crate::solution::Solution;

/// The narrow gaps of a scene.
#[derive(Clone, Debug)]
pub(super) struct NarrowGaps<'a> {
    solution: &'a Solution,
    visibility: &'a Visibility,
    /// Diagonal of the scene's bounding box (scene length).
    diagonal: f64,
    /// Diagonals of the bounding boxes of its surfaces (scene length).
    extents: Vec<f64>,
}

impl<'a> NarrowGaps<'a> {
    /// The gaps of a scene; None where rays meet nothing, or masks or the number of reflections tell what is read.
    pub(super) fn of(solution: &'a Solution, visibility: &'a Visibility) -> Option<Self> {
        let is_plain = visibility.casts() && solution.masked().is_none() && !solution.is_truncated();
        let extent = |surface: usize| solution.elements().shape(surface).bounds(&Rect::FULL).diagonal();
        is_plain.then(|| Self {
            solution,
            visibility,
            diagonal: visibility.bounds().diagonal(),
            extents: (0..solution.elements().surfaces()).map(extent).collect(),
        })
    }

    /// The part of all surfaces that lies in gaps, judged at the middles of elements.
    pub(super) fn part(&self) -> f64 {
        let list = self.solution.elements().list();
        let is_in_gap = |element: &&Element| {
            let node = element.patches[0].node(0.5, 0.5);
            self.hold(&ReceiverPoint::on(element.surface, node.position, node.normal))
        };
        let area = |elements: &mut dyn Iterator<Item = &Element>| elements.map(|own| own.area).sum::<f64>();
        area(&mut list.iter().filter(is_in_gap)) / area(&mut list.iter())
    }

    /// Whether a point of a surface lies in a narrow gap under another one.
    pub(super) fn hold(&self, receiver: &ReceiverPoint) -> bool {
        self.about(receiver).is_some()
    }

    /// The surfaces of the narrow gap in which a point of one of them lies; under one that touches it is in none.
    pub(super) fn about(&self, receiver: &ReceiverPoint) -> Option<[usize; 2]> {
        let up = receiver.ground.unwrap_or(receiver.normal);
        let heights = COINCIDENT * self.diagonal..=NARROW_GAP_IN_SCENE * self.diagonal;
        let surface = receiver.surface?;
        let met = self.visibility.nearest_from(surface, receiver.position, up)?;
        let narrow = || NARROW_GAP * self.extents[surface].min(self.extents[met.surface]);
        let is_near = met.surface != surface && heights.contains(&met.hit.t) && met.hit.t <= narrow();
        is_near.then_some([surface, met.surface])
    }
}

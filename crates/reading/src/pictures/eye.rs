//! The places that camera rays see.

use radiosity_elements::Elements;
use radiosity_geom::{DVec3, Encounter, Ray};
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_solve::gather::surface_point::SurfacePoint;
use radiosity_solve::solution::{Solution, SurfacePlace};
use radiosity_visibility::Visibility;
use radiosity_work::ranks::vector;
use serde::{Deserialize, Serialize};

/// Least cosine between the normals of places that belong together; most height of one over the plane of the
/// other, over their distance, on one surface and on two. Chosen: leaves of a book apart, patches of a teapot
/// together.
const ALIKE: f64 = 0.9;
const BENT: f64 = 0.3;
const LEVEL: f64 = 0.1;

/// A place on the front of a surface.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct SeenPlace {
    /// Index of the element.
    pub element: usize,
    /// The place.
    pub place: SurfacePlace,
    /// Unit normal there.
    #[serde(with = "vector")]
    pub normal: DVec3,
}

impl SeenPlace {
    /// The place at these parameters of a surface in a scene of this diagonal; None in a hole or under a body.
    pub(crate) fn at(
        elements: &Elements,
        surface: usize,
        parameters: [f64; 2],
        diagonal: f64,
    ) -> Option<Self> {
        let SurfacePoint { place, element, normal, .. } =
            SurfacePoint::at(elements, surface, parameters, diagonal)?;
        let is_open = elements.list()[element].contact.is_none();
        is_open.then_some(Self { element, place, normal })
    }

    /// The place as a receiver.
    pub(crate) fn receiver_point(&self) -> ReceiverPoint {
        ReceiverPoint::on(self.place.surface, self.place.position, self.normal)
    }

    /// Whether light may be interpolated between this place and another: on about one smooth surface.
    pub(crate) fn goes_with(&self, other: &Self) -> bool {
        let step = other.place.position - self.place.position;
        let most = if self.place.surface == other.place.surface { BENT } else { LEVEL } * step.length();
        self.normal.dot(other.normal) > ALIKE
            && step.dot(self.normal).abs() <= most
            && step.dot(other.normal).abs() <= most
    }
}

/// The elements and obstacles that camera rays meet.
#[derive(Debug)]
pub(crate) struct Eye<'a> {
    pub elements: &'a Elements,
    pub visibility: &'a Visibility,
    /// Diagonal of the scene's bounding box (scene length).
    pub diagonal: f64,
}

impl<'a> Eye<'a> {
    /// The eye for the surfaces of a solution among these obstacles.
    pub(crate) fn of(solution: &'a Solution, visibility: &'a Visibility) -> Self {
        Self { elements: solution.elements(), visibility, diagonal: visibility.bounds().diagonal() }
    }

    /// The front that a ray meets first, if it is a front.
    pub(crate) fn along(&self, ray: &Ray) -> Option<SeenPlace> {
        let Encounter { surface, hit, front, .. } = self.visibility.nearest(ray)?;
        // Where two surfaces meet, light is the limit from within the visible one.
        let point =
            front.then(|| SurfacePoint::at(self.elements, surface, [hit.u, hit.v], self.diagonal))??;
        Some(SeenPlace { element: point.element, place: point.place, normal: point.normal })
    }
}

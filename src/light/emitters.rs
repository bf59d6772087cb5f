//! What emits: elements, diffusely by their exitance, and luminaires by their intensity.

use crate::elements::Element;
use crate::elements::coating::Coating;
use crate::light::point_lights::PointLights;

/// The sources of direct light among the elements of a scene.
#[derive(Clone, Debug)]
pub struct Emitters<'a> {
    /// The elements.
    pub elements: &'a [Element],
    /// Their reflectance and exitance, a coating per band.
    pub coatings: Vec<&'a Coating>,
    /// The luminaires, with a strength per band.
    pub points: &'a PointLights,
}

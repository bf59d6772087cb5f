//! The emission of a scene, for direct light that no solution needs be found for.

use radiosity::elements::coating::Coating;
use radiosity::elements::{Discretization, Elements, Subdivide};
use radiosity::light::emitters::{Emitters, Radiances};
use radiosity::light::point_lights::PointLights;
use radiosity::visibility::Visibility;
use radiosity::{Options, Scene};

/// The emission of a scene, on the elements that exact blocks take.
pub struct Sources {
    elements: Elements,
    coatings: Vec<Coating>,
    radiances: Radiances,
    points: PointLights,
}

impl Sources {
    /// The emission of `scene`, whose obstacles are given.
    #[track_caller]
    pub fn of(scene: &Scene, visibility: &Visibility) -> Self {
        let Options { order, space, layers, near_layers, .. } = Options::default();
        let subdivide = Subdivide::Auto { occluded: visibility.any_shadow(), near_layers };
        let elements = Elements::new(scene, &Discretization { order, space, subdivide, layers })
            .unwrap_or_else(|error| panic!("{error}"));
        let coating = |band: usize| Coating::of(scene, elements.list(), band);
        let coatings = (0..scene.bands.len()).map(coating).collect();
        let (radiances, points) = (Radiances::of(scene), PointLights::of(scene));
        Self { elements, coatings, radiances, points }
    }

    /// The emitters, for whoever reads their light.
    pub fn emitters(&self) -> Emitters<'_> {
        Emitters {
            elements: self.elements.list(),
            coatings: self.coatings.iter().collect(),
            radiances: &self.radiances,
            points: &self.points,
        }
    }
}

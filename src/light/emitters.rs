//! What emits: elements, diffusely or as openings to a sky, by their exitance; luminaires and the sun, by their intensity.

use std::sync::Arc;

use radiosity_geom::DVec3;

use crate::elements::Element;
use crate::elements::coating::Coating;
use crate::light::point_lights::PointLights;
use crate::scene::{Outlook, Scene};

/// The sources of direct light among the elements of a scene.
#[derive(Clone, Debug)]
pub struct Emitters<'a> {
    /// The elements.
    pub elements: &'a [Element],
    /// Their reflectance and exitance, a coating per band.
    pub coatings: Vec<&'a Coating>,
    /// What openings see.
    pub outlooks: &'a Outlooks,
    /// The luminaires and the sun, with a strength per band.
    pub points: &'a PointLights,
}

/// What openings to a sky see, by surfaces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outlooks(Vec<Option<Arc<Outlook>>>);

impl Outlooks {
    /// Those of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self(scene.surfaces.iter().map(|surface| surface.outlook.clone()).collect())
    }

    /// That of a surface, if it is an opening.
    pub fn of_surface(&self, surface: usize) -> Option<&Arc<Outlook>> {
        self.0.get(surface)?.as_ref()
    }

    /// The radiance that a surface sends into a unit direction, over that of a diffuse emitter of its exitance.
    pub(crate) fn relative(&self, surface: usize, into: DVec3) -> f64 {
        self.of_surface(surface).map_or(1.0, |outlook| outlook.relative(into))
    }
}

impl Emitters<'_> {
    /// Whether there are openings to a sky.
    pub(crate) fn have_outlooks(&self) -> bool {
        self.outlooks.0.iter().any(Option::is_some)
    }
}

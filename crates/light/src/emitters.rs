//! Emitters of a scene: elements, diffusely or by direction, by their exitance; luminaires without an area
//! and the sun, by their intensity.

use std::sync::Arc;

use radiosity_elements::Element;
use radiosity_elements::coating::Coating;
use radiosity_geom::DVec3;
use radiosity_scene::{Radiance, Scene};

use crate::point_lights::PointLights;

/// The sources of direct light among the elements of a scene.
#[derive(Clone, Debug)]
pub struct Emitters<'a> {
    /// Elements of the scene.
    pub elements: &'a [Element],
    /// Their reflectance and exitance, a coating per band.
    pub coatings: Vec<&'a Coating>,
    /// Angular distributions of the light of openings and luminous areas.
    pub radiances: &'a Radiances,
    /// The luminaires and the sun, with a strength per band.
    pub points: &'a PointLights,
}

/// Angular distributions of the light of surfaces that are no diffuse emitters. Copies share them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Radiances(Arc<[Option<Radiance>]>);

impl Radiances {
    /// Angular distributions of the surfaces of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self(scene.surfaces.iter().map(|surface| surface.radiance.clone()).collect())
    }

    /// Angular distribution of a surface; None if it is a diffuse emitter.
    pub(crate) fn of_surface(&self, surface: usize) -> Option<&Radiance> {
        self.0.get(surface)?.as_ref()
    }

    /// Whether a surface is no diffuse emitter.
    pub fn is_directed(&self, surface: usize) -> bool {
        self.of_surface(surface).is_some()
    }

    /// Whether the light of a surface varies with its direction, and not at the horizon alone.
    pub fn is_graded(&self, surface: usize) -> bool {
        self.of_surface(surface).is_some_and(Radiance::is_graded)
    }

    /// The radiance that a surface sends into a unit direction, over that of a diffuse emitter of its
    /// exitance.
    pub fn relative(&self, surface: usize, into: DVec3) -> f64 {
        self.of_surface(surface).map_or(1.0, |own| own.relative(into))
    }
}

impl Emitters<'_> {
    /// Whether the light of any varies with its direction, and not at the horizon alone.
    pub fn are_graded(&self) -> bool {
        self.elements.iter().any(|own| self.radiances.is_graded(own.surface))
    }

    /// Whether any of them is no diffuse emitter.
    pub fn are_directed(&self) -> bool {
        self.radiances.0.iter().any(Option::is_some)
    }
}

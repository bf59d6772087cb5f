//! The sun through openings: where it stands in the sky behind the opening that a ray towards it meets first.

use std::collections::HashMap;

use radiosity_geom::DVec3;
use radiosity_scene::{Radiance, Scene};

use crate::rays::Rays;
use crate::spectrum::Spectrum;

/// The suns of all skies behind openings.
#[derive(Debug)]
pub(crate) struct Suns(Vec<Sun>);

/// A sun in one direction.
#[derive(Debug)]
struct Sun {
    /// Unit vector to it.
    direction: DVec3,
    /// Irradiance across its beam (W m⁻²) behind each opening.
    behind: HashMap<usize, Spectrum>,
}

impl Suns {
    /// The suns of a scene, the bands from `first` on.
    pub(crate) fn of(scene: &Scene, first: usize) -> Self {
        let mut suns: Vec<Sun> = Vec::new();
        for (index, surface) in scene.surfaces.iter().enumerate() {
            let outlook = surface.radiance.as_ref().and_then(Radiance::outlook);
            let Some((direction, irradiance)) = outlook.and_then(|own| own.beam()) else { continue };
            let behind = surface.factor() * Spectrum::of(first, &irradiance);
            match suns.iter_mut().find(|sun| sun.direction == direction) {
                Some(sun) => _ = sun.behind.insert(index, behind),
                None => suns.push(Sun { direction, behind: HashMap::from([(index, behind)]) }),
            }
        }
        Self(suns)
    }

    /// No sun.
    pub(crate) fn none() -> Self {
        Self(Vec::new())
    }

    /// Calls `take` with the irradiance of each sun at a point that receives along `normal`, and with the
    /// opening that it comes through; returns the number of rays.
    pub(crate) fn at(
        &self,
        rays: &Rays,
        point: DVec3,
        normal: DVec3,
        mut take: impl FnMut(usize, Spectrum),
    ) -> u64 {
        let mut traced = 0;
        for sun in &self.0 {
            let cosine = normal.dot(sun.direction);
            if cosine <= 0.0 {
                continue;
            }
            traced += 1;
            if let Some(place) = rays.first(point, sun.direction)
                && let Some(irradiance) = sun.behind.get(&place.surface)
            {
                take(place.surface, cosine * *irradiance);
            }
        }
        traced
    }
}

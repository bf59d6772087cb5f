//! A surface of a scene.

use std::sync::Arc;

use radiosity_geom::Surface;

use crate::{
    light_group::LightGroup, material::Material, place::Place, radiance::Radiance, thermal::Thermal,
};

/// A shape with a name, a material and wishes for its elements. Only its front emits and receives; its back
/// blocks.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct SceneSurface {
    /// Name, unique in the scene; the back of a two-sided surface is `name:back`.
    pub name: String,
    /// The shape key of the file, e.g. `quad`; `surface` if it was built in code.
    pub kind: &'static str,
    /// The shape, already flipped if the file says so.
    pub shape: Arc<dyn Surface>,
    /// Its material; black if the file names none.
    pub material: Material,
    /// The material's name in the file, if one is given.
    pub material_name: Option<String>,
    /// The index of its other side, where it is two-sided.
    pub other_side: Option<usize>,
    /// Its light group, if it has one: its own, or else that of its material.
    pub group: Option<LightGroup>,
    /// Flux of each band (W) that it emits, not dimmed, where that is given instead of the emission of its
    /// material.
    pub flux: Option<Vec<f64>>,
    /// Factor of each band that a motion has put on what it emits, which holds it; none where that is as it
    /// is at rest, or where it emits nothing at rest.
    pub emission_factors: Option<Vec<f64>>,
    /// Angular distribution of its light, if not diffuse: of openings to a sky and of luminous areas.
    pub radiance: Option<Radiance>,
    /// Its emissivity and thermal condition, as far as they are known.
    pub thermal: Thermal,
    /// Order of the basis here, at most [`MAX_ORDER`](crate::MAX_ORDER), instead of the order asked for.
    pub order: Option<usize>,
    /// Elements along u and v, each at least 1, instead of the subdivision asked for.
    pub subdivide: Option<[usize; 2]>,
    /// Where the surface stands in the file; none if it was built in code.
    pub place: Option<Place>,
}

impl SceneSurface {
    /// Emitted exitance of a band (W m⁻²): the emission of its material times the factor of its light group.
    pub fn exitance(&self, band: usize) -> f64 {
        self.factor() * self.material.emission[band]
    }

    /// Emitted exitance of a band (W m⁻²) at its parameters.
    pub fn exitance_at(&self, band: usize, parameters: [f64; 2]) -> f64 {
        let pattern = self.material.emission_pattern.as_ref();
        pattern.map_or_else(|| self.exitance(band), |own| self.factor() * own.at(band, parameters))
    }

    /// Reflectance of a band at its parameters.
    pub fn reflectance_at(&self, band: usize, parameters: [f64; 2]) -> f64 {
        let pattern = self.material.reflectance_pattern.as_ref();
        pattern.map_or(self.material.reflectance[band], |own| own.at(band, parameters))
    }

    /// The factor of its light group; 1 without a group.
    pub fn factor(&self) -> f64 {
        self.group.as_ref().map_or(1.0, |group| group.factor)
    }

    /// Whether it emits, or would if no motion had dimmed it to nothing.
    pub fn is_source(&self) -> bool {
        self.material.emits() || self.emission_factors.is_some()
    }

    /// Multiplies what it emits in each band by a factor, if it emits anything.
    pub(crate) fn dim(&mut self, factors: &[f64]) {
        if !self.material.emits() {
            return;
        }
        self.material = self.material.dimmed(factors);
        self.flux
            .iter_mut()
            .for_each(|flux| flux.iter_mut().zip(factors).for_each(|(flux, own)| *flux *= own));
        self.radiance = self.radiance.as_ref().map(|own| own.dimmed(factors));
        self.emission_factors = Some(factors.to_vec());
    }

    /// Whether it is an opening to a sky.
    pub fn is_opening(&self) -> bool {
        self.radiance.as_ref().is_some_and(Radiance::is_of_opening)
    }

    /// Whether it is the luminous area of a luminaire.
    pub fn is_luminaire(&self) -> bool {
        matches!(self.radiance, Some(Radiance::Luminaire(_)))
    }

    /// Whether it is a member of the light group `name`; of no group for None.
    pub fn is_in(&self, group: Option<&str>) -> bool {
        self.group.as_ref().map(|own| own.name.as_str()) == group
    }
}

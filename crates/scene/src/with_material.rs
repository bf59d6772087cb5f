//! Painting: a copy of a scene with another material.

use crate::{
    Scene,
    error::{Located, SceneError, title},
    fault::Fault,
    material::{Material, check_sheet},
    surface::SceneSurface,
};

impl Scene {
    /// Copy of the scene in which the material `name` is `material`, with a number for each band. Surfaces of
    /// a given flux keep this flux, and openings the light of their sky. The copy has no `source`.
    ///
    /// # Errors
    /// [`FaultKind::UnknownName`](crate::FaultKind::UnknownName), which lists the materials of the surfaces; a
    /// number out of range; [`FaultKind::Conflict`](crate::FaultKind::Conflict) where a surface cannot let
    /// through what the material does.
    pub fn with_material(&self, name: &str, material: Material) -> Result<Self, SceneError> {
        self.painted(name, &material).map_err(|located| self.error(located))
    }

    fn painted(&self, name: &str, material: &Material) -> Result<Self, Located> {
        material
            .check(self.bands.len())
            .map_err(|fault| Located::nowhere(fault).within(|| title("material", name)))?;
        let mut painted = Self { source: None, ..self.clone() };
        let own = painted.surfaces.iter_mut().filter(|own| own.material_name.as_deref() == Some(name));
        if own.map(|own| paint(own, material)).count() == 0 {
            return Err(Located::nowhere(self.unknown_material(name)));
        }
        painted.check_sides(name)?;
        Ok(painted)
    }

    /// Refuses a transmittance where a surface has no other side, or one of another transmittance.
    fn check_sides(&self, material: &str) -> Result<(), Located> {
        self.surfaces.iter().filter(|own| own.material_name.as_deref() == Some(material)).try_for_each(
            |own| {
                let other = own.other_side.map(|index| &self.surfaces[index].material);
                check_sheet(&own.material, other)
                    .map_err(|fault| Located::nowhere(fault).within(|| title("surface", &own.name)))
            },
        )
    }

    fn unknown_material(&self, name: &str) -> Fault {
        let mut known: Vec<String> =
            self.surfaces.iter().filter_map(|surface| surface.material_name.clone()).collect();
        known.sort_unstable();
        known.dedup();
        Fault::unknown_material(name, known)
    }
}

/// Gives a surface the material; a surface of a given flux, an opening or a luminaire keeps its emission, and
/// what a motion has dimmed stays so.
fn paint(surface: &mut SceneSurface, material: &Material) {
    let keeps = surface.flux.is_some() || surface.radiance.is_some();
    let own = std::mem::replace(&mut surface.material, material.clone());
    if keeps {
        surface.material.emission = own.emission;
        surface.material.emission_pattern = own.emission_pattern;
    } else if let Some(factors) = surface.emission_factors.take() {
        surface.dim(&factors);
    }
}

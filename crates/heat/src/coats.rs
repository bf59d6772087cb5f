//! Scenes whose coatings are those of heat, in the single band `heat`.

use radiosity_scene::{LightGroup, Material, Scene};

use super::black_body::level;
use super::roles::{Role, Roles};

/// The scene with coatings for heat in a single band: e = ε σ T⁴ and ρ = 1 − ε, or e = q and ρ = 1. Each
/// shield is a light group of the level 1.
pub(super) fn radiant(scene: &Scene, roles: &Roles) -> Scene {
    coated(scene, roles, |role| match *role {
        Role::Temperature { emissivity, kelvin } => {
            Coat { reflectance: 1.0 - emissivity, emission: emissivity * level(kelvin) }
        }
        Role::Flux { flux, .. } => Coat { reflectance: 1.0, emission: flux },
        Role::Shield { emissivity, .. } => Coat { reflectance: 1.0 - emissivity, emission: emissivity },
        Role::Idle { .. } => Coat { reflectance: 0.0, emission: 0.0 },
    })
}

/// Largest reflectance of surfaces that all emit. Chosen: rays are spread by light that is solved for, which has
/// no level in pockets where nothing is taken up; that of a soda shop was told thirty times too uncertain.
const SETTLING: f64 = 0.9;

/// The scene of [`radiant`] where every surface emits 1 W m⁻², so that no pair is left out, and takes up a tenth.
pub(super) fn all_emit(scene: &Scene, roles: &Roles) -> Scene {
    let mut scene = radiant(scene, roles);
    scene.surfaces.iter_mut().for_each(|surface| {
        surface.material.emission = vec![1.0];
        surface.material.reflectance[0] = surface.material.reflectance[0].min(SETTLING);
        surface.group = None;
    });
    scene
}

/// Reflectance and emission of a surface in the single band of heat.
pub(super) struct Coat {
    pub reflectance: f64,
    /// e (W m⁻²).
    pub emission: f64,
}

/// The scene in the single band `heat`, without its luminaires and its sky, with this coat for each role.
pub(super) fn coated(scene: &Scene, roles: &Roles, coat: impl Fn(&Role) -> Coat) -> Scene {
    let mut scene = scene.clone();
    scene.luminaires.clear();
    scene.bands = vec!["heat".to_owned()];
    "W/m²".clone_into(&mut scene.unit);
    for (surface, role) in scene.surfaces.iter_mut().zip(&roles.list) {
        let Coat { reflectance, emission } = coat(role);
        surface.material = Material::black(1);
        surface.material.reflectance[0] = reflectance;
        surface.material.emission[0] = emission;
        surface.flux = None;
        surface.radiance = None;
        surface.group = match role {
            Role::Shield { shield, .. } => Some(LightGroup::new(group_of_shield(*shield))),
            _ => None,
        };
    }
    scene
}

/// Name of the light group of a shield.
pub(super) fn group_of_shield(shield: usize) -> String {
    format!("shield {shield}")
}

/// The scene with its shields at these levels σ T⁴.
pub(super) fn at_levels(mut scene: Scene, roles: &Roles, levels: &[f64]) -> Scene {
    for (surface, role) in scene.surfaces.iter_mut().zip(&roles.list) {
        if let (Role::Shield { shield, .. }, Some(group)) = (role, surface.group.as_mut()) {
            group.factor = levels[*shield];
        }
    }
    scene
}

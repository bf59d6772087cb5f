//! Roles of surfaces in heat: a known temperature, a known flux, or a side of a sheet of known flux.

use radiosity_scene::{Condition, Scene, SceneSurface};

use super::fault::HeatFault;

/// The Stefan–Boltzmann constant, W m⁻² K⁻⁴; exact by the definition of the SI units of 2019.
pub(super) const STEFAN_BOLTZMANN: f64 = 5.670_374_419e-8;

/// The known quantity of a surface.
#[derive(Clone, Copy, Debug)]
pub(super) enum Role {
    /// Its temperature, as the level σ T⁴ (W m⁻²).
    Temperature { emissivity: f64, level: f64 },
    /// The flux (W m⁻²) that it sends out; without an emissivity that is 0.
    Flux { emissivity: Option<f64>, flux: f64 },
    /// The flux of both sides of a sheet together, by its index.
    Sheet { emissivity: f64, sheet: usize },
}

/// Two sides of one known flux, and of one temperature that is unknown.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    /// Indices of front and back.
    pub(super) sides: [usize; 2],
    pub(super) emissivities: [f64; 2],
    /// Flux (W m⁻²) per area of the front that both send out together.
    pub(super) flux: f64,
}

/// The roles of all surfaces.
#[derive(Debug)]
pub(super) struct Roles {
    /// One for each surface.
    pub(super) list: Vec<Role>,
    pub(super) pairs: Vec<Pair>,
}

impl Roles {
    /// The roles of the surfaces of `scene`.
    ///
    /// # Errors
    /// Surfaces of which too little is known.
    pub(super) fn of(scene: &Scene) -> Result<Self, HeatFault> {
        let surfaces = named(scene, |_, surface| surface.material.transmits());
        if !surfaces.is_empty() {
            return Err(HeatFault::Transmits { surfaces });
        }
        let conditions: Vec<Option<Condition>> =
            scene.surfaces.iter().map(|surface| surface.thermal.condition).collect();
        let surfaces = named(scene, |index, _| conditions[index].is_none());
        if !surfaces.is_empty() {
            return Err(HeatFault::NoCondition { surfaces });
        }
        let other = |index: usize| {
            let other = scene.surfaces[index].other_side?;
            let is_sheet = matches!(conditions[index], Some(Condition::HeatFlux(_)))
                && conditions[index] == conditions[other]
                && !scene.surfaces[index].is_insulated();
            is_sheet.then_some(other)
        };
        // The irradiance alone tells the temperature of what is adiabatic.
        let needs = |index: usize, surface: &SceneSurface| {
            let is_adiabatic = conditions[index] == Some(Condition::HeatFlux(0.0)) && other(index).is_none();
            emissivity(scene, surface).is_none() && !is_adiabatic
        };
        let surfaces = named(scene, needs);
        if !surfaces.is_empty() {
            return Err(HeatFault::NoEmissivity { surfaces });
        }
        let mut roles = Self { list: Vec::new(), pairs: Vec::new() };
        for (index, surface) in scene.surfaces.iter().enumerate() {
            let emissivity = emissivity(scene, surface);
            let role = match (conditions[index], other(index)) {
                (Some(Condition::Temperature(kelvin)), _) => Role::Temperature {
                    emissivity: emissivity.unwrap_or(1.0),
                    level: STEFAN_BOLTZMANN * kelvin.powi(4),
                },
                (Some(Condition::HeatFlux(flux)), Some(other)) => {
                    let emissivity = emissivity.unwrap_or(1.0);
                    Role::Sheet { emissivity, sheet: roles.side([index, other], emissivity, flux) }
                }
                (Some(Condition::HeatFlux(flux)), None) => Role::Flux { emissivity, flux },
                (None, _) => Role::Flux { emissivity, flux: 0.0 },
            };
            roles.list.push(role);
        }
        Ok(roles)
    }

    /// Whether a surface neither gains nor loses heat by itself; of a sheet, both sides together.
    pub(super) fn is_adiabatic(&self, surface: usize) -> bool {
        match self.list[surface] {
            Role::Temperature { .. } => false,
            Role::Flux { flux, .. } => flux == 0.0,
            Role::Sheet { sheet, .. } => self.pairs[sheet].flux == 0.0,
        }
    }

    /// Adds a side of a sheet whose other side may be known, and returns the number of the sheet.
    fn side(&mut self, [own, other]: [usize; 2], emissivity: f64, flux: f64) -> usize {
        match self.pairs.iter().rposition(|pair| pair.sides == [other, own]) {
            Some(sheet) => {
                self.pairs[sheet].emissivities[1] = emissivity;
                sheet
            }
            None => {
                self.pairs.push(Pair { sides: [own, other], emissivities: [emissivity; 2], flux });
                self.pairs.len() - 1
            }
        }
    }
}

/// The names of the surfaces of which `holds` is true.
fn named(scene: &Scene, holds: impl Fn(usize, &SceneSurface) -> bool) -> Vec<String> {
    let all = scene.surfaces.iter().enumerate().filter(|(index, surface)| holds(*index, surface));
    all.map(|(index, _)| scene.shown_name(index).to_owned()).collect()
}

/// The emissivity that is given, else 1 − ρ where there is a single band and no pattern.
fn emissivity(scene: &Scene, surface: &SceneSurface) -> Option<f64> {
    let is_grey = scene.bands.len() == 1 && surface.material.reflectance_pattern.is_none();
    let grey = is_grey.then(|| 1.0 - surface.material.reflectance[0]);
    surface.thermal.emissivity.or(grey)
}

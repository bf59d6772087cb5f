//! The figures of each surface.

use radiosity_core::dot;
use radiosity_elements::Elements;
use radiosity_scene::Scene;
use radiosity_solve::solution::Solution;

use super::black_body::{STEFAN_BOLTZMANN, kelvin, level};
use super::error::HeatError;
use super::roles::{Role, Roles, named};

/// The heat of one surface. Fluxes and temperatures are means over it: T is that of the mean of σ T⁴.
#[derive(Clone, Debug, serde::Serialize)]
pub struct SurfaceHeat {
    /// Its name.
    pub name: String,
    /// Area that exchanges heat (scene length², metres² for watts); where things touch they see each other.
    pub area: f64,
    /// Emissivity; None where none was given and none is needed.
    pub emissivity: Option<f64>,
    /// Temperature (K); not a number where nothing sets its level, as the fields of light.
    pub temperature: f64,
    /// Whether that was given.
    pub is_temperature_known: bool,
    /// Whether the flux and the flow were given.
    pub is_flow_known: bool,
    /// Net flux q (W m⁻²) that leaves it: J − H.
    pub flux: f64,
    /// Net flow Q (W) that leaves it: q times the area.
    pub flow: f64,
    /// Radiosity J (W m⁻²).
    pub radiosity: f64,
    /// Irradiance H (W m⁻²).
    pub irradiance: f64,
    /// Estimated error of the temperature (K); 0 where it was given.
    pub temperature_error: f64,
    /// Estimated error of the flow (W); 0 where it was given.
    pub flow_error: f64,
}

impl SurfaceHeat {
    /// Area times what it absorbs of the irradiance, or times 1 where its level follows from that: what is read of it
    /// errs in this proportion.
    pub(super) fn absorbing_area(&self) -> f64 {
        let known = self.emissivity.filter(|_| self.is_temperature_known);
        self.area * known.unwrap_or(1.0)
    }
}

/// Factors by which the errors of a surface became larger.
#[derive(Clone, Copy, Debug)]
pub(super) struct ErrorGrowth {
    pub(super) temperature: f64,
    pub(super) flow: f64,
}

impl ErrorGrowth {
    /// The growth from one figure of a surface to another; `usual` where the first one is 0.
    pub(super) fn between(before: &SurfaceHeat, after: &SurfaceHeat, usual: f64) -> Self {
        let factor = |before: f64, after: f64| if before > 0.0 { after / before } else { usual };
        Self {
            temperature: factor(before.temperature_error, after.temperature_error),
            flow: factor(before.flow_error, after.flow_error),
        }
    }
}

/// Power (W) that arrives on each surface, for the coefficients h of the irradiance.
pub(super) fn received(elements: &Elements, irradiance: &[f64]) -> Vec<f64> {
    let mut received = vec![0.0; elements.surfaces()];
    let mut rest = irradiance;
    for element in elements.list() {
        let (own, others) = rest.split_at(element.constant.len());
        received[element.surface] += dot(&element.constant, own);
        rest = others;
    }
    received
}

/// Area of each surface that exchanges heat.
pub(super) fn areas(elements: &Elements) -> Vec<f64> {
    let mut areas = vec![0.0; elements.surfaces()];
    elements.list().iter().for_each(|element| areas[element.surface] += element.area);
    areas
}

/// The figures of all surfaces, without errors.
///
/// # Errors
/// A surface from which more is drawn than arrives.
pub(super) fn figures(
    scene: &Scene,
    roles: &Roles,
    solution: &Solution,
) -> Result<Vec<SurfaceHeat>, HeatError> {
    let elements = solution.elements();
    let band = &solution.bands()[0];
    let (areas, received) = (areas(elements), received(elements, &band.coefficients.irradiance));
    let figure = |surface: usize| {
        let (area, power) = (areas[surface], received[surface]);
        let is_idle = matches!(roles.list[surface], Role::Idle { .. });
        let irradiance = match area > 0.0 {
            _ if is_idle => f64::NAN,
            true => power / area,
            false => 0.0,
        };
        // All elements of a surface have the same coating; a surface without elements exchanges nothing.
        let own = elements.of_surface(surface).next();
        let radiosity = own.map_or(0.0, |element| band.coating.radiosity(element, [0.0; 2], irradiance, 0.0));
        let flux = match roles.list[surface] {
            Role::Flux { flux, .. } => flux,
            Role::Idle { .. } => 0.0,
            // As J − H, in which the digits of small emissivities are lost.
            Role::Temperature { emissivity, kelvin } if own.is_some() => {
                emissivity * (level(kelvin) - irradiance)
            }
            Role::Temperature { .. } | Role::Shield { .. } => radiosity - irradiance,
        };
        let temperature = match roles.list[surface] {
            Role::Temperature { kelvin, .. } => kelvin,
            Role::Flux { flux: 0.0, .. } => kelvin(irradiance),
            Role::Flux { emissivity, flux } => kelvin(irradiance + flux / emissivity.unwrap_or(1.0)),
            Role::Shield { emissivity, .. } => kelvin(irradiance + flux / emissivity),
            Role::Idle { .. } => f64::NAN,
        };
        SurfaceHeat {
            name: scene.surfaces[surface].name.clone(),
            area,
            emissivity: roles.list[surface].emissivity(),
            temperature,
            is_temperature_known: matches!(roles.list[surface], Role::Temperature { .. }),
            is_flow_known: matches!(roles.list[surface], Role::Flux { .. } | Role::Idle { .. }),
            flux,
            flow: flux * area,
            radiosity,
            irradiance,
            temperature_error: if is_idle { f64::NAN } else { 0.0 },
            flow_error: 0.0,
        }
    };
    let all: Vec<SurfaceHeat> = (0..scene.surfaces.len()).map(figure).collect();
    let is_idle = |surface: usize| matches!(roles.list[surface], Role::Idle { .. });
    let surfaces = named(scene, |surface, _| !is_idle(surface) && !all[surface].temperature.is_finite());
    if surfaces.is_empty() { Ok(all) } else { Err(HeatError::TooCold { surfaces }) }
}

/// Makes the errors `share` times the differences from what a balance on other elements found, and those of an
/// irradiance that is off by the part `least` of itself at the least.
pub(super) fn add_errors(surfaces: &mut [SurfaceHeat], others: &[SurfaceHeat], share: f64, least: f64) {
    for (own, other) in surfaces.iter_mut().zip(others) {
        add_errors_of_irradiance(own, least * own.irradiance.abs());
        let flow = if own.is_flow_known { 0.0 } else { share * (own.flow - other.flow).abs() };
        own.flow_error = own.flow_error.max(flow);
        let temperature = share * (own.temperature - other.temperature).abs();
        own.temperature_error = own.temperature_error.max(temperature);
    }
}

/// The part of the irradiance by which half of the flows and levels that are found differ less between two balances.
pub(super) fn difference(surfaces: &[SurfaceHeat], others: &[SurfaceHeat]) -> f64 {
    let part = |(own, other): (&SurfaceHeat, &SurfaceHeat)| {
        let found = match own.is_temperature_known {
            true => (own.flux - other.flux) / own.emissivity.unwrap_or(1.0),
            false => level(own.temperature) - level(other.temperature),
        };
        (own.irradiance > 0.0).then(|| found.abs() / own.irradiance)
    };
    let mut parts: Vec<f64> = surfaces.iter().zip(others).filter_map(part).collect();
    parts.sort_by(f64::total_cmp);
    parts.get(parts.len() / 2).copied().unwrap_or(0.0)
}

/// Makes the errors of all surfaces those of an irradiance that is off by the part `eps` of itself.
pub(super) fn add_errors_of_blocks(surfaces: &mut [SurfaceHeat], eps: f64) {
    surfaces.iter_mut().for_each(|own| add_errors_of_irradiance(own, eps * own.irradiance.abs()));
}

/// Area of all surfaces of known temperature times their emissivities: what takes up heat.
pub(super) fn taking_up(surfaces: &[SurfaceHeat]) -> f64 {
    surfaces.iter().filter(|own| own.is_temperature_known).map(SurfaceHeat::absorbing_area).sum()
}

/// Makes the errors of flow and temperature those that follow from one of the irradiance (W m⁻²) at the least.
pub(super) fn add_errors_of_irradiance(own: &mut SurfaceHeat, irradiance: f64) {
    if !own.is_flow_known {
        own.flow_error = own.flow_error.max(own.emissivity.unwrap_or(1.0) * irradiance * own.area);
    }
    if !own.is_temperature_known {
        own.temperature_error = own.temperature_error.max(own.kelvin_of(irradiance));
    }
}

impl SurfaceHeat {
    /// Whether something sets its level.
    pub fn has_level(&self) -> bool {
        self.temperature.is_finite()
    }

    /// The error of the temperature (K) that one of its level (W m⁻²) makes: dT = d(σ T⁴) / (4 σ T³).
    pub(super) fn kelvin_of(&self, level: f64) -> f64 {
        let slope = 4.0 * STEFAN_BOLTZMANN * self.temperature.powi(3);
        if slope > 0.0 { level / slope } else { kelvin(level) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An error of 0 says nothing of how far it is from the true one.
    #[test]
    fn errors_of_nothing_grow_as_those_of_all() {
        let surface = |flow_error| SurfaceHeat {
            name: "wall".to_owned(),
            area: 1.0,
            emissivity: Some(0.5),
            temperature: 300.0,
            is_temperature_known: true,
            is_flow_known: false,
            flux: 0.0,
            flow: 0.0,
            radiosity: 0.0,
            irradiance: 0.0,
            temperature_error: 0.0,
            flow_error,
        };
        let growth = |before, after| ErrorGrowth::between(&surface(before), &surface(after), 4.0).flow;
        assert_eq!([growth(0.0, 0.0), growth(0.0, 2.0), growth(0.5, 1.0)], [4.0, 4.0, 2.0]);
    }
}

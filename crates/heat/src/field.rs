//! The field of σ T⁴ over the surfaces.
//!
//! ```text
//! T known, and shields:   σ T⁴ even over the surface ;
//! q known:                σ T⁴ = H + q / ε , which varies with the irradiance H .
//! ```
//!
//! Both are a radiosity e + ρ H: with e = σ T⁴ and ρ = 0, or e = q / ε and ρ = 1.

use radiosity_elements::coating::Coating;
use radiosity_solve::solution::{Band, Solution};
use radiosity_solve::system::Coefficients;

use super::black_body::level;
use super::figures::SurfaceHeat;

/// σ T⁴ as the radiosity of a solution with the irradiance of `solution`.
pub(super) fn levels(solution: &Solution, surfaces: &[SurfaceHeat]) -> Solution {
    let elements = solution.elements();
    let coats = elements.list().iter().map(|element| coat(&surfaces[element.surface]));
    let (reflectance, exitance) = coats.unzip();
    let coating = Coating::constant(reflectance, exitance);
    let own = &solution.bands()[0];
    let irradiance = own.coefficients.irradiance.clone();
    let direct = vec![0.0; irradiance.len()];
    let residual = own.coefficients.residual;
    let coefficients = Coefficients::of_irradiance(elements.list(), &coating, irradiance, direct, residual);
    solution.with_bands(vec![Band::new("heat".to_owned(), elements, coating, coefficients)])
}

/// Reflectance and exitance with which the radiosity is σ T⁴.
fn coat(own: &SurfaceHeat) -> (f64, f64) {
    match (own.is_flow_known, own.flux) {
        (false, _) => (0.0, level(own.temperature)),
        (true, 0.0) => (1.0, 0.0),
        (true, flux) => (1.0, flux / own.emissivity.unwrap_or(1.0)),
    }
}

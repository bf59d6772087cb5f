//! Black bodies: exitance and temperature.
//!
//! ```text
//! M = σ T⁴        W m⁻²
//! ```

/// The Stefan–Boltzmann constant, W m⁻² K⁻⁴; exact by the definition of the SI units of 2019 (CODATA 2018).
pub const STEFAN_BOLTZMANN: f64 = 5.670_374_419e-8;

/// σ T⁴ (W m⁻²), the exitance of a black surface.
pub(super) fn level(kelvin: f64) -> f64 {
    STEFAN_BOLTZMANN * kelvin.powi(4)
}

/// The temperature (K) at which a black surface has this exitance (W m⁻²).
pub fn kelvin(level: f64) -> f64 {
    (level / STEFAN_BOLTZMANN).sqrt().sqrt()
}

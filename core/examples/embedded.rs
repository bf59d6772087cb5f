//! The radiant power through a lens, on a machine without an operating system.
//!
//! The rule is computed by the compiler; the program holds sixteen numbers and multiplies. To see it build for a
//! bare target, `benches/README.md` has the two commands.
#![no_std]

use radiosity_core::gauss::Rule;
use radiosity_core::jacobi::Weight;

/// Eight points for ∫₋₁¹ f(x) (1 + x) dx: the radius of a disk is (1 + x)/2, and its area element grows with it.
const DISK: Rule<8> = Rule::jacobi(Weight::integer(0, 1));

/// π/2 ∫₋₁¹ irradiance((1 + x)/2) (1 + x) dx = ∬ irradiance dA over the unit disk, exact to degree 15 in the radius.
///
/// `irradiance` maps a radius in [0, 1] to W m⁻²; the result is in W.
pub fn power(irradiance: impl Fn(f64) -> f64) -> f64 {
    core::f64::consts::FRAC_PI_2 * DISK.sum(|x| irradiance(0.5 * (1.0 + x)))
}

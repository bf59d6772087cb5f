//! What errors of blocks make of the light.
//!
//! ```text
//! h = G b + … ,  b = e + ρ h :     δh = (I − G ρ)⁻¹ δG b ,     ‖δh‖ ≤ ‖r‖/(1 − max ρ) ,     r_i = Σ_j ε_ij ‖b_j‖
//! ```
//!
//! as ‖G‖ ≤ 1. The remainder ε_ij of a series bounds the norm of δG_ij, by Bessel's inequality: Σ_kl δG_kl² ≤ ∫∫ δκ² dA dA. What
//! the rules miss is an estimate and counts like it, that of the series and what a fresh block is allowed: the difference from a
//! fresh frame is told. Without shadows ‖G‖ may exceed 1 by what bodies hide from each other.

use crate::elements::Element;
use crate::solution::{Band, Solution};

/// A block that is the sum of a series.
#[derive(Clone, Copy, Debug)]
pub(super) struct Summed {
    /// Receiver and emitter.
    pub places: [usize; 2],
    /// ε of the block.
    pub error: f64,
}

/// Bound of ‖δh‖/‖h‖, the largest of any band.
pub(super) fn carried(summed: &[Summed], solution: &Solution) -> f64 {
    let list = solution.elements().list();
    solution.bands().iter().map(|band| of_band(summed, list, band)).fold(0.0, f64::max)
}

fn of_band(summed: &[Summed], list: &[Element], band: &Band) -> f64 {
    let sizes = sizes(list, band);
    let mut rest = vec![0.0; list.len()];
    for Summed { places: [i, j], error } in summed {
        rest[*i] += error * sizes[*j];
        rest[*j] += error * sizes[*i];
    }
    let most = band.coating.reflectance.iter().fold(0.0, |most: f64, rho| most.max(*rho));
    let [rest, light] = [&rest, &band.coefficients.irradiance].map(|x| norm(x));
    if rest == 0.0 { 0.0 } else { rest / ((1.0 - most) * light) }
}

/// ‖b_j‖ of each element.
fn sizes(list: &[Element], band: &Band) -> Vec<f64> {
    let mut rest = &band.coefficients.irradiance[..];
    let size = |(place, element): (usize, &Element)| {
        let (own, others) = rest.split_at(element.basis.len());
        rest = others;
        let (rho, emitted) = (band.coating.reflectance[place], band.coating.exitance[place]);
        let sent: Vec<f64> = own.iter().zip(&element.constant).map(|(h, c)| emitted * c + rho * h).collect();
        norm(&sent)
    };
    list.iter().enumerate().map(size).collect()
}

fn norm(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}
